"""An open run: it waits at the end of its program, and goes on with the commands that are appended."""

import threading
from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.events.model import CommandsAwaited, Event, Telemetry
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunResult
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start

GO = {"action": "move_forward", "distance": 0.2}
BUSY = {
    "action": "repeat",
    "times": 800,
    "commands": [{"action": "change_variable", "name": "n", "by": 1}],
}
SQUARE_IN_CALLS: list[list[dict[str, Any]]] = [
    [{"action": "set_variable", "name": "n", "value": 0}, BUSY, GO],
    [{"action": "set_gesture_result", "result": "A"}, BUSY],
    # in the tick of the call before: 1,000 steps a tick are those of both
    [{"action": "set_gesture_result", "result": "B"}, BUSY],
    [{"action": "conditional_execution", "condition": 'result == "B"', "commands": [GO]}],
    [{"action": "turn", "angle": 90}, {"action": "pen", "down": True}],
    [{"action": "drive", "linear": 0.2, "angular": 10}],
    [{"action": "wait", "seconds": 1}],
]


class OpenRun:
    """Appends a call whenever the run has come to its end; at last does `at_end`."""

    def __init__(self, calls: list[list[dict[str, Any]]], at_end: Callable[[RunControl], None]):
        self.control, self.events = RunControl(), list[tuple[int, Event]]()
        self._calls, self._at_end = iter(calls), at_end
        self.control.append([])

    def observe(self, tick: int, event: Event) -> None:
        self.events.append((tick, event))
        if type(event) is CommandsAwaited:
            call = next(self._calls, None)
            if call is None:
                self._at_end(self.control)
            else:
                self.control.append(call)

    def run(self) -> RunResult:
        return start(RunSpec([], "empty_room", pace="max"), self.observe, self.control)

    @property
    def recorded(self) -> list[tuple[int, Event]]:
        return [one for one in self.events if type(one[1]).is_recorded]


@pytest.mark.parametrize("at_end", [RunControl.finish, RunControl.stop])
def test_an_open_run_is_tick_by_tick_the_run_of_its_whole_program(
    at_end: Callable[[RunControl], None],
) -> None:
    open_run = OpenRun(SQUARE_IN_CALLS, at_end)
    result = open_run.run()
    whole: list[tuple[int, Event]] = []
    document = [command for call in SQUARE_IN_CALLS for command in call]
    expected = start(
        RunSpec(document, "empty_room", pace="max"), lambda *event: whole.append(event)
    )
    assert result.ended == expected.ended
    assert result.ended.state == "finished"
    assert open_run.recorded == whole
    assert result.variables == {"n": 2400}


def test_it_tells_how_many_commands_were_executed_and_the_gesture_result() -> None:
    open_run = OpenRun([[GO], [{"action": "set_gesture_result", "result": "B"}]], RunControl.finish)
    open_run.run()
    awaited = [event for _, event in open_run.events if type(event) is CommandsAwaited]
    assert awaited[:3] == [CommandsAwaited(0, ""), CommandsAwaited(1, ""), CommandsAwaited(2, "B")]


def test_a_pause_between_two_calls_holds_the_first_tick_of_the_next_one() -> None:
    open_run = OpenRun([[GO], [GO]], RunControl.finish)
    observe, control = open_run.observe, open_run.control
    timer = threading.Timer(0.2, control.resume)

    def pausing(tick: int, event: Event) -> None:
        if type(event) is CommandsAwaited and event.n_executed == 1:
            control.pause()
            timer.start()
        observe(tick, event)

    spec = RunSpec([], "empty_room", pace="max")
    assert start(spec, pausing, control).ended.state == "finished"
    kinds = [type(event).__name__ for _, event in open_run.recorded if type(event) is not Telemetry]
    pause = ["RunState", "RunState"]
    assert kinds == [
        "RunState", "BlockStarted", "BlockEnded", "BlockStarted", *pause, "BlockEnded", "RunEnded"
    ]  # fmt: skip


def test_commands_that_were_appended_together_are_done_one_after_the_other() -> None:
    open_run = OpenRun([[GO]], RunControl.finish)
    open_run.control.append([{"action": "turn", "angle": 90}])
    assert open_run.run().ended.n_executed == 2
