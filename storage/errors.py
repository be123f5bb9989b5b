"""Errors of the store: a code, and the parameters of its message."""

import contextlib
import errno
import os
import shutil
import sys
from pathlib import Path

from storage.sqlite import sqlite3

_BY_PREFIX = {
    "SQLITE_FULL": "disk_full",
    "SQLITE_READONLY": "database_read_only",
    "SQLITE_CANTOPEN": "database_read_only",
    "SQLITE_PERM": "database_read_only",
    "SQLITE_BUSY": "database_locked",
    "SQLITE_LOCKED": "database_locked",
    "SQLITE_CORRUPT": "database_damaged",
    "SQLITE_NOTADB": "database_damaged",
}
# SQLite's messages by error name: pysqlite3 gives no name for an error of a backup (sqlite.org/c3ref/errcode.html)
_NAMES = {
    "database or disk is full": "SQLITE_FULL",
    "attempt to write a readonly database": "SQLITE_READONLY",
    "unable to open database file": "SQLITE_CANTOPEN",
    "database is locked": "SQLITE_BUSY",
    "database table is locked": "SQLITE_LOCKED",
    "database disk image is malformed": "SQLITE_CORRUPT",
    "file is not a database": "SQLITE_NOTADB",
    "disk I/O error": "SQLITE_IOERR",
}
_NEARLY_FULL = 2**20
_PROBE = 2**16


class StoreError(Exception):
    """An error that a person can act on; the application has the messages of the codes.

    Codes: `disk_full`, `database_read_only`, `database_locked`, `database_damaged`, `database_newer`,
    `database_older`, `database_foreign`, `database_is_bundle`, `database_unreadable`, `database_failed`;
    `group_not_found`, `program_not_found`, `version_not_found`, `run_not_found`, `classroom_not_found`,
    `lesson_not_found`, `note_not_found`, `taught_sign_not_found`; `group_exists`, `classroom_exists`, `name_empty`,
    `name_too_long`, `note_empty`, `note_too_long`, `color_unknown`, `picture_unknown`, `pattern_unknown`,
    `lesson_not_joinable`,
    `sign_name_wrong`, `sign_taught_enough`, `signs_too_many`, `own_activity_not_found`, `own_activities_too_many`,
    `calibrated_robot_not_found`, `calibrated_robots_too_many`,
    `version_damaged`, `run_damaged`, `bundle_not_lesson`, `lesson_without_class`, `work_unreadable`.
    """

    def __init__(self, code: str, **params: object) -> None:
        super().__init__(f"{code} {params}" if params else code)
        self.code = code
        self.params: dict[str, object] = params


def translated(error: sqlite3.Error, path: Path) -> StoreError:
    """Translates an error of SQLite."""
    name = error_name(error)
    for prefix, by_prefix in _BY_PREFIX.items():
        if name.startswith(prefix):
            return StoreError(by_prefix, path=str(path))
    if name.startswith("SQLITE_IOERR") and (code := _why_not_writable(path)):
        return StoreError(code, path=str(path))
    return StoreError("database_failed", path=str(path), problem=str(error))


def error_name(error: BaseException) -> str:
    """Returns SQLite's name of an error, such as `SQLITE_FULL`; empty for errors that are not SQLite's."""
    return str(getattr(error, "sqlite_errorname", "")) or _NAMES.get(str(error), "")


def is_full(error: OSError) -> bool:
    """Returns True if the disk, this user's quota or the maximum size of a file is used up."""
    return error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


def _why_not_writable(path: Path) -> str | None:
    """Returns the code of the cause that prevents writing, if SQLite reports only an I/O error."""
    error = _error_of_writing(path)
    if error is not None and error.errno == errno.EROFS:  # Linux makes a disk with errors read-only
        return "database_read_only"
    is_without_room = _is_nearly_full(path) or _is_file_limit_reached(path)
    return "disk_full" if is_without_room or (error and is_full(error)) else None


def _is_nearly_full(path: Path) -> bool:
    try:
        return shutil.disk_usage(path.parent).free < _NEARLY_FULL
    except OSError:
        return False


def _is_file_limit_reached(path: Path) -> bool:
    """Returns True if the user's limit on file size (`ulimit -f`) is below the size that file and WAL need."""
    if sys.platform == "win32":
        return False
    import resource  # noqa: PLC0415 - not available on every system

    limit, _ = resource.getrlimit(resource.RLIMIT_FSIZE)
    return limit != resource.RLIM_INFINITY and _size_with_wal(path) + _PROBE > limit


def _size_with_wal(path: Path) -> int:
    size = 0
    for part in (path, path.with_name(path.name + "-wal")):
        with contextlib.suppress(OSError):
            size += part.stat().st_size
    return size


def _error_of_writing(path: Path) -> OSError | None:
    """Returns the system's error when something is written beside the file, None if that works."""
    import tempfile  # noqa: PLC0415 - rarely needed

    try:
        with tempfile.TemporaryFile(dir=path.parent) as file:
            file.write(bytes(_PROBE))
            file.flush()
            os.fsync(file.fileno())
    except OSError as error:
        return error
    return None
