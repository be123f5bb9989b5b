"""Bundles: one file that SQLite opens, with all that was to be in it."""

import os
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from storage import RunStart, Store, StoreError, open_for_reading, open_store
from storage.exchange.bundle_reading import open_bundle
from storage.exchange.bundle_writing import export_bundle
from storage.exchange.content_hash import content_hash
from storage.exchange.scope import Scope
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import a_run, exported, hash_of, merged, problems_in, work


@pytest.fixture
def busy(store: Store) -> Store:
    """Two groups of one class and one of none, with work, and a run of the command line."""
    classroom = store.classrooms.create("5º B")
    for name in ("Onças", "Araras"):
        work(store, store.groups.create(name, classroom_id=classroom.id), f"Programa {name}")
    work(store, store.groups.create("Visitas"), "Programa Visitas")
    a_run(store, None)
    return store


def rows(path: Path, query: str) -> list[tuple[object, ...]]:
    with closing(sqlite3.connect(path)) as db:
        return db.execute(query).fetchall()


def test_a_bundle_holds_what_its_store_holds(busy: Store, tmp_path: Path) -> None:
    info = exported(busy, tmp_path / "a.pinel")
    assert info.content_hash == hash_of(busy)
    with open_bundle(info.path) as bundle, closing(sqlite3.connect(bundle.address, uri=True)) as db:
        assert bundle.info == info
        assert content_hash(db) == info.content_hash
    assert info.counts["runs"] == 4
    assert problems_in(info.path) == []


def test_people_find_their_way_in_it(busy: Store, tmp_path: Path) -> None:
    path = exported(busy, tmp_path / "a.pinel").path
    names = {row[0] for row in rows(path, "SELECT name FROM group_list")}
    assert names == {"Onças", "Araras", "Visitas"}
    assert rows(path, "SELECT computer FROM run_list WHERE program IS NOT NULL")


def test_the_list_of_runs_says_which_passes_do_not_count(busy: Store) -> None:
    passed = "UPDATE runs SET passed = 1, activity = 'square' RETURNING id"
    marked = "INSERT INTO unconfirmed_runs VALUES (?, NULL, '', NULL)"
    first, *others = busy._database.write(lambda db: [row[0] for row in db.execute(passed)])
    busy._database.write(lambda db: db.execute(marked, [first]).rowcount)
    listed = rows(busy.path, "SELECT id, passed, unconfirmed FROM run_list ORDER BY id")
    assert sorted(map(tuple, listed)) == sorted(
        [(first, None, "waiting"), *((one, 1, None) for one in others)]
    )


def test_nothing_lies_beside_it(busy: Store, tmp_path: Path) -> None:
    folder = tmp_path / "stick"
    folder.mkdir()
    exported(busy, folder / "a.pinel")
    assert [file.name for file in folder.iterdir()] == ["a.pinel"]


def test_a_file_that_is_there_stays(busy: Store, tmp_path: Path) -> None:
    (tmp_path / "a.pinel").write_bytes(b"older")
    names = [exported(busy, tmp_path / "a.pinel").path.name for _ in range(2)]
    assert names == ["a-2.pinel", "a-3.pinel"]
    assert (tmp_path / "a.pinel").read_bytes() == b"older"


def test_where_nothing_can_be_written_nothing_is_left(busy: Store, tmp_path: Path) -> None:
    with pytest.raises(StoreError) as caught:
        exported(busy, tmp_path / "missing" / "a.pinel")
    assert caught.value.code == "export_failed"
    assert not (tmp_path / "missing").exists()


def test_a_run_that_goes_on_is_not_in_it(busy: Store, tmp_path: Path) -> None:
    ended_only = hash_of(busy)
    version = busy.versions.newest(busy.programs.of_group(busy.groups.all()[0].id)[0].id)
    assert version is not None

    busy.runs.begin(RunStart("sim", "w", {}, 1, "0.1.0", document={"name": "x"}))
    info = exported(busy, tmp_path / "a.pinel")
    assert (info.counts["runs"], info.content_hash) == (4, ended_only)


@pytest.mark.parametrize("kind", ["group", "program"])
def test_a_part_holds_what_it_belongs_to_and_what_belongs_to_it(
    busy: Store, tmp_path: Path, opened: Callable[..., Store], kind: str
) -> None:
    group = next(group for group in busy.groups.all() if group.name == "Onças")
    program = busy.programs.of_group(group.id)[0]
    scope = Scope(group_id=group.id) if kind == "group" else Scope(program_id=program.id)
    info = exported(busy, tmp_path / "a.pinel", scope)
    expected = {"classrooms": 1, "groups": 1, "programs": 1, "versions": 2, "version_labels": 1}
    expected |= {"runs": 1, "notes": 1, "lessons": 1, "computers": 1, "tombstones": 0}
    assert expected.items() <= info.counts.items()
    other = opened(tmp_path / "other.db")
    merged(other, info.path)
    assert other.programs.of_group(group.id)[0].name == "Programa Onças"
    assert other.classrooms.all()[0].name == "5º B"
    assert problems_in(tmp_path / "other.db") == []


def test_a_class_comes_with_its_groups(busy: Store, tmp_path: Path) -> None:
    classroom = busy.classrooms.all()[0]
    info = exported(busy, tmp_path / "a.pinel", Scope(classroom_id=classroom.id))
    assert (info.counts["groups"], info.counts["runs"], info.counts["classrooms"]) == (2, 2, 1)


@pytest.mark.parametrize("kind", ["classroom", "group", "program"])
def test_what_is_not_there_cannot_be_exported(store: Store, tmp_path: Path, kind: str) -> None:
    with pytest.raises(StoreError) as caught:
        exported(store, tmp_path / "a.pinel", Scope(**{f"{kind}_id": "x"}))
    assert caught.value.code == f"{kind}_not_found"
    assert not list(tmp_path.glob("*.pinel"))


def test_the_store_remembers_where_it_went(busy: Store, tmp_path: Path, path: Path) -> None:
    exported(busy, tmp_path / "a.pinel")
    assert rows(path, "SELECT path FROM exports") == [(str(tmp_path / "a.pinel"),)]


def test_a_store_that_can_only_be_read_is_exported_too(
    busy: Store, tmp_path: Path, path: Path
) -> None:
    computer = busy.computers.this()
    busy.close()

    with open_for_reading(path) as reading:
        info = export_bundle(
            reading._database, tmp_path / "a.pinel", app_version="1", computer=computer
        )
    assert info.counts["runs"] == 4


def test_nobody_works_inside_a_bundle(busy: Store, tmp_path: Path) -> None:
    path = exported(busy, tmp_path / "a.pinel").path
    before = path.read_bytes()
    for opening in (open_store, open_for_reading):
        with pytest.raises(StoreError) as caught:
            opening(path)
        assert caught.value.code == "database_is_bundle"
    assert path.read_bytes() == before


def test_copies_that_a_merge_left_behind_go_after_a_day(
    busy: Store, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    temporary = tmp_path / "temporary"
    monkeypatch.setattr("tempfile.tempdir", str(temporary))
    old, new, other = (temporary / name for name in ("pinel-bundle-a", "pinel-bundle-b", "other"))
    for folder in (old, new, other):
        folder.mkdir(parents=True)
        (folder / "bundle").write_bytes(b"x")
    for folder in (old, other):
        os.utime(folder, (0, 0))
    with open_bundle(exported(busy, tmp_path / "a.pinel").path):
        assert not old.exists()
    assert sorted(temporary.iterdir()) == [other, new]
