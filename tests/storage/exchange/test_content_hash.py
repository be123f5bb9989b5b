"""The content hash, calculated once more as docs/bundles.md describes it."""

import hashlib
import json
from functools import partial

import pytest

from storage import Store, VersionRow
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED
from tests.storage.bundle_makers import a_run, hash_of

# what separates rows, in every form in which a text could hold it
NASTY = (
    '"',
    "\\",
    "\0",
    ',"\0"],[',
    ',"\\u0000"],[',
    '\\",\\"\\u0000\\"],[',
    "]\n[",
    "é€😀\u2028",
    "",
)


def by_the_page(store: Store) -> str:
    digest = hashlib.sha256()
    with store._database.read_connection() as db:
        for table in REPLICATED:
            key, going = ", ".join(table.key), table.condition.format(schema="main")
            names = _counted(db, table)
            found = db.execute(
                f"SELECT {', '.join(names)} FROM {table.name} WHERE {going} ORDER BY {key}"
            )
            rows = [tuple(row) for row in found.fetchall()]
            if rows or table.counts_empty:
                digest.update(in_json([table.name, *names]))
            for row in rows:
                digest.update(in_json([len(v) if isinstance(v, bytes) else v for v in row]))
                digest.update(b"".join(value for value in row if isinstance(value, bytes)))
    return digest.hexdigest()


def _counted(db: sqlite3.Connection, table: ReplicatedTable) -> list[str]:
    """The columns in the order of the file, without those that the page leaves out while they are empty."""
    names = [row[1] for row in db.execute(f"PRAGMA table_info({table.name})")]
    if table.name != "groups":
        return names
    filled = "SELECT count(*) FROM groups WHERE {} != ''"
    robot = ("robot_name", "robot_pattern")
    return [
        one for one in names if one not in robot or db.execute(filled.format(one)).fetchone()[0]
    ]


def in_json(value: list[object]) -> bytes:
    return json.dumps(value, separators=(",", ":")).encode("ascii") + b"\n"


@pytest.mark.parametrize("n_runs", [0, 1, 40])
def test_the_hash_is_that_of_the_page_whatever_texts_hold(
    store: Store, version: VersionRow, n_runs: int
) -> None:
    runs = [a_run(store, version.id) for _ in range(n_runs)]
    assert hash_of(store) == by_the_page(store)
    store._database.write(lambda db: _fill(db, runs))
    assert hash_of(store) == by_the_page(store)


def _fill(db: sqlite3.Connection, runs: list[str]) -> None:
    """Nasty texts and NULL, also in the last column of a table."""
    for n, run in enumerate(runs):
        values = (*NASTY, None)
        one, other = values[n % len(values)], values[(n + 5) % len(values)]
        db.execute("UPDATE runs SET reason = ?, block = ? WHERE id = ?", [one, other, run])
        db.executemany(
            "INSERT INTO events (run_id, seq, tick, type, data) VALUES (?, ?, 1, ?, ?)",
            [(run, 1000 + m, text, NASTY[m - n % 3]) for m, text in enumerate(NASTY)],
        )


def test_a_robot_s_name_and_pattern_count_as_soon_as_one_group_has_them(store: Store) -> None:
    group = store.groups.create("Botos")
    store._database.write(lambda db: db.execute("UPDATE groups SET robot_pattern = ''"))
    hashes = [hash_of(store)]
    for changes in ({"robot_name": "Faísca"}, {"robot_pattern": "star"}):
        store.groups.change(group.id, changes)
        assert hash_of(store) == by_the_page(store)
        hashes.append(hash_of(store))
    assert len(set(hashes)) == 3


def test_a_value_that_moves_into_the_next_row_or_column_changes_the_hash(
    store: Store, version: VersionRow
) -> None:
    run = a_run(store, version.id)
    hashes = set()
    for reason, block in (('a","\0"],["b', "c"), ("a", 'b"],["c'), ("a", "b")):
        store._database.write(partial(_set_reason_and_block, values=[reason, block, run]))
        hashes.add(hash_of(store))
    assert len(hashes) == 3


def _set_reason_and_block(db: sqlite3.Connection, values: list[str]) -> None:
    db.execute("UPDATE runs SET reason = ?, block = ? WHERE id = ?", values)
