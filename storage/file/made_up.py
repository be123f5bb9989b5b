"""Mending a file into which an earlier release let ids, numbers and revisions that somebody made up.

That release gave later work of this PC ids after the made-up one, which no other PC takes: exports would leave it out.
All such rows get other ids, numbers and revisions. The new ones follow from the old ones alone, so that PCs which hold
the same rows mend them alike.
"""

import re
from collections.abc import Iterator

from storage.limits import MAX_NUMBERS_AHEAD, MAX_REVISION
from storage.sql import column_names, tuples
from storage.sqlite import sqlite3
from storage.tables.columns import KEY, ReplicatedTable
from storage.tables.local import LOCAL
from storage.tables.replicated import REPLICATED
from storage.text import FIRST_MADE_UP_ID, IS_ID

_ID = re.compile(r"[0-9a-f]{8}-[0-9a-f]{4}-7[0-9a-f]{3}-[0-9a-f]{4}-[0-9a-f]{12}")
# times of new ids: the seven weeks before the release that mends. A time keeps its place within seven weeks, of which
# those that follow one id need some minutes
_FIRST_MS, _N_MS = 0x1A1_0000_0000, 2**32
# texts that name rows: own activities, and what this PC has chosen and written
_TEXTS = (
    ("settings", "value"),
    ("exports", "content"),
    ("lessons", "activity"),
    ("runs", "activity"),
    ("versions", "setup"),
    ("class_presets", "preset"),
    ("own_activities", "document"),
)


def mended_id(key: str) -> str:
    """A made-up id with a time that a clock may have shown; in the order of the old ones. Others stay as they are."""
    if not (_ID.fullmatch(key) and key >= FIRST_MADE_UP_ID):
        return key
    octets = int(key.replace("-", ""), 16)
    ms = _FIRST_MS + ((octets >> 80) + _N_MS // 2) % _N_MS
    text = f"{ms << 80 | octets & (2**80 - 1):032x}"
    return "-".join((text[:8], text[8:12], text[12:16], text[16:20], text[20:]))


def is_damage(db: sqlite3.Connection) -> bool:
    """Whether ids that look made up are damaged ones: what belongs to their rows, or their sum, has another id."""
    lost = """SELECT 1 FROM content_sums WHERE table_name IN ('versions', 'runs')
        AND row_id NOT IN (SELECT id FROM versions UNION ALL SELECT id FROM runs
                           UNION ALL SELECT id FROM tombstones) LIMIT 1"""
    violation = tuples(db, "PRAGMA foreign_key_check").fetchone()
    return violation is not None or tuples(db, lost).fetchone() is not None


def mend(db: sqlite3.Connection, now: str) -> int:
    """Mends all rows within the caller's transaction; returns how many had a made-up id, number or revision."""
    db.execute("PRAGMA defer_foreign_keys = ON")
    db.create_function("mended_id", 1, mended_id, deterministic=True)
    db.create_function("mended_text", 1, _mended_text, deterministic=True)
    n_mended = sum(_mend_key(db, *place) for place in _keys(db))
    for table, column in _TEXTS:
        new = f"mended_text({column})"
        db.execute(f"UPDATE {table} SET {column} = {new} WHERE {column} <> {new}")
    n_mended += _mend_numbers(db) + _mend_revisions(db, now)
    if n_mended:  # sums of what the rows were before would call them damaged; they are noted anew
        db.execute("DELETE FROM content_sums")
    return n_mended


def _keys(db: sqlite3.Connection) -> Iterator[tuple[str, str, bool]]:
    """Table, column and whether it is part of the key, of every column that holds ids."""
    for table in (*REPLICATED, *LOCAL):
        there = column_names(db, table.name)
        for column in table.columns:
            if column.kind is KEY and column.name in there:
                yield table.name, column.name, column.name in table.key


def _mend_key(db: sqlite3.Connection, table: str, column: str, is_key: bool) -> int:
    """A row whose new key is there already came mended from another PC: it is the same row twice, and goes."""
    made_up = f"{column} >= ? AND {IS_ID.replace('id', column, 1)}"
    n_rows = db.execute(
        f"UPDATE OR IGNORE {table} SET {column} = mended_id({column}) WHERE {made_up}",
        [FIRST_MADE_UP_ID],
    ).rowcount
    if is_key:
        db.execute(f"DELETE FROM {table} WHERE {made_up}", [FIRST_MADE_UP_ID])
    return n_rows if column == "id" else 0


def _mended_text(text: str | None) -> str | None:
    return text and _ID.sub(lambda found: mended_id(found[0]), text)


def _mend_numbers(db: sqlite3.Connection) -> int:
    """Versions with a number far beyond their count follow the others, in their order."""
    ahead = db.execute(
        f"""SELECT id, row_number() OVER (PARTITION BY program_id ORDER BY number, id) + coalesce((
                SELECT max(number) FROM versions AS sound WHERE sound.program_id = versions.program_id
                AND number <= n + {MAX_NUMBERS_AHEAD}), 0)
            FROM versions JOIN (SELECT program_id, count(*) AS n FROM versions GROUP BY program_id)
                USING (program_id) WHERE number > n + {MAX_NUMBERS_AHEAD}"""
    ).fetchall()
    db.executemany("UPDATE versions SET number = ?2 WHERE id = ?1", [tuple(row) for row in ahead])
    return len(ahead)


def _mend_revisions(db: sqlite3.Connection, now: str) -> int:
    """A revision at the limit is decided by time; a time to come would win for ever."""
    return sum(
        db.execute(
            f"UPDATE {table.name} SET revision = {MAX_REVISION}, changed_at = min(changed_at, ?)"
            f" WHERE revision > {MAX_REVISION}",
            [now],
        ).rowcount
        for table in REPLICATED
        if _is_revised(table)
    )


def _is_revised(table: ReplicatedTable) -> bool:
    return any(column.name == "revision" for column in table.columns)
