"""A person's time is real time, whatever the speed; a simulated robot's time stands still meanwhile."""

from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import pytest

from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import (
    Answered,
    BoxesMoved,
    CaptureStarted,
    Countdown,
    Event,
    GestureResult,
    Ranges,
    RunState,
    Telemetry,
)
from pinel_desktop.execution.clock import TICK_S
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunResult
from pinel_desktop.execution.inputs import Capture
from pinel_desktop.program.limits import MAX_RUN_S
from pinel_desktop.runs.recorded_inputs import RecordedInputs
from pinel_desktop.runs.spec import Pace, RunSpec
from pinel_desktop.runs.start import start
from tests.execution.wall import Wall
from tests.links import clockwork

Commands = list[dict[str, Any]]
ASK = {"action": "ask", "question": "?", "variable": "a", "block": "a"}
DRIVE = {"action": "drive", "linear": 0.3, "angular": 0}
CAMERA_SIGN = Capture("B", "camera", 0.97, "F")
PUSH = {"action": "move_forward", "distance": 0.5, "block": "m"}


def capture(timeout_s: float) -> dict[str, Any]:
    return {"action": "classify_gestures", "timeout": timeout_s, "block": "c"}


class People:
    """A live run on wall time of its own, with everything that was reported."""

    def __init__(self, *commands: dict[str, Any], pace: Pace = "live", speed: float = 1.0) -> None:
        self.wall, self.control = Wall(), RunControl()
        self.control.set_speed(speed)
        self.spec = RunSpec(
            {"pinel_ir": 1, "commands": list(commands)},
            "empty_room",
            inputs=self.control.inputs,
            pace=pace,
        )
        self.log: list[tuple[int, Event]] = []
        self.at_s: list[float] = []

    def run(self) -> RunResult:
        return start(self.spec, self._observe, self.control, wall=self.wall.time)

    def _observe(self, tick: int, event: Event) -> None:
        self.log.append((tick, event))
        self.at_s.append(self.wall.passed_s)

    def of(self, kind: type[Event]) -> list[Any]:
        return [event for _, event in self.log if type(event) is kind]

    def passed_between(self, first: type[Event], last: type[Event]) -> tuple[int, float]:
        """Ticks and wall time in s."""
        kinds = [type(event) for _, event in self.log]
        i, j = kinds.index(first), kinds.index(last)
        return self.log[j][0] - self.log[i][0], self.at_s[j] - self.at_s[i]

    def check_that_a_replay_is_identical(self, result: RunResult) -> None:
        stamp, again, wire = EventSequencer("r"), EventSequencer("r"), []
        for tick, event in self.log:
            if event.is_recorded and type(event) is not Telemetry:
                wire.append(stamp.wire(tick, event))
        repeated = []

        def observe(tick: int, event: Event) -> None:
            if event.is_recorded and type(event) is not Telemetry:
                repeated.append(again.wire(tick, event))

        replayed = start(replace(self.spec, inputs=RecordedInputs(wire), pace="max"), observe)
        assert repeated == wire
        assert replayed.ended.telemetry_sha256 == result.ended.telemetry_sha256


PACES: list[tuple[Pace, float]] = [("live", 1.0), ("live", 10.0), ("live", 0.1), ("max", 1.0)]


@pytest.mark.parametrize(("pace", "speed"), PACES)
def test_a_capture_closes_after_so_many_seconds_of_the_wall_clock(pace: Pace, speed: float) -> None:
    people = People(capture(10.0), pace=pace, speed=speed)
    people.run()
    assert people.of(GestureResult) == [GestureResult("", "capture")]
    ticks, seconds = people.passed_between(CaptureStarted, GestureResult)
    assert ticks == 0
    assert seconds == pytest.approx(10.0, abs=2 * TICK_S)


@pytest.mark.parametrize(("pace", "speed"), PACES)
def test_a_question_uses_up_no_robot_time(pace: Pace, speed: float) -> None:
    people = People(PUSH, ASK, PUSH, pace=pace, speed=speed)
    people.wall.at(95.0, partial(people.control.inputs.answers.answer, "Ana"))
    result = people.run()
    assert result.variables == {"a": "Ana"}
    assert people.wall.passed_s > 95.0
    alone = People(PUSH, PUSH).run()
    assert result.ended.duration_s == alone.ended.duration_s
    assert result.ended.telemetry_sha256 == alone.ended.telemetry_sha256
    people.check_that_a_replay_is_identical(result)


def test_the_hour_that_a_run_may_take_is_not_used_up_by_people() -> None:
    people = People(*[capture(600.0)] * 8)
    result = people.run()
    assert people.wall.passed_s > MAX_RUN_S
    assert result.ended.state == "finished"


def test_robot_and_boxes_stand_still_while_the_simulator_waits() -> None:
    people = People(DRIVE, {"action": "wait", "seconds": 2}, ASK, {"action": "stop"})
    people.spec = replace(people.spec, world="obstacles")
    people.wall.at(60.0, partial(people.control.inputs.answers.answer, "x"))
    result = people.run()
    rows = [tick for tick, event in people.log if type(event) is Telemetry]
    assert rows == list(range(1, len(rows) + 1))
    assert len(rows) < 4 * 30
    moved = [i for i, (_, event) in enumerate(people.log) if type(event) in (Telemetry, BoxesMoved)]
    seconds = sorted(people.at_s[i] for i in moved)
    assert max(b - a for a, b in pairwise(seconds)) > 55.0
    assert result.ended.pose is not None
    assert result.ended.pose["x_m"] < 0.8
    people.check_that_a_replay_is_identical(result)


def test_the_countdown_is_told_in_real_seconds_and_stands_during_a_pause() -> None:
    people = People(capture(10.0), speed=10.0)
    people.wall.at(4.0, people.control.pause)
    people.wall.at(64.0, people.control.resume)
    result = people.run()
    left = [event.left_s for event in people.of(Countdown)]
    assert left[0] == 10.0
    assert left == sorted(left, reverse=True)
    assert len(left) == pytest.approx(5 * 10, abs=2)
    assert people.wall.passed_s == pytest.approx(70.0, abs=1.5)
    people.check_that_a_replay_is_identical(result)


def test_a_pause_while_the_program_waits_is_at_once_and_the_values_can_be_seen() -> None:
    people = People({"action": "set_variable", "name": "n", "value": 7}, ASK)
    values: list[Any] = []
    people.wall.at(5.0, people.control.pause)
    people.wall.at(
        7.0, lambda: people.control.evaluate({"var": "n"}, lambda value, _: values.append(value))
    )
    people.wall.at(8.0, people.control.resume)
    people.wall.at(20.0, partial(people.control.inputs.answers.answer, "x"))
    result = people.run()
    assert values == [7]
    at = {
        event.state: seconds
        for (_, event), seconds in zip(people.log, people.at_s, strict=True)
        if type(event) is RunState
    }
    assert at["paused"] == pytest.approx(5.0, abs=2 * TICK_S)
    assert at["running"] == pytest.approx(8.0, abs=2 * TICK_S)
    people.check_that_a_replay_is_identical(result)


@pytest.mark.parametrize("wait", [ASK, capture(60.0)])
def test_stop_while_the_program_waits_is_at_once(wait: dict[str, Any]) -> None:
    people = People(PUSH, wait, PUSH)
    people.wall.at(30.0, people.control.stop)
    result = people.run()
    assert (result.ended.state, result.ended.block) == ("stopped", wait["block"])
    assert people.wall.passed_s < 30.5
    people.check_that_a_replay_is_identical(result)


def test_a_run_stops_at_a_breakpoint_after_an_answer_and_is_replayed() -> None:
    people = People(ASK, PUSH)
    people.control.breakpoints = frozenset(["m"])
    people.wall.at(3.0, partial(people.control.inputs.answers.answer, "x"))
    people.wall.at(9.0, people.control.resume)
    result = people.run()
    assert [event.cause for event in people.of(RunState)] == [None, "breakpoint", None]
    people.check_that_a_replay_is_identical(result)


def test_who_subscribes_while_the_program_waits_is_told_what_the_sensors_measure() -> None:
    people = People(ASK)

    def subscribe() -> None:
        people.control.subscriptions = frozenset(["sonar"])

    people.wall.at(2.0, subscribe)
    people.wall.at(6.0, partial(people.control.inputs.answers.answer, "x"))
    people.run()
    reports = [event for event in people.of(Ranges) if event.sonar]
    assert reports


def test_two_captures_in_a_row_are_replayed_with_a_pause_in_the_second() -> None:
    people = People(capture(5.0), capture(5.0))
    people.wall.at(7.0, people.control.pause)
    people.wall.at(8.0, people.control.resume)
    people.wall.at(9.0, partial(people.control.inputs.gestures.answer, CAMERA_SIGN))
    result = people.run()
    nothing, recognised = people.of(GestureResult)
    assert nothing == GestureResult("", "capture")
    assert recognised == GestureResult("B", "capture", "camera", 0.97, "F")
    people.check_that_a_replay_is_identical(result)


def test_wait_and_wait_until_are_robot_time() -> None:
    until = {"action": "wait_until", "condition": "1 == 2", "timeout": 4}
    people = People({"action": "wait", "seconds": 6}, until, speed=10.0)
    result = people.run()
    assert result.ended.duration_s == pytest.approx(10.0, abs=0.1)
    assert people.wall.passed_s == pytest.approx(1.0, abs=0.1)


class TestARobotThatIsNotSimulated:
    """Its time is everybody's."""

    @pytest.fixture
    def people(self, monkeypatch: pytest.MonkeyPatch) -> People:
        found = People(DRIVE, ASK, speed=10.0, pace="max")
        clockwork.install(monkeypatch, found.wall.time)
        found.spec = replace(found.spec, link="clockwork")
        return found

    def test_it_drives_on_while_it_asks(self, people: People) -> None:
        people.wall.at(1.0, partial(people.control.inputs.answers.answer, "x"))
        result = people.run()
        assert people.log[-1][0] == pytest.approx(30, abs=4)
        assert result.ended.pose is not None
        assert result.ended.pose["x_m"] == pytest.approx(0.3, abs=0.02)
        (answered,) = (tick for tick, event in people.log if type(event) is Answered)
        assert answered == pytest.approx(30, abs=2)

    def test_speed_and_pace_change_nothing(self, people: People) -> None:
        waits = {"action": "wait", "seconds": 3}
        people.spec = replace(people.spec, document={"pinel_ir": 1, "commands": [waits]})
        result = people.run()
        assert people.wall.passed_s == pytest.approx(3.0, abs=0.1)
        assert result.ended.duration_s == pytest.approx(3.0, abs=0.1)

    def test_a_capture_closes_by_the_same_clock(self, people: People) -> None:
        document = {"pinel_ir": 1, "commands": [capture(4.0)]}
        people.spec = replace(people.spec, document=document)
        people.run()
        ticks, seconds = people.passed_between(CaptureStarted, GestureResult)
        assert ticks == pytest.approx(120, abs=2)
        assert seconds == pytest.approx(4.0, abs=2 * TICK_S)
