"""Replaces a damaged, empty or missing file by its last intact backup and the rows that are still readable in it."""

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
from storage.file.open_files import delete, replace
from storage.file.temporary import remove_leftovers
from storage.sql import integrity_problem, opened
from storage.sqlite import sqlite3
from storage.text import local_time, time_text

SalvageInto = Callable[[Path, Path, str], SalvageResult]
IsOurs = Callable[[sqlite3.Connection], None]
_log = logging.getLogger(__name__)
# in the order of renaming: while the file itself is there, the next start repeats it with all of them
_SIBLINGS = ("", "-wal", "-journal", "-shm")


def is_lost_file(path: Path, *, by_log: bool) -> bool:
    """Returns True if a missing or empty file is a loss, and not a first start.

    It is one if the file has backups or a log, was damaged before, or has counted commits.

    Args:
        by_log: whether a log counts; not for a file without tables, whose making was interrupted.
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
    """Replaces the file by the last intact backup with all readable rows of the file, and sets the file aside.

    Without a backup the readable rows go into a new file.

    Args:
        is_ours: raises StoreError for a backup that must not be used.
        salvage_into: merges the readable rows of a file into another; None to leave that out.

    Raises:
        StoreError: `disk_full`, or `database_newer` for the newest intact backup; the file is in its place.
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
    """Replaces a file that is intact except for the end of its log by a copy with the readable rows of the log.

    Returns None if no row can be recovered; nothing has changed then.
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
    """Finishes or undoes a replacement that a power cut interrupted."""
    remove_leftovers(path.parent)
    _remove(_unfinished(path))
    copy = _restoring(path)
    if copy.exists():
        if path.exists():
            delete(copy)
        else:
            # the remaining siblings of the damaged file
            _quarantine(path, datetime.fromtimestamp(copy.stat().st_mtime, UTC))
            replace(copy, path)


def rollback_notice(path: Path, known: CommitRecord, n_saves: int) -> Notice:
    """Returns the notice that the file has fewer commits than before; names the newest backup with more, if any."""
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
    """How a file was replaced, and the notice about it."""

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
        """True if another file replaces it; otherwise the next step makes a new one."""
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
    """Merges the readable rows into `made`; returns None if that failed.

    No error of a damaged file may prevent the start. But without space the file must not be set aside unread: then
    raises StoreError `disk_full`.
    """
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
            replace(before, made)
        return None
    finally:
        delete(before, missing_ok=True)
    return salvaged


def _is_disk_full(error: Exception) -> bool:
    """Returns whether the disk is full. An I/O error of SQLite counts, as it does not read the damaged file here."""
    if isinstance(error, OSError):
        return is_full(error)
    return error_name(error).startswith(("SQLITE_FULL", "SQLITE_IOERR"))


def _check(made: Path) -> None:
    with closing(opened(made, "rw")) as db:
        if problem := integrity_problem(db):
            raise sqlite3.DatabaseError(problem)


def _install(path: Path, made: Path, now: datetime, found: _Outcome) -> None:
    """Renames files in an order that the next start can repeat or finish (`finish_replacing`) after a power cut."""
    copy = _restoring(path)
    if found.has_successor:
        _copy_commit_count(path, made)
        replace(made, copy)
    else:
        _remove(made)
    found.aside = _quarantine(path, now)
    if found.has_successor:
        replace(copy, path)


def _copy_commit_count(path: Path, made: Path) -> None:
    """Lets the successor continue the commit count of the file (see `commit_counter`)."""
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
        if part.exists():  # a read-only disk refuses even the deletion of a missing file
            delete(part, missing_ok=True)


def _restoring(path: Path) -> Path:
    return path.with_name(f"{path.name}.restoring")


def _unfinished(path: Path) -> Path:
    return path.with_name(f"{path.name}.mending")


def _quarantine(path: Path, now: datetime) -> Path | None:
    """Sets the file aside; returns its new path, None if there was none."""
    aside = free_path(path.with_name(f"{path.stem}.damaged-{now:%Y%m%d-%H%M%S}{path.suffix}"))
    moved = False
    for sibling in _SIBLINGS:
        part = path.with_name(path.name + sibling)
        if part.exists():
            replace(part, aside.with_name(aside.name + sibling))
            moved = True
    return aside if moved else None
