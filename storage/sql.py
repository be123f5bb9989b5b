"""SQL helpers that many modules need."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import fields
from pathlib import Path
from typing import Any

from storage.errors import StoreError
from storage.limits import MAX_REVISION
from storage.sqlite import sqlite3
from storage.text import just_after

Stop = Callable[[], bool]
_STEPS_BETWEEN_STOPS = 10_000


def address(path: Path, mode: str) -> str:
    """Returns SQLite's URI of a file. Modes: `ro`, `rw`, `rwc` (creates it), `immutable` (nobody writes it)."""
    uri = path.absolute().as_uri()
    return f"{uri}?mode=ro&immutable=1" if mode == "immutable" else f"{uri}?mode={mode}"


def opened(path: Path, mode: str) -> sqlite3.Connection:
    """Returns a plain connection in autocommit mode."""
    return sqlite3.connect(address(path, mode), uri=True, isolation_level=None)


def column_names(db: sqlite3.Connection, table: str, schema: str = "main") -> tuple[str, ...]:
    """Returns the table's columns in their order; none if there is no such table."""
    return tuple(str(row[1]) for row in db.execute(f"PRAGMA {schema}.table_info({table})"))


def tuples(
    db: sqlite3.Connection, query: str, parameters: tuple[object, ...] = ()
) -> sqlite3.Cursor:
    """Returns the rows as plain tuples, whatever the connection's row factory is."""
    cursor = db.cursor()
    cursor.row_factory = None
    return cursor.execute(query, parameters)


def row_batches(cursor: sqlite3.Cursor) -> Iterator[list[tuple[Any, ...]]]:
    """Yields batches of 16 rows, because one version may have megabytes."""
    while rows := cursor.fetchmany(16):
        yield rows


def rows_of(
    db: sqlite3.Connection, query: str, parameters: Sequence[Any] | Mapping[str, Any] = ()
) -> list[sqlite3.Row]:
    """Returns all rows. Replacement characters stand for damaged ones, so that a list can still be read."""
    try:
        return db.execute(query, parameters).fetchall()
    except sqlite3.OperationalError as error:
        if not is_text_damage(error):
            raise
    before = db.text_factory
    read_all_texts(db)
    try:
        return db.execute(query, parameters).fetchall()
    finally:
        db.text_factory = before


def is_text_damage(error: sqlite3.Error) -> bool:
    """Returns whether the error means a damaged text: a wrong bit makes octets that are not UTF-8."""
    return "UTF-8" in str(error)


def read_all_texts(db: sqlite3.Connection) -> None:
    """Makes the connection read damaged texts with replacement characters. Slower, so used after damage only."""
    db.text_factory = lambda octets: octets.decode("utf-8", "replace")


def setup_value(column: str, name: str) -> str:
    """Returns the SQL expression of a value in a JSON column; NULL if the JSON is damaged."""
    return f"CASE WHEN json_valid({column}) THEN json_extract({column}, '$.{name}') END"


def row_count(db: sqlite3.Connection, table: str, condition: str = "1") -> int:
    """Returns the number of rows that meet a condition."""
    query = f"SELECT count(*) FROM {table} WHERE {condition}"
    return int(db.execute(query).fetchone()[0])


def integrity_problem(
    db: sqlite3.Connection, check: str = "integrity_check", stop: Stop | None = None
) -> str | None:
    """Returns the first problem that SQLite's check finds in the file; None for none.

    Args:
        stop: polled every few milliseconds; once it returns True, the check raises `sqlite3.OperationalError`.
    """
    with stoppable(db, stop):
        finding = str(db.execute(f"PRAGMA {check}(1)").fetchone()[0])
    return None if finding == "ok" else finding


@contextmanager
def stoppable(db: sqlite3.Connection, stop: Stop | None) -> Iterator[None]:
    """Makes queries within the context raise `sqlite3.OperationalError` once `stop` returns True."""
    db.set_progress_handler(stop, _STEPS_BETWEEN_STOPS)
    try:
        yield
    finally:
        db.set_progress_handler(None, 0)


def checkpoint(db: sqlite3.Connection) -> bool:
    """Empties the write-ahead log, outside of a transaction; returns False if another program reads from it."""
    busy, _, _ = db.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()
    return not busy


def exists(db: sqlite3.Connection, table: str, key: str) -> bool:
    """Returns whether the table has a row of that key."""
    return db.execute(f"SELECT 1 FROM {table} WHERE id = ?", [key]).fetchone() is not None


def require(db: sqlite3.Connection, table: str, key: str) -> None:
    """Raises StoreError `KIND_not_found` if there is no such row; the kind is the table's name in the singular."""
    if not exists(db, table, key):
        raise not_found(table, key)


def not_found(table: str, key: str) -> StoreError:
    """Returns the error for a missing row."""
    kind = f"{table[:-3]}y" if table.endswith("ies") else table.removesuffix("s")
    return StoreError(f"{kind}_not_found", id=key)


def insert(db: sqlite3.Connection, table: str, row: Mapping[str, object]) -> None:
    """Adds a row; columns that it lacks get their default."""
    placeholders = ", ".join(f":{name}" for name in row)
    db.execute(f"INSERT INTO {table} ({', '.join(row)}) VALUES ({placeholders})", row)


def update_row(
    db: sqlite3.Connection,
    table: str,
    key: str,
    values: Mapping[str, object],
    now: str,
    *,
    n_revisions: int = 1,
) -> None:
    """Updates a row and raises its revision: only this makes a state that wins over the row's earlier state in merges.

    Args:
        n_revisions: the number to raise the revision by. With 0 only the time is newer, so changes by other PCs that
            raise the revision win.
    """
    row = db.execute(f"SELECT revision, changed_at FROM {table} WHERE id = ?", [key]).fetchone()
    if row is None:
        return
    revision, changed_at = _next_state(int(row[0]), str(row[1]), now, n_revisions)
    assignments = "".join(f"{name} = :{name}, " for name in values)
    db.execute(
        f"UPDATE {table} SET {assignments}revision = :revision, changed_at = :at WHERE id = :key",
        {**values, "revision": revision, "at": changed_at, "key": key},
    )


def _next_state(revision: int, changed_at: str, now: str, n_revisions: int) -> tuple[int, str]:
    """Returns revision and time of the next state. If the revision stays, as at its bound, the time decides."""
    next_revision = min(revision + n_revisions, MAX_REVISION)
    return next_revision, now if next_revision > revision else max(now, just_after(changed_at))


def selected(record: Any, table: str, **computed: str) -> str:
    """Returns `SELECT` of a record's fields: columns of the table, or the SQL expressions given by field name."""
    names = getattr(record, "_fields", None) or [field.name for field in fields(record)]
    listed = ", ".join(
        f"({computed[name]}) AS {name}" if name in computed else f"{table}.{name}" for name in names
    )
    return f"SELECT {listed} FROM {table}"


@contextmanager
def snapshot(db: sqlite3.Connection) -> Iterator[None]:
    """Makes all reads within the context see one state of the database."""
    if db.in_transaction:
        yield
        return
    db.execute("BEGIN")
    try:
        yield
    finally:
        if db.in_transaction:
            db.execute("ROLLBACK")
