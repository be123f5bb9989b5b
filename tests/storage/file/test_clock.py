"""Clocks of school PCs: set back, years ahead, at 2010 each morning. Work is in the order in which it was made."""

import uuid
from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from storage import RunStart, Store, text
from storage.tables.work import VERSIONS
from storage.text import continue_after, id_of, may_be_of, new_id, to_json

NOW = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)


class Clock:
    """The PC's clock, for times and for ids."""

    def __init__(self) -> None:
        self.time = NOW

    def __call__(self) -> datetime:
        return self.time

    def time_ns(self) -> int:
        return int(self.time.timestamp() * 1e9)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr("storage.text.time.time_ns", clock.time_ns)
    monkeypatch.setattr(text, "_ids", text._Ids())
    return clock


@pytest.fixture
def started(
    opened: Callable[..., Store], clock: Clock, monkeypatch: pytest.MonkeyPatch
) -> Callable[[], Store]:
    """Starts the program on the PC: what the one before knew is forgotten."""

    def start() -> Store:
        monkeypatch.setattr(text, "_ids", text._Ids())
        return opened(clock=clock, close_interrupted=True)

    return start


def begin_run(store: Store, version_id: str) -> str:
    start = RunStart("sim", "empty_room", {}, 0, "1", version_id=version_id)
    return store.runs.begin(start).id


def test_ids_are_of_version_7_with_their_time_and_grow_while_the_clock_goes_back(
    clock: Clock,
) -> None:
    ids = [new_id() for _ in range(5)]
    clock.time -= timedelta(days=6000)
    ids += [new_id() for _ in range(5)]
    assert sorted(set(ids)) == ids
    assert {(uuid.UUID(key).version, uuid.UUID(key).variant) for key in ids} == {(7, uuid.RFC_4122)}
    assert uuid.UUID(ids[0]).int >> 80 == NOW.timestamp() * 1000


def test_an_id_of_content_grows_as_well_and_is_of_no_other_content() -> None:
    before, key, after = new_id(), id_of("this"), new_id()
    assert before < key < after
    assert uuid.UUID(key).version == 8
    assert may_be_of(key, "this")
    assert not may_be_of(key, "that")
    assert may_be_of(before, "that")  # as those of earlier releases it tells nothing


def test_the_key_of_a_version_is_of_what_it_was_in_the_files_of_schools() -> None:
    row = {"program_id": "p", "created_at": "t", "workspace": "{}", "faults": "[]"}
    content = to_json([row.get(name) for name in VERSIONS.bound])
    assert content == '["p",null,null,null,"t","{}",null,"[]",null,null]'
    assert may_be_of("01a20d29-698b-8bc5-83b0-c5b5ca476ff5", content)


@pytest.mark.parametrize("no_id", ["", "g", "00", "ffffffff-ffff-7fff-bfff-ffffffffffff"])
def test_what_is_no_id_of_a_clock_changes_no_ids(clock: Clock, no_id: str) -> None:
    continue_after(no_id)
    assert uuid.UUID(new_id()).int >> 80 == NOW.timestamp() * 1000


@pytest.mark.parametrize("years", [-16, 70], ids=["in 2010", "in 2096"])
def test_after_a_start_with_another_time_what_is_new_comes_first(
    started: Callable[[], Store], clock: Clock, years: int
) -> None:
    made: list[str] = []
    group_id = ""
    for shift in (0, years, 0, years):
        clock.time = NOW + timedelta(days=365 * shift)
        with started() as store:
            group_id = group_id or store.groups.create("A").id
            program = store.programs.create(group_id, "P")
            version = store.versions.save(program.id, {"n": 1}, None)
            made.append(begin_run(store, version.id))
            assert store.programs.of_group(group_id)[0].id == program.id
            assert store.runs.newest(1)[0].id == made[-1]
    with started() as store:
        assert [run.id for run in store.runs.of_group(group_id)] == made[::-1]


def test_a_program_edited_while_the_clock_jumps_steps_back_through_what_was_edited(
    started: Callable[[], Store], clock: Clock
) -> None:
    with started() as store:
        program = store.programs.create(store.groups.create("A").id, "P")
    for n, years in enumerate((0, -16, 70, -3)):
        clock.time = NOW + timedelta(days=365 * years)
        with started() as store:
            store.versions.save(program.id, {"n": n}, None)
            newest = store.versions.newest(program.id)
            assert newest is not None
            assert (newest.workspace, newest.number) == ({"n": n}, n + 1)


def test_work_of_one_morning_is_one_lesson_while_the_clock_is_set_right(
    started: Callable[[], Store], clock: Clock, path: Path
) -> None:
    with started() as store:
        group = store.groups.create("A")
        program = store.programs.create(group.id, "P")
        lessons = []
        for minutes in (0, 20, -10, 5):
            clock.time = NOW + timedelta(minutes=minutes)
            version = store.versions.save(program.id, {"n": minutes}, None)
            lessons.append(version.lesson_id)
        assert len(set(lessons)) == 1
        clock.time = NOW - timedelta(days=3000)
        lessons.append(store.versions.save(program.id, {"n": "2018"}, None).lesson_id)
        assert len(set(lessons)) == 1
    clock.time = NOW
    with started() as store:
        next_version = store.versions.save(program.id, {"n": "another day"}, None)
        assert next_version.lesson_id not in lessons
