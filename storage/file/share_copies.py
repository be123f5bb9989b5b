"""Copies of the newest backups in a folder that the school shares, for the day on which this PC's disk breaks.

A small file beside the database names every copy, from before it is made until it is seen to be gone. So a deletion
for good finds them also after another folder was chosen, and can name them while the folder does not answer. It is not
in the database, where each copy would count as new work that needs another backup.
"""

import json
import re
import shutil
from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from storage.file.atomic_files import atomic_write
from storage.file.backups import Backup, has_tombstones, list_backups
from storage.side_files import read_regular

MAX_COPIES = 3
_FOLDER = "PINEL-backups"


@dataclass(frozen=True, slots=True)
class CopyManifest:
    """The copies of a PC that may exist, in the order in which they were made, and the last that was finished."""

    computer_id: str
    copies: tuple[Path, ...] = ()
    finished: Path | None = None


def read_manifest(database: Path) -> CopyManifest | None:
    """What is known of the copies, without a look at their folder; None where there are no notes."""
    with suppress(OSError, ValueError, TypeError, KeyError, RecursionError):
        found = json.loads(read_regular(_notes_of(database)))
        finished = Path(found["finished"]) if found["finished"] else None
        return CopyManifest(str(found["computer"]), tuple(map(Path, found["copies"])), finished)
    return None


class ShareCopies:
    """The copies of this PC's backups.

    Args:
        computer: its key and name.
    """

    def __init__(self, database: Path, computer: tuple[str, str]) -> None:
        self._database = database
        self._computer = computer

    @property
    def manifest(self) -> CopyManifest:
        """The copies that may exist. Notes that came with a copied data folder are of another PC, and not followed."""
        found = read_manifest(self._database)
        key = self._computer[0]
        return found if found and found.computer_id == key else CopyManifest(key)

    def folder_in(self, shared: Path) -> Path:
        """Where they lie. The end of the key tells PCs of one name apart: keys of the same minute begin alike."""
        key, name = self._computer
        clean = re.sub(r"[^\w -]", "", name).strip()[:60] or "PC"
        return shared / _FOLDER / f"{clean}-{key[-8:]}"

    def clean(self, shared: Path | None, tombstoned: Collection[str]) -> tuple[Path, ...]:
        """Deletes the copies that may hold rows deleted for good.

        Args:
            shared: where copies may lie that are not noted, as the notes were lost with a disk.
            tombstoned: keys of the rows.

        Returns:
            Copies that could not be looked at or deleted, and may hold the rows still.
        """
        deleted, left = set(), []
        for copy in dict.fromkeys((*self.manifest.copies, *self._listed(shared))):
            try:
                if _ensure_deleted(copy, tombstoned):
                    deleted.add(copy)
            except OSError:
                left.append(copy)
        if deleted:
            with suppress(OSError):  # what stays noted is looked at again
                self._note([copy for copy in self.manifest.copies if copy not in deleted])
        return tuple(left)

    def copy_newest(self, shared: Path, tombstoned: Collection[str]) -> None:
        """Copies the newest backup, unless it is there, and deletes older copies of this PC.

        A backup that holds rows deleted for good stays here until it is cleaned.

        Raises:
            OSError: the folder is missing, full, read-only or unreachable; what was there before is still there.
        """
        newest = next(iter(list_backups(self._database)), None)
        if newest is None or (tombstoned and not has_tombstones(newest.path, tombstoned)):
            return
        folder = self.folder_in(shared)
        folder.parent.mkdir(
            exist_ok=True
        )  # the shared folder must be there: else it is not mounted
        folder.mkdir(exist_ok=True)
        for part in folder.glob(f".{self._database.stem}-*.part"):  # of a copy that was cut off
            part.unlink()
        target = folder / newest.path.name
        if not _is_there(target, newest):
            self._copy(newest, target)
        self._prune(shared)

    def _listed(self, shared: Path | None) -> list[Path]:
        """The copies where they lie now, the oldest first."""
        found = list_backups(self._database, self.folder_in(shared)) if shared else []
        return [copy.path for copy in reversed(found)]

    def _copy(self, backup: Backup, target: Path) -> None:
        copies = [*(copy for copy in self.manifest.copies if copy != target), target]
        self._note(copies)
        with atomic_write(target) as part:
            shutil.copyfile(backup.path, part)
        self._note(copies, target)

    def _prune(self, shared: Path) -> None:
        """Deletes all but the copies made last: where the database was put back, their numbers begin anew."""
        copies, folder = self.manifest.copies, self.folder_in(shared)
        here = [copy for copy in copies if copy.parent.parent == folder.parent]
        surplus = [*(copy for copy in self._listed(shared) if copy not in here), *here][
            :-MAX_COPIES
        ]
        for copy in surplus:
            copy.unlink(missing_ok=True)
            if copy.parent != folder:  # of the time when this PC had another name
                with suppress(OSError):
                    copy.parent.rmdir()
        if surplus:
            self._note([copy for copy in copies if copy not in surplus])

    def _note(self, copies: Sequence[Path], finished: Path | None = None) -> None:
        last = finished or self.manifest.finished
        found = {
            "computer": self._computer[0],
            "copies": [str(copy) for copy in copies],
            "finished": str(last) if last in copies else None,
        }
        with atomic_write(_notes_of(self._database)) as part:
            part.write_text(json.dumps(found), "utf-8")


def _is_there(target: Path, backup: Backup) -> bool:
    return target.is_file() and target.stat().st_size == backup.size_bytes


def _ensure_deleted(copy: Path, tombstoned: Collection[str]) -> bool:
    """True for a copy that does not exist any more; one that lacks tombstones of the keys is deleted first.

    Raises:
        OSError: that could not be found out.
    """
    if not copy.parent.is_dir():
        raise FileNotFoundError(copy.parent)  # not mounted, perhaps
    if tombstoned:
        copy.with_name(f".{copy.name}.part").unlink(missing_ok=True)
        if copy.is_file() and not has_tombstones(copy, tombstoned):
            copy.unlink()
    return not copy.is_file()


def _notes_of(database: Path) -> Path:
    return database.with_name(f"{database.name}.copies.json")
