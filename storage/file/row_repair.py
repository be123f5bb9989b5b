"""Repairs damaged rows from the newest backup that has them intact, or from a merged bundle.

A row is intact if its content has the checksum that was stored with it (`row_checksums`), so no other content fits.
"""

import logging
from collections.abc import Mapping, Sequence
from contextlib import closing
from pathlib import Path

from storage.errors import StoreError
from storage.file.backups import list_backups
from storage.file.connection import Database
from storage.file.row_checksums import KEYS, content_checksum, is_intact, stored_checksum
from storage.sql import opened, tuples
from storage.sqlite import sqlite3

_log = logging.getLogger(__name__)
_Rows = list[tuple[object, ...]]


def try_repair(database: Database, table: str, key: str) -> bool:
    """Tries to repair a damaged row from the backups; returns whether it is intact now.

    If no backup has the row intact, it is recorded as damaged. If the file cannot be written, nothing is changed.
    """
    with database.read_connection() as db:
        right = stored_checksum(db, table, key)
    if right is None or not database.can_write:
        return False
    found = _right_rows(database.path, table, key, right)

    def write(db: sqlite3.Connection) -> bool:
        if is_intact(db, table, key):  # repaired meanwhile
            return True
        if found is None:
            record_damage(db, table, key, database.now())
            return False
        _put(db, table, key, *found)
        return is_intact(db, table, key)

    is_repaired = database.write(write)
    _log.warning("%s %s was damaged; mended from a backup: %s", table, key, is_repaired)
    return is_repaired


def record_damage(db: sqlite3.Connection, table: str, key: str, now: str) -> None:
    """Records when the damage was found first; a damaged run does not count as passed."""
    db.execute(
        "UPDATE content_sums SET damaged_at = ? WHERE table_name = ? AND row_id = ? AND damaged_at IS NULL",
        [now, table, key],
    )


def _right_rows(path: Path, table: str, key: str, right: str) -> tuple[Sequence[str], _Rows] | None:
    """Returns columns and rows from the newest backup that has them intact."""
    for backup in list_backups(path):
        try:
            with closing(opened(backup.path, "immutable")) as db:
                if content_checksum(db, table, key) == right:
                    return _rows(db, table, key)
        except (sqlite3.Error, StoreError):
            continue
    return None


def _rows(db: sqlite3.Connection, table: str, key: str) -> tuple[Sequence[str], _Rows]:
    cursor = tuples(db, f"SELECT * FROM {table} WHERE {KEYS[table]} = ?", (key,))
    names = [column[0] for column in cursor.description]
    return names, cursor.fetchall()


def _put(db: sqlite3.Connection, table: str, key: str, names: Sequence[str], rows: _Rows) -> None:
    """Replaces rows by the given ones. Updates a row that others refer to, instead of deleting it."""
    if table in ("versions", "runs"):
        assignments = ", ".join(f"{name} = ?" for name in names)
        changed = db.execute(f"UPDATE {table} SET {assignments} WHERE id = ?", [*rows[0], key])
        if changed.rowcount:
            return
        _remove_stray(db, table, dict(zip(names, rows[0], strict=True)))
    else:  # also deletes rows whose run is missing
        db.execute(
            f"DELETE FROM {table} WHERE run_id = ? OR run_id NOT IN (SELECT id FROM runs)", [key]
        )
    placeholders = ", ".join("?" for _ in names)
    db.executemany(f"INSERT INTO {table} ({', '.join(names)}) VALUES ({placeholders})", rows)


def _remove_stray(db: sqlite3.Connection, table: str, right: Mapping[str, object]) -> None:
    """Deletes the copy of the row under a damaged key, whose other values are all equal."""
    others = {name: value for name, value in right.items() if name != "id"}
    condition = " AND ".join(f"{name} IS :{name}" for name in others)
    db.execute(f"DELETE FROM {table} WHERE {condition}", others)
