"""The tables that the migrations make are those that are declared, column by column."""

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from storage.sqlite import sqlite3
from storage.tables.columns import TEXT, UNCHANGED, Column, ReplicatedTable
from storage.tables.migrations import MIGRATIONS_TABLE, migrate
from storage.tables.replicated import REPLICATED, TABLES
from storage.tables.rules import short

BUNDLES = Path(__file__).parents[3] / "docs" / "bundles.md"


@pytest.fixture(scope="module")
def fresh() -> Iterator[sqlite3.Connection]:
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as db:
        migrate(db)
        yield db


def test_every_table_is_declared_and_every_declared_table_is_made(
    fresh: sqlite3.Connection,
) -> None:
    made = {row[0] for row in fresh.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    assert made - {MIGRATIONS_TABLE} == set(TABLES)


@pytest.mark.parametrize("name", TABLES)
def test_columns_have_the_type_that_is_declared_and_are_empty_only_where_they_may_be(
    fresh: sqlite3.Connection, name: str
) -> None:
    table = TABLES[name]
    rows = fresh.execute(f"PRAGMA table_info({name})").fetchall()
    made = {(row[1], row[2], bool(row[3] or row[5])) for row in rows}
    assert made == {(one.name, one.kind.sql, not one.optional) for one in table.columns}
    assert {row[1] for row in rows if row[5]} == set(table.key)


@pytest.mark.parametrize("table", REPLICATED, ids=lambda table: table.name)
def test_parents_are_the_foreign_keys_and_stand_before_their_rows(
    fresh: sqlite3.Connection, table: ReplicatedTable
) -> None:
    rows = fresh.execute(f"PRAGMA foreign_key_list({table.name})").fetchall()
    assert set(table.parents) == {(row[3], row[2]) for row in rows}
    before = [other.name for other in REPLICATED[: REPLICATED.index(table)]]
    assert {parent for _, parent in table.parents} <= set(before)


def test_columns_refer_to_tables_that_are_declared() -> None:
    named = {column.references for table in TABLES.values() for column in table.columns}
    assert named - {""} <= set(TABLES)


def test_a_text_must_say_what_becomes_of_it_in_an_anonymous_bundle() -> None:
    assert Column("motto", TEXT, "a motto", short, UNCHANGED).anonymous == UNCHANGED
    with pytest.raises(ValueError, match="motto"):
        Column("motto", TEXT, "a motto", short)


def test_the_page_about_bundles_tells_the_order_of_the_tables() -> None:
    page = " ".join(BUNDLES.read_text("utf-8").split())
    assert f"in the order {', '.join(table.name for table in REPLICATED)} a JSON" in page
