"""The content hash: equal for two files that hold the same replicated rows.

It covers the tables of `REPLICATED`. Settings, merges and exports belong to one PC. A run that
has not ended does not count yet, nor does a PC that nothing in the file was made on: a file that was only merged into
has the same hash on every PC.
"""

import hashlib
import json
from collections.abc import Iterator

from storage.sql import column_names, row_batches, row_count, snapshot, tuples
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED

_encode = json.JSONEncoder(separators=(",", ":")).encode
# a row's last value while it is encoded. No text has the end of such a row in it: quotation marks of texts are escaped
_END = "\0"
_END_OF_ROW = ',"\\u0000"]'


def content_hash(db: sqlite3.Connection, schema: str = "main") -> str:
    """SHA-256, in hex, of every replicated row, in the order of the tables and of their keys.

    Of each table first a JSON array of its name and its columns, then each row as a JSON array, each followed by a
    line feed; in place of a blob stands its length, and the blob follows the line feed. Tables that later releases
    added are left out while they are empty. docs/bundles.md says more.
    """
    digest = hashlib.sha256()
    with snapshot(db):
        for table in REPLICATED:
            names = column_names(db, table.name, schema)
            if not names:  # a table that the release which wrote the file did not have
                continue
            going = table.condition.format(schema=schema)
            if not table.counts_empty and not row_count(db, f"{schema}.{table.name}", going):
                continue
            digest.update(f"{_encode([table.name, *names])}\n".encode())
            for octets in _encoded_rows(db, table, names, schema):
                digest.update(octets)
    return digest.hexdigest()


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
    """Each row as a JSON array; encoded together, as each by itself takes twice as long."""
    heads = [
        [len(value) if type(value) is bytes else value for value in (*row, _END)] for row in rows
    ]
    *encoded, _ = _encode(heads).split(_END_OF_ROW)
    return (f"{row[1:]}]\n".encode() for row in encoded)  # without the bracket or comma before it
