"""Runs of activities on a real robot: judged by the robot's measurements, or not at all; and their review."""

from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event
from pinel_desktop.robot.robot_profile import profile_from
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from tests.links.aurora import Aurora, free_port
from tests.storage.sample_runs import ended, sample
from tests.web.browser import Browser, Stream
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

PIN = "314159"
ROOM = {"width_m": 20.0, "depth_m": 20.0}
FAST = {"max_v_mps": 1.2, "max_omega_dps": 250.0, "room": ROOM}
SHORT = {**SQUARE, "commands": [{"action": "move_forward", "distance": 0.2, "block": "m"}]}


@dataclass
class Lesson:
    """A group in a lesson with an activity, and the robot of its PC."""

    app: App
    browser: Browser
    teacher: Browser
    engine: FakeEngine
    port: int
    id: str
    group: str
    program: str

    def begin(self, document: dict[str, Any] = SQUARE, robot: str = "bridge") -> str:
        version = {"workspace": {"of": len(str(document))}, "document": document}
        saved = self.browser.post(f"/api/programs/{self.program}/versions", version).data["id"]
        body = {"version_id": saved, "world": "empty_room", "robot": robot}
        run_data = self.browser.post("/api/runs", body).data
        assert run_data["passed"] is None
        return str(run_data["id"])

    def drive(self, run: str) -> None:
        """Drives the robot of the engine's start request, and delivers the events of the run."""
        asked, stamp = self.engine.start_spec, EventSequencer(run)

        def observe(tick: int, event: Event) -> None:
            self.engine.send(stamp.wire(tick, event))

        robot = profile_from(asked["robot"])
        spec = RunSpec(asked["document"], asked["world"], "bridge", robot, pace="live")
        with closing(Aurora(self.port)):
            start(spec, observe)

    def run(self, run: str) -> dict[str, Any]:
        found: dict[str, Any] = self.browser.get(f"/api/runs/{run}").data
        return found

    def tried(self) -> dict[str, bool]:
        found = self.browser.get(f"/api/groups/{self.group}/activities").data["activities"]
        return {one["name"]: one["passed"] for one in found}

    def review(self) -> dict[str, Any]:
        found: dict[str, Any] = self.teacher.get(f"/api/lessons/{self.id}/review").data
        return found


Open = Callable[[str], Lesson]


@pytest.fixture
def lesson(app: App, browser: Browser, engine: FakeEngine) -> Open:
    def open_lesson(activity: str) -> Lesson:
        teacher, store, port = Browser.signed_in(app.address), app._store, free_port()
        teacher.put("/api/teacher/pin", {"pin": PIN})
        saved = teacher.put("/api/real-robots/bridge", {"record": {**FAST, "port": port}})
        assert saved.status == 200, saved.data
        classroom = store.classrooms.create("9º A").id
        opened = store.lessons.open(classroom, "Aula 1", activity)
        group = store.groups.create("Os Robôs", classroom_id=classroom).id
        program = store.programs.create(group, "Quadrado").id
        return Lesson(app, browser, teacher, engine, port, opened.id, group, program)

    return open_lesson


def test_a_square_driven_on_the_robot_passes_by_what_the_robot_measured(lesson: Open) -> None:
    here = lesson("square")
    with here.browser.stream() as events:
        run = here.begin()
        here.drive(run)
        judged, lines = verdict_and_check_list(events)
    assert (judged["passed"], judged["by_robot"], judged["not_judged"]) == (True, True, None)
    assert {line["state"] for line in lines} == {"met"}
    found = here.run(run)
    assert (found["activity"], found["passed"], found["by_robot"]) == ("square", True, True)
    assert found["path_length_m"] == pytest.approx(4.0, rel=0.1)
    assert here.tried() == {"square": True}
    review = here.review()
    assert review["summary"]["n_passed"] == 1
    marks = [mark for mark in review["groups"][0]["entries"] if mark["kind"] == "run"]
    assert [(mark["link"], mark["passed"]) for mark in marks] == [("bridge", True)]


def verdict_and_check_list(events: Stream) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """Returns the verdict and the last check list of a run, which come in either order."""
    judged: dict[str, Any] = {}
    lines: list[dict[str, Any]] = []
    for event in events.events():
        if event["type"] == "judged":
            judged = event
        if event["type"] == "checks_stand":
            lines = event["checks"]
        if judged and lines and all(line["state"] != "open" for line in lines):
            break
    return judged, lines


def test_a_short_way_on_the_robot_does_not_pass_and_is_told_what_is_missing(lesson: Open) -> None:
    here = lesson("square")
    with here.browser.stream() as events:
        run = here.begin(SHORT)
        here.drive(run)
        judged = events.until("judged")[-1]
    assert (judged["passed"], judged["by_robot"], judged["block"]) == (False, True, "m")
    assert judged["missing"].startswith("The path is")
    # the required value, not the value with tolerance
    assert "at least 3.95 m" in judged["missing"]
    assert here.run(run)["passed"] is False
    assert here.tried() == {"square": False}


@pytest.mark.parametrize(
    ("activity", "state", "reason", "why"),
    [
        ("maze", "finished", None, "Not judged on a real robot: this mission needs the simulator"),
        ("square", "stopped", "stopped_by_person", "Not judged: the run was stopped."),
        ("square", "failed", "link_lost", "Not judged: the run did not come to its end."),
    ],
)
def test_a_run_that_cannot_be_judged_is_no_failure_and_no_try(
    lesson: Open, activity: str, state: str, reason: str | None, why: str
) -> None:
    here = lesson(activity)
    for _ in range(3):
        with here.browser.stream() as events:
            run = here.begin()
            here.engine.send(sample(run, 1))
            here.engine.send(ended(run, 1, 1, state=state, reason=reason))
            judged = events.until("judged")[-1]
        assert (judged["passed"], judged["by_robot"]) == (None, False)
        assert judged["not_judged"].startswith(why)
        found = here.run(run)
        assert (found["passed"], found["by_robot"]) == (None, False)
        assert found["not_judged"] == judged["not_judged"]
    assert here.app._store.grading_results.pending() == []
    assert here.tried() == {}
    review = here.review()
    assert review["summary"]["n_passed"] == 0
    need = "help" if state == "failed" else "working"  # three lost connections do need help
    assert review["groups"][0]["need"] == need
    assert review["groups"][0]["figures"]["attempts_until_passed"] is None
    listed = here.teacher.get("/api/runs?outcome=not_passed").data["runs"]
    assert listed == []


def test_runs_that_were_not_judged_are_no_attempts_before_one_that_passed(lesson: Open) -> None:
    here = lesson("square")
    with here.browser.stream() as events:
        for state, robot in (("stopped", "bridge"), ("finished", "sim")):
            run = here.begin(robot=robot)
            here.engine.send(ended(run, 0, 0, state=state))
            passed = events.until("judged")[-1]["passed"]
    assert passed is True
    assert here.review()["groups"][0]["figures"]["attempts_until_passed"] == 1
    table = here.teacher.get(f"/api/lessons/{here.id}/review.csv").text
    assert "robot by the bridge" in table
    assert "Real room" in table


def test_verdicts_of_another_pc_are_the_same_after_merging(lesson: Open, tmp_path: Path) -> None:
    here = lesson("square")
    with here.browser.stream() as events:
        driven = here.begin(SHORT)
        here.drive(driven)
        events.until("judged")
        stopped = here.begin()
        here.engine.send(sample(stopped, 1))
        here.engine.send(ended(stopped, 1, 1, state="stopped"))
        events.until("judged")
    before = [here.run(run) for run in (driven, stopped)]
    bundle = here.app._store.exchange.export(
        tmp_path / "work.pinel", app_version="0", computer=here.app._store.computers.this()
    )
    with App(tmp_path / "other.db", make_engine=FakeEngine) as other:
        other._store.exchange.merge(bundle.path)
        assert other._store.grading_results.pending() == []
        tab = Browser.signed_in(other.address)
        same = ("link", "activity", "passed", "by_robot", "not_judged", "path_length_m")
        for one in before:
            found = tab.get(f"/api/runs/{one['id']}").data
            assert {name: found[name] for name in same} == {name: one[name] for name in same}
