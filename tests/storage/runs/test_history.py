"""Runs chosen from the history, and what a lesson left behind."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from storage import RunFilter, RunStart, Store, open_store
from storage.runs.history import NO_CLASSROOM
from storage.runs.runs import Batch
from tests.storage.sample_runs import ended
from tests.storage.work.school_clock import SchoolClock


@dataclass
class School:
    """Two classes and a group without one, whose runs end as the test says."""

    store: Store
    clock: SchoolClock
    groups: dict[str, str] = field(default_factory=dict)
    programs: dict[str, str] = field(default_factory=dict)

    def group(self, name: str, classroom: str | None) -> str:
        self.groups[name] = self.store.groups.create(name, classroom_id=classroom).id
        self.programs[name] = self.store.programs.create(self.groups[name], f"de {name}").id
        return self.groups[name]

    def edit(self, name: str, metres: int) -> str:
        return self.store.versions.save(self.programs[name], {"n": metres}, {"commands": []}).id

    def run(
        self,
        name: str,
        state: str = "finished",
        activity: str = "square",
        passed: Any = None,
        world: str = "w",
    ) -> str:
        newest = self.store.versions.newest(self.programs[name])
        version = newest.id if newest else self.edit(name, 0)
        start = RunStart(
            "sim", world, {"name": world}, 0, "1", version_id=version, activity=activity
        )
        run_id = self.store.runs.begin(start).id
        end = ended(run_id, 0, 30, state=state, reason="collision" if state == "failed" else None)
        batches = [Batch(run_id, self.store.now(), ended=end)]
        self.store.record(lambda: batches).result()
        self.store._database.write(
            lambda db: (
                db.execute("UPDATE runs SET passed = ? WHERE id = ?", [passed, run_id]).rowcount
            )
        )
        return run_id

    def page(self, **which: Any) -> list[str]:
        return [line.run.id for line in self.store.history.page(RunFilter(**which))]


@pytest.fixture
def school(path: Path) -> Iterator[School]:
    clock = SchoolClock()
    with open_store(path, clock=clock, uptime=clock.uptime) as store:
        found = School(store, clock)
        ninth, tenth = (store.classrooms.create(name).id for name in ("9º A", "10º"))
        found.groups |= {"9º A": ninth, "10º": tenth}
        found.group("robots", ninth)
        found.group("stars", tenth)
        found.group("alone", None)
        yield found


def test_runs_are_chosen_by_class_and_group(school: School) -> None:
    runs = {name: school.run(name) for name in ("robots", "stars", "alone")}
    assert school.page() == [runs["alone"], runs["stars"], runs["robots"]]
    assert school.page(classroom_id=school.groups["9º A"]) == [runs["robots"]]
    assert school.page(classroom_id=NO_CLASSROOM) == [runs["alone"]]
    assert school.page(group_id=school.groups["stars"]) == [runs["stars"]]
    assert school.page(group_id=school.groups["stars"], classroom_id=school.groups["9º A"]) == []
    (line,) = school.store.history.page(RunFilter(group_id=school.groups["alone"]))
    assert line.group is not None
    assert (line.group.name, line.run.program_name) == ("alone", "de alone")


def test_runs_are_chosen_by_what_became_of_them(school: School) -> None:
    bumped = school.run("robots", "failed")
    passed = school.run("robots", passed=1)
    missed = school.run("robots", "stopped", passed=0)
    other = school.run("robots", activity="maze", passed=1)
    assert school.page(outcome="failed") == [bumped]
    assert school.page(outcome="stopped") == school.page(outcome="not_passed") == [missed]
    assert school.page(outcome="passed") == school.page(outcome="finished") == [other, passed]
    assert school.page(outcome="passed", activity="maze") == [other]


def test_runs_are_chosen_by_world(school: School) -> None:
    maze, own = school.run("robots", world="maze"), school.run("stars", world="own")
    assert school.page(world="maze") == [maze]
    assert school.page(world="own") == [own]
    assert school.page(world="maze", group_id=school.groups["stars"]) == []
    assert school.page(world="gone") == []


def test_runs_are_chosen_by_lesson_and_time(school: School) -> None:
    first = school.run("robots")
    school.clock.passes(days=1)
    second = school.run("robots")
    (newer, earlier) = school.store.lessons.of_classroom(school.groups["9º A"])
    assert school.page(lesson_ids=(earlier.id,)) == [first]
    assert school.page(lesson_ids=(earlier.id, newer.id)) == [second, first]
    assert school.page(started_from="2026-03-03", started_before="2026-03-04") == [second]
    assert school.page(started_before="2026-03-03T00:00:00.000000Z") == [first]


def test_pages_follow_each_other_without_gap(school: School) -> None:
    made = [school.run("robots") for _ in range(7)][::-1]
    history, found = school.store.history, list[str]()
    while page := history.page(RunFilter(), before=found[-1] if found else None, limit=3):
        found += [line.run.id for line in page]
    assert found == made


@pytest.mark.parametrize(
    ("which", "index"),
    [
        ({}, "sqlite_autoindex_runs_1"),
        ({"classroom_id": "x"}, "runs_history"),
        ({"outcome": "failed", "activity": "square", "started_from": "2026"}, "runs_history"),
        ({"outcome": "passed"}, "runs_history"),
        ({"world": "maze"}, "runs_history"),
        ({"group_id": "x"}, "idx_runs_group_id_id"),
        ({"lesson_ids": ("x", "y")}, "runs_lesson"),
    ],
)
def test_every_choice_is_read_from_an_index(school: School, which: Any, index: str) -> None:
    asked: list[str] = []
    with school.store._database.read_connection() as db:
        db.set_trace_callback(asked.append)
    school.store.history.page(RunFilter(**which))
    with school.store._database.read_connection() as db:
        db.set_trace_callback(None)
        (query,) = [text for text in asked if "SELECT" in text]
        plan = "; ".join(row["detail"] for row in db.execute(f"EXPLAIN QUERY PLAN {query}"))
    assert f"INDEX {index}" in plan
    assert "SCAN runs;" not in plan


def test_a_lesson_s_records_are_lines_of_its_groups(school: School) -> None:
    first = school.edit("robots", 1)
    run_id = school.run("robots", "failed")
    second = school.edit("robots", 2)
    school.run("stars")
    (lesson,) = school.store.lessons.of_classroom(school.groups["9º A"])
    lines = school.store.lesson_histories.of([lesson.id])
    assert [(group.name, group.picture) for group in lines.groups] == [("robots", "anchor")]
    work = lines.work[school.groups["robots"]]
    assert [(edit.version_id, edit.number, edit.parent_id) for edit in work.edits] == [
        (first, 1, None),
        (second, 2, first),
    ]
    (run,) = work.runs
    assert (run.id, run.version_id, run.number, run.state) == (run_id, first, 1, "failed")
    assert (run.activity, run.passed, run.params) == ("square", None, {})
    assert lines.computers == dict([school.store.computers.this()])


def test_workspaces_are_read_by_version(school: School) -> None:
    first, second = school.edit("robots", 1), school.edit("robots", 2)
    read = school.store.lesson_histories.workspaces
    assert read([first, second, "gone"]) == {first: {"n": 1}, second: {"n": 2}}
    assert read([]) == {}


def test_a_lesson_without_work_has_no_groups(school: School) -> None:
    lesson = school.store.lessons.open(school.groups["9º A"], "Aula 1")
    assert school.store.lesson_histories.of([lesson.id]).groups == []
