"""A recorded run, run again: pauses, steps, stops, captures and answers come at the same moments."""

import random
from itertools import pairwise
from typing import Any, TypeVar

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pinel_desktop.errors import PinelError
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event, RunState, Telemetry
from pinel_desktop.execution.clock import WallTime
from pinel_desktop.execution.control import RunControl, StepMode
from pinel_desktop.execution.executor import RunResult
from pinel_desktop.execution.inputs import Capture, LiveInputs, Pending, PersonInput
from pinel_desktop.runs.recorded_inputs import RecordedInputs
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start

Wire = dict[str, Any]
PROGRAM = {
    "pinel_ir": 1,
    "functions": [
        {
            "name": "side",
            "parameters": ["n"],
            "commands": [
                {"action": "move_forward", "distance": 0.2, "block": "ahead"},
                {"action": "turn", "angle": {"op": "*", "args": [{"var": "n"}, 20]}, "block": "t"},
            ],
        }
    ],
    "commands": [
        {"action": "set_variable", "name": "a", "value": 1, "block": "set"},
        {
            "action": "repeat",
            "times": 3,
            "block": "loop",
            "commands": [
                {
                    "action": "call",
                    "function": "side",
                    "arguments": {"n": {"var": "a"}},
                    "block": "call",
                },
                {"action": "change_variable", "name": "a", "by": 1, "block": "more"},
                {"action": "beep", "block": "beep"},
            ],
        },
        {"action": "ask", "question": "?", "variable": "b", "block": "ask"},
        {"action": "read_number", "timeout": 1, "block": "count"},
        {"action": "turn", "angle": {"gesture": "number"}, "block": "by_number"},
        {"action": "classify_gestures", "timeout": 1, "block": "see"},
        {
            "action": "conditional_execution",
            "condition": "result == 'B'",
            "commands": [{"action": "turn", "angle": {"var": "b"}, "block": "end"}],
            "elif": [],
            "else": [{"action": "move_backward", "distance": 0.1, "block": "back"}],
        },
        {"action": "drive", "linear": 0.2, "angular": 10, "block": "drive"},
        {"action": "wait", "seconds": 0.5, "block": "wait"},
    ],
}


T = TypeVar("T")

CAPTURES = [
    Capture("B", "person"),
    Capture("A", "camera", 0.983, "S"),
    Capture("7", "taught", 0.91),
    Capture("", "person"),
]


class TickingInput(PersonInput[T]):
    """As people were waited for before robot time stood still meanwhile: a tick for each look."""

    def poll(self) -> T | Pending:
        given = super().poll()
        return Pending.TICK if given is Pending.PERSON else given


class TickingInputs(LiveInputs):
    def __init__(self) -> None:
        self.gestures, self.answers = TickingInput[Capture](), TickingInput[str]()


class Classroom:
    """People who press buttons at random, but always the same ones for one seed."""

    def __init__(self, seed: int, inputs: LiveInputs) -> None:
        self.control = RunControl()
        self.gestures, self.answers = inputs.gestures, inputs.answers
        self.wire: list[Wire] = []
        self._stamp = EventSequencer("r")
        self._random = random.Random(seed)
        self._is_paused = False
        self._now_s = 0.0
        self.wall = WallTime(lambda: self._now_s, self._wait)
        if self._random.random() < 0.3:
            self.control.step = "into"

    def _wait(self, seconds: float) -> None:
        self._now_s += seconds
        if self._random.random() < 0.02:
            self.control.stop()
        self._act()

    def observe(self, tick: int, event: Event) -> None:
        if type(event) is RunState:
            self._is_paused = event.state == "paused"
        if type(event) is Telemetry:
            if not self._is_paused:
                self._act()
        elif event.is_recorded:
            self.wire.append(self._stamp.wire(tick, event))
        if type(event) is RunState and event.state == "paused":
            self._while_paused()

    def _act(self) -> None:
        chance = self._random.random()
        if chance < 0.02:
            self.control.pause()
        elif chance < 0.04:
            self.control.breakpoints = frozenset(self._random.sample(["ahead", "more", "beep"], 2))
        elif chance < 0.043:
            self.control.stop()
        elif chance < 0.1:
            self.answers.answer(self._random.choice(["30", "-45,5", "0.001"]))
        elif chance < 0.15:
            self.gestures.answer(self._random.choice(CAPTURES))

    def _while_paused(self) -> None:
        chance = self._random.random()
        modes: list[StepMode] = ["into", "over", "out"]
        if chance < 0.1:
            self.control.stop()
        elif chance < 0.6:
            self.control.step_on(self._random.choice(modes))
        else:
            self.control.breakpoints = frozenset()
            self.control.resume()


def live(seed: int, inputs: type[LiveInputs] = LiveInputs) -> tuple[RunResult, list[Wire]]:
    given = inputs()
    people, spec = Classroom(seed, given), RunSpec(PROGRAM, "empty_room", inputs=given)
    return start(spec, people.observe, people.control, wall=people.wall), people.wire


def again(
    wire: list[Wire], until_tick: int | None = None, observed: list[Wire] | None = None
) -> RunResult:
    stamp = EventSequencer("r")

    def observe(tick: int, event: Event) -> None:
        if observed is not None and event.is_recorded and type(event) is not Telemetry:
            observed.append(stamp.wire(tick, event))

    return start(RunSpec(PROGRAM, "empty_room", inputs=RecordedInputs(wire, until_tick)), observe)


def check_that_it_comes_out_the_same(result: RunResult, wire: list[Wire]) -> None:
    observed: list[Wire] = []
    repeated = again(wire, observed=observed)
    assert observed == wire
    assert repeated.ended.telemetry_sha256 == result.ended.telemetry_sha256
    assert repeated.ended.state == result.ended.state
    assert repeated.variables == result.variables or result.ended.state == "stopped"


@given(st.integers(0, 10**9))
@settings(max_examples=60, deadline=None)
def test_whatever_people_did_it_comes_out_the_same(seed: int) -> None:
    check_that_it_comes_out_the_same(*live(seed))


@given(st.integers(0, 10**9))
@settings(max_examples=60, deadline=None)
def test_so_does_what_was_recorded_while_ticks_passed_for_people(seed: int) -> None:
    check_that_it_comes_out_the_same(*live(seed, TickingInputs))


def test_the_classroom_does_everything() -> None:
    """Otherwise the test above would show little."""
    outcomes = set()
    for seed in range(60):
        result, wire = live(seed)
        outcomes |= {event["cause"] for event in wire if event["type"] == "run_state"}
        outcomes |= {event["type"] for event in wire}
        outcomes.add(result.ended.state)
        stopped_in_pause = result.ended.state == "stopped" and wire[-2]["type"] in (
            "run_state",
            "watch",
        )
        outcomes |= {"stopped_in_pause"} if stopped_in_pause else set()
        kinds = [event["type"] for event in wire if event["type"] != "watch"]
        outcomes |= set(pairwise(kinds))
    expected = {"person", "breakpoint", "step", "answered", "gesture_result", "finished", "stopped"}
    assert expected <= outcomes
    assert "stopped_in_pause" in outcomes
    for waiting in ("asked", "capture_started"):
        assert (waiting, "run_state") in outcomes  # paused while the program waits
        assert (waiting, "run_ended") in outcomes  # and stopped


def test_a_record_that_breaks_off_is_repeated_as_far_as_it_goes() -> None:
    runs = (live(seed) for seed in range(60))
    result, wire = next(run for run in runs if run[0].ended.duration_s > 5.0)
    cut = [event for event in wire if event["tick"] <= 40 and event["type"] != "run_ended"]
    repeated = again(cut, until_tick=40)
    n = 40 * result.telemetry.COLUMNS
    assert repeated.telemetry.rows[:n] == result.telemetry.rows[:n]
    assert len(repeated.telemetry.rows) < len(result.telemetry.rows)


@pytest.mark.parametrize(
    "event",
    [
        {"type": "run_state", "state": "paused", "cause": "step", "tick": 4},
        {"type": "run_ended", "state": "stopped", "tick": 4, "params": {}},
    ],
)
def test_records_of_earlier_releases_may_not_tell_enough(event: Wire) -> None:
    with pytest.raises(PinelError, match="run_not_repeatable"):
        RecordedInputs([event])
