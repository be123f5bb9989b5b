"""Opens the file in any state: damaged, read-only, of a newer release, or of another program."""

import contextlib
import math
import os
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from storage.errors import StoreError, error_name, translated
from storage.file import log
from storage.file.commit_counter import (
    CommitRecord,
    commit_count,
    ensure_counter,
    read_counter,
    write_counter,
)
from storage.file.filesystems import is_on_share
from storage.file.invalid_values import damaged_ids, repair_settings
from storage.file.notices import Notice
from storage.file.private import PRIVATE_FOLDER
from storage.file.replacing import (
    SalvageInto,
    finish_replacing,
    is_lost_file,
    repair_wal_tail,
    replace_damaged,
    rollback_notice,
)
from storage.sql import address, integrity_problem
from storage.sqlite import sqlite3
from storage.tables.ddl import BASELINE, MIGRATIONS
from storage.tables.migrations import MIGRATION_SET, MIGRATIONS_TABLE, migrate
from storage.text import IS_ID, continue_after, from_json, local_time, time_text

_BUSY_S = 5.0
# queries for the newest id that this PC made; if the newest 2000 rows are of other PCs, `merges` gives a bound
_MADE_HERE = (
    *(f"SELECT max(id) FROM {table} WHERE {IS_ID}" for table in ("merges", "exports")),
    *(
        f"""SELECT max(id) FROM (SELECT id, computer_id FROM {table} ORDER BY id DESC LIMIT 2000)
            WHERE {IS_ID} AND (computer_id IS NULL OR computer_id = :this)"""
        for table in ("runs", "versions")
    ),
)
_EMPTY = ("missing", "empty")
_CHUNK = 2**20


@dataclass(frozen=True, slots=True)
class OpenPlan:
    """The address to connect to, and whether writing is possible."""

    address: str
    writable: bool
    notice: Notice | None


def connect(address: str) -> sqlite3.Connection:
    """Returns a connection in autocommit mode, for use by one thread at a time."""
    connection = sqlite3.connect(
        address, uri=True, timeout=_BUSY_S, isolation_level=None, check_same_thread=False
    )
    connection.row_factory = sqlite3.Row
    connection.execute("PRAGMA foreign_keys = ON")
    connection.execute("PRAGMA synchronous = FULL")  # schools cut the power
    connection.execute("PRAGMA wal_autocheckpoint = 0")  # only the writer empties the log
    return connection


def prepare(path: Path, now: datetime, salvage_into: SalvageInto | None = None) -> OpenPlan:
    """Makes the file ready: replaces a damaged file by its last intact backup and applies missing migrations.

    Args:
        salvage_into: merges the readable rows of a damaged file into the file that replaces it.

    Raises:
        StoreError: `database_newer`, `database_foreign` or `database_is_bundle` with the file untouched;
            `database_read_only`, `disk_full` if not even reading is possible; `database_locked`, `database_failed`.
    """
    try:
        found = _examined(path, now, salvage_into)
        trouble = _migrate(path, now)
        return OpenPlan(address(path, "rwc"), writable=True, notice=found or trouble)
    except _ReadOnlyError as stop:
        return OpenPlan(stop.address, writable=False, notice=_of_read_only(path, stop.address))
    except (sqlite3.Error, StoreError) as error:
        return _shown_on_full_disk(path, error)
    except OSError as error:
        raise StoreError("database_read_only", path=str(path), problem=error.strerror) from error


def _shown_on_full_disk(path: Path, error: sqlite3.Error | StoreError) -> OpenPlan:
    """Returns how to read an intact file whose disk has no space for SQLite's own files. Else raises StoreError."""
    problem = error if isinstance(error, StoreError) else translated(error, path)
    if problem.code == "disk_full":
        with contextlib.suppress(sqlite3.Error, StoreError):
            readable = _readable_address(path)
            with closing(_tried(readable)) as connection:
                _check_ownership(connection, path)
                if integrity_problem(connection, "quick_check") is None:
                    notice = _of_read_only(path, readable, "disk_full_at_start")
                    return OpenPlan(readable, writable=False, notice=notice)
    raise problem


def prepare_reading(path: Path) -> OpenPlan:
    """Returns how to read the file as it is. Writes, creates and renames nothing, not even beside the file.

    Raises:
        StoreError: `database_damaged`, `database_older`, `database_newer`, `database_foreign`,
            `database_is_bundle`, `database_unreadable`; `database_locked`, `database_failed`.
    """
    try:
        unchanged = _untouching_address(path)
        with closing(_tried(unchanged)) as connection:
            if integrity_problem(connection, "quick_check") is not None:
                raise StoreError("database_damaged", path=str(path))
            _check_ownership(connection, path)
            if _tables(connection) and _applied(connection) == MIGRATIONS.keys():
                return OpenPlan(unchanged, writable=False, notice=None)
    except sqlite3.Error as error:
        problem = translated(error, path)
        if problem.code != "database_read_only":
            raise problem from error
        raise StoreError("database_unreadable", path=str(path)) from error
    raise StoreError("database_older", path=str(path))


class _ReadOnlyError(Exception):
    def __init__(self, address: str) -> None:
        super().__init__(address)
        self.address = address


def _examined(path: Path, now: datetime, salvage_into: SalvageInto | None) -> Notice | None:
    """Inspects the file without writing to it; replaces it if it is damaged or lost."""
    if path.exists() and not path.is_file():  # a folder or a pipe: reading might never end
        raise StoreError("database_failed", path=str(path), problem=f"{path}: no file")
    path.parent.mkdir(PRIVATE_FOLDER, parents=True, exist_ok=True)
    finish_replacing(path)
    known = read_counter(path)  # before the file is read, as another program may commit meanwhile
    problem, n_saves = _inspect(path)
    if problem in _EMPTY and not is_lost_file(path, by_log=problem == "missing"):
        return None  # the first start
    if problem:
        return replace_damaged(path, problem, now, lambda db: _require_ours(db, path), salvage_into)
    return _examined_end(path, known, n_saves, now, salvage_into)


def _inspect(path: Path) -> tuple[str, int]:
    """Returns the problem of the file, "" for none, and its commit count."""
    if not path.exists() or not path.stat().st_size:
        return "missing", 0
    try:
        with closing(_connect_reading(path)) as connection:
            if problem := integrity_problem(connection, "quick_check"):
                return problem, 0
            if not _tables(connection):
                return "empty", 0
            _check_ownership(connection, path)
            is_current = _applied(connection) == MIGRATIONS.keys()
            return damaged_ids(connection) if is_current else "", commit_count(connection)
    except sqlite3.DatabaseError as error:
        if not _is_damage(error, path):
            raise
        return str(error), 0


def _is_damage(error: sqlite3.Error, path: Path) -> bool:
    """Returns whether an error of opening means wrong bytes in the file.

    SQLite reports only "disk I/O error" for some truncated files with a log, though every byte can be read.
    """
    code = translated(error, path).code
    if code != "database_failed" or error_name(error) != "SQLITE_IOERR":
        return code == "database_damaged"
    return all(_can_be_read(part) for part in (path, log.path_of(path)) if part.exists())


def _can_be_read(file: Path) -> bool:
    try:
        with file.open("rb") as opened:
            while opened.read(_CHUNK):
                pass
    except OSError:
        return False
    return True


def _examined_end(
    path: Path,
    known: CommitRecord | None,
    n_saves: int,
    now: datetime,
    salvage_into: SalvageInto | None,
) -> Notice | None:
    """Checks by log and commit counter whether commits were lost; salvages them, or returns a rollback notice."""
    is_behind = known is not None and n_saves < known.n_saves
    n_cut_off = log.lost_commits(path) if is_behind or known is None else 0
    notice = repair_wal_tail(path, now, salvage_into) if n_cut_off else None
    if notice or not is_behind or known is None:
        return notice
    # so the notice comes once: a person may have restored an earlier copy on purpose
    write_counter(path, n_saves, known.at)
    return rollback_notice(path, known, n_saves)


def _connect_reading(path: Path) -> sqlite3.Connection:
    try:
        return _tried(address(path, "ro"))
    except sqlite3.OperationalError as error:
        if translated(error, path).code != "database_read_only":
            raise
        # a file in WAL mode in a read-only folder can only be read as immutable
        return _tried(address(path, "immutable"))


def _tried(address: str) -> sqlite3.Connection:
    connection = connect(address)
    try:
        connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
    except BaseException:
        connection.close()
        raise
    return connection


def _check_ownership(connection: sqlite3.Connection, path: Path) -> None:
    tables = _tables(connection)
    if not tables:
        return
    if MIGRATIONS_TABLE not in tables:
        raise StoreError("database_foreign", path=str(path))
    applied = _applied(connection)
    if not applied and tables == {MIGRATIONS_TABLE} and not _migrations_of_others(connection):
        return  # the power was cut while the file was being made
    if not applied.issuperset(BASELINE):
        raise StoreError("database_foreign", path=str(path))
    if applied - MIGRATIONS.keys():
        raise StoreError("database_newer", path=str(path))
    if "bundle" in tables:  # other PCs would refuse it as a bundle once it has other work
        raise StoreError("database_is_bundle", path=str(path))


def _tables(connection: sqlite3.Connection) -> set[str]:
    rows = connection.execute(
        "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite\\_%' ESCAPE '\\'"
    )
    return {str(row[0]) for row in rows}


def _migrations_of_others(connection: sqlite3.Connection) -> bool:
    query = f"SELECT 1 FROM {MIGRATIONS_TABLE} WHERE migration_set != ?"
    return connection.execute(query, [MIGRATION_SET]).fetchone() is not None


def _applied(connection: sqlite3.Connection) -> set[str]:
    rows = connection.execute(
        f"SELECT name FROM {MIGRATIONS_TABLE} WHERE migration_set = ?", [MIGRATION_SET]
    )
    return {str(row[0]) for row in rows}


def _require_ours(connection: sqlite3.Connection, path: Path) -> None:
    if not _tables(connection):
        raise StoreError("database_foreign", path=str(path))
    _check_ownership(connection, path)


def _migrate(path: Path, now: datetime) -> Notice | None:
    """Applies missing migrations; raises _ReadOnlyError if the file can be read but not written."""
    if path.exists() and not os.access(path, os.W_OK):
        # if a WAL and its index were left on a read-only disk, SQLite would notice only at the first write
        raise _ReadOnlyError(_readable_address(path))
    try:
        with closing(_connect_writing(path)) as connection, _reporting_full_disk(path):
            notice = _choose_journal(connection, path)
            connection.execute("BEGIN IMMEDIATE")
            connection.execute("ROLLBACK")
            is_initialised = MIGRATIONS_TABLE in _tables(connection)
            applied = _applied(connection) if is_initialised else set()
            if applied and applied != MIGRATIONS.keys():
                notice = _back_up(path, now) or notice
            if applied != MIGRATIONS.keys():
                migrate(connection, at_once=not is_initialised)
            repair_notice = repair_settings(connection, path)
            _continue_ids(connection)
            ensure_counter(path, commit_count(connection), time_text(now))
            return notice or repair_notice
    except sqlite3.OperationalError as error:
        if translated(error, path).code != "database_read_only" or not path.exists():
            raise
        raise _ReadOnlyError(_readable_address(path)) from error


@contextlib.contextmanager
def _reporting_full_disk(path: Path) -> Iterator[None]:
    """Raises `disk_full` before closing deletes the WAL, whose size may be the only evidence of a full disk."""
    try:
        yield
    except sqlite3.Error as error:
        problem = translated(error, path)
        if problem.code == "disk_full":
            raise problem from error
        raise


def _continue_ids(connection: sqlite3.Connection) -> None:
    """Makes new ids greater than all made here: lists sort by id, and an empty battery sets the clock to 2010."""
    key = connection.execute("SELECT value FROM settings WHERE key = 'computer_id'").fetchone()
    computer = from_json(key[0]) if key else None
    for query in _MADE_HERE:
        continue_after(connection.execute(query, {"this": computer}).fetchone()[0] or "")


def _back_up(path: Path, now: datetime) -> Notice | None:
    from storage.file.backups import make_backup  # noqa: PLC0415 - few starts need it

    try:
        make_backup(path, now)
    except StoreError as error:  # migrates without backup, as each migration is a transaction
        return Notice(error.code, error.params)
    return None


def _choose_journal(connection: sqlite3.Connection, path: Path) -> Notice | None:
    """Chooses WAL, unless processes cannot share its index: on a network share, or if SQLite refuses WAL."""
    if not is_on_share(path.parent):
        mode = connection.execute("PRAGMA journal_mode = WAL").fetchone()[0]
        if mode == "wal":
            return None
    connection.execute("PRAGMA journal_mode = DELETE").fetchone()
    return Notice("database_on_share", {"path": str(path)})


def _connect_writing(path: Path) -> sqlite3.Connection:
    """Connects for writing, also to a file that was copied in WAL mode to a file system without shared memory."""
    writable = address(path, "rwc")
    try:
        return _tried(writable)
    except sqlite3.OperationalError as error:
        if translated(error, path).code != "database_read_only" or not path.exists():
            raise
        if not _may_write(path) or not _left_wal(path):
            raise
        return _tried(writable)


def _may_write(path: Path) -> bool:
    """Returns whether this user may write the file and create others beside it."""
    return os.access(path, os.W_OK) and os.access(path.parent, os.W_OK)


def _left_wal(path: Path) -> bool:
    with (
        contextlib.suppress(sqlite3.Error),
        closing(sqlite3.connect(address(path, "rwc"), uri=True, isolation_level=None)) as alone,
    ):
        alone.execute("PRAGMA locking_mode = EXCLUSIVE").fetchone()
        alone.execute("PRAGMA journal_mode = DELETE").fetchone()
        return True
    return False


def _readable_address(path: Path) -> str:
    """Returns the address that reads a file which cannot be written. Its tables must be up to date."""
    for mode in ("ro", "immutable"):
        readable = address(path, mode)
        try:
            with closing(_tried(readable)) as connection:
                if _applied(connection) == MIGRATIONS.keys():
                    return readable
        except sqlite3.OperationalError:
            continue
    raise StoreError("database_read_only", path=str(path))


def _of_read_only(path: Path, readable: str, code: str = "database_read_only") -> Notice:
    """Returns the notice of a read-only file. `immutable` reads it without its WAL, which may have the last edits."""
    wal = path.with_name(path.name + "-wal")
    if readable != address(path, "immutable") or not wal.exists() or not wal.stat().st_size:
        return Notice(code, {"path": str(path)})
    found = wal.stat()
    written_at = datetime.fromtimestamp(found.st_mtime, UTC)
    kb, time = math.ceil(found.st_size / 1000), local_time(written_at)
    about = {"path": str(path), "name": wal.name, "kb": kb, "time": time}
    return Notice("database_without_last_edits", about)


def _untouching_address(path: Path) -> str:
    """Returns the address that reads a file without creating anything beside it.

    A reader of a file in WAL mode creates the WAL if there is none. Without WAL nobody has the file open, so
    `immutable` is safe then.
    """
    has_wal = path.with_name(path.name + "-wal").exists()
    return address(path, "ro" if has_wal else "immutable")
