"""Where a real robot truly was: kept with its run, and brought by bundles as other work."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from storage import Store, StoreError, TruePoseRow
from storage.exchange.scope import Scope
from storage.tables.rules import poses
from tests.storage.bundle_makers import a_run, exported, hash_of, merged, removed, work

END: TruePoseRow = (None, 1.0234567, -0.03, 3.1415926, 0.01, 0.035)
PATH: list[TruePoseRow] = [(3, 0.1, 0.0, 0.0, 0.004, 0.01), (5, 0.2, 0.0, 0.1, 0.004, 0.01)]


def test_each_source_says_its_own_and_a_later_measurement_replaces_it(store: Store) -> None:
    run = a_run(store, None)
    store.truths.record(run, "camera", PATH)
    store.truths.record(run, "tape", PATH)
    store.truths.record(run, "tape", [END])
    camera, tape = store.truths.of_run(run)
    assert (camera.source, camera.poses) == ("camera", tuple(PATH))
    assert (tape.source, tape.poses) == (
        "tape",
        ((None, 1.0235, -0.03, 3.14159, 0.01, 0.035),),
    )


def test_a_removed_measurement_is_not_listed(store: Store) -> None:
    run = a_run(store, None)
    store.truths.record(run, "tape", [END])
    store.truths.record(run, "tape", [])
    assert store.truths.of_run(run) == []


def test_a_run_that_is_not_there_and_poses_that_break_a_rule_are_refused(store: Store) -> None:
    with pytest.raises(StoreError, match="run_not_found"):
        store.truths.record("0199e4a0-0000-7fff-bfff-ffffffffffff", "tape", [END])
    with pytest.raises(StoreError, match="truth_invalid"):
        store.truths.record(a_run(store, None), "tape", [END, END])


def test_a_damaged_truth_is_left_out(store: Store) -> None:
    run = a_run(store, None)
    store.truths.record(run, "tape", [END])
    store._database.write(lambda db: db.execute("UPDATE truths SET poses = '[[1]]'"))
    assert store.truths.of_run(run) == []


@pytest.mark.parametrize(
    "value",
    [
        [[None, 0, 0, 0, 0.01]],
        [[None, 0, 0, 0, 0.01, 4]],
        [[None, 0, 101, 0, 0.01, 0.1]],
        [[None, 0, 0, 0, 0, 0.1]],
        [[0.5, 0, 0, 0, 0.01, 0.1]],
        [[None, 0, 0, "1", 0.01, 0.1]],
        [[5, 0, 0, 0, 0.01, 0.1], [4, 0, 0, 0, 0.01, 0.1]],
    ],
)
def test_poses_that_no_store_writes_are_refused_of_a_file(value: object) -> None:
    assert not poses(json.dumps(value))


def test_the_later_measurement_of_two_pcs_counts_on_both(
    pc: Callable[[str], Store], tmp_path: Path
) -> None:
    here, there = pc("a"), pc("b")
    _, run = work(here, here.groups.create("Onças"), "Quadrado")
    here.truths.record(run, "tape", PATH[:1])
    merged(there, exported(here, tmp_path / "1.pinel").path)
    there.truths.record(run, "tape", [END])
    here.truths.record(run, "camera", PATH)
    merged(there, exported(here, tmp_path / "2.pinel").path)
    merged(here, exported(there, tmp_path / "3.pinel").path)
    assert [truth.source for truth in here.truths.of_run(run)] == ["camera", "tape"]
    assert here.truths.of_run(run)[1].poses[0][0] is None
    assert hash_of(here) == hash_of(there)


def test_a_deleted_run_takes_its_truth_along(store: Store) -> None:
    _, run = work(store, store.groups.create("Onças"), "Quadrado")
    store.truths.record(run, "tape", [END])
    removed(store, run)
    assert store._database.write(lambda db: db.execute("SELECT 1 FROM truths").fetchone()) is None


def test_a_program_that_a_group_takes_along_has_the_truth_of_its_runs(
    pc: Callable[[str], Store], tmp_path: Path
) -> None:
    here, there = pc("a"), pc("b")
    program, run = work(there, there.groups.create("Onças"), "Quadrado")
    there.truths.record(run, "tape", [END])
    path = exported(there, tmp_path / "p.pinel", Scope(program_id=program.id)).path
    here.exchange.merge_program(path)
    assert here.truths.of_run(run) == there.truths.of_run(run)
