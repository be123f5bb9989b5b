"""Rows out of the pages of a file that SQLite refuses."""

from contextlib import closing
from pathlib import Path

import pytest

from storage import open_store
from storage.salvage.pages import Pages
from storage.salvage.reading import Found, read_into
from storage.sql import opened, row_count, tuples
from storage.sqlite import sqlite3
from storage.tables.migrations import migrate

PAGE = 4096
N_EDITS = 40
LONG = "y" * 3 * PAGE  # goes on in pages of its own


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """A program of many edits; the text of one is too long for its page."""
    path = tmp_path / "damaged.db"
    with open_store(path) as store:
        program = store.programs.create(store.groups.create("Onças").id, "Quadrado")
        for n in range(N_EDITS):
            text = LONG if n == 20 else f"{n} " + "x" * 900
            store.versions.save(program.id, {"text": text}, None)
    return path


def read(file: Path) -> tuple[Found, sqlite3.Connection]:
    db = sqlite3.connect(":memory:", isolation_level=None)
    migrate(db)
    with Pages(file, file.with_name("no log")) as pages:
        return read_into(db, pages, lambda: False), db


def overwrite(file: Path, page: int) -> None:
    with file.open("r+b") as octets:
        octets.seek((page - 1) * PAGE)
        octets.write(bytes(PAGE))


def root_of(file: Path, name: str) -> int:
    with closing(opened(file, "ro")) as db:
        query = "SELECT rootpage FROM sqlite_schema WHERE name = ?"
        return int(db.execute(query, [name]).fetchone()[0])


def test_a_table_without_its_root_is_told_by_its_rows(file: Path) -> None:
    overwrite(file, root_of(file, "versions"))
    found, db = read(file)
    with closing(db):
        assert row_count(db, "versions") == len(found.edits) == N_EDITS


def test_without_the_list_of_tables_all_rows_are_told_by_their_values(file: Path) -> None:
    overwrite(file, 1)
    _, db = read(file)
    with closing(db):
        counts = [row_count(db, name) for name in ("groups", "programs", "versions")]
        assert counts == [1, 1, N_EDITS]
        assert row_count(db, "content_sums") == N_EDITS


def test_a_value_of_which_a_page_is_missing_is_unread_and_the_others_are_not(file: Path) -> None:
    octets = file.read_bytes()
    pages = range(len(octets) // PAGE)
    overwrite(file, 1 + next(n for n in pages if octets[n * PAGE :][4:PAGE] == b"y" * (PAGE - 4)))
    found, db = read(file)
    with closing(db):
        numbers = {row[0] for row in tuples(db, "SELECT number FROM versions")}
        assert {number for _, number in found.edits} - numbers == {21}
        assert found.n_unread == 1


def test_values_that_run_in_a_circle_are_read_to_their_stated_length_only(file: Path) -> None:
    octets = bytearray(file.read_bytes())
    for n in range(len(octets) // PAGE):
        if octets[n * PAGE :][4:PAGE] == b"y" * (PAGE - 4):
            octets[n * PAGE : n * PAGE + 4] = (n + 1).to_bytes(4, "big")
    file.write_bytes(octets)
    found, db = read(file)
    with closing(db):
        assert row_count(db, "versions") == N_EDITS - 1
        assert len(found.edits) == N_EDITS
