"""The page about the file says what is in it, and nothing else."""

from scripts.reference.database import tables_and_views
from storage import Store
from storage.sqlite import sqlite3


def test_every_table_is_described(store: Store) -> None:
    with sqlite3.connect(store.path) as db:
        tables = {row[0] for row in db.execute("SELECT name FROM sqlite_master WHERE type='table'")}
    db.close()
    described = {line[4:] for line in tables_and_views().splitlines() if line.startswith("### ")}
    assert tables - described == {"_sqlite_migrations"}


def test_every_view_can_be_read(store: Store) -> None:
    with sqlite3.connect(store.path) as db:
        for (name,) in db.execute("SELECT name FROM sqlite_master WHERE type='view'").fetchall():
            assert f"**{name}**" in tables_and_views() or name == "about"
            db.execute(f"SELECT * FROM {name}").fetchall()
    db.close()
