"""Merging: in any order, any number of times, cut off and begun again, it comes to the same."""

import itertools
import random
import subprocess
import sys
import time
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import RunRecorder, RunStart, StoreError, open_for_reading, open_store
from storage.exchange.known_computers import known_computers
from storage.exchange.merging import merge
from storage.exchange.scope import Scope
from storage.file.backups import list_backups, make_backup
from tests.storage.bundle_makers import (
    Opened,
    a_run,
    a_store,
    exported,
    hash_of,
    merged,
    problems_in,
    removed,
    work,
)
from tests.storage.exchange.random_life import RandomLife
from tests.storage.sample_documents import WORLD
from tests.storage.sample_runs import ended


def hash_after(folder: Path, files: list[Path]) -> str:
    """Of a fresh store into which the bundles were merged in this order."""
    path = folder / f"{'-'.join(file.stem for file in files)}.db"
    with open_store(path) as store:
        for file in files:
            merged(store, file)
        found = hash_of(store)
    assert problems_in(path) == []
    return found


def test_all_that_was_made_on_another_pc_is_there(pc: Opened, tmp_path: Path) -> None:
    here, there = pc("a"), pc("b")
    group = there.groups.create("Onças", classroom_id=there.classrooms.create("5º B").id)
    program, run_id = work(there, group, "Quadrado")
    info = exported(there, tmp_path / "b.pinel")
    report = merged(here, info.path)
    assert report.added["runs"] == 1
    assert not report.nothing_new
    assert here.groups.all() == there.groups.all()
    assert here.versions.newest(program.id) == there.versions.newest(program.id)
    assert here.runs.get(run_id) == there.runs.get(run_id)
    assert here.runs.events(run_id) == there.runs.events(run_id)
    assert here.runs.telemetry(run_id).to_wire() == there.runs.telemetry(run_id).to_wire()
    assert hash_of(here) == hash_of(there) == info.content_hash


def test_a_robot_comes_with_its_group(pc: Opened, tmp_path: Path) -> None:
    there, here = pc("there"), pc("here")
    group = there.groups.create("Botos")
    robot = {"robot_name": "Faísca", "robot_pattern": "dots"}
    there.groups.change(group.id, robot)
    merged(here, exported(there, tmp_path / "there.pinel").path)
    (found,) = here.groups.all()
    assert (found.robot_name, found.robot_pattern) == ("Faísca", "dots")


def test_the_same_again_changes_nothing(pc: Opened, tmp_path: Path) -> None:
    here, there = pc("a"), pc("b")
    work(there, there.groups.create("Onças"), "Quadrado")
    path = exported(there, tmp_path / "b.pinel").path
    merged(here, path)
    before = hash_of(here)
    assert merged(here, path).nothing_new
    assert merged(here, exported(there, tmp_path / "b2.pinel").path).nothing_new
    assert merged(there, path).nothing_new
    assert hash_of(here) == before


def test_two_groups_of_one_name_are_both_kept(pc: Opened, tmp_path: Path) -> None:
    stores = [pc("a"), pc("b")]
    for store in stores:
        work(store, store.groups.create("Onças"), "Quadrado")
    merged(stores[0], exported(stores[1], tmp_path / "b.pinel").path)
    assert [group.name for group in stores[0].groups.all()] == ["Onças", "Onças"]


def test_both_sides_keep_what_they_made_of_one_program(pc: Opened, tmp_path: Path) -> None:
    here, there = pc("a"), pc("b")
    group = here.groups.create("Onças")
    program, _ = work(here, group, "Quadrado")
    merged(there, exported(here, tmp_path / "a.pinel", Scope(program_id=program.id)).path)
    for store, text in ((here, "mine"), (there, "theirs")):
        version = store.versions.save(program.id, {"text": text}, None)
        a_run(store, version.id)
    there.programs.rename(program.id, "Quadrado grande")
    report = merged(here, exported(there, tmp_path / "b.pinel").path)
    assert (report.added["versions"], report.changed["programs"]) == (1, 1)
    found = here.programs.get(program.id)
    assert (found.name, found.n_versions, found.n_runs) == ("Quadrado grande", 4, 3)


def test_of_two_ways_to_go_on_the_one_that_is_not_open_is_told(pc: Opened, tmp_path: Path) -> None:
    here, there = pc("a"), pc("b")
    program, _ = work(here, here.groups.create("Onças"), "Quadrado")
    merged(there, exported(here, tmp_path / "a.pinel").path)
    for store, texts in ((here, ("mine",)), (there, ("theirs", "theirs again"))):
        for text in texts:
            last = store.versions.save(program.id, {"text": text}, None)
            assert store.versions.newest_on_other_pc(last) is None
    merged(here, exported(there, tmp_path / "b.pinel").path)
    newest = here.versions.newest(program.id)
    assert newest
    assert newest.workspace == {"text": "theirs again"}
    other = here.versions.newest_on_other_pc(newest)
    assert other
    assert here.versions.get(other.id).workspace == {"text": "mine"}
    here.versions.save(program.id, {"text": "both"}, None)
    back = here.versions.newest(program.id)
    assert back
    assert here.versions.newest_on_other_pc(back) is None  # no end of another PC is left


@pytest.mark.parametrize("seed", range(4))
def test_every_order_comes_to_the_same(seed: int, tmp_path: Path) -> None:
    chance = random.Random(seed)
    files: list[Path] = []
    for n in range(4):
        # clocks of school PCs are often wrong
        with a_store(tmp_path / f"pc{n}.db", f"{2010 + 9 * n}-05-01T10:00:00+00:00") as store:
            life = RandomLife(store, chance, files)
            life.advance(n_steps=25)
            files.append(exported(store, tmp_path / f"{n}.pinel").path)
            life.advance(n_steps=5)
            if n == 3:
                files.append(exported(store, tmp_path / f"{n}b.pinel").path)
    orders = list(itertools.permutations(files))
    chance.shuffle(orders)
    repeated = [*files, *files]
    chance.shuffle(repeated)
    hashes = {hash_after(tmp_path, list(order)) for order in (*orders[:10], repeated)}
    assert len(hashes) == 1


def test_stores_that_have_merged_each_other_are_the_same(pc: Opened, tmp_path: Path) -> None:
    stores = [pc(name) for name in "abc"]
    for store in stores:
        work(store, store.groups.create("Onças"), "Quadrado")
    files = [exported(store, tmp_path / f"{n}.pinel").path for n, store in enumerate(stores)]
    for store in stores:
        for file in files:
            merged(store, file)
    assert len({hash_of(store) for store in stores}) == 1


class TestDeleted:
    def test_what_was_deleted_here_does_not_come_back(self, pc: Opened, tmp_path: Path) -> None:
        store = pc("a")
        group = store.groups.create("Onças")
        work(store, group, "Quadrado")
        old = exported(store, tmp_path / "old.pinel").path
        removed(store, group.id)
        before = hash_of(store)
        report = merged(store, old)
        assert report.nothing_new
        assert report.skipped["runs"] == 1
        assert hash_of(store) == before

    def test_it_is_deleted_wherever_the_bundle_goes(self, pc: Opened, tmp_path: Path) -> None:
        here, there = pc("a"), pc("b")
        group = here.groups.create("Onças")
        work(here, group, "Quadrado")
        merged(there, exported(here, tmp_path / "1.pinel").path)
        there_too, _ = work(there, group, "Feito aqui")
        removed(here, group.id)
        report = merged(there, exported(here, tmp_path / "2.pinel").path)
        assert (report.removed["groups"], report.removed["runs"]) == (1, 2)
        assert there.groups.all() == []
        merged(here, exported(there, tmp_path / "3.pinel").path)
        assert hash_of(here) == hash_of(there)
        assert there_too.id not in {run.program_id for run in here.runs.newest(10)}

    def test_nothing_is_deleted_until_it_is_confirmed(self, pc: Opened, tmp_path: Path) -> None:
        here, there = pc("a"), pc("b")
        classroom = here.classrooms.create("5º B")
        work(here, here.groups.create("Onças", classroom_id=classroom.id), "Quadrado")
        merged(there, exported(here, tmp_path / "1.pinel").path)
        removed(there, classroom.id)
        work(there, there.groups.create("Araras"), "Outro")
        path = exported(there, tmp_path / "2.pinel").path
        before = here.groups.all()
        first, again = (merged(here, path, delete=False) for _ in range(2))
        assert first.would_delete == again.would_delete
        assert first.would_delete is not None
        assert first.would_delete.names[:2] == ("5º B", "Onças")
        counts = first.would_delete
        assert (counts.groups, counts.programs, counts.runs) == (1, 1, 1)
        assert (first.removed, first.added["runs"], again.added) == ({}, 1, {})
        assert [group for group in here.groups.all() if group in before] == before
        late = merged(here, path)
        assert (late.removed["groups"], late.would_delete) == (1, None)
        assert hash_of(here) == hash_of(there)
        assert merged(here, path).nothing_new

    def test_a_group_is_not_deleted_by_way_of_a_class_that_nobody_knows(
        self, pc: Opened, tmp_path: Path
    ) -> None:
        here, there = pc("a"), pc("b")
        group = here.groups.create("Onças")
        merged(there, exported(here, tmp_path / "1.pinel").path)
        there.groups.change(group.id, {"classroom_id": there.classrooms.create("X").id})
        moved = exported(there, tmp_path / "2.pinel").path
        removed(here, there.classrooms.all()[0].id)
        report = merged(here, moved, delete=False)
        assert report.would_delete is not None
        assert report.would_delete.names == ("Onças",)
        assert len(here.groups.all()) == 1
        assert merged(here, moved).removed == {"groups": 1}

    def test_it_leaves_log_and_backups_too(self, pc: Opened, tmp_path: Path) -> None:
        here, there = pc("a"), pc("b")
        group = here.groups.create("Zebras")
        work(here, group, "Quagga")
        mine = exported(here, tmp_path / "1.pinel").path
        merged(there, mine)
        removed(there, group.id)
        path = exported(there, tmp_path / "2.pinel").path
        make_backup(here.path, datetime(2026, 3, 3, tzinfo=UTC))
        (backup,) = list_backups(here.path)
        assert b"Quagga" in backup.path.read_bytes()
        here.exchange.merge(path)
        assert len(here.groups.all()) == 1
        report = here.exchange.merge(path, delete=True)
        assert report.left_in == [str(mine)]
        with here._database.read_connection() as db:
            assert [row["file"] for row in db.execute("SELECT DISTINCT file FROM merges")] == [""]
        files = [here.path, here.path.with_name(f"{here.path.name}-wal"), backup.path]
        assert [file for file in files if b"Quagga" in file.read_bytes()] == []

    def test_groups_of_a_deleted_class_do_not_come_either(self, pc: Opened, tmp_path: Path) -> None:
        here, there = pc("a"), pc("b")
        classroom = here.classrooms.create("5º B")
        merged(there, exported(here, tmp_path / "roster.pinel").path)
        work(there, there.groups.create("Onças", classroom_id=classroom.id), "Quadrado")
        late = exported(there, tmp_path / "late.pinel").path
        removed(here, classroom.id)
        report = merged(here, late)
        assert report.skipped["groups"] == 1
        assert here.groups.all() == []
        assert here.runs.newest(5) == []

    def test_a_group_that_was_moved_to_another_class_stays(
        self, pc: Opened, tmp_path: Path
    ) -> None:
        here, there = pc("a"), pc("b")
        old, new = (here.classrooms.create(name) for name in ("5º B", "6º A"))
        group = here.groups.create("Onças", classroom_id=old.id)
        work(here, group, "Quadrado")
        merged(there, exported(here, tmp_path / "1.pinel").path)
        there.groups.change(group.id, {"classroom_id": new.id})
        removed(there, old.id)
        merged(here, exported(there, tmp_path / "2.pinel").path)
        assert [found.classroom_id for found in here.groups.all()] == [new.id]
        assert hash_of(here) == hash_of(there)


def test_a_deletion_waits_until_the_run_has_ended(pc: Opened, tmp_path: Path) -> None:
    here, there = pc("a"), pc("b")
    program, _ = work(here, here.groups.create("Onças"), "Quadrado")
    version = here.versions.newest(program.id)
    assert version is not None
    merged(there, exported(here, tmp_path / "a.pinel").path)
    removed(there, program.id)
    there.groups.create("Araras")
    path = exported(there, tmp_path / "b.pinel").path
    run = here.runs.begin(RunStart("sim", "w", WORLD, 1, "0.1.0", version_id=version.id))
    before = hash_of(here)
    with pytest.raises(StoreError) as caught:
        merged(here, path)
    assert (caught.value.code, hash_of(here)) == ("run_in_progress", before)
    recorder = RunRecorder(here)
    recorder(ended(run.id, 0, 0))
    assert merged(here, path).removed["runs"] == 2


def test_the_store_knows_whom_it_has_heard_from(pc: Opened, tmp_path: Path) -> None:
    here, there = pc("a"), pc("b")
    there.computers.rename("Lab 7")
    work(there, there.groups.create("Onças"), "Quadrado")
    for n in range(2):
        info = exported(there, tmp_path / f"{n}.pinel")
        merged(here, info.path)
    (computer,) = known_computers(here._database)
    assert (computer.name, computer.exported_at, computer.n_runs) == ("Lab 7", info.exported_at, 1)


def test_a_store_that_can_only_be_read_takes_nothing(pc: Opened, tmp_path: Path) -> None:
    there = pc("b")
    work(there, there.groups.create("Onças"), "Quadrado")
    path = exported(there, tmp_path / "b.pinel").path
    pc("a").close()
    with open_for_reading(tmp_path / "a.db") as here, pytest.raises(StoreError) as caught:
        merged(here, path)
    assert caught.value.code == "database_read_only"


def test_the_bundle_is_let_go_in_every_case(
    pc: Opened, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here, there = pc("a"), pc("b")
    work(there, there.groups.create("Onças"), "Quadrado")
    path = exported(there, tmp_path / "b.pinel").path
    before = hash_of(here)
    with monkeypatch.context() as broken:
        broken.setattr("storage.exchange.merging._note", lambda *_: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            merged(here, path)
    assert hash_of(here) == before
    attached = here._database.write(
        lambda db: [row[1] for row in db.execute("PRAGMA database_list")]
    )
    assert "bundle" not in attached
    assert merged(here, path).added["runs"] == 1


MERGER = """
import sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from storage import open_store
from storage.exchange.merging import merge
with open_store(Path(sys.argv[2])) as store:
    print("ready", flush=True)
    for file in sys.argv[3:]:
        merge(store._database, Path(file))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9")
def test_a_merge_that_is_killed_leaves_nothing_or_all_and_can_go_on(
    pc: Opened, tmp_path: Path
) -> None:
    files = []
    for n in range(3):
        there = pc(f"pc{n}")
        group = there.groups.create("Onças")
        for m in range(6):
            work(there, group, f"P {m}")
        files.append(exported(there, tmp_path / f"{n}.pinel").path)
    allowed = {hash_after(tmp_path, files[:n]) for n in range(4)}
    target, root = tmp_path / "killed.db", Path(__file__).parents[3]
    script = [sys.executable, "-c", MERGER, str(root), str(target), *map(str, files)]
    observed = set()
    for delay_s in [0.02 * n for n in range(8)]:
        with subprocess.Popen(script, stdout=subprocess.PIPE) as process:
            assert process.stdout is not None
            process.stdout.readline()
            time.sleep(delay_s)  # the moment of the kill is what is tried
            process.kill()
        with open_store(target) as store:
            assert store.notice is None
            observed.add(hash_of(store))
        assert problems_in(target) == []
    assert observed <= allowed
    with open_store(target) as store:
        for file in files:
            merge(store._database, file)
        assert hash_of(store) == hash_after(tmp_path / "again", files)
