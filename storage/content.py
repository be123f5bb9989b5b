"""What of the file is content, which goes from PC to PC, and the one number that says whether two files hold the same.

Settings, merges and exports belong to one PC. A run that has not ended is no content yet, nor is a PC that nothing
in the file was made on: a file that was only merged into is the same on whatever PC that was done.
"""

import hashlib
import json
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

_ENDED = "run_id NOT IN (SELECT id FROM {schema}.runs WHERE state = 'running')"
_USED = """id IN (
    SELECT computer_id FROM {schema}.versions UNION SELECT computer_id FROM {schema}.lessons
    UNION SELECT computer_id FROM {schema}.runs WHERE state <> 'running')"""


@dataclass(frozen=True, slots=True)
class Content:
    """A table of content.

    Attributes:
        key: what names a row in every file.
        condition: which rows are content, with the place `{schema}`.
        parents: column -> table whose row it belongs to; what belongs to a deleted row is deleted.
    """

    table: str
    key: tuple[str, ...]
    condition: str = "1"
    parents: tuple[tuple[str, str], ...] = ()


_ID = ("id",)
TOMBSTONES = Content("tombstones", _ID)
COMPUTERS = Content("computers", _ID, _USED)
CLASSROOMS = Content("classrooms", _ID)
GROUPS = Content("groups", _ID, parents=(("classroom_id", "classrooms"),))
LESSONS = Content("lessons", _ID, parents=(("classroom_id", "classrooms"),))
PROGRAMS = Content("programs", _ID, parents=(("group_id", "groups"),))
VERSIONS = Content("versions", _ID, parents=(("program_id", "programs"),))
LABELS = Content("version_labels", _ID, parents=(("id", "versions"),))
RUNS = Content(
    "runs",
    _ID,
    "state <> 'running'",
    parents=(("group_id", "groups"), ("program_id", "programs"), ("version_id", "versions")),
)
EVENTS = Content("events", ("run_id", "seq"), _ENDED, parents=(("run_id", "runs"),))
TELEMETRY = Content("telemetry", ("run_id", "chunk"), _ENDED, parents=(("run_id", "runs"),))
NOTES = Content("notes", _ID, _ENDED, parents=(("run_id", "runs"),))

# a row's parents stand before it
CONTENT = (
    TOMBSTONES,
    COMPUTERS,
    CLASSROOMS,
    GROUPS,
    LESSONS,
    PROGRAMS,
    VERSIONS,
    LABELS,
    RUNS,
    EVENTS,
    TELEMETRY,
    NOTES,
)
_encode = json.JSONEncoder(separators=(",", ":")).encode


def columns(db: sqlite3.Connection, table: str, schema: str = "main") -> tuple[str, ...]:
    """The table's columns in their order; none where there is no such table."""
    return tuple(str(row[1]) for row in db.execute(f"PRAGMA {schema}.table_info({table})"))


def content_hash(db: sqlite3.Connection, schema: str = "main") -> str:
    """SHA-256, in hex, of every row of content, in the order of the tables and of their keys.

    Of each table first a JSON array of its name and its columns, then each row as a JSON array, each followed by a
    line feed; in place of a blob stands its length, and the blob follows the line feed. docs/bundles.md says more.
    """
    digest = hashlib.sha256()
    with snapshot(db):
        for content in CONTENT:
            names = columns(db, content.table, schema)
            if names:
                digest.update(f"{_encode([content.table, *names])}\n".encode())
            for octets in _encoded_rows(db, content, names, schema):
                digest.update(octets)
    return digest.hexdigest()


@contextmanager
def snapshot(db: sqlite3.Connection) -> Iterator[None]:
    """All that is read within is of one moment."""
    if db.in_transaction:
        yield
        return
    db.execute("BEGIN")
    try:
        yield
    finally:
        if db.in_transaction:
            db.execute("ROLLBACK")


def tuples(
    db: sqlite3.Connection, query: str, parameters: tuple[object, ...] = ()
) -> sqlite3.Cursor:
    """The rows as plain tuples, whatever the connection makes of rows."""
    cursor = db.cursor()
    cursor.row_factory = None
    return cursor.execute(query, parameters)


def _encoded_rows(
    db: sqlite3.Connection, content: Content, names: tuple[str, ...], schema: str
) -> Iterator[bytes]:
    if not names:
        return
    rows = tuples(
        db,
        f"SELECT {', '.join(names)} FROM {schema}.{content.table}"
        f" WHERE {content.condition.format(schema=schema)} ORDER BY {', '.join(content.key)}",
    )
    if content is TELEMETRY:
        place = names.index("data")
        for row in rows:
            blob = row[place]
            head = [*row[:place], len(blob), *row[place + 1 :]]
            yield f"{_encode(head)}\n".encode() + blob
        return
    for row in rows:
        yield f"{_encode(row)}\n".encode()
