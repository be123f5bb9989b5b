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
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from storage.sql import column_names, snapshot, tuples
from storage.sqlite import sqlite3

# the column that names the row, or the run that the rows belong to
KEYS = {"versions": "id", "runs": "id", "events": "run_id", "telemetry": "run_id"}
OF_RUNS = ("runs", "events", "telemetry")
_SIDES = {"INSERT": ("new",), "UPDATE": ("old", "new"), "DELETE": ("old",)}
_ORDER = {"versions": "id", "runs": "id", "events": "seq", "telemetry": "chunk"}
_SELECT = {
    table: f"SELECT * FROM {{schema}}.{table} WHERE {key} = ? ORDER BY {_ORDER[table]}"
    for table, key in KEYS.items()
}


class Changes:
    """What a connection has changed since `renew` was called last.

    A change that was rolled back may still be noted: its row then gets the sum that it has.
    """

    def __init__(self, db: sqlite3.Connection) -> None:
        self._rows: set[tuple[str, str]] = set()
        db.create_function("note_change", 2, self._note)
        for table, key in KEYS.items():
            for change, sides in _SIDES.items():
                noted = " ".join(
                    f"SELECT note_change('{table}', CAST({side}.{key} AS BLOB));" for side in sides
                )
                db.execute(
                    f"CREATE TEMP TRIGGER {change}_{table} AFTER {change} ON main.{table}"
                    f" BEGIN {noted} END"
                )

    def _note(self, table: str, key: bytes) -> None:
        self._rows.add((table, key.decode("utf-8", "replace")))  # the key may be what is damaged

    def renew(self, db: sqlite3.Connection) -> None:
        """Gives each row that was changed its sum, within the transaction that changed it."""
        changed, self._rows = self._rows, set()
        for table, key in _to_renew(db, changed):
            _renew_one(db, table, key)


def seal(db: sqlite3.Connection, keys: Sequence[tuple[str, str]]) -> None:
    """Gives rows without a sum the one of what is there now, within the caller's transaction."""
    for table, key in keys:
        if stored_sum(db, table, key) is None:
            _renew_one(db, table, key)


def mend_from(db: sqlite3.Connection, schema: str) -> None:
    """Mends rows that were found damaged from an attached file that has them as they were written.

    A row that no longer is there is left to the backups: it may have been deleted.
    """
    noted = "SELECT table_name, row_id, sha256 FROM content_sums WHERE damaged_at IS NOT NULL"
    for table, key, right in tuples(db, noted).fetchall():
        if content_sum(db, table, key, schema) == right and not is_sound(db, table, key):
            take_over(db, table, key, schema)


def content_sum(db: sqlite3.Connection, table: str, key: str, schema: str = "main") -> str | None:
    """SHA-256, in hex, of a row of `versions` or `runs`, or of the rows of a run in `events` or `telemetry`.

    None where there is no row of that key. A column that is NULL does not count: one that a later release adds leaves
    the sums of earlier rows as they are.

    Raises:
        sqlite3.DatabaseError: the value lies on a page that cannot be read.
    """
    digest = hashlib.sha256()
    with _raw(db):
        cursor = tuples(db, _SELECT[table].format(schema=schema), (key,))
        names = [f"{column[0]}=".encode() for column in cursor.description]
        n_rows = 0
        for row in cursor:
            n_rows += 1
            digest.update(_octets(names, row))
    return digest.hexdigest() if n_rows or table in ("events", "telemetry") else None


def stored_sum(db: sqlite3.Connection, table: str, key: str, schema: str = "main") -> str | None:
    """The sum that the row had when it was written; None where it has none."""
    query = f"SELECT sha256 FROM {schema}.content_sums WHERE table_name = ? AND row_id = ?"
    row = tuples(db, query, (table, key)).fetchone()
    return row and str(row[0])


def is_sound(db: sqlite3.Connection, table: str, key: str, schema: str = "main") -> bool:
    """Whether the row is as it was written; True for one without a sum."""
    with snapshot(db):
        stored = stored_sum(db, table, key, schema)
        if stored is None:
            return True
        try:
            return content_sum(db, table, key, schema) == stored
        except sqlite3.DatabaseError as error:
            if getattr(error, "sqlite_errorname", "").startswith("SQLITE_CORRUPT"):
                return False
            raise


def take_over(
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


def _to_renew(db: sqlite3.Connection, changed: set[tuple[str, str]]) -> Iterator[tuple[str, str]]:
    """The sums that change with the rows. A run's events and samples get theirs when it ends."""
    for table, key in sorted(changed):
        yield table, key
        if table == "runs":
            for part in ("events", "telemetry"):
                if (part, key) not in changed and stored_sum(db, part, key) is None:
                    yield part, key


def _renew_one(db: sqlite3.Connection, table: str, key: str) -> None:
    found = None
    if table == "versions" or _has_ended(db, key):
        found = content_sum(db, table, key)
    which = (table, key)
    if found is None:
        db.execute("DELETE FROM content_sums WHERE table_name = ? AND row_id = ?", which)
        return
    db.execute(
        """INSERT INTO content_sums (table_name, row_id, sha256) VALUES (?, ?, ?)
           ON CONFLICT DO UPDATE SET damaged_at = NULL, sha256 = excluded.sha256
           WHERE damaged_at IS NULL OR sha256 = excluded.sha256""",
        (*which, found),
    )


def _has_ended(db: sqlite3.Connection, run_id: str) -> bool:
    row = tuples(db, "SELECT state FROM runs WHERE id = ?", (run_id,)).fetchone()
    return row is not None and row[0] != "running"


@contextmanager
def _raw(db: sqlite3.Connection) -> Iterator[None]:
    """Texts as the bytes in the file, whether they are UTF-8 or not; told apart from blobs."""
    before = db.text_factory
    db.text_factory = bytearray
    try:
        yield
    finally:
        db.text_factory = before


def _octets(names: Sequence[bytes], row: Sequence[object]) -> bytes:
    """What counts of a row: the type, the length and the octets of each value that is not NULL."""
    parts: list[bytes | bytearray] = []
    for name, value in zip(names, row, strict=True):
        if value is None:
            continue
        if type(value) is bytearray:  # a text; by far the most values are texts and whole numbers
            parts += (b"%bt%d:" % (name, len(value)), value)
        elif type(value) is int:
            parts.append(b"%bi%d;" % (name, value))
        elif type(value) is float:
            parts += (name, b"f", struct.pack("<d", value))
        elif type(value) is bytes:
            parts += (b"%bb%d:" % (name, len(value)), value)
    parts.append(b"\n")
    return b"".join(parts)
