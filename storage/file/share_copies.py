"""Copies of the newest backups in the school's shared folder, in case the disk of this PC breaks.

A manifest beside the database lists every copy, from before it is made until its deletion is confirmed. So a deletion
for good finds copies also after another folder was chosen, and can name them while the folder does not respond. The
manifest is not in the database, where each copy would count as new work that needs another backup.
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
from storage.file.open_files import delete
from storage.side_files import read_regular

MAX_COPIES = 3
_FOLDER = "PINEL-backups"


@dataclass(frozen=True, slots=True)
class CopyManifest:
    """The copies of a PC that may exist, in the order of their making, and the last that was completed."""

    computer_id: str
    copies: tuple[Path, ...] = ()
    finished: Path | None = None


def read_manifest(database: Path) -> CopyManifest | None:
    """Returns the manifest without accessing the folder of the copies; None if there is none."""
    with suppress(OSError, ValueError, TypeError, KeyError, RecursionError):
        found = json.loads(read_regular(_notes_of(database)))
        finished = Path(found["finished"]) if found["finished"] else None
        return CopyManifest(str(found["computer"]), tuple(map(Path, found["copies"])), finished)
    return None


class ShareCopies:
    """The copies of this PC's backups.

    Args:
        computer: key and name of this PC.
    """

    def __init__(self, database: Path, computer: tuple[str, str]) -> None:
        self._database = database
        self._computer = computer

    @property
    def manifest(self) -> CopyManifest:
        """The copies that may exist. A manifest that came with a copied data folder is another PC's and ignored."""
        found = read_manifest(self._database)
        key = self._computer[0]
        return found if found and found.computer_id == key else CopyManifest(key)

    def folder_in(self, shared: Path) -> Path:
        """Returns the folder of the copies. Its name has the end of the key, as keys of one minute start alike."""
        key, name = self._computer
        clean = re.sub(r"[^\w -]", "", name).strip()[:60] or "PC"
        return shared / _FOLDER / f"{clean}-{key[-8:]}"

    def clean(self, shared: Path | None, tombstoned: Collection[str]) -> tuple[Path, ...]:
        """Deletes the copies that may hold rows deleted for good.

        Args:
            shared: the folder to search for copies that the manifest lacks, because it was lost with a disk.
            tombstoned: keys of the rows.

        Returns:
            Copies that could not be inspected or deleted and may still hold the rows.
        """
        deleted, left = set(), []
        for copy in dict.fromkeys((*self.manifest.copies, *self._listed(shared))):
            try:
                if _ensure_deleted(copy, tombstoned):
                    deleted.add(copy)
            except OSError:
                left.append(copy)
        if deleted:
            with suppress(OSError):  # copies that stay in the manifest are inspected again
                self._note([copy for copy in self.manifest.copies if copy not in deleted])
        return tuple(left)

    def copy_newest(self, shared: Path, tombstoned: Collection[str]) -> None:
        """Copies the newest backup, unless it is there, and deletes older copies of this PC.

        A backup that holds rows deleted for good is not copied until it is cleaned.

        Raises:
            OSError: the folder is missing, full, read-only or unreachable; earlier copies are still there.
        """
        newest = next(iter(list_backups(self._database)), None)
        if newest is None or (tombstoned and not has_tombstones(newest.path, tombstoned)):
            return
        folder = self.folder_in(shared)
        # the shared folder itself is not created: if it is missing, it is not mounted
        folder.parent.mkdir(exist_ok=True)
        folder.mkdir(exist_ok=True)
        for part in folder.glob(f".{self._database.stem}-*.part"):  # of an interrupted copy
            delete(part)
        target = folder / newest.path.name
        if not _is_there(target, newest):
            self._copy(newest, target)
        self._prune(shared)

    def _listed(self, shared: Path | None) -> list[Path]:
        """Returns the copies in the folder, oldest first."""
        found = list_backups(self._database, self.folder_in(shared)) if shared else []
        return [copy.path for copy in reversed(found)]

    def _copy(self, backup: Backup, target: Path) -> None:
        copies = [*(copy for copy in self.manifest.copies if copy != target), target]
        self._note(copies)
        with atomic_write(target) as part:
            shutil.copyfile(backup.path, part)
        self._note(copies, target)

    def _prune(self, shared: Path) -> None:
        """Deletes all but the newest copies. The manifest orders them, as a restored database reuses numbers."""
        copies, folder = self.manifest.copies, self.folder_in(shared)
        here = [copy for copy in copies if copy.parent.parent == folder.parent]
        surplus = [*(copy for copy in self._listed(shared) if copy not in here), *here][
            :-MAX_COPIES
        ]
        for copy in surplus:
            delete(copy, missing_ok=True)
            if copy.parent != folder:  # made when this PC had another name
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
    """Returns True if the copy does not exist any more. Deletes one that lacks tombstones of the keys first.

    Raises:
        OSError: the copy cannot be inspected.
    """
    if not copy.parent.is_dir():
        raise FileNotFoundError(copy.parent)  # not mounted, perhaps
    if tombstoned:
        delete(copy.with_name(f".{copy.name}.part"), missing_ok=True)
        if copy.is_file() and not has_tombstones(copy, tombstoned):
            delete(copy)
    return not copy.is_file()


def _notes_of(database: Path) -> Path:
    return database.with_name(f"{database.name}.copies.json")
