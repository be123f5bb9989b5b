"""Salvages a damaged file: merges its readable rows into an intact store, by `storage/exchange`.

Of two states of a row the newer wins. The store loses no row, and rows that were deleted for good stay deleted.
"""

import errno
import math
import shutil
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path

from storage.errors import StoreError
from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.merging import merge_attached
from storage.file.connection import Database
from storage.file.notices import SalvageResult
from storage.file.row_checksums import ChangedRows
from storage.file.temporary import temporary_folder
from storage.runs.runs import close_runs
from storage.salvage.damaged_rows import (
    import_damage_records,
    prefer_intact_rows,
    record_damaged_runs,
)
from storage.salvage.page_reader import roots
from storage.salvage.placeholder_rows import add_missing_parents
from storage.salvage.row_recovery import RecoveryStats, recover_rows
from storage.sql import column_names, opened
from storage.sqlite import sqlite3
from storage.tables.local import LOCAL
from storage.tables.migrations import migrate
from storage.text import new_id

_TIMEOUT_S = 20.0  # limit at the start of the app; `pinel salvage` has none
_LEFT_FREE = 50 * 10**6
# checksums are imported for damaged runs only; all other imported rows get new ones
_NOT_BROUGHT = ("merges", "content_sums")
_LOCAL = tuple(table for table in LOCAL if table.name not in _NOT_BROUGHT)


@dataclass(frozen=True, slots=True)
class RecoveredRows:
    """Readable rows of a damaged file, in a temporary database at `address`."""

    address: str
    found: RecoveryStats


def salvage_into(
    file: Path, target: Path, now: str, *, timeout_s: float = _TIMEOUT_S
) -> SalvageResult:
    """Merges the readable rows of a file, with the log beside it, into a database that nobody has open.

    Args:
        target: a restored backup, or a free path, where a new database is made.
        timeout_s: time limit of reading, in s; the rows found until then are merged.

    Raises:
        sqlite3.Error, OSError, StoreError: nothing was merged; the target is unchanged, or empty.
    """
    with (
        recovered_rows(file, now, beside=target, timeout_s=timeout_s) as found,
        closing(opened(target, "rwc")) as db,
    ):
        db.row_factory = sqlite3.Row
        db.execute("PRAGMA journal_mode = DELETE")
        db.execute("PRAGMA foreign_keys = ON")
        migrate(db)
        db.execute("ATTACH DATABASE ? AS bundle", [found.address])
        changes = ChangedRows(db)  # rows that get a newer state get new checksums
        _import_settings(db)
        try:
            return import_rows(db, found.found, now, changes, delete=True)
        except StoreError:  # a deletion does not fit the target, as of a run that has not ended
            return import_rows(db, found.found, now, changes, delete=False)


def salvage(database: Database, file: Path) -> SalvageResult:
    """Merges the readable rows of a file into a store; deletes nothing from it. Raises StoreError, OSError."""
    now = database.now()
    with recovered_rows(file, now, beside=database.path, timeout_s=math.inf) as found:
        return database.write(
            lambda db: merge_recovered_rows(db, found.found, now, delete=False),
            attached=found.address,
        )


@contextmanager
def recovered_rows(
    file: Path, now: str, *, beside: Path, timeout_s: float
) -> Iterator[RecoveredRows]:
    """Yields the readable rows of a file; only reads the file. Raises OSError, sqlite3.Error.

    Args:
        beside: the database that the rows are for; the temporary database is made in its folder.
        timeout_s: time limit of reading, in s.
    """
    deadline = time.monotonic() + timeout_s
    with temporary_folder(beside.parent) as folder:
        _require_free_space(file, beside)
        path = folder / "remains"
        with closing(opened(path, "rwc")) as db:
            db.row_factory = sqlite3.Row
            db.execute("PRAGMA journal_mode = OFF")
            db.execute("PRAGMA synchronous = OFF")
            migrate(db)
            usual = roots(path) | (roots(beside) if beside.exists() else {})
            found = recover_rows(db, file, folder, usual, lambda: time.monotonic() > deadline)
            record_damaged_runs(db, now)
            running = [
                row["id"] for row in db.execute("SELECT id FROM runs WHERE state = 'running'")
            ]
            close_runs(db, running, now)
        yield RecoveredRows(f"{path.absolute().as_uri()}?mode=rw", found)


def import_rows(
    db: sqlite3.Connection, found: RecoveryStats, now: str, changes: ChangedRows, *, delete: bool
) -> SalvageResult:
    """Merges the recovered rows, which are the schema `bundle`, in one transaction.

    Args:
        delete: also deletes the rows for which the recovered rows have tombstones.
    """
    with _transaction(db):
        salvaged = merge_recovered_rows(db, found, now, delete=delete)
        changes.update_checksums(db)
        return salvaged


def _import_settings(db: sqlite3.Connection) -> None:
    """Takes all settings from the damaged file, which is newer: a PIN that was replaced must not be valid again."""
    names = ", ".join(column_names(db, "settings"))
    db.execute(
        f"INSERT OR REPLACE INTO main.settings ({names}) SELECT {names} FROM bundle.settings WHERE json_valid(value)"
    )


def merge_recovered_rows(
    db: sqlite3.Connection, found: RecoveryStats, now: str, *, delete: bool
) -> SalvageResult:
    """Merges the recovered rows within the caller's transaction; see `import_rows`."""
    numbers = dict(_highest(db))
    add_missing_parents(db, now)
    prefer_intact_rows(db)
    info = _info(now)
    report = merge_attached(db, info, now, delete=delete)
    db.execute("DELETE FROM main.merges WHERE checksum = ?", [info.content_hash])
    for table in _LOCAL:
        names = ", ".join(column_names(db, table.name))
        db.execute(
            f"INSERT OR IGNORE INTO main.{table.name} ({names}) SELECT {names} FROM bundle.{table.name}"
        )
    import_damage_records(db)
    n_rows = sum(report.added.values()) + sum(report.changed.values())
    n_edits = report.added.get("versions", 0)
    return SalvageResult(n_edits, n_rows, _n_unread(db, found, numbers), found.is_cut_short)


def _info(now: str) -> BundleInfo:
    """Returns the description of a bundle that does not exist: recovered rows were never exported or merged."""
    return BundleInfo(Path("remains"), "", now, new_id(), "", f"{new_id()}", {}, False)


def _highest(db: sqlite3.Connection) -> Iterator[tuple[str, int]]:
    for row in db.execute("SELECT program_id, max(number) FROM main.versions GROUP BY program_id"):
        yield str(row[0]), int(row[1])


def _n_unread(db: sqlite3.Connection, found: RecoveryStats, before: dict[str, int]) -> int:
    """Returns how many edits are missing: an index lists them, or imported edits have greater numbers."""
    here: dict[str, set[int]] = {}
    for row in db.execute("SELECT program_id, number FROM main.versions"):
        here.setdefault(str(row[0]), set()).add(int(row[1]))
    tombstoned = {str(row[0]) for row in db.execute("SELECT id FROM main.tombstones")}
    missing = {(p, n) for p, n in found.edits if p not in tombstoned and n not in here.get(p, ())}
    for program, numbers in here.items():
        first = before.get(program, 0) + 1
        if (last := max(numbers)) - first < 10**6:
            missing |= {(program, n) for n in range(first, last) if n not in numbers}
    return len(missing)


def _require_free_space(file: Path, beside: Path) -> None:
    parts = (file, file.with_name(file.name + "-wal"))
    needed = sum(part.stat().st_size for part in parts if part.exists())
    if shutil.disk_usage(beside.parent).free < 3 * needed + _LEFT_FREE:
        raise OSError(errno.ENOSPC, "no room to read the damaged file")


@contextmanager
def _transaction(db: sqlite3.Connection) -> Iterator[None]:
    db.execute("BEGIN IMMEDIATE")
    try:
        yield
        db.execute("COMMIT")
    except BaseException:
        if db.in_transaction:
            db.execute("ROLLBACK")
        raise
