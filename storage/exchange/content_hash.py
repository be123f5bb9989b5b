"""The content hash of a store or bundle: equal for two files that hold the same replicated rows.

It covers the tables of `REPLICATED`, not settings, merges and exports, which belong to one PC. Runs that have not
ended do not count yet. A PC counts only if rows of the file were made on it. So a file into which bundles were only
merged has the same hash on every PC.
"""

import hashlib
import json
from collections.abc import Iterator

from storage.sql import column_names, row_batches, row_count, snapshot, tuples
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED

_encode = json.JSONEncoder(separators=(",", ":")).encode
# the last value of each row while it is encoded; no text contains the encoded end, as its quotes are escaped
_END = "\0"
_END_OF_ROW = ',"\\u0000"]'


def content_hash(db: sqlite3.Connection, schema: str = "main") -> str:
    """Returns the SHA-256, in hex, of every replicated row, in the order of the tables and of their keys.

    Each table is hashed as a JSON array of its name and its columns, then each row as a JSON array; a line feed follows
    each array. In the array the length of a blob, in octets, replaces it; the blob follows the line feed. Tables that
    later releases added are left out while they are empty, and their columns while each value is empty.
    docs/bundles.md has the details.
    """
    digest = hashlib.sha256()
    with snapshot(db):
        for table in REPLICATED:
            names = column_names(db, table.name, schema)
            if not names:  # the release that wrote the file had no such table
                continue
            going = table.condition.format(schema=schema)
            if not table.counts_empty and not row_count(db, f"{schema}.{table.name}", going):
                continue
            names = _counted(db, table, names, schema)
            digest.update(f"{_encode([table.name, *names])}\n".encode())
            for octets in _encoded_rows(db, table, names, schema):
                digest.update(octets)
    return digest.hexdigest()


def _counted(
    db: sqlite3.Connection, table: ReplicatedTable, names: tuple[str, ...], schema: str
) -> tuple[str, ...]:
    """Returns the names without columns of later releases that are empty in every row."""
    added = {column.name for column in table.columns if not column.counts_empty}
    return tuple(
        name
        for name in names
        if name not in added or row_count(db, f"{schema}.{table.name}", f"{name} != ''")
    )


def _encoded_rows(
    db: sqlite3.Connection, table: ReplicatedTable, names: tuple[str, ...], schema: str
) -> Iterator[bytes]:
    found = tuples(
        db,
        f"SELECT {', '.join(names)} FROM {schema}.{table.name}"
        f" WHERE {table.condition.format(schema=schema)} ORDER BY {', '.join(table.key)}",
    )
    for rows in row_batches(found):
        for line, row in zip(_lines(rows), rows, strict=True):
            yield b"".join((line, *[value for value in row if type(value) is bytes]))


def _lines(rows: list[tuple[object, ...]]) -> Iterator[bytes]:
    """Yields each row as a JSON array. Encodes many at once, as one by one takes twice as long."""
    heads = [
        [len(value) if type(value) is bytes else value for value in (*row, _END)] for row in rows
    ]
    *encoded, _ = _encode(heads).split(_END_OF_ROW)
    return (f"{row[1:]}]\n".encode() for row in encoded)  # without the bracket or comma before it
