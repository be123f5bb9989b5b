"""Files of earlier releases are brought up to date with all that they hold."""

from collections.abc import Callable
from pathlib import Path

import pytest

from storage import Store, StoreError, open_for_reading
from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS
from storage.tables.migrations import migrate


@pytest.fixture
def before_worlds(path: Path) -> Path:
    """A file from before versions had worlds, with one of them."""
    with sqlite3.connect(path) as db:
        migrate(db, n_steps=2)
        db.executescript(
            """INSERT INTO groups VALUES ('g', 'A', 'a', '#000000', 't', 't');
               INSERT INTO programs VALUES ('p', 'g', 'Quadrado', 't', 't');
               INSERT INTO versions VALUES ('v', 'p', 1, 't', '{"b":1}', NULL, '[]');"""
        )
    db.close()
    return path


def test_a_version_from_before_worlds_has_none_and_is_still_the_newest(
    before_worlds: Path, opened: Callable[..., Store]
) -> None:
    versions = opened(before_worlds).versions
    kept = versions.get("v")
    assert (kept.workspace, kept.world) == ({"b": 1}, None)
    assert versions.save("p", {"b": 1}, None).id == "v"
    assert versions.save("p", {"b": 1}, None, world={"name": "own"}).world == {"name": "own"}


def test_the_file_s_description_of_itself_follows(
    before_worlds: Path, opened: Callable[..., Store]
) -> None:
    opened(before_worlds)
    with sqlite3.connect(before_worlds) as db:
        meanings = dict(db.execute("SELECT name, meaning FROM about"))
    db.close()
    assert "world" in meanings["versions"]


def test_a_file_that_is_only_to_be_looked_at_is_not_brought_up_to_date(before_worlds: Path) -> None:
    before = before_worlds.read_bytes()
    with pytest.raises(StoreError) as caught:
        open_for_reading(before_worlds)
    assert caught.value.code == "database_older"
    assert before_worlds.read_bytes() == before


def test_a_new_file_that_cannot_be_finished_has_no_table_yet(
    path: Path, opened: Callable[..., Store], monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as broken:
        broken.setitem(MIGRATIONS, "last", ("no statement",))
        with pytest.raises(StoreError):
            opened()
    with sqlite3.connect(path) as db:
        assert db.execute("SELECT count(*) FROM sqlite_master").fetchone() == (0,)
    db.close()
    assert opened().can_write
