"""Files of earlier releases are brought up to date with all that they hold."""

from collections.abc import Callable
from pathlib import Path

import pytest

from storage import Store, StoreError, open_for_reading
from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS
from storage.tables.replicated import TABLES
from tests.storage.file.refusals import code_of


def test_the_file_s_description_of_itself_follows(
    older: Path, opened: Callable[..., Store], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(TABLES, "groups", TABLES["programs"])
    opened(older)
    with sqlite3.connect(older) as db:
        meanings = dict(db.execute("SELECT name, meaning FROM about"))
    db.close()
    assert "groups" not in meanings


def test_a_file_that_is_only_to_be_looked_at_is_not_brought_up_to_date(older: Path) -> None:
    before = older.read_bytes()
    with pytest.raises(StoreError) as caught:
        open_for_reading(older)
    assert caught.value.code == "database_older"
    assert older.read_bytes() == before


def test_a_file_with_only_some_of_the_first_steps_is_of_no_release(
    older: Path, opened: Callable[..., Store]
) -> None:
    with sqlite3.connect(older) as db:
        db.execute("DELETE FROM _sqlite_migrations WHERE name = 'deletions'")
    db.close()
    assert code_of(lambda: opened(older)) == "database_foreign"


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
