"""Rows of a damaged file whose checksum does not match (`storage/file/row_checksums.py`).

A bit that flipped inside a value still fits every rule of its table. A damaged version counts as unread. The
remaining rows of a damaged run are imported and recorded as damaged, unless the store has an intact copy.
"""

from collections.abc import Iterator

from storage.file.row_checksums import OF_RUNS, content_checksum, copy_rows, is_intact
from storage.file.row_repair import record_damage
from storage.sql import tuples
from storage.sqlite import sqlite3

_DAMAGED = "SELECT table_name, row_id, sha256 FROM bundle.content_sums WHERE damaged_at IS NOT NULL"


def remove_damaged_versions(db: sqlite3.Connection) -> set[tuple[str, int]]:
    """Deletes versions whose checksum does not match; returns program and number of each, as read now."""
    removed = set()
    for key in _damaged_keys(db, "versions"):
        query = "DELETE FROM versions WHERE id = ? RETURNING program_id, number"
        program, number = tuples(db, query, (key,)).fetchall()[0]
        removed.add((str(program), int(number)))
    return removed


def record_damaged_runs(db: sqlite3.Connection, now: str) -> None:
    """Records which rows, events and samples of runs are damaged or incomplete."""
    db.execute("UPDATE content_sums SET damaged_at = NULL")
    for table in OF_RUNS:
        for key in list(_damaged_keys(db, table)):
            record_damage(db, table, key, now)


def prefer_intact_rows(db: sqlite3.Connection) -> None:
    """Replaces damaged rows in the schema `bundle` by intact rows of the store."""
    for table, key, right in tuples(db, _DAMAGED).fetchall():
        if content_checksum(db, table, key) == right or (table == "runs" and _has_its_end(db, key)):
            copy_rows(db, table, key, "main", "bundle")
            which = "table_name = ? AND row_id = ?"
            db.execute(f"DELETE FROM bundle.content_sums WHERE {which}", [table, key])


def import_damage_records(db: sqlite3.Connection) -> None:
    """Records in the store which of the imported runs are damaged, with the checksums that they should have."""
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
    """Returns True if the stored run has its end. An interrupted one, as in a backup, is worse than a damaged row."""
    ended = "state <> 'running' AND reason IS NOT 'interrupted'"
    return bool(
        db.execute(f"SELECT 1 FROM main.runs WHERE id = ? AND {ended}", [run_id]).fetchone()
    )
