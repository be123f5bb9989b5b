"""Backups: copies of the file in the folder `backups` beside it, made while the app works.

The number in a file name orders backups. The time in the name is for people only: clocks of school PCs are often wrong,
and a copy dated 2099 must not be the newest for ever.
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
from storage.file.open_files import delete
from storage.file.row_checksums import ChangedRows
from storage.sql import Stop, column_names, integrity_problem, opened
from storage.sqlite import sqlite3
from storage.tables.migrations import migrate

Remove = Callable[[sqlite3.Connection, Collection[str]], object]

EVERY = timedelta(hours=24)
EVERY_HOUR = timedelta(hours=1)
_LATEST = 3  # whatever their day: a PC whose battery is empty has the same day every day
_DAYS = 14
_WEEKS = 8
_MAX_BYTES = 10**9
_LEFT_FREE = 50 * 10**6  # bytes; the store needs space to grow beside a backup
_PAGES = 256
_PAUSE_S = 0.002
_RESTARTS = 20
_TIME = "%Y%m%dT%H%M%SZ"
# a copy that started before a deletion and ended after it would hold the deleted rows
_at_work = threading.Lock()


@dataclass(frozen=True, slots=True)
class Backup:
    """A copy of the file, intact when it was made. The clock's time may be wrong; the number is not."""

    path: Path
    number: int
    made_at: datetime
    size_bytes: int


class _StoppedError(Exception):
    pass


def folder_of(path: Path) -> Path:
    """Returns the folder of a database's backups."""
    return path.parent / "backups"


def list_backups(path: Path, folder: Path | None = None) -> list[Backup]:
    """Returns the backups of a database, newest first; ignores other files of the folder, by default its own."""
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
    """Returns the time in the name of a backup. Raises ValueError."""
    return datetime.strptime(backup.stem.rpartition("-")[2], _TIME).replace(tzinfo=UTC)


def is_due(path: Path, now: datetime, n_saves: int) -> bool:
    """Returns True if the newest backup is a day old, or an hour old and lacks commits.

    Also if its time is in the future, because the clock was set back.

    Args:
        n_saves: commits that the database has counted (see `commit_counter`).
    """
    newest = next(iter(list_backups(path)), None)
    if newest is None:
        return True
    age = now - newest.made_at
    return not timedelta(0) <= age < (EVERY_HOUR if lacks_work(newest, n_saves) else EVERY)


def lacks_work(backup: Backup, n_saves: int) -> bool:
    """Returns True if the database has commits that the backup lacks."""
    with contextlib.suppress(sqlite3.Error), closing(opened(backup.path, "immutable")) as db:
        return commit_count(db) != n_saves
    return True


def make_backup(
    path: Path, now: datetime, *, free: Free = free_bytes, stop: Stop = lambda: False
) -> Backup | None:
    """Copies the file as it is at this moment; readers and writers do not wait. Returns None if stopped.

    Afterwards deletes backups that need not be retained. A backup that fails leaves no file.

    Args:
        free: returns the free bytes on the disk of a folder.
        stop: polled every few milliseconds.

    Raises:
        StoreError: `backup_no_room`; `backup_found_damage` if the copy is damaged, as the file is then too;
            `backup_failed`.
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
    for left in folder.glob("*.part"):  # left by a power cut
        delete(left)
    number = max((backup.number for backup in list_backups(path)), default=0) + 1
    return folder / f"{path.stem}-{number:05d}-{now.astimezone(UTC):{_TIME}}{path.suffix}"


def prune(path: Path, *, free: Free = free_bytes) -> None:
    """Deletes the backups that are not in `retained_backups`."""
    backups = list_backups(path)
    total = sum(backup.size_bytes for backup in backups)
    with contextlib.suppress(OSError):  # the next backup tries again
        limit = min(_MAX_BYTES, (free(folder_of(path)) + total) // 10)
        for backup in set(backups).difference(retained_backups(backups, limit)):
            delete(backup.path)


def retained_backups(backups: Sequence[Backup], limit_bytes: int) -> list[Backup]:
    """Returns the backups to retain: the last three, then the last of each day, then the last of each week.

    Only days and weeks with backups count, 14 days and before them 8 weeks. So neither holidays nor a wrong clock make
    all backups old at once. If all together are too large, the oldest are left out, but never the newest.

    Args:
        backups: newest first.
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
    """Copies the newest intact backup to `target`; returns the backup, None if there is none.

    Args:
        is_ours: raises StoreError for a file that must not be used.

    Raises:
        StoreError: `disk_full`; `database_newer` if a newer release made the backup, as an older one would bring back
            less work; nothing has changed.
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
        delete(target)
    return None


def remove_from_backups(
    path: Path, ids: Collection[str], remove: Remove, stop: Stop = lambda: False
) -> list[Path]:
    """Deletes rows from every backup, so that deleted rows are nowhere. Replaces each backup as a whole.

    Skips a backup that has tombstones of the keys, so a repeated call completes an interrupted one.

    Args:
        ids: keys of the rows, which are deleted with all rows that belong to them.
        remove: deletes them within a transaction, as from the file itself, and adds tombstones.
        stop: polled before each backup.

    Returns:
        Files that may still hold the rows: backups that could not be rewritten, and damaged files that were set
        aside. People must be informed of them.
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
    """Returns the problem that SQLite finds in a file that nobody writes; None for none."""
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
            # one snapshot of the file while others write; otherwise each write would restart the copy.
            # A file without WAL has no such snapshot: its writers would wait.
            source.execute("BEGIN")
            source.execute("SELECT count(*) FROM sqlite_master").fetchone()
        target.execute("PRAGMA synchronous = OFF")  # `atomic_write` syncs once, at the end
        source.backup(target, pages=_PAGES, progress=_pauses(stop))


def _pauses(stop: Stop) -> Callable[[int, int, int], None]:
    """Returns the callback between two steps of a copy: pauses, and ends a copy that restarts too often."""
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
    """Returns True if a backup has tombstones of all keys: it is replaced as a whole, so it lacks their rows then."""
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
        changes.update_checksums(db)  # checksums are deleted with their rows
        db.execute("COMMIT")
        db.execute("VACUUM")  # otherwise free pages would still hold the deleted texts


def _is_good(file: Path, is_ours: Callable[[sqlite3.Connection], None]) -> bool:
    if damage_of(file) is not None:
        return False
    try:
        with closing(opened(file, "immutable")) as db:
            is_ours(db)
    except StoreError as error:
        if error.code == "database_newer":
            raise
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
