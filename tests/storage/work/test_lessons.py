"""Which lesson work belongs to: on this PC, after merges, while its clock is set, and by its title."""

import shutil
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import LessonRow, ProgramRow, RunStart, Store
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import exported, hash_of, merged, removed
from tests.storage.sample_documents import WORLD
from tests.storage.work.school_clock import SchoolClock

Start = Callable[..., Store]


@pytest.fixture
def clock() -> SchoolClock:
    return SchoolClock()


@pytest.fixture
def started(opened: Start, clock: SchoolClock) -> Start:
    """Starts the app on a PC; its clocks go on."""
    return lambda *file: opened(*file, clock=clock, uptime=clock.uptime)


@pytest.fixture
def school(started: Start) -> Store:
    return started()


@pytest.fixture
def other(started: Start, school: Store, square: ProgramRow, tmp_path: Path) -> Store:
    """Another PC, which knows the class."""
    store = started(tmp_path / "other.db")
    brought(school, store, tmp_path)
    return store


def brought(one: Store, to: Store, folder: Path) -> None:
    """What is on one PC is merged on another."""
    merged(to, exported(one, folder / f"{len(list(folder.iterdir()))}.pinel").path)


def saved(store: Store, program: ProgramRow) -> LessonRow:
    """The lesson that the next edit belongs to."""
    newest = store.versions.newest(program.id)
    version = store.versions.save(program.id, {"n": newest.number if newest else 0}, None)
    return store.lessons.get(str(version.lesson_id))


def activity_of_a_run(store: Store, program: ProgramRow) -> str | None:
    version = store.versions.save(program.id, {"runs": store.now()}, {"commands": []})
    return store.runs.begin(
        RunStart("sim", "empty_room", WORLD, 0, "1", version_id=version.id)
    ).activity


def current(store: Store, classroom_id: str) -> str | None:
    lesson = store.lessons.current(classroom_id)
    return lesson.id if lesson else None


def test_a_merge_in_the_middle_of_a_lesson_leaves_it_open(
    school: Store,
    other: Store,
    ninth: str,
    square: ProgramRow,
    clock: SchoolClock,
    tmp_path: Path,
) -> None:
    here = school.lessons.open(ninth, "Quadrado", "square").id
    clock.passes(minutes=1)
    assert other.lessons.open(ninth, "Quadrado", "square").id == here
    clock.passes(minutes=1)
    brought(other, school, tmp_path)
    assert school.lessons.get(here).computer_id == other.computers.this()[0]
    assert current(school, ninth) == here
    assert saved(school, square).id == here
    assert activity_of_a_run(school, square) == "square"


def test_a_lesson_that_was_closed_on_another_pc_goes_on_where_it_is_open(
    school: Store,
    other: Store,
    ninth: str,
    square: ProgramRow,
    clock: SchoolClock,
    tmp_path: Path,
) -> None:
    here = school.lessons.open(ninth, "Quadrado").id
    clock.passes(minutes=1)
    other.lessons.open(ninth, "Quadrado")
    other.lessons.close(here)
    brought(other, school, tmp_path)
    assert school.lessons.get(here).closed_at is not None
    assert current(school, ninth) == here
    lesson = saved(school, square)
    assert (lesson.id, lesson.closed_at) == (here, None)


def test_a_merge_opens_no_lesson_where_it_was_closed(
    school: Store,
    other: Store,
    ninth: str,
    square: ProgramRow,
    clock: SchoolClock,
    tmp_path: Path,
) -> None:
    lesson = school.lessons.open(ninth, "Quadrado").id
    brought(school, other, tmp_path)
    assert current(other, ninth) is None
    other.lessons.change(lesson, {"title": "Losango"})
    school.lessons.close(lesson)
    brought(other, school, tmp_path)
    row = school.lessons.get(lesson)
    assert (row.closed_at, row.computer_id) == (None, school.computers.this()[0])
    assert current(school, ninth) is None
    assert saved(school, square).by_itself


def test_what_is_open_is_no_content(school: Store, other: Store, ninth: str, path: Path) -> None:
    before = hash_of(other), hash_of(school)
    assert before[0] == before[1]
    lesson = school.lessons.open(ninth, "Quadrado").id
    opened = hash_of(school)
    with sqlite3.connect(path) as db:
        assert db.execute("DELETE FROM settings WHERE key LIKE 'open_lesson%'").rowcount == 1
    db.close()
    assert hash_of(school) == opened
    assert current(school, ninth) == lesson  # as in a file of an earlier release


@pytest.mark.parametrize("on_other_pc", [False, True], ids=["here", "on another PC"])
def test_of_a_lesson_that_is_deleted_nothing_stays_open(
    school: Store,
    other: Store,
    ninth: str,
    square: ProgramRow,
    tmp_path: Path,
    on_other_pc: bool,
) -> None:
    lesson = school.lessons.open(ninth, "Quadrado").id
    if on_other_pc:
        brought(school, other, tmp_path)
        removed(other, lesson)
        brought(other, school, tmp_path)
    else:
        school.exchange.purge("lesson", lesson)
    assert current(school, ninth) is None
    again = saved(school, square)
    assert (again.id != lesson, again.by_itself) == (True, True)
    assert current(school, ninth) == again.id
    assert school.lessons.open(ninth, "Quadrado").id != lesson


def test_a_lesson_that_is_joined_named_closed_and_opened_again_stays_the_one_that_is_open(
    school: Store, other: Store, ninth: str, square: ProgramRow, clock: SchoolClock, tmp_path: Path
) -> None:
    first = saved(school, square).id
    whole = other.lessons.open(ninth, "Aula 1").id
    brought(other, school, tmp_path)
    school.lessons.change(first, {"part_of": whole, "title": "Começo", "activity": "square"})
    assert saved(school, square).id == first
    assert activity_of_a_run(school, square) == "square"
    school.lessons.close(whole)  # another PC's
    assert current(school, ninth) == first
    school.lessons.close(first)
    assert current(school, ninth) is None
    opened = school.lessons.open(ninth, "Começo", "square")
    assert (opened.id, opened.by_itself, opened.closed_at) == (first, False, None)
    clock.passes(hours=1)
    assert saved(school, square).id == first


def test_a_lesson_goes_on_after_a_start_but_not_in_a_copied_folder(
    school: Store,
    started: Start,
    ninth: str,
    square: ProgramRow,
    clock: SchoolClock,
    path: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    lesson = school.lessons.open(ninth, "Quadrado").id
    school.close()
    copy = Path(shutil.copy(path, tmp_path / "copy.db"))
    clock.passes(hours=5)
    assert current(started(), ninth) == lesson
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: "another")
    there = started(copy)
    assert current(there, ninth) is None
    assert saved(there, square).by_itself


def test_a_lesson_of_yesterday_is_not_open_today(
    school: Store, started: Start, ninth: str, clock: SchoolClock
) -> None:
    school.lessons.open(ninth, "Quadrado")
    clock.passes(hours=7)
    assert current(school, ninth) is None
    assert current(started(), ninth) is None


@pytest.mark.parametrize("days", [5900, -5900, 0.5], ids=["forth", "back", "by half a day"])
def test_a_clock_that_is_set_does_not_end_a_lesson(
    school: Store, ninth: str, square: ProgramRow, clock: SchoolClock, days: float
) -> None:
    clock.time = datetime(2018, 1, 1, tzinfo=UTC)
    lesson = school.lessons.open(ninth, "Quadrado", "square").id
    assert saved(school, square).id == lesson
    clock.passes(minutes=2)
    clock.is_set(days=days)
    assert current(school, ninth) == lesson
    assert saved(school, square).id == lesson
    assert activity_of_a_run(school, square) == "square"
    clock.passes(hours=7)
    clock.is_set(hours=-7)
    assert current(school, ninth) is None


def test_a_lesson_that_opened_by_itself_ends_by_what_has_passed(
    school: Store, ninth: str, square: ProgramRow, clock: SchoolClock
) -> None:
    lesson = saved(school, square).id
    clock.is_set(days=5900)
    clock.passes(minutes=40)
    assert saved(school, square).id == lesson
    clock.passes(minutes=46)
    clock.is_set(minutes=-46)
    assert saved(school, square).id != lesson


def test_after_a_start_the_clock_that_was_set_is_the_new_measure(
    school: Store, started: Start, ninth: str, square: ProgramRow, clock: SchoolClock
) -> None:
    clock.time = datetime(2010, 1, 1, tzinfo=UTC)
    lesson = school.lessons.open(ninth, "Quadrado").id
    clock.is_set(days=5900)
    saved(school, square)
    clock.passes(minutes=10)
    assert saved(started(), square).id == lesson


def test_a_title_opens_the_lesson_that_has_it_now(school: Store, ninth: str) -> None:
    first = school.lessons.open(ninth, "Aula 1").id
    school.lessons.change(first, {"title": "Quadrados"})
    school.lessons.close(first)
    second = school.lessons.open(ninth, "Aula 1")
    assert (second.id != first, second.title) == (True, "Aula 1")
    assert school.lessons.open(ninth, "QUADRADOS").id == first
    assert school.lessons.open(ninth, "aula 1").id == second.id
    assert len(school.lessons.of_classroom(ninth)) == 2


def test_a_title_opens_the_newest_of_several_that_have_it(
    school: Store, ninth: str, clock: SchoolClock
) -> None:
    ids = []
    for title in ("A", "B", "C"):
        ids.append(school.lessons.open(ninth, title).id)
        clock.passes(days=7)
    for lesson in ids[:2]:
        school.lessons.change(lesson, {"title": "D"})
    assert school.lessons.open(ninth, "d").id == ids[1]
    tenth = school.classrooms.create("10º").id
    assert school.lessons.open(tenth, "D").id not in ids


def test_a_title_that_was_another_lesson_s_is_one_lesson_on_all_pcs(
    school: Store, other: Store, ninth: str, tmp_path: Path
) -> None:
    first = school.lessons.open(ninth, "Aula 1").id
    school.lessons.change(first, {"title": ""})
    brought(school, other, tmp_path)
    second = school.lessons.open(ninth, "Aula 1").id
    assert other.lessons.open(ninth, "aula 1").id == second != first
    for store in (school, other):
        store.lessons.change(second, {"title": "Losangos"})
    third = school.lessons.open(ninth, "Aula 1").id
    assert third not in (first, second)
    brought(school, other, tmp_path)
    brought(other, school, tmp_path)
    assert other.lessons.open(ninth, "Aula 1").id == third
    titles = {row.id: row.title for row in school.lessons.of_classroom(ninth)}
    assert titles == {first: "", second: "Losangos", third: "Aula 1"}
