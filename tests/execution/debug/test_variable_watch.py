"""What those who watch are told of the inside of a program."""

import itertools
from typing import Any

import pytest

from pinel_desktop.events.model import Event, RunEnded, RunState, Telemetry, Watch
from pinel_desktop.execution.control import RunControl


def put(name: str, value: Any) -> dict[str, Any]:
    return {"action": "set_variable", "name": name, "value": value}


def wait(seconds: float) -> dict[str, Any]:
    return {"action": "wait", "seconds": seconds}


def watched(log: Any) -> list[tuple[int, Watch]]:
    return [(tick, event) for tick, event in log if isinstance(event, Watch)]


COUNT = {
    "action": "repeat",
    "times": 60,
    "commands": [{"action": "change_variable", "name": "i", "by": 1}, wait(1 / 30)],
}


def test_variables_are_reported_at_most_five_times_a_second(execute_commands: Any) -> None:
    _, log = execute_commands(put("i", 0), COUNT)
    ticks = [tick for tick, _ in watched(log)]
    assert all(following - earlier >= 6 for earlier, following in itertools.pairwise(ticks[:-1]))
    assert len(ticks) == pytest.approx(60 / 6, abs=2)
    assert watched(log)[-1][1].variables == {"i": 60}


def test_last_report_comes_before_the_end_and_tells_the_last_values(execute_commands: Any) -> None:
    result, log = execute_commands(put("a", 1), put("a", 2))
    assert isinstance(log[-1][1], RunEnded)
    assert watched(log)[-1][1] == Watch({"a": 2}, [], "")
    assert result.variables == {"a": 2}


def test_nothing_is_reported_where_nothing_changes(execute_commands: Any) -> None:
    _, log = execute_commands({"action": "move_forward", "distance": 1}, wait(1))
    assert watched(log) == []
    _, log = execute_commands(put("a", 1), wait(2))
    assert len(watched(log)) == 1


def test_failed_run_tells_its_variables_too(execute_commands: Any) -> None:
    _, log = execute_commands(put("a", 1), put("b", {"var": "nobody"}))
    assert watched(log)[-1][1].variables == {"a": 1}


def test_pause_reports_at_once(execute_commands: Any) -> None:
    control = RunControl()

    class Resuming:
        waits = 0

        def wait_for_tick(self) -> None:
            self.waits += control.pause_requested
            if self.waits == 10:
                control.resume()

    def pause(tick: int, event: Event) -> None:
        if tick == 15 and isinstance(event, Telemetry):
            control.pause()

    _, log = execute_commands(put("i", 0), COUNT, control=control, clock=Resuming(), listener=pause)
    events = [event for _, event in log]
    paused = [isinstance(e, RunState) and e.state == "paused" for e in events].index(True)
    at_the_pause = [
        event.variables for tick, event in watched(log[paused - 2 :]) if tick <= log[paused][0]
    ]
    assert {"i": 15} in at_the_pause


def test_calls_are_told_from_the_outermost_with_the_block_that_calls(execute_commands: Any) -> None:
    functions = [
        {
            "name": "outer",
            "parameters": ["a"],
            "commands": [{"action": "call", "function": "inner", "block": "in outer"}],
        },
        {"name": "inner", "parameters": [], "commands": [wait(1)]},
    ]
    call = {"action": "call", "function": "outer", "arguments": {"a": 7}, "block": "in main"}
    _, log = execute_commands(put("a", 1), put("b", 2), call, functions=functions)
    deepest = max((event for _, event in watched(log)), key=lambda event: len(event.stack))
    assert deepest.stack == [
        {"function": "outer", "block": "in main"},
        {"function": "inner", "block": "in outer"},
    ]
    assert deepest.variables == {"a": 1, "b": 2}
    assert watched(log)[-1][1].stack == []


def test_parameters_hide_variables_of_the_same_name(execute_commands: Any) -> None:
    function = {"name": "f", "parameters": ["a"], "commands": [wait(1)]}
    call = {"action": "call", "function": "f", "arguments": {"a": 7}}
    _, log = execute_commands(put("a", 1), call, functions=[function])
    inside = [event for _, event in watched(log) if event.stack]
    assert inside[0].variables == {"a": 7}


def test_gesture_result_is_told(execute_commands: Any) -> None:
    _, log = execute_commands({"action": "set_gesture_result", "result": "B"})
    assert watched(log)[-1][1].gesture == "B"


def test_long_values_are_cut(execute_commands: Any) -> None:
    _, log = execute_commands(
        put("text", "x" * 1_000), put("list", list(range(100))), put("short", [1, 2])
    )
    variables = watched(log)[-1][1].variables
    assert variables["text"] == "x" * 200 + "…"
    assert variables["list"] == [*range(20), "…"]
    assert variables["short"] == [1, 2]


def test_report_of_many_long_values_stays_small(execute_commands: Any) -> None:
    many = [put(f"v{i}", ["x" * 100] * 25) for i in range(300)]
    _, log = execute_commands(*many)
    variables = watched(log)[-1][1].variables
    assert len(variables) == 300
    assert variables["v299"] == "…"
    assert len(str(variables)) < 40_000
