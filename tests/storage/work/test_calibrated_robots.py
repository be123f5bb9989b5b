"""Robots of the simulator with the errors of a real one: in the store, and in files for other PCs."""

from collections.abc import Callable
from pathlib import Path

import pytest

from storage import Store
from storage.exchange.scope import Scope
from storage.limits import MAX_CALIBRATED_ROBOTS
from tests.storage.bundle_makers import exported, hash_of, merged, work
from tests.storage.file.refusals import code_of

Opened = Callable[[Path], Store]


def made(store: Store, title: str) -> str:
    return store.calibrated_robots.create(
        title, "pioneer_3dx", {"track_m": 0.345}, {"runs": ["a"]}
    ).id


def titles(store: Store) -> list[str]:
    return [one.title for one in store.calibrated_robots.all()]


@pytest.fixture
def other(opened: Opened, tmp_path: Path) -> Store:
    return opened(tmp_path / "other.db")


def test_a_robot_is_stored_deleted_and_brought_back(store: Store) -> None:
    key = made(store, " Pioneer  da sala 3 ")
    robot = store.calibrated_robots.get(key)
    assert (robot.title, robot.parameters, robot.report) == (
        "Pioneer da sala 3",
        {"track_m": 0.345},
        {"runs": ["a"]},
    )
    store.calibrated_robots.delete(key)
    assert titles(store) == []
    assert store.calibrated_robots.get(key).deleted_at is not None
    store.calibrated_robots.undelete(key)
    assert titles(store) == ["Pioneer da sala 3"]


def test_what_cannot_be_stored_is_refused(store: Store) -> None:
    assert code_of(lambda: store.calibrated_robots.get("x")) == "calibrated_robot_not_found"
    assert code_of(lambda: store.calibrated_robots.delete("x")) == "calibrated_robot_not_found"
    assert code_of(lambda: made(store, " ")) == "name_empty"
    for i in range(MAX_CALIBRATED_ROBOTS):
        made(store, f"P{i}")
    assert code_of(lambda: made(store, "one more")) == "calibrated_robots_too_many"


def test_two_pcs_merge_to_one_hash_in_any_order(store: Store, other: Store, tmp_path: Path) -> None:
    key = made(store, "Pioneer da sala 3")
    merged(other, exported(store, tmp_path / "a.pinel").path)
    other.calibrated_robots.delete(key)
    made(other, "Pioneer da sala 4")
    bundles = [exported(one, tmp_path / f"{i}.pinel").path for i, one in enumerate((store, other))]
    merged(store, bundles[1])
    merged(other, bundles[0])
    assert titles(store) == titles(other) == ["Pioneer da sala 4"]
    assert hash_of(store) == hash_of(other)


def test_they_go_with_their_class_its_lesson_and_work_that_names_them(
    store: Store, tmp_path: Path
) -> None:
    used = made(store, "Usado")
    made(store, "Outro")
    fifth = store.classrooms.create("5º B").id
    group = store.groups.create("Onças", classroom_id=fifth)
    program, _ = work(store, group, "P")
    store.versions.save(program.id, {"n": 3}, None, setup={"calibrated_robot": used})
    lesson = store.lessons.open(fifth, "Robôs").id
    scopes = {
        "all": (Scope(), 2),
        "class": (Scope(classroom_id=fifth), 2),
        "lesson": (Scope(classroom_id=fifth, lesson_id=lesson), 2),
        "group": (Scope(group_id=group.id), 1),
        "program": (Scope(program_id=program.id), 1),
    }
    for name, (scope, n) in scopes.items():
        counts = exported(store, tmp_path / f"{name}.pinel", scope).counts
        assert counts["calibrated_robots"] == n, name


def test_a_file_without_them_has_the_hash_that_it_had_and_an_anonymous_one_no_name(
    store: Store, tmp_path: Path
) -> None:
    before = hash_of(store)
    made(store, "Robô da Ana")
    assert hash_of(store) != before
    path = store.exchange.export(
        tmp_path / "x.pinel", app_version="1", computer=("", ""), anonymous=[]
    ).path
    assert "Robô da Ana".encode() not in path.read_bytes()
