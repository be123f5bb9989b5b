"""What takes the place of a damaged, empty or missing file: its last sound backup, and what it still holds itself."""

import logging
import shutil
from collections.abc import Callable
from contextlib import closing, suppress
from datetime import UTC, datetime
from pathlib import Path

from storage.errors import StoreError, error_name, is_full
from storage.file import log
from storage.file.atomic_files import free_path
from storage.file.backups import Backup, list_backups, restored_copy
from storage.file.commit_counter import CommitRecord, commit_count, read_counter, set_saves
from storage.file.notices import Notice, SalvageResult
from storage.file.temporary import remove_leftovers
from storage.sql import integrity_problem, opened
from storage.sqlite import sqlite3
from storage.text import local_time, time_text

SalvageInto = Callable[[Path, Path, str], SalvageResult]
IsOurs = Callable[[sqlite3.Connection], None]
_log = logging.getLogger(__name__)
# in the order in which they are set aside: as long as the file is there, the next start begins anew with all of them
_SIBLINGS = ("", "-wal", "-journal", "-shm")


def is_lost_file(path: Path, *, by_log: bool) -> bool:
    """True where a missing or empty file is a loss: it has backups or a log, was damaged before, or was saved to.

    Args:
        by_log: a log is a sign; not of a file without tables, whose making was cut off.
    """
    known = read_counter(path)
    return bool(
        (by_log and log.has_frames(path))
        or list_backups(path)
        or (known and known.n_saves)
        or any(path.parent.glob(f"{path.stem}.damaged-*{path.suffix}"))
    )


def replace_damaged(
    path: Path, problem: str, now: datetime, is_ours: IsOurs, salvage_into: SalvageInto | None
) -> Notice:
    """Puts the last sound backup, with all that is readable of the file, in its place, and the file aside.

    Without a backup what is readable goes into a new file.

    Args:
        is_ours: raises StoreError for a backup that is not to be used.
        salvage_into: brings what is readable of a file into another; None to leave that out.

    Raises:
        StoreError: `disk_full`; the file is in its place.
        OSError: the folder cannot be written; the file is in its place.
    """
    is_missing = not path.exists() or path.stat().st_size == 0
    made = _unfinished(path)
    backup = restored_copy(path, made, is_ours)
    try:
        salvaged = _try_salvage(path, made, now, salvage_into)
    except StoreError:
        _remove(made)
        raise
    found = _Outcome(path, is_missing, problem, backup, salvaged)
    _install(path, made, now, found)
    return found.notice()


def repair_wal_tail(path: Path, now: datetime, salvage_into: SalvageInto | None) -> Notice | None:
    """The same for a file that is sound but for the end of its log: a copy of the file takes the backup's part.

    None where nothing can be brought back; nothing has changed then.
    """
    made = _unfinished(path)
    try:
        _copy_with_log(path, made)
        salvaged = _try_salvage(path, made, now, salvage_into)
        if salvaged is None or not salvaged.n_rows:
            return None
        found = _Outcome(path, False, "", None, salvaged, is_end=True)
        _install(path, made, now, found)
        return found.notice()
    except OSError as error:
        if is_full(error):
            raise StoreError("disk_full", path=str(path)) from error
        raise
    finally:
        _remove(made)


def finish_replacing(path: Path) -> None:
    """The power was cut while another file took the damaged one's place, or while it was read."""
    remove_leftovers(path.parent)
    _remove(_unfinished(path))
    copy = _restoring(path)
    if copy.exists():
        if path.exists():
            copy.unlink()
        else:
            _quarantine(
                path, datetime.fromtimestamp(copy.stat().st_mtime, UTC)
            )  # what was left of it
            copy.replace(path)


def rollback_notice(path: Path, known: CommitRecord, n_saves: int) -> Notice:
    """The file has fewer commits than it had; names the newest backup that has more, where there is one."""
    params: dict[str, object] = {
        "path": str(path),
        "time": local_time(known.at),
        "n_saves": known.n_saves - n_saves,
    }
    newer = next((one for one in list_backups(path) if _saves_in(one.path) > n_saves), None)
    if newer is None:
        return Notice("database_earlier", params)
    about = {"backup": str(newer.path), "made_at": local_time(newer.made_at)}
    return Notice("database_earlier_backup", params | about)


def _saves_in(backup: Path) -> int:
    with suppress(sqlite3.Error), closing(opened(backup, "immutable")) as db:
        return commit_count(db)
    return 0


class _Outcome:
    """What is known of a file that was replaced, and how to say it."""

    def __init__(
        self,
        path: Path,
        is_missing: bool,
        problem: str,
        backup: Backup | None,
        salvaged: SalvageResult | None,
        *,
        is_end: bool = False,
    ) -> None:
        self.aside: Path | None = None
        self.backup = backup
        self._path, self._is_missing, self._problem, self._is_end = (
            path,
            is_missing,
            problem,
            is_end,
        )
        self.salvaged = salvaged or SalvageResult()

    @property
    def has_successor(self) -> bool:
        """Something is to take the file's place; else a new one is begun."""
        return bool(self.backup or self.salvaged.n_rows)

    def notice(self) -> Notice:
        aside = self.aside or self._path
        params: dict[str, object] = {
            "path": str(self._path),
            "folder": str(aside.parent),
            "name": aside.name,
            "problem": self._problem,
            "n_edits": self.salvaged.n_edits,
            "n_unread": self.salvaged.n_unread,
        }
        if self.backup is not None:
            params["time"] = local_time(self.backup.made_at)
        return Notice(self._code(), params)

    def _code(self) -> str:
        has_work = bool(self.salvaged.n_rows or self.salvaged.n_unread)
        if self._is_end:
            return "database_end_salvaged"
        if self._is_missing:
            if self.backup is not None:
                return "database_gone_salvaged" if has_work else "database_gone_restored"
            return "database_gone_kept" if self.salvaged.n_rows else "database_gone"
        if self.backup is not None:
            return "database_salvaged" if has_work else "database_restored"
        return "database_salvaged_alone" if self.salvaged.n_rows else "database_set_aside"


def _try_salvage(
    path: Path, made: Path, now: datetime, salvage_into: SalvageInto | None
) -> SalvageResult | None:
    """None where nothing was brought back. No fault of a damaged file may keep the app from starting; but without room
    it must not be set aside unread: raises StoreError `disk_full`."""
    if salvage_into is None:
        return None
    before = made.with_name(f"{made.name}.before")
    try:
        if made.exists():
            shutil.copyfile(made, before)
        salvaged = salvage_into(path, made, time_text(now))
        _check(made)
    except Exception as error:
        if _is_disk_full(error):
            raise StoreError("disk_full", path=str(path)) from error
        _log.exception("nothing could be salvaged from %s", path)
        _remove(made)
        if before.exists():
            before.replace(made)
        return None
    finally:
        before.unlink(missing_ok=True)
    return salvaged


def _is_disk_full(error: Exception) -> bool:
    """SQLite writes here only what is new: the damaged file is not read by it."""
    if isinstance(error, OSError):
        return is_full(error)
    return error_name(error).startswith(("SQLITE_FULL", "SQLITE_IOERR"))


def _check(made: Path) -> None:
    with closing(opened(made, "rw")) as db:
        if problem := integrity_problem(db):
            raise sqlite3.DatabaseError(problem)


def _install(path: Path, made: Path, now: datetime, found: _Outcome) -> None:
    """In this order: cut off anywhere, the next start begins anew, or finishes it (`finish_replacing`)."""
    copy = _restoring(path)
    if found.has_successor:
        _copy_commit_count(path, made)
        made.replace(copy)
    else:
        _remove(made)
    found.aside = _quarantine(path, now)
    if found.has_successor:
        copy.replace(path)


def _copy_commit_count(path: Path, made: Path) -> None:
    """The successor goes on counting where the file had come to (see `mark`)."""
    known = read_counter(path)
    with suppress(sqlite3.Error), closing(opened(made, "rw")) as db:
        db.execute("PRAGMA journal_mode = DELETE")
        if known:
            set_saves(db, known.n_saves)


def _copy_with_log(path: Path, made: Path) -> None:
    shutil.copyfile(path, made)
    shutil.copyfile(log.path_of(path), log.path_of(made))
    with closing(opened(made, "rw")) as db:
        db.execute("PRAGMA journal_mode = DELETE")


def _remove(made: Path) -> None:
    for suffix in ("", "-journal", "-wal", "-shm", ".before"):
        part = made.with_name(made.name + suffix)
        if part.exists():  # a read-only disk refuses to remove even what is not there
            part.unlink(missing_ok=True)


def _restoring(path: Path) -> Path:
    return path.with_name(f"{path.name}.restoring")


def _unfinished(path: Path) -> Path:
    return path.with_name(f"{path.name}.mending")


def _quarantine(path: Path, now: datetime) -> Path | None:
    """Where the file is now; None where there was nothing to set aside."""
    aside = free_path(path.with_name(f"{path.stem}.damaged-{now:%Y%m%d-%H%M%S}{path.suffix}"))
    moved = False
    for sibling in _SIBLINGS:
        part = path.with_name(path.name + sibling)
        if part.exists():
            part.rename(aside.with_name(aside.name + sibling))
            moved = True
    return aside if moved else None
