"""Checksums: a SHA-256 of each version and of each run that has ended, which detects a flipped bit in a value.

SQLite detects damage to the structure of its file, not to values. The checksums stay on one PC, in `content_sums`.
A run has three, of its row, its events and its samples, so that judging a run later costs little. Worlds are
columns of versions and runs, which covers them.

No code has to update checksums by itself. Triggers of the writer's connection record each row that a transaction
changes. Before the commit `ChangedRows.update_checksums` stores the checksums of these rows, or deletes
them with the row. A run that has not ended has none.
"""

import hashlib
import struct
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import groupby, islice
from operator import itemgetter

from storage.sql import column_names, snapshot, tuples
from storage.sqlite import sqlite3
from storage.text import to_json

# the column with the row's key, or with the key of the run that the rows belong to
KEYS = {"versions": "id", "runs": "id", "events": "run_id", "telemetry": "run_id"}
_PARTS = ("events", "telemetry")
OF_RUNS = ("runs", *_PARTS)
_SIDES = {"INSERT": ("new",), "UPDATE": ("old", "new"), "DELETE": ("old",)}
# checksum of the events or samples of a run without any
_NOTHING = hashlib.sha256().hexdigest()
_ORDER = {"versions": "id", "runs": "id", "events": "seq", "telemetry": "chunk"}
_SELECT = {
    table: f"SELECT * FROM {{schema}}.{table} WHERE {key} {{which}} ORDER BY {key}, {_ORDER[table]}"
    for table, key in KEYS.items()
}
_BATCH_SIZE = 256
_IN = "IN (SELECT value FROM json_each(?))"


class ChangedRows:
    """The rows that a connection has changed since the last call of `update_checksums`.

    A row may be recorded though its change was rolled back. It gets its present checksum again then.
    """

    def __init__(self, db: sqlite3.Connection) -> None:
        self._keys: dict[str, set[bytes]] = {table: set() for table in KEYS}
        for table, key in KEYS.items():
            db.create_function(f"note_{table}", 1, self._keys[table].add)
            for change, sides in _SIDES.items():
                calls = " ".join(
                    f"SELECT note_{table}(CAST({side}.{key} AS BLOB));" for side in sides
                )
                db.execute(
                    f"CREATE TEMP TRIGGER {change}_{table} AFTER {change} ON main.{table}"
                    f" BEGIN {calls} END"
                )

    def update_checksums(self, db: sqlite3.Connection) -> None:
        """Stores the checksum of each changed row, within the transaction that changed it."""
        changed = {
            (table, key.decode("utf-8", "replace"))  # the key itself may be damaged
            for table, keys in self._keys.items()
            for key in keys
        }
        for keys in self._keys.values():
            keys.clear()
        _update_checksums(db, _stale_checksums(db, changed))


def add_missing_checksums(db: sqlite3.Connection, keys: Sequence[tuple[str, str]]) -> None:
    """Stores the checksums of rows that have none, from their present content, within the caller's transaction."""
    _update_checksums(db, [which for which in keys if stored_checksum(db, *which) is None])


def repair_from(db: sqlite3.Connection, schema: str) -> None:
    """Repairs rows that were found damaged from an attached file that has them intact.

    Does not restore a missing row, since it may have been deleted. The backups may have it.
    """
    damaged = "SELECT table_name, row_id, sha256 FROM content_sums WHERE damaged_at IS NOT NULL"
    for table, key, right in tuples(db, damaged).fetchall():
        if content_checksum(db, table, key, schema) == right and not is_intact(db, table, key):
            copy_rows(db, table, key, schema)


def content_checksum(
    db: sqlite3.Connection, table: str, key: str, schema: str = "main"
) -> str | None:
    """Returns the SHA-256, in hex, of a row of `versions` or `runs`, or of a run's rows in `events` or `telemetry`.

    Returns None if there is no row of that key. A NULL does not count, so that a column which a later release adds
    leaves earlier checksums as they are.

    Raises:
        sqlite3.DatabaseError: the value is on a page that cannot be read.
    """
    nothing = _NOTHING if table in _PARTS else None
    return _content_checksums(db, table, [key], schema).get(key, nothing)


def stored_checksum(
    db: sqlite3.Connection, table: str, key: str, schema: str = "main"
) -> str | None:
    """Returns the checksum that was stored with the row; None if it has none."""
    query = f"SELECT sha256 FROM {schema}.content_sums WHERE table_name = ? AND row_id = ?"
    row = tuples(db, query, (table, key)).fetchone()
    return row and str(row[0])


def is_intact(db: sqlite3.Connection, table: str, key: str, schema: str = "main") -> bool:
    """Returns whether the row matches its stored checksum; True if it has none."""
    with snapshot(db):
        stored = stored_checksum(db, table, key, schema)
        if stored is None:
            return True
        try:
            return content_checksum(db, table, key, schema) == stored
        except sqlite3.DatabaseError as error:
            if getattr(error, "sqlite_errorname", "").startswith("SQLITE_CORRUPT"):
                return False
            raise


def copy_rows(
    db: sqlite3.Connection, table: str, key: str, schema: str, target: str = "main"
) -> None:
    """Replaces the rows of a key in the schema `target`, which has that row or run, by the rows of `schema`."""
    names = ", ".join(column_names(db, table, schema))
    which = f"FROM {schema}.{table} WHERE {KEYS[table]} = ?"
    if table in ("versions", "runs"):
        query = f"UPDATE {target}.{table} SET ({names}) = (SELECT {names} {which}) WHERE id = ?"
        db.execute(query, [key, key])
        return
    db.execute(f"DELETE FROM {target}.{table} WHERE run_id = ?", [key])
    db.execute(f"INSERT INTO {target}.{table} ({names}) SELECT {names} {which}", [key])


def _stale_checksums(
    db: sqlite3.Connection, changed: set[tuple[str, str]]
) -> Iterator[tuple[str, str]]:
    """Yields the checksums that change with the rows. Checksums of events and samples are due when the run ends."""
    for table, key in changed:
        yield table, key
        if table == "runs":
            for part in _PARTS:
                if (part, key) not in changed and stored_checksum(db, part, key) is None:
                    yield part, key


def _update_checksums(db: sqlite3.Connection, changed: Iterable[tuple[str, str]]) -> None:
    for table, group in groupby(sorted(changed), itemgetter(0)):
        keys = [key for _, key in group]
        lasting = keys if table == "versions" else _ended(db, keys)
        by_key = dict.fromkeys(lasting, _NOTHING) if table in _PARTS else {}
        by_key |= _content_checksums(db, table, lasting)
        missing = [(table, key) for key in keys if key not in by_key]
        if missing:
            db.executemany("DELETE FROM content_sums WHERE table_name = ? AND row_id = ?", missing)
        db.executemany(
            """INSERT INTO content_sums (table_name, row_id, sha256) VALUES (?, ?, ?)
               ON CONFLICT DO UPDATE SET damaged_at = NULL, sha256 = excluded.sha256
               WHERE damaged_at IS NULL OR sha256 = excluded.sha256""",
            [(table, key, found) for key, found in by_key.items()],
        )


def _ended(db: sqlite3.Connection, run_ids: Sequence[str]) -> list[str]:
    query = f"SELECT id FROM runs WHERE id {_IN} AND state IS NOT 'running'"
    return [str(row[0]) for row in tuples(db, query, (to_json(run_ids),))]


@contextmanager
def _raw(db: sqlite3.Connection) -> Iterator[None]:
    """Reads texts as the octets in the file, whether they are UTF-8 or not; blobs are still a type of their own."""
    before = db.text_factory
    db.text_factory = bytearray
    try:
        yield
    finally:
        db.text_factory = before


def _content_checksums(
    db: sqlite3.Connection, table: str, keys: Sequence[str], schema: str = "main"
) -> dict[str, str]:
    """Returns the checksums by key, without the keys that have no row."""
    # a query of its own for one key, as one edit is by far the most frequent change
    which, parameter = ("= ?", keys[0]) if len(keys) == 1 else (_IN, to_json(keys))
    with _raw(db):
        cursor = tuples(db, _SELECT[table].format(schema=schema, which=which), (parameter,))
        columns = [column[0] for column in cursor.description]
        names = [f"{column}=".encode() for column in columns]
        return {
            key.decode(): _digest(names, rows)
            for key, rows in groupby(cursor, itemgetter(columns.index(KEYS[table])))
        }


def _digest(names: Sequence[bytes], rows: Iterator[tuple[object, ...]]) -> str:
    digest = hashlib.sha256()
    while some := list(islice(rows, _BATCH_SIZE)):  # a run of an hour has many events
        digest.update(_octets(names, some))
    return digest.hexdigest()


def _octets(names: Sequence[bytes], rows: Iterable[tuple[object, ...]]) -> bytes:
    """Encodes rows for the checksum: the name, type, length and octets of each value that is not NULL."""
    parts: list[bytes | bytearray] = []
    for row in rows:
        for name, value in zip(names, row, strict=True):
            if value is None:
                continue
            if type(value) is bytearray:  # a text; most values are texts and whole numbers
                parts += (b"%bt%d:" % (name, len(value)), value)
            elif type(value) is int:
                parts.append(b"%bi%d;" % (name, value))
            elif type(value) is float:
                parts += (name, b"f", struct.pack("<d", value))
            elif type(value) is bytes:
                parts += (b"%bb%d:" % (name, len(value)), value)
        parts.append(b"\n")
    return b"".join(parts)
