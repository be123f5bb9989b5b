"""What is deleted for good is gone, from every table and from the bytes of the file."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from storage import RunRecorder, RunStart, Store, StoreError
from storage.exchange.content_hash import content_hash
from storage.exchange.deleting.deletion import purge_keys
from storage.exchange.scope import Scope
from storage.file.opening import connect
from storage.sql import checkpoint
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import exported, work
from tests.storage.sample_documents import SQUARE, WORLD
from tests.storage.sample_runs import ended, sample


@pytest.fixture
def db(store: Store, path: Path) -> Iterator[sqlite3.Connection]:
    connection = connect(path.as_uri())
    yield connection
    connection.close()


def busy_group(store: Store, name: str) -> str:
    """A group with a program, a version and a run whose texts all hold the name."""
    group = store.groups.create(name)
    program = store.programs.create(group.id, f"{name} program")
    version = store.versions.save(program.id, {"text": f"{name} blocks " * 900}, SQUARE)
    run = store.runs.begin(RunStart("sim", "w", WORLD, 1, "0.1.0", version_id=version.id))
    recorder = RunRecorder(store)
    for tick in range(40):
        recorder(sample(run.id, tick))
    recorder({"v": 1, "type": "said", "run": run.id, "seq": 40, "tick": 39, "text": name})
    recorder(ended(run.id, 41, 40))
    return group.id


def removed(db: sqlite3.Connection, *ids: str) -> dict[str, int]:
    db.execute("BEGIN IMMEDIATE")
    deletion = purge_keys(db, ids)
    db.execute("COMMIT")
    return deletion.counts


def test_a_group_goes_with_all_that_it_made(store: Store, db: sqlite3.Connection) -> None:
    deleted, retained = (busy_group(store, name) for name in ("Zebras", "Onças"))
    counts = removed(db, deleted)
    assert counts == {
        "events": 2,
        "telemetry": 1,
        "runs": 1,
        "versions": 1,
        "programs": 1,
        "groups": 1,
    }
    assert [group.id for group in store.groups.all()] == [retained]
    assert db.execute("PRAGMA foreign_key_check").fetchall() == []
    assert removed(db, deleted) == {}


def test_nothing_of_its_text_is_left_in_the_file(
    store: Store, db: sqlite3.Connection, path: Path
) -> None:
    deleted = busy_group(store, "Zebras")
    for n in range(30):
        busy_group(store, f"Onças {n}")
    removed(db, deleted)
    assert checkpoint(db)
    assert b"Zebras" not in path.read_bytes()
    assert path.with_name(f"{path.name}-wal").stat().st_size == 0


def test_keys_that_are_not_there_are_kept_from_coming(db: sqlite3.Connection) -> None:
    before = content_hash(db)
    assert removed(db, "0193a5b0-0000-7000-8000-000000000000") == {}
    assert content_hash(db) != before


class TestRemove:
    def test_a_class_goes_with_its_groups_and_lessons(self, store: Store) -> None:
        classroom = store.classrooms.create("5º B")
        work(store, store.groups.create("Onças", classroom_id=classroom.id), "P")
        work(store, store.groups.create("Visitas"), "P")
        removal = store.exchange.purge("classroom", classroom.id)
        assert (removal.counts["groups"], removal.counts["lessons"], len(removal.ids)) == (1, 1, 4)
        assert [group.name for group in store.groups.all()] == ["Visitas"]
        assert store.classrooms.all() == []

    def test_a_program_goes_with_its_runs_and_labels(self, store: Store) -> None:
        group = store.groups.create("Onças")
        deleted, _ = work(store, group, "P")
        retained, _ = work(store, group, "Q")
        counts = store.exchange.purge("program", deleted.id).counts
        assert (counts["version_labels"], counts["runs"], counts["notes"]) == (1, 1, 1)
        assert [program.id for program in store.programs.of_group(group.id)] == [retained.id]

    def test_a_run_goes_with_its_notes_and_leaves_the_version(self, store: Store) -> None:
        program, run_id = work(store, store.groups.create("Onças"), "P")
        counts = store.exchange.purge("run", run_id).counts
        assert counts == {"events": 2, "telemetry": 1, "notes": 1, "runs": 1}
        assert store.programs.get(program.id).n_versions == 2

    def test_a_name_that_it_had_before_is_gone_too(self, store: Store, path: Path) -> None:
        group = store.groups.create("Zebras")
        work(store, group, "Quagga")
        store.groups.change(group.id, {"name": "Onças"})
        assert store.exchange.purge("group", group.id).overwritten
        octets = path.read_bytes()
        assert [name for name in ("Zebras", "Quagga", "Onças") if name.encode() in octets] == []

    def test_names_of_files_go_with_the_group_that_they_name(
        self, store: Store, path: Path
    ) -> None:
        deleted, retained = (store.groups.create(name) for name in ("Zebras", "Onças"))
        folder = path.parent
        for group in (deleted, retained):
            scope = Scope(group_id=group.id)
            dest = folder / f"{group.name}.pinel"
            store.exchange.export(dest, app_version="1", computer=("", ""), scope=scope)
        (export,) = store.exchange.purge("group", deleted.id).exports
        assert export.path == str(folder / "Zebras.pinel")
        assert b"Zebras" not in path.read_bytes()
        (export,) = store.exchange.purge("group", retained.id).exports
        assert export.path == str(folder / "Onças.pinel")

    def test_while_somebody_reads_the_log_it_says_so(
        self, store: Store, db: sqlite3.Connection, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr("storage.file.opening._BUSY_S", 0.05)
        group = store.groups.create("Zebras")
        db.execute("BEGIN")
        db.execute("SELECT count(*) FROM groups").fetchone()
        assert not store.exchange.purge("group", group.id).overwritten
        db.execute("ROLLBACK")

    def test_a_group_whose_run_goes_on_is_not_deleted(self, store: Store) -> None:
        group = store.groups.create("Onças")
        program = store.programs.create(group.id, "P")
        version = store.versions.save(program.id, {}, SQUARE)
        store.runs.begin(RunStart("sim", "w", WORLD, 1, "0.1.0", version_id=version.id))
        with pytest.raises(StoreError) as caught:
            store.exchange.purge("group", group.id)
        assert caught.value.code == "run_in_progress"
        assert store.groups.get(group.id).n_runs == 1

    @pytest.mark.parametrize("kind", ["classroom", "group", "program", "run", "lesson", "note"])
    def test_what_is_not_there_cannot_be_deleted(self, store: Store, kind: str) -> None:
        with pytest.raises(StoreError) as caught:
            store.exchange.purge(kind, "x")
        assert caught.value.code == f"{kind}_not_found"

    def test_bundles_that_may_still_hold_it_are_named(self, store: Store, tmp_path: Path) -> None:
        deleted, other = (store.groups.create(name) for name in ("Onças", "Araras"))
        program, _ = work(store, deleted, "P")
        scopes = {
            "all": Scope(),
            "group": Scope(group_id=deleted.id),
            "program": Scope(program_id=program.id),
            "other": Scope(group_id=other.id),
        }
        for name, scope in scopes.items():
            exported(store, tmp_path / f"{name}.pinel", scope)
        exports = store.exchange.purge("group", deleted.id).exports
        assert [Path(export.path).stem for export in exports] == ["all", "group", "program"]
        assert all(export.made_at for export in exports)
