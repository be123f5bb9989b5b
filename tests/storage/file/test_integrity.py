"""Damage that a start does not see: one wrong bit in an index."""

from contextlib import closing
from pathlib import Path

import pytest

from storage import ProgramRow, Store, StoreError, open_store
from storage.maintenance import Maintenance
from storage.sqlite import sqlite3

_PAGE = 4096


def damage_index_of_versions(path: Path, version: str) -> None:
    """Changes one bit of the key in the index: the table holds it as it was."""
    with closing(sqlite3.connect(path)) as db:
        query = "SELECT rootpage FROM sqlite_master WHERE name = 'sqlite_autoindex_versions_1'"
        root = db.execute(query).fetchone()[0]
    octets = bytearray(path.read_bytes())
    octets[octets.index(version.encode(), (root - 1) * _PAGE)] ^= 4
    path.write_bytes(octets)


@pytest.fixture
def damaged(store: Store, program: ProgramRow, path: Path) -> str:
    """The newest version, which is there and cannot be found."""
    for n in range(3):
        version = store.versions.save(program.id, {"n": n}, None)
    store.close()
    damage_index_of_versions(path, version.id)
    return version.id


def test_an_index_that_does_not_fit_is_made_anew(
    damaged: str, program: ProgramRow, path: Path
) -> None:
    with open_store(path) as store:
        with pytest.raises(StoreError):
            store.versions.save(program.id, {"n": 3}, None, parent_id=damaged)
        maintenance = Maintenance(store)
        maintenance.check_integrity()
        assert maintenance.notice is None
        assert store.versions.save(program.id, {"n": 3}, None, parent_id=damaged).number == 4
        assert store.check_and_reindex() is None


def test_what_cannot_be_mended_is_told(damaged: str, path: Path) -> None:
    with open_store(path) as store:
        other = sqlite3.connect(path, isolation_level=None)
        with closing(other):
            other.execute("BEGIN IMMEDIATE")  # nobody else can write now
            maintenance = Maintenance(store)
            maintenance.check_integrity()
            assert maintenance.notice
            assert maintenance.notice.code == "backup_found_damage"
            other.execute("ROLLBACK")


def test_a_look_that_is_stopped_finds_nothing(damaged: str, path: Path) -> None:
    with open_store(path) as store:
        assert store.check_and_reindex(lambda: True) is None
