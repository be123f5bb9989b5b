"""Validates the rows of a bundle: each value must be one that a store can write (`storage/tables/rules.py`)."""

import zlib
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from typing import Any

from storage.limits import MAX_NUMBERS_AHEAD, MAX_REVISION, MAX_SAMPLES
from storage.sql import column_names, is_text_damage, row_batches, tuples
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED
from storage.tables.runs import TELEMETRY
from storage.text import may_be_of, time_text, to_json, utc_now

_SAMPLE_COLUMNS = 16
_RELEASED = datetime(2026, 11, 23, tzinfo=UTC)  # lower bound: the clock of a PC may be at 2010
_CLOCKS_DIFFER = timedelta(days=1)


def problem_in_rows(db: sqlite3.Connection) -> str | None:
    """Returns the first invalid place as `table.column`, None if all rows are valid."""
    for table in REPLICATED:
        if problem := _problem_in_table(db, table):
            return problem
    violation = db.execute("PRAGMA foreign_key_check").fetchone()
    if violation:
        return f"{violation[0]}: {violation[2]}"
    return _problem_in_runs(db) or _problem_in_numbers(db) or _problem_in_revisions(db)


def refused_rows(
    db: sqlite3.Connection, table: ReplicatedTable
) -> Iterator[tuple[tuple[Any, ...], str]]:
    """Yields the key of each row that breaks a rule, and the place as `table.column`; unpacks no samples.

    A text that is not UTF-8 is given as octets, also in the key.
    """
    try:
        yield from list(_refused_rows(db, table))
    except sqlite3.OperationalError as error:
        if not is_text_damage(error):
            raise
        db.text_factory = _text_or_octets
        try:
            yield from list(_refused_rows(db, table))
        finally:
            db.text_factory = str


def _text_or_octets(octets: bytes) -> str | bytes:
    try:
        return octets.decode()
    except UnicodeDecodeError:
        return octets


def _refused_rows(
    db: sqlite3.Connection, table: ReplicatedTable
) -> Iterator[tuple[tuple[Any, ...], str]]:
    names = column_names(db, table.name)
    table_rules = table.rules
    rules = [table_rules[name] for name in names]
    places = [names.index(name) for name in table.key]
    found = tuples(db, f"SELECT {', '.join(names)} FROM {table.name}")
    for rows in row_batches(found):
        columns = zip(*rows, strict=True)
        is_well = all(all(map(rule, values)) for rule, values in zip(rules, columns, strict=True))
        if is_well and not table.bound:
            continue  # nearly always
        for row in rows:
            wrong = (
                name for value, rule, name in zip(row, rules, names, strict=True) if not rule(value)
            )
            name = next(wrong, None) or _wrong_key(table, dict(zip(names, row, strict=True)))
            if name:
                yield tuple(row[place] for place in places), f"{table.name}.{name}"


def _wrong_key(table: ReplicatedTable, row: dict[str, Any]) -> str | None:
    """Returns `id` if the key is not derived from the row's content: somebody replaced the content."""
    is_own = not table.bound or may_be_of(
        row["id"], to_json([row.get(name) for name in table.bound])
    )
    return None if is_own else "id"


def _problem_in_table(db: sqlite3.Connection, table: ReplicatedTable) -> str | None:
    if not column_names(db, table.name):  # the release that wrote the file had no such table
        return None
    for _, problem in refused_rows(db, table):
        return problem
    if table is not TELEMETRY:
        return None
    samples = tuples(db, "SELECT data, n_rows FROM telemetry")
    return None if all(_unpacks(*row) for row in samples) else "telemetry.data"


def _unpacks(blob: bytes, n_rows: int) -> bool:
    """Returns True if the blob is telemetry of `n_rows` rows; never unpacks more octets than these need."""
    max_octets = 4 * _SAMPLE_COLUMNS * n_rows
    unpacking = zlib.decompressobj()
    try:
        octets = unpacking.decompress(blob, max_octets + 1)
    except zlib.error:
        return False
    fits = 0 < len(octets) <= max_octets and len(octets) % (4 * n_rows) == 0
    return fits and unpacking.eof and not unpacking.unused_data


def _problem_in_runs(db: sqlite3.Connection) -> str | None:
    """Bounds the samples of a run together, because a run is read as a whole."""
    by_length = db.execute(
        "SELECT sum(n_rows) FROM telemetry GROUP BY run_id ORDER BY 1 DESC LIMIT 1"
    )
    row = by_length.fetchone()
    return "telemetry.n_rows" if row and row[0] > MAX_SAMPLES else None


def _problem_in_numbers(db: sqlite3.Connection) -> str | None:
    """Bounds the numbers of versions: a number far above the count would stay the newest after every edit.

    Versions are numbered from 1, and a bundle has all versions of a program. Number and count both grow with each
    edit, so no number that PINEL gave exceeds the count.
    """
    ahead = db.execute(
        f"SELECT 1 FROM versions GROUP BY program_id HAVING max(number) > count(*) + {MAX_NUMBERS_AHEAD}"
    )
    return "versions.number" if ahead.fetchone() else None


def _problem_in_revisions(db: sqlite3.Connection) -> str | None:
    """Refuses times in the future at the maximum revision: there the time decides, so it would win for ever.

    No person reaches the maximum revision.
    """
    latest = time_text(max(utc_now(), _RELEASED) + _CLOCKS_DIFFER)
    for table in REPLICATED:
        if "revision" in column_names(db, table.name):
            condition = f"revision >= {MAX_REVISION} AND changed_at > ?"
            query = f"SELECT 1 FROM {table.name} WHERE {condition}"
            if db.execute(query, [latest]).fetchone():
                return f"{table.name}.changed_at"
    return None
