"""Rows out of a file that SQLite refuses."""

from contextlib import closing
from pathlib import Path

import pytest

from storage import open_store
from storage.salvage.page_reader import EDITS_INDEX, roots
from storage.salvage.row_recovery import RecoveryStats, recover_rows
from storage.sql import opened, row_count, tuples
from storage.sqlite import sqlite3
from storage.tables.migrations import migrate

PAGE = 4096
N_EDITS = 120  # their index has more than one page
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


def read(file: Path, *, stop: bool = False) -> tuple[RecoveryStats, sqlite3.Connection]:
    """The roots of a sound file of this release, as a backup has them, stand in for a damaged list of tables."""
    db = sqlite3.connect(file.with_name("remains"), isolation_level=None)
    migrate(db)
    return recover_rows(db, file, file.parent, roots(file.with_name("remains")), lambda: stop), db


def overwrite(file: Path, page: int, octets: bytes = bytes(PAGE)) -> None:
    with file.open("r+b") as opened_file:
        opened_file.seek((page - 1) * PAGE)
        opened_file.write(octets)


def root_of(file: Path, name: str) -> int:
    return roots(file)[name]


@pytest.mark.parametrize("octets", [bytes(PAGE), b"\xff" * PAGE, b"\x05" * PAGE])
def test_a_table_without_its_root_is_recognised_by_its_rows(file: Path, octets: bytes) -> None:
    overwrite(file, root_of(file, "versions"), octets)
    found, db = read(file)
    with closing(db):
        assert row_count(db, "versions") == len(found.edits) == N_EDITS


def test_without_the_list_of_tables_all_rows_are_read(file: Path) -> None:
    with open_store(file) as store:
        store.settings.set("language", "es")
    overwrite(file, 1)
    found, db = read(file)
    with closing(db):
        counts = [row_count(db, name) for name in ("groups", "programs", "versions")]
        assert counts == [1, 1, N_EDITS]
        assert row_count(db, "content_sums") == N_EDITS
        assert row_count(db, "settings", "key = 'language'") == 1
        assert len(found.edits) == N_EDITS


def test_with_a_list_of_tables_that_leads_elsewhere_rows_are_recognised_by_their_values(
    file: Path,
) -> None:
    places = roots(file)
    with closing(opened(file, "rw")) as db:
        db.execute("PRAGMA writable_schema = ON")
        names = [name for name in places if name != EDITS_INDEX]
        for name, other in zip(names, (*names[1:], names[0]), strict=True):
            db.execute(
                "UPDATE sqlite_schema SET rootpage = ? WHERE name = ?", [places[other], name]
            )
    _, db = read(file)
    with closing(db):
        counts = [row_count(db, name) for name in ("groups", "programs", "versions", "computers")]
        assert counts == [1, 1, N_EDITS, 1]


def test_a_value_of_which_a_page_is_missing_is_unread_and_the_others_are_not(file: Path) -> None:
    overwrite(file, page_of(file, "y"))
    found, db = read(file)
    with closing(db):
        numbers = {row[0] for row in tuples(db, "SELECT number FROM versions")}
        assert {number for _, number in found.edits} - numbers == {21}


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


@pytest.mark.timeout(60)
def test_a_tree_that_runs_in_a_circle_is_read_once(file: Path) -> None:
    root = root_of(file, "versions")
    page = bytearray(file.read_bytes()[(root - 1) * PAGE : root * PAGE])
    page[8:12] = root.to_bytes(4, "big")  # its last child is itself
    overwrite(file, root, bytes(page))
    found, db = read(file)
    with closing(db):
        assert row_count(db, "versions") == len(found.edits) == N_EDITS


def test_a_reading_without_time_says_that_it_was_cut_short(file: Path) -> None:
    found, db = read(file, stop=True)
    with closing(db):
        assert found.is_cut_short


def page_of(file: Path, sign: str) -> int:
    """A page that holds the continuation of a long text."""
    octets, whole = file.read_bytes(), sign.encode() * (PAGE - 4)
    return 1 + next(n for n in range(len(octets) // PAGE) if octets[n * PAGE :][4:PAGE] == whole)


def test_a_wrong_bit_in_the_count_of_a_page_loses_no_row(file: Path) -> None:
    octets = file.read_bytes()
    of_edits = next(n for n in range(len(octets) // PAGE) if b'"0 xxx' in octets[n * PAGE :][:PAGE])
    page = bytearray(octets[of_edits * PAGE :][:PAGE])
    page[3] ^= 0x80
    overwrite(file, of_edits + 1, bytes(page))
    _, db = read(file)
    with closing(db):
        assert row_count(db, "versions") == N_EDITS
