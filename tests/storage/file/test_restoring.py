"""A backup comes back: in place of a damaged file, and before the tables change."""

import errno
import os
from pathlib import Path

import pytest

from storage import open_store
from storage.file.backups import (
    damage_of,
    list_backups,
)
from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS
from tests.storage.file.backup_files import DAY, NOON, backed_up, names_in, ruin
from tests.storage.file.refusals import code_of


def contents(folder: Path) -> dict[Path, bytes]:
    return {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def test_a_damaged_file_gives_way_to_its_last_backup_and_lies_beside(path: Path) -> None:
    with open_store(path) as store:
        store.groups.create("A")
        backup = backed_up(path)
        store.groups.create("B")
    damaged = ruin(path)
    with open_store(path, clock=lambda: NOON) as store:
        assert store.notice is not None
        assert store.notice.code == "database_restored"
        assert store.notice.params["name"] == "pinel.damaged-20261121-120000.db"
        assert str(store.notice.params["time"]).startswith("2026-11-2")
        assert [group.name for group in store.groups.all()] == ["A"]
        assert store.groups.create("C").name == "C"
    assert path.with_name("pinel.damaged-20261121-120000.db").read_bytes() == damaged
    assert names_in(backup.path) == ["A"]
    with open_store(path) as store:
        assert store.notice is None


def test_where_the_newest_backup_is_bad_an_older_one_comes_back(path: Path) -> None:
    with open_store(path) as store:
        for n, name in enumerate("ABCD"):
            store.groups.create(name)
            backed_up(path, NOON + n * DAY)
    newest, second, third, _ = (backup.path for backup in list_backups(path))
    newest.write_bytes(b"rubbish" * 1000)
    second.write_bytes(b"")
    with sqlite3.connect(third) as db:
        db.execute("DROP TABLE _sqlite_migrations")  # of another program
    db.close()
    ruin(path)
    with open_store(path) as store:
        assert store.notice is not None
        assert store.notice.code == "database_restored"
        assert [group.name for group in store.groups.all()] == ["A"]


@pytest.mark.parametrize("is_missing", [True, False], ids=["missing", "damaged"])
def test_a_file_whose_backups_are_of_a_newer_program_is_refused_and_not_touched(
    is_missing: bool, path: Path
) -> None:
    with open_store(path) as store:
        for n, name in enumerate("AB"):
            store.groups.create(name)
            backed_up(path, NOON + n * DAY)
    with sqlite3.connect(list_backups(path)[0].path) as db:
        db.execute(
            "INSERT INTO _sqlite_migrations (migration_set, name, applied_at) VALUES ('pinel', 'next', '2031')"
        )
    db.close()
    if is_missing:
        path.unlink()
    else:
        ruin(path)
    before = contents(path.parent)
    assert code_of(lambda: open_store(path)) == "database_newer"
    assert contents(path.parent) == before


def test_where_no_backup_is_good_a_new_file_is_begun_as_without_any(path: Path) -> None:
    with open_store(path) as store:
        store.groups.create("A")
    backed_up(path).path.write_bytes(b"rubbish" * 1000)
    ruin(path)
    with open_store(path) as store:
        assert store.notice is not None
        assert store.notice.code == "database_set_aside"
        assert store.groups.all() == []
    assert len(list_backups(path)) == 1


@pytest.mark.parametrize(
    ("number", "code"), [(errno.ENOSPC, "disk_full"), (errno.EROFS, "database_read_only")]
)
def test_a_damaged_file_stays_in_its_place_while_the_backup_cannot_be_copied(
    path: Path, monkeypatch: pytest.MonkeyPatch, number: int, code: str
) -> None:
    with open_store(path) as store:
        store.groups.create("A")
        backed_up(path)
    damaged = ruin(path)

    def fail(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    with monkeypatch.context() as patch:
        patch.setattr("shutil.copyfile", fail)
        assert code_of(lambda: open_store(path)) == code
    assert path.read_bytes() == damaged
    with open_store(path) as store:
        assert [group.name for group in store.groups.all()] == ["A"]


@pytest.mark.parametrize("step", ["copy", "whole", "", "-wal", "-shm", "in place"])
def test_a_power_cut_while_a_backup_comes_back_loses_nothing(
    path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    with open_store(path) as store:
        store.groups.create("A")
        backed_up(path)
        store.groups.create("B")
        copies = {
            suffix: path.with_name(path.name + suffix).read_bytes() for suffix in ("-wal", "-shm")
        }
    ruin(path)
    for suffix, content in copies.items():  # of the damaged file, not of what takes its place
        path.with_name(path.name + suffix).write_bytes(content)
    steps = iter(["copy", "whole", "", "-wal", "-shm", "in place"])

    def cut_off(old: Path, new: Path) -> Path:
        if next(steps) == step:
            raise KeyboardInterrupt
        os.replace(old, new)
        return new

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", cut_off)
        patch.setattr(Path, "rename", cut_off)
        with pytest.raises(KeyboardInterrupt):
            open_store(path)
    with open_store(path) as store:
        assert {group.name for group in store.groups.all()} == {"A", "B"}  # B was in the WAL
    assert not path.with_name("pinel.db.restoring").exists()
    assert damage_of(path) is None


def test_before_a_file_is_brought_up_to_date_it_is_backed_up_as_it_was(older: Path) -> None:
    with open_store(older, clock=lambda: NOON) as store:
        assert store.notice is None
    (backup,) = list_backups(older)
    assert (backup.made_at, names_in(backup.path)) == (NOON, ["A"])
    db = sqlite3.connect(f"{backup.path.as_uri()}?immutable=1", uri=True)
    applied = db.execute("SELECT name FROM _sqlite_migrations ORDER BY id").fetchall()
    assert [*applied, ("newest",)] == [(name,) for name in MIGRATIONS]
    db.close()
    open_store(older).close()
    assert list_backups(older) == [backup]


def test_a_disk_without_room_for_a_backup_does_not_keep_a_file_from_being_brought_up_to_date(
    older: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    nothing = type("Usage", (), {"free": 0})
    monkeypatch.setattr("shutil.disk_usage", lambda folder: nothing)
    with open_store(older) as store:
        assert store.notice is not None
        assert store.notice.code == "backup_no_room"
        assert store.groups.create("B").name == "B"
