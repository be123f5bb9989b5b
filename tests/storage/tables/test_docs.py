"""The page about the file says what is in it, and nothing else."""

import sqlite3
from pathlib import Path

from storage import Store
from storage.description import text

PAGE = Path(__file__).parents[2] / "docs" / "database.md"


def test_the_page_is_current() -> None:
    assert PAGE.read_text("utf-8") == text(), "python -m storage.description > docs/database.md"


def test_every_table_is_described(store: Store) -> None:
    with sqlite3.connect(store.path) as db:
        tables = {row[0] for row in db.execute("SELECT name FROM sqlite_master WHERE type='table'")}
    db.close()
    described = {line[4:] for line in text().splitlines() if line.startswith("### ")}
    assert tables - described == {"_sqlite_migrations"}


def test_every_view_can_be_read(store: Store) -> None:
    with sqlite3.connect(store.path) as db:
        for (name,) in db.execute("SELECT name FROM sqlite_master WHERE type='view'").fetchall():
            assert f"**{name}**" in text() or name == "about"
            db.execute(f"SELECT * FROM {name}").fetchall()
    db.close()
