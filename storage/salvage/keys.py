"""Repairs keys of rows in which one bit flipped.

The right key follows from the row's checksum, for a version or run, or from its child rows, for a class, group or
program. Keys are random enough that two of them hardly ever differ by one bit.
"""

from collections.abc import Iterator

from storage.file.row_checksums import content_checksum
from storage.sql import tuples
from storage.sqlite import sqlite3
from storage.tables.replicated import REPLICATED

_SUMMED = ("versions", "runs")
_ABOVE = ("classrooms", "groups", "programs")


def repair_keys(db: sqlite3.Connection, invalid_keys: set[tuple[str, str]]) -> set[tuple[str, int]]:
    """Restores the keys of rows.

    Args:
        invalid_keys: table and key of rows in the database whose key is invalid; if the key cannot be repaired,
            the row is deleted.

    Returns:
        Program and number of the deleted edits.
    """
    for table in _SUMMED:
        for key in _checksums_without_row(db, table):
            _find_by_sum(db, table, key)
    for table in _ABOVE:
        for key in _named_without_row(db, table):
            _find_unnamed(db, table, key)
    return _delete_rows(db, invalid_keys)


def _checksums_without_row(db: sqlite3.Connection, table: str) -> list[str]:
    query = f"SELECT row_id FROM content_sums WHERE table_name = ? AND row_id NOT IN (SELECT id FROM {table})"
    return [str(key) for (key,) in tuples(db, query, (table,)).fetchall()]


def _find_by_sum(db: sqlite3.Connection, table: str, key: str) -> None:
    query = "SELECT sha256 FROM content_sums WHERE table_name = ? AND row_id = ?"
    (right,) = tuples(db, query, (table, key)).fetchall()[0]
    for other in _one_bit_neighbours(db, table, key):
        _rename(db, table, other, key)
        if content_checksum(db, table, key) == right:
            return
        _rename(db, table, key, other)


def _named_without_row(db: sqlite3.Connection, table: str) -> list[str]:
    query = f"SELECT key FROM ({_named(table)}) WHERE key NOT IN (SELECT id FROM {table})"
    return [str(key) for (key,) in tuples(db, query).fetchall()]


def _find_unnamed(db: sqlite3.Connection, table: str, key: str) -> None:
    named = {str(key) for (key,) in tuples(db, _named(table))}
    for other in _one_bit_neighbours(db, table, key):
        if other not in named:
            _rename(db, table, other, key)
            return


def _named(table: str) -> str:
    """Returns SQL of the table's keys that rows refer to; not their own keys, which may be the damaged ones."""
    return " UNION ".join(
        f"SELECT {column} AS key FROM {child.name} WHERE {column} IS NOT NULL"
        for child in REPLICATED
        for column, parent in child.parents
        if parent == table and column != "id"
    )


def _one_bit_neighbours(db: sqlite3.Connection, table: str, key: str) -> list[str]:
    """Returns the keys of rows that differ from a key by one bit."""
    keys = tuple(_one_bit_away(key))
    placeholders = ", ".join("?" * len(keys))
    return [
        str(row[0])
        for row in tuples(db, f"SELECT id FROM {table} WHERE id IN ({placeholders})", keys)
    ]


def _one_bit_away(key: str) -> Iterator[str]:
    for place, sign in enumerate(key):
        for bit in range(7):
            yield key[:place] + chr(ord(sign) ^ 1 << bit) + key[place + 1 :]


def _rename(db: sqlite3.Connection, table: str, key: str, new: str) -> None:
    db.execute(f"UPDATE {table} SET id = ? WHERE id = ?", [new, key])


def _delete_rows(
    db: sqlite3.Connection, invalid_keys: set[tuple[str, str]]
) -> set[tuple[str, int]]:
    deleted = set()
    for table, key in invalid_keys:
        if table == "versions":
            query = "SELECT program_id, number FROM versions WHERE id = ?"
            deleted |= {(str(p), int(n)) for p, n in tuples(db, query, (key,)).fetchall()}
        db.execute(f"DELETE FROM {table} WHERE id = ?", [key])
    return deleted
