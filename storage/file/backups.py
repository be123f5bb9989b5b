"""Copies of the file in the folder `backups` beside it: made while the app goes on, kept for a while by size.

A number in the name orders them, the time is for people: clocks of school PCs are often wrong, and a copy made in
what the PC took for 2099 must not be the newest for ever.
"""

import contextlib
import errno
import os
import re
import shutil
import sqlite3
import threading
import time
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path

from storage.errors import StoreError, translated
from storage.places import Free, free_bytes
from storage.schema import migrate

Stop = Callable[[], bool]
Remove = Callable[[sqlite3.Connection, Collection[str]], object]

EVERY = timedelta(hours=24)
_LATEST = 3  # a PC whose battery is empty has the same day every day
_DAYS = 14
_WEEKS = 8
_MOST_BYTES = 10**9
_LEFT_FREE = 50 * 10**6  # a backup must not take from the store the room it needs to go on
_PAGES = 256
_PAUSE_S = 0.002
_RESTARTS = 20
_STEPS_BETWEEN_STOPS = 10_000
_TIME = "%Y%m%dT%H%M%SZ"
# what is deleted for good must not come back by a copy that was begun before and is whole after
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


def list_backups(path: Path) -> list[Backup]:
    """Backups of a database, the newest first; what else lies in the folder is not looked at."""
    name = re.compile(rf"{re.escape(path.stem)}-(\d+)-(\d{{8}}T\d{{6}}Z){re.escape(path.suffix)}")
    found = []
    with contextlib.suppress(OSError):
        for file in folder_of(path).iterdir():
            if match := name.fullmatch(file.name):
                with contextlib.suppress(ValueError, OSError):
                    made_at = datetime.strptime(match[2], _TIME).replace(tzinfo=UTC)
                    found.append(Backup(file, int(match[1]), made_at, file.stat().st_size))
    return sorted(found, key=lambda backup: backup.number, reverse=True)


def is_due(path: Path, now: datetime) -> bool:
    """True when the newest is a day old, or seems to come from the future because the clock was set back."""
    newest = next(iter(list_backups(path)), None)
    return newest is None or not timedelta(0) <= now - newest.made_at < EVERY


def make_backup(
    path: Path, now: datetime, *, free: Free = free_bytes, stop: Stop = lambda: False
) -> Backup | None:
    """Copies the file as it is at this moment; nobody who reads or writes it waits. None when stopped.

    What is no longer to be kept goes afterwards. A backup that cannot be finished leaves nothing.

    Args:
        free: bytes that are free where a folder lies.
        stop: asked every few milliseconds.

    Raises:
        StoreError: `backup_no_room`; `backup_found_damage` when the copy is not sound, so neither is the
            file; `backup_failed`.
    """
    try:
        with _at_work:
            _require_room(path, free)
            with _part_of(_next_place(path, now)) as part:
                _copy(path, part, stop)
                _require_sound(part, path, stop)
                shutil.copymode(path, part)
            remove_surplus(path, free=free)
    except _StoppedError:
        return None
    except sqlite3.Error as error:
        raise _given_up(path, translated(error, path).code, str(error)) from error
    except OSError as error:
        code = "disk_full" if _is_full(error) else ""
        raise _given_up(path, code, str(error.strerror)) from error
    return list_backups(path)[0]


def _next_place(path: Path, now: datetime) -> Path:
    folder = folder_of(path)
    folder.mkdir(exist_ok=True)
    for left in folder.glob("*.part"):  # by a power cut
        left.unlink()
    number = max((backup.number for backup in list_backups(path)), default=0) + 1
    return folder / f"{path.stem}-{number:05d}-{now.astimezone(UTC):{_TIME}}{path.suffix}"


def remove_surplus(path: Path, *, free: Free = free_bytes) -> None:
    """Deletes what is no longer to be kept: see `kept`."""
    backups = list_backups(path)
    total = sum(backup.size_bytes for backup in backups)
    with contextlib.suppress(OSError):  # tried again with the next one
        limit = min(_MOST_BYTES, (free(folder_of(path)) + total) // 10)
        for backup in set(backups).difference(kept(backups, limit)):
            backup.path.unlink()


def kept(backups: Sequence[Backup], limit_bytes: int) -> list[Backup]:
    """Of backups, the newest first, those worth their room: the last three, then the last of each day.

    Days and weeks are those on which there were backups, 14 days and before them 8 weeks: so neither holidays
    nor a wrong clock make all of them old at once. The oldest go when together they are too large, the newest
    never does.
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
            with _part_of(target) as part:
                shutil.copyfile(backup.path, part)
        except OSError as error:
            if _is_full(error):
                raise StoreError("disk_full", path=str(path)) from error
            raise
        if _is_good(target, is_ours):
            return backup
        target.unlink()
    return None


def remove_from_backups(
    path: Path, ids: Collection[str], remove: Remove, stop: Stop = lambda: False
) -> list[Path]:
    """Takes rows out of every backup, so that what was deleted is nowhere; each is replaced as a whole.

    One that keeps the keys as deleted is left as it is: the same again, after it was cut off, does the rest.

    Args:
        ids: keys of what goes, with all that belongs to it.
        remove: deletes them within a transaction, as from the file itself, and keeps the keys.
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
            and not _knows(backup.path, ids)
            and not _is_removed(backup.path, path, ids, remove)
        ]
    return left + sorted(path.parent.glob(f"{path.stem}.damaged-*{path.suffix}"))


def damage_of(file: Path, stop: Stop = lambda: False) -> str | None:
    """What SQLite finds wrong with a file that nobody writes; None when all is well."""
    try:
        with closing(_reading(file)) as connection:
            connection.set_progress_handler(stop, _STEPS_BETWEEN_STOPS)
            finding = str(connection.execute("PRAGMA integrity_check(1)").fetchone()[0])
    except sqlite3.Error as error:
        if stop():
            raise _StoppedError from error
        return str(error)
    return None if finding == "ok" else finding


@contextlib.contextmanager
def _part_of(final: Path) -> Iterator[Path]:
    """A file to be filled, which takes its place only when it is whole and on disk; gone if it is not."""
    part = final.with_name(f"{final.name}.part")
    try:
        yield part
        _sync(part)
        part.replace(final)
        if os.name == "posix":
            _sync(final.parent)
    finally:
        for suffix in ("", "-journal"):
            part.with_name(part.name + suffix).unlink(missing_ok=True)


def _copy(path: Path, part: Path, stop: Stop) -> None:
    address = f"{path.absolute().as_uri()}?mode=rw"
    with (
        closing(sqlite3.connect(address, uri=True, isolation_level=None)) as source,
        closing(sqlite3.connect(part, isolation_level=None)) as target,
    ):
        if source.execute("PRAGMA journal_mode").fetchone()[0] == "wal":
            # one moment of the file, while others write on; without it, each write would begin the copy anew.
            # A file without WAL cannot be held like this: its writers would wait.
            source.execute("BEGIN")
            source.execute("SELECT count(*) FROM sqlite_master").fetchone()
        target.execute("PRAGMA synchronous = OFF")  # `_part_of` sees to it, once
        source.backup(target, pages=_PAGES, progress=_breather(stop))


def _breather(stop: Stop) -> Callable[[int, int, int], None]:
    """Between two steps of a copy: lets others have the disk, and gives up where it would never end."""
    before, restarts = 2**62, 0

    def breathe(_status: int, remaining: int, _total: int) -> None:
        nonlocal before, restarts
        restarts += remaining > before
        before = remaining
        if restarts > _RESTARTS:
            raise sqlite3.OperationalError("written all the time")
        if stop():
            raise _StoppedError
        time.sleep(_PAUSE_S)

    return breathe


def _knows(backup: Path, ids: Collection[str]) -> bool:
    """A backup is replaced as a whole, so one that knows the keys holds nothing of what they were."""
    try:
        with closing(_reading(backup)) as connection:
            known = {key for (key,) in connection.execute("SELECT id FROM tombstones")}
    except sqlite3.Error:
        return False
    return known.issuperset(ids)


def _is_removed(backup: Path, path: Path, ids: Collection[str], remove: Remove) -> bool:
    try:
        with _part_of(backup) as part:
            shutil.copy2(backup, part)
            _remove(part, ids, remove)
            _require_sound(part, path, lambda: False)
    except (sqlite3.Error, OSError, StoreError):
        return False
    return True


def _remove(file: Path, ids: Collection[str], remove: Remove) -> None:
    with closing(sqlite3.connect(file, isolation_level=None)) as connection:
        connection.row_factory = sqlite3.Row
        connection.execute("PRAGMA journal_mode = DELETE")
        connection.execute("PRAGMA foreign_keys = ON")
        migrate(connection)
        connection.execute("BEGIN IMMEDIATE")
        remove(connection, ids)
        connection.execute("COMMIT")
        connection.execute("VACUUM")  # what was deleted is still there to be read before


def _is_good(file: Path, is_ours: Callable[[sqlite3.Connection], None]) -> bool:
    if damage_of(file) is not None:
        return False
    try:
        with closing(_reading(file)) as connection:
            is_ours(connection)
    except StoreError:
        return False
    return True


def _reading(file: Path) -> sqlite3.Connection:
    return sqlite3.connect(f"{file.absolute().as_uri()}?mode=ro&immutable=1", uri=True)


def _require_sound(part: Path, path: Path, stop: Stop) -> None:
    if problem := damage_of(part, stop):
        raise StoreError("backup_found_damage", path=str(path), problem=problem)


def _require_room(path: Path, free: Free) -> None:
    parts = (path, path.with_name(path.name + "-wal"))
    needed = sum(part.stat().st_size for part in parts if part.exists())
    if free(path.parent) < needed + _LEFT_FREE:
        raise StoreError("backup_no_room", folder=str(folder_of(path)))


def _given_up(path: Path, code: str, problem: str) -> StoreError:
    folder = str(folder_of(path))
    if code == "disk_full":
        return StoreError("backup_no_room", folder=folder)
    if code == "database_damaged":
        return StoreError("backup_found_damage", path=str(path), problem=problem)
    return StoreError("backup_failed", folder=folder, problem=problem)


def _is_full(error: OSError) -> bool:
    return error.errno in (errno.ENOSPC, errno.EDQUOT)


def _sync(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY if path.is_dir() else os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
