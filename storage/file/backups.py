"""Backups: copies of the file in the folder `backups` beside it, made while the app works.

A number in the name orders them. The time in it is for people: clocks of school PCs are often wrong, and a copy made in
what the PC took for 2099 must not be the newest for ever.
"""

import contextlib
import re
import shutil
import threading
import time
from collections.abc import Callable, Collection, Sequence
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path

from storage.errors import StoreError, is_full, translated
from storage.file.atomic_files import atomic_write
from storage.file.commit_counter import commit_count
from storage.file.filesystems import Free, free_bytes
from storage.file.row_checksums import ChangedRows
from storage.sql import Stop, column_names, integrity_problem, opened
from storage.sqlite import sqlite3
from storage.tables.migrations import migrate

Remove = Callable[[sqlite3.Connection, Collection[str]], object]

EVERY = timedelta(hours=24)
EVERY_HOUR = timedelta(hours=1)
_LATEST = 3  # a PC whose battery is empty has the same day every day
_DAYS = 14
_WEEKS = 8
_MAX_BYTES = 10**9
_LEFT_FREE = 50 * 10**6  # the store needs room to grow beside a backup
_PAGES = 256
_PAUSE_S = 0.002
_RESTARTS = 20
_TIME = "%Y%m%dT%H%M%SZ"
# a copy that began before a deletion and ended after it would hold what was deleted
_at_work = threading.Lock()


@dataclass(frozen=True, slots=True)
class Backup:
    """A copy of the file, sound when it was made. The clock's time may be wrong; the number is not."""

    path: Path
    number: int
    made_at: datetime
    size_bytes: int


class _StoppedError(Exception):
    pass


def folder_of(path: Path) -> Path:
    """Where backups of a database lie."""
    return path.parent / "backups"


def list_backups(path: Path, folder: Path | None = None) -> list[Backup]:
    """Backups of a database, the newest first; other files of the folder, by default its own, are ignored."""
    name = re.compile(rf"{re.escape(path.stem)}-(\d+)-(\d{{8}}T\d{{6}}Z){re.escape(path.suffix)}")
    found = []
    with contextlib.suppress(OSError):
        for file in (folder or folder_of(path)).iterdir():
            if (match := name.fullmatch(file.name)) and file.is_file():
                with contextlib.suppress(ValueError, OSError):
                    number, made_at = int(match[1]), time_of(file)
                    found.append(Backup(file, number, made_at, file.stat().st_size))
    return sorted(found, key=lambda backup: backup.number, reverse=True)


def time_of(backup: Path) -> datetime:
    """The time in the name of a backup. Raises ValueError."""
    return datetime.strptime(backup.stem.rpartition("-")[2], _TIME).replace(tzinfo=UTC)


def is_due(path: Path, now: datetime, n_saves: int) -> bool:
    """True when the newest is a day old, or an hour old while there is work that it does not have, or seems to come
    from the future because the clock was set back.

    Args:
        n_saves: commits that the database has counted (see `mark`).
    """
    newest = next(iter(list_backups(path)), None)
    if newest is None:
        return True
    age = now - newest.made_at
    return not timedelta(0) <= age < (EVERY_HOUR if lacks_work(newest, n_saves) else EVERY)


def lacks_work(backup: Backup, n_saves: int) -> bool:
    """True where something was saved since the backup was made."""
    with contextlib.suppress(sqlite3.Error), closing(opened(backup.path, "immutable")) as db:
        return commit_count(db) != n_saves
    return True


def make_backup(
    path: Path, now: datetime, *, free: Free = free_bytes, stop: Stop = lambda: False
) -> Backup | None:
    """Copies the file as it is at this moment; readers and writers do not wait. None when stopped.

    Backups that are no longer worth keeping are deleted afterwards. A backup that cannot be finished leaves nothing.

    Args:
        free: bytes that are free where a folder lies.
        stop: asked every few milliseconds.

    Raises:
        StoreError: `backup_no_room`; `backup_found_damage` when the copy is not sound, so neither is the
            file; `backup_failed`.
    """
    try:
        with _at_work:
            _require_free_space(path, free)
            with atomic_write(_next_path(path, now)) as part:
                _copy(path, part, stop)
                _require_intact(part, path, stop)
                shutil.copymode(path, part)
            prune(path, free=free)
    except _StoppedError:
        return None
    except sqlite3.Error as error:
        raise _failure(path, translated(error, path).code, str(error)) from error
    except OSError as error:
        code = "disk_full" if is_full(error) else ""
        raise _failure(path, code, str(error.strerror)) from error
    return list_backups(path)[0]


def _next_path(path: Path, now: datetime) -> Path:
    folder = folder_of(path)
    folder.mkdir(exist_ok=True)
    for left in folder.glob("*.part"):  # by a power cut
        left.unlink()
    number = max((backup.number for backup in list_backups(path)), default=0) + 1
    return folder / f"{path.stem}-{number:05d}-{now.astimezone(UTC):{_TIME}}{path.suffix}"


def prune(path: Path, *, free: Free = free_bytes) -> None:
    """Deletes the backups that are not `worth_keeping`."""
    backups = list_backups(path)
    total = sum(backup.size_bytes for backup in backups)
    with contextlib.suppress(OSError):  # tried again with the next one
        limit = min(_MAX_BYTES, (free(folder_of(path)) + total) // 10)
        for backup in set(backups).difference(retained_backups(backups, limit)):
            backup.path.unlink()


def retained_backups(backups: Sequence[Backup], limit_bytes: int) -> list[Backup]:
    """Of backups, the newest first, the last three, then the last of each day, then the last of each week.

    Counted are the 14 days, and before them the 8 weeks, in which there were backups: so neither holidays nor a wrong
    clock make all of them old at once. The oldest are left out when together they are too large, the newest never is.
    """
    days: set[object] = set()
    weeks: set[object] = set()
    chosen: list[Backup] = []
    total = 0
    for backup in backups:
        day, week = backup.made_at.date(), backup.made_at.isocalendar()[:2]
        if len(chosen) < _LATEST or (day not in days and len(days) < _DAYS):
            days.add(day)
        elif day not in days and week not in weeks and len(weeks) < _WEEKS:
            weeks.add(week)
        else:
            continue
        total += backup.size_bytes
        if chosen and total > limit_bytes:
            break
        chosen.append(backup)
    return chosen


def restored_copy(
    path: Path, target: Path, is_ours: Callable[[sqlite3.Connection], None]
) -> Backup | None:
    """Puts a copy of the newest sound backup to `target` and tells which it is; None where there is none.

    Args:
        is_ours: raises StoreError for a file that is not to be used.

    Raises:
        StoreError: `disk_full`; nothing has changed.
        OSError: the folder cannot be written; nothing has changed.
    """
    for backup in list_backups(path):
        if not _is_good(backup.path, is_ours):
            continue
        try:
            with atomic_write(target) as part:
                shutil.copyfile(backup.path, part)
        except OSError as error:
            if is_full(error):
                raise StoreError("disk_full", path=str(path)) from error
            raise
        if _is_good(target, is_ours):
            return backup
        target.unlink()
    return None


def remove_from_backups(
    path: Path, ids: Collection[str], remove: Remove, stop: Stop = lambda: False
) -> list[Path]:
    """Deletes rows from every backup, so that what was deleted is nowhere; each backup is replaced as a whole.

    A backup that has tombstones of the keys is left as it is: the same again, after it was cut off, does the rest.

    Args:
        ids: keys of the rows, which are deleted with all that belongs to them.
        remove: deletes them within a transaction, as from the file itself, and adds tombstones.
        stop: asked before each backup.

    Returns:
        Files that may hold them still, for people to be told: backups that could not be written anew, and damaged
        files that were set aside.
    """
    with _at_work:
        left = [
            backup.path
            for backup in list_backups(path)
            if not stop()
            and not has_tombstones(backup.path, ids)
            and not _is_removed(backup.path, path, ids, remove)
        ]
    return left + sorted(path.parent.glob(f"{path.stem}.damaged-*{path.suffix}"))


def damage_of(file: Path, stop: Stop = lambda: False) -> str | None:
    """What SQLite finds wrong with a file that nobody writes; None when all is well."""
    try:
        with closing(opened(file, "immutable")) as db:
            return integrity_problem(db, stop=stop)
    except sqlite3.Error as error:
        if stop():
            raise _StoppedError from error
        return str(error)


def _copy(path: Path, part: Path, stop: Stop) -> None:
    with closing(opened(path, "rw")) as source, closing(opened(part, "rwc")) as target:
        if source.execute("PRAGMA journal_mode").fetchone()[0] == "wal":
            # one moment of the file, while others write on; without it, each write would begin the copy anew.
            # A file without WAL cannot be held like this: its writers would wait.
            source.execute("BEGIN")
            source.execute("SELECT count(*) FROM sqlite_master").fetchone()
        target.execute("PRAGMA synchronous = OFF")  # `whole_file` syncs once, at the end
        source.backup(target, pages=_PAGES, progress=_pauses(stop))


def _pauses(stop: Stop) -> Callable[[int, int, int], None]:
    """What is done between two steps of a copy: others get the disk, and a copy that begins anew too often ends."""
    before, restarts = 2**62, 0

    def pause(_status: int, remaining: int, _total: int) -> None:
        nonlocal before, restarts
        restarts += remaining > before
        before = remaining
        if restarts > _RESTARTS:
            raise sqlite3.OperationalError("written all the time")
        if stop():
            raise _StoppedError
        time.sleep(_PAUSE_S)

    return pause


def has_tombstones(backup: Path, ids: Collection[str]) -> bool:
    """True where a backup has tombstones of all keys: as a whole is replaced, it then holds nothing of their rows."""
    try:
        with closing(opened(backup, "immutable")) as db:
            tombstoned = {key for (key,) in db.execute("SELECT id FROM tombstones")}
            if column_names(db, "deletions"):
                retained = db.execute("SELECT id FROM deletions WHERE turn % 2")
                tombstoned -= {key for (key,) in retained}
            return tombstoned.issuperset(ids)
    except sqlite3.Error:
        return False


def _is_removed(backup: Path, path: Path, ids: Collection[str], remove: Remove) -> bool:
    try:
        with atomic_write(backup) as part:
            shutil.copy2(backup, part)
            _remove(part, ids, remove)
            _require_intact(part, path, lambda: False)
    except (sqlite3.Error, OSError, StoreError):
        return False
    return True


def _remove(file: Path, ids: Collection[str], remove: Remove) -> None:
    with closing(opened(file, "rw")) as db:
        db.row_factory = sqlite3.Row
        db.execute("PRAGMA journal_mode = DELETE")
        db.execute("PRAGMA foreign_keys = ON")
        migrate(db)
        changes = ChangedRows(db)
        db.execute("BEGIN IMMEDIATE")
        remove(db, ids)
        changes.update_checksums(db)  # the sums go with the rows
        db.execute("COMMIT")
        db.execute("VACUUM")  # the text of deleted rows is still in free pages before


def _is_good(file: Path, is_ours: Callable[[sqlite3.Connection], None]) -> bool:
    if damage_of(file) is not None:
        return False
    try:
        with closing(opened(file, "immutable")) as db:
            is_ours(db)
    except StoreError:
        return False
    return True


def _require_intact(part: Path, path: Path, stop: Stop) -> None:
    if problem := damage_of(part, stop):
        raise StoreError("backup_found_damage", path=str(path), problem=problem)


def _require_free_space(path: Path, free: Free) -> None:
    parts = (path, path.with_name(path.name + "-wal"))
    needed = sum(part.stat().st_size for part in parts if part.exists())
    if free(path.parent) < needed + _LEFT_FREE:
        raise StoreError("backup_no_room", folder=str(folder_of(path)))


def _failure(path: Path, code: str, problem: str) -> StoreError:
    folder = str(folder_of(path))
    if code == "disk_full":
        return StoreError("backup_no_room", folder=folder)
    if code == "database_damaged":
        return StoreError("backup_found_damage", path=str(path), problem=problem)
    return StoreError("backup_failed", folder=folder, problem=problem)
