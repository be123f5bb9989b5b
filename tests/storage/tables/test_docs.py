"""The page about the file says what is in it, and nothing else."""

import sqlite3
from pathlib import Path

import pytest

from storage import Store
from storage.tables.description import PAGES, database_page, page

DOCS = Path(__file__).parents[3] / "docs"


@pytest.mark.parametrize("name", PAGES)
def test_the_page_is_current(name: str) -> None:
    current = (DOCS / f"{name}.md").read_text("utf-8")
    assert current == page(name, current), "python -m storage.tables.description"


def test_every_table_is_described(store: Store) -> None:
    with sqlite3.connect(store.path) as db:
        tables = {row[0] for row in db.execute("SELECT name FROM sqlite_master WHERE type='table'")}
    db.close()
    described = {line[4:] for line in database_page().splitlines() if line.startswith("### ")}
    assert tables - described == {"_sqlite_migrations"}


def test_every_view_can_be_read(store: Store) -> None:
    with sqlite3.connect(store.path) as db:
        for (name,) in db.execute("SELECT name FROM sqlite_master WHERE type='view'").fetchall():
            assert f"**{name}**" in database_page() or name == "about"
            db.execute(f"SELECT * FROM {name}").fetchall()
    db.close()
