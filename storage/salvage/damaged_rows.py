"""Rows of a damaged file that do not give the sum they had when they were written (`storage/file/row_checksums.py`).

A bit that flipped inside a value fits every rule of its table. A version that is not as it was written counts as
unread; what is left of a run is kept, marked as damaged, where the store has nothing better.
"""

from collections.abc import Iterator

from storage.file.row_checksums import OF_RUNS, content_checksum, copy_rows, is_intact
from storage.file.row_repair import record_damage
from storage.sql import tuples
from storage.sqlite import sqlite3

_DAMAGED = "SELECT table_name, row_id, sha256 FROM bundle.content_sums WHERE damaged_at IS NOT NULL"


def remove_damaged_versions(db: sqlite3.Connection) -> set[tuple[str, int]]:
    """Deletes versions that are not as they were written; tells program and number of each, as it has them now."""
    removed = set()
    for key in _damaged_keys(db, "versions"):
        query = "DELETE FROM versions WHERE id = ? RETURNING program_id, number"
        program, number = tuples(db, query, (key,)).fetchall()[0]
        removed.add((str(program), int(number)))
    return removed


def record_damaged_runs(db: sqlite3.Connection, now: str) -> None:
    """Notes which rows, events and samples of runs are not as they were written, or not whole."""
    db.execute("UPDATE content_sums SET damaged_at = NULL")
    for table in OF_RUNS:
        for key in list(_damaged_keys(db, table)):
            record_damage(db, table, key, now)


def prefer_intact_rows(db: sqlite3.Connection) -> None:
    """What the store has as it was written goes into the schema `bundle` in the place of what is damaged there."""
    for table, key, right in tuples(db, _DAMAGED).fetchall():
        if content_checksum(db, table, key) == right or (table == "runs" and _has_its_end(db, key)):
            copy_rows(db, table, key, "main", "bundle")
            which = "table_name = ? AND row_id = ?"
            db.execute(f"DELETE FROM bundle.content_sums WHERE {which}", [table, key])


def import_damage_records(db: sqlite3.Connection) -> None:
    """Notes in the store which of the runs that came are damaged, with the sums that they should have."""
    db.execute(
        """INSERT OR REPLACE INTO main.content_sums SELECT * FROM bundle.content_sums
           WHERE damaged_at IS NOT NULL AND row_id IN (SELECT id FROM main.runs)"""
    )


def _damaged_keys(db: sqlite3.Connection, table: str) -> Iterator[str]:
    home = "versions" if table == "versions" else "runs"
    query = f"SELECT row_id FROM content_sums WHERE table_name = ? AND row_id IN (SELECT id FROM {home})"
    for (key,) in tuples(db, query, (table,)).fetchall():
        if not is_intact(db, table, str(key)):
            yield str(key)


def _has_its_end(db: sqlite3.Connection, run_id: str) -> bool:
    """A run that was cut off, as in a backup, is better with what is left of its end."""
    ended = "state <> 'running' AND reason IS NOT 'interrupted'"
    return bool(
        db.execute(f"SELECT 1 FROM main.runs WHERE id = ? AND {ended}", [run_id]).fetchone()
    )
