"""Inputs without a person: another robot gets what people gave in a recorded run, after the same waits."""

import json
from typing import Any

from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event, RunState, Telemetry
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunResult
from pinel_desktop.execution.inputs import Capture, LiveInputs, Pending, PersonInput
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.runs.fixed_inputs import FixedInputs
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start

Wire = dict[str, Any]
REALISTIC = SimulationConfig(preset="realistic", feedback="odometry")
WAIT_TICKS = 12


def document(first_m: float) -> Wire:
    """A program that drives, asks, and drives on by a sign."""
    return {
        "pinel_ir": 1,
        "commands": [
            {"action": "move_forward", "distance": first_m},
            {"action": "ask", "question": "?", "variable": "d"},
            {"action": "move_forward", "distance": {"var": "d"}},
            {"action": "classify_gestures", "timeout": 5},
            {
                "action": "conditional_execution",
                "condition": "result == 'B'",
                "commands": [{"action": "turn", "angle": 90}],
                "elif": [],
                "else": [],
            },
        ],
    }


class Person(LiveInputs):
    """Answers after some ticks of robot time, as beside a real robot, and pauses the run once."""

    def __init__(self, control: RunControl) -> None:
        self.gestures, self.answers = _Slow(Capture("B", "person")), _Slow("0.5")
        self._control, self.wire, self._stamp = control, list[Wire](), EventSequencer("r")

    def observe(self, tick: int, event: Event) -> None:
        if type(event) is RunState and event.state == "paused":
            self._control.resume()
        elif type(event) is Telemetry and tick == 10:
            self._control.pause()
        if event.is_recorded and type(event) is not Telemetry:
            self.wire.append(json.loads(json.dumps(self._stamp.wire(tick, event))))


class _Slow(PersonInput[Any]):
    def __init__(self, given: object) -> None:
        super().__init__()
        self._answer, self._polls = given, 0

    def poll(self) -> Any:
        self._polls += 1
        return self._answer if self._polls > WAIT_TICKS else Pending.TICK


def recorded_run() -> list[Wire]:
    """The events of an ideal robot's run of 1 m, with a pause."""
    control = RunControl()
    person = Person(control)
    spec = RunSpec(document(1.0), "empty_room", inputs=person)
    assert start(spec, person.observe, control).ended.state == "finished"
    assert any(event.get("state") == "paused" for event in person.wire)
    return person.wire


def driven(given: FixedInputs, first_m: float, seed: int = 7) -> tuple[RunResult, list[Wire]]:
    """Drives a realistic robot with fixed inputs."""
    wire: list[Wire] = []
    stamp = EventSequencer("r")

    def observe(tick: int, event: Event) -> None:
        wire.append(stamp.wire(tick, event))

    program, inputs = document(first_m), given.source()
    spec = RunSpec(program, "empty_room", setting=REALISTIC, seed=seed, inputs=inputs)
    return start(spec, observe), wire


def waits(wire: list[Wire]) -> list[int]:
    """Returns how many ticks each wait took."""
    begins = [event["tick"] for event in wire if event["type"] in ("asked", "capture_started")]
    ends = [event["tick"] for event in wire if event["type"] in ("answered", "gesture_result")]
    return [end - begin for begin, end in zip(begins, ends, strict=True)]


def test_another_robot_and_a_changed_program_get_each_input_after_the_recorded_wait() -> None:
    wire = recorded_run()
    given = FixedInputs.from_message(json.loads(json.dumps(FixedInputs.of_run(wire).as_message())))
    for first_m in (1.0, 0.2, 2.5):
        result, observed = driven(given, first_m)
        assert result.ended.state == "finished"
        assert waits(observed) == waits(wire) == [WAIT_TICKS, WAIT_TICKS]
        assert result.variables["d"] == 0.5
        assert not any(event.get("state") == "paused" for event in observed)


def test_a_question_beyond_the_recorded_ones_fails_at_once() -> None:
    wire = [event for event in recorded_run() if event["type"] != "answered"]
    result, _ = driven(FixedInputs.of_run(wire), 0.2)
    assert (result.ended.state, result.ended.reason) == ("failed", "answer_missing")
    wire = [event for event in recorded_run() if event["type"] != "gesture_result"]
    result, _ = driven(FixedInputs.of_run(wire), 0.2)
    assert (result.ended.state, result.ended.reason) == ("failed", "no_more_gestures")


def test_lists_are_given_in_their_order() -> None:
    result, observed = driven(FixedInputs(("B",), ("0.3",)), 0.2)
    assert (result.ended.state, result.variables["d"]) == ("finished", 0.3)
    assert waits(observed) == [1, 1]
