"""A SHA-256 of each version and of each run that has ended: a bit that flips inside a value is seen.

SQLite finds damage to the structure of its file, not to what stands in it. The sums stay on one PC, in `content_sums`;
the sum of a run's row, of its events and of its samples are three, so that a run that is judged later costs little.
Worlds are columns of versions and runs, and are covered with them.

Nobody has to remember to renew a sum: triggers of the writer's connection note each row that a transaction changes,
and `Changes.renew` gives these rows their sums before it commits, or takes them away with the row. A run that goes on
has none.
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

# the column that names the row, or the run that the rows belong to
KEYS = {"versions": "id", "runs": "id", "events": "run_id", "telemetry": "run_id"}
_PARTS = ("events", "telemetry")
OF_RUNS = ("runs", *_PARTS)
_SIDES = {"INSERT": ("new",), "UPDATE": ("old", "new"), "DELETE": ("old",)}
# of a run without events or without samples
_NOTHING = hashlib.sha256().hexdigest()
_ORDER = {"versions": "id", "runs": "id", "events": "seq", "telemetry": "chunk"}
_SELECT = {
    table: f"SELECT * FROM {{schema}}.{table} WHERE {key} {{which}} ORDER BY {key}, {_ORDER[table]}"
    for table, key in KEYS.items()
}
_ROWS_AT_ONCE = 256
_IN = "IN (SELECT value FROM json_each(?))"


class ChangedRows:
    """What a connection has changed since `update_checksums` was called last.

    A change that was rolled back may still be noted: its row then gets the sum that it has.
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
        """Gives each row that was changed its sum, within the transaction that changed it."""
        changed = {
            (table, key.decode("utf-8", "replace"))  # the key may be what is damaged
            for table, keys in self._keys.items()
            for key in keys
        }
        for keys in self._keys.values():
            keys.clear()
        _update_checksums(db, _stale_checksums(db, changed))


def add_missing_checksums(db: sqlite3.Connection, keys: Sequence[tuple[str, str]]) -> None:
    """Gives rows without a sum the one of what is there now, within the caller's transaction."""
    _update_checksums(db, [which for which in keys if stored_checksum(db, *which) is None])


def repair_from(db: sqlite3.Connection, schema: str) -> None:
    """Mends rows that were found damaged from an attached file that has them as they were written.

    A row that no longer is there is left to the backups: it may have been deleted.
    """
    damaged = "SELECT table_name, row_id, sha256 FROM content_sums WHERE damaged_at IS NOT NULL"
    for table, key, right in tuples(db, damaged).fetchall():
        if content_checksum(db, table, key, schema) == right and not is_intact(db, table, key):
            copy_rows(db, table, key, schema)


def content_checksum(
    db: sqlite3.Connection, table: str, key: str, schema: str = "main"
) -> str | None:
    """SHA-256, in hex, of a row of `versions` or `runs`, or of the rows of a run in `events` or `telemetry`.

    None where there is no row of that key. A column that is NULL does not count: one that a later release adds leaves
    the sums of earlier rows as they are.

    Raises:
        sqlite3.DatabaseError: the value lies on a page that cannot be read.
    """
    nothing = _NOTHING if table in _PARTS else None
    return _content_checksums(db, table, [key], schema).get(key, nothing)


def stored_checksum(
    db: sqlite3.Connection, table: str, key: str, schema: str = "main"
) -> str | None:
    """The sum that the row had when it was written; None where it has none."""
    query = f"SELECT sha256 FROM {schema}.content_sums WHERE table_name = ? AND row_id = ?"
    row = tuples(db, query, (table, key)).fetchone()
    return row and str(row[0])


def is_intact(db: sqlite3.Connection, table: str, key: str, schema: str = "main") -> bool:
    """Whether the row is as it was written; True for one without a sum."""
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
    """Puts the rows of a file into those of another, which has a row or run of that key."""
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
    """The sums that change with the rows. A run's events and samples get theirs when it ends."""
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
    """Texts as the bytes in the file, whether they are UTF-8 or not; told apart from blobs."""
    before = db.text_factory
    db.text_factory = bytearray
    try:
        yield
    finally:
        db.text_factory = before


def _content_checksums(
    db: sqlite3.Connection, table: str, keys: Sequence[str], schema: str = "main"
) -> dict[str, str]:
    """By key; without those of which there is no row."""
    # one edit is by far the most frequent change
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
    while some := list(islice(rows, _ROWS_AT_ONCE)):  # an hour's run has many events
        digest.update(_octets(names, some))
    return digest.hexdigest()


def _octets(names: Sequence[bytes], rows: Iterable[tuple[object, ...]]) -> bytes:
    """What counts of rows: the type, the length and the octets of each value that is not NULL."""
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
