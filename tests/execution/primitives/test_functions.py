"""Functions: their parameters, their values, their depth, and the time they take."""

import itertools
from typing import Any

import pytest

from pinel_desktop.events.model import BlockEnded, BlockStarted
from pinel_desktop.execution.control import RunControl


def op(name: str, *args: Any) -> dict[str, Any]:
    return {"op": name, "args": list(args)}


def var(name: str) -> dict[str, Any]:
    return {"var": name}


def put(name: str, value: Any) -> dict[str, Any]:
    return {"action": "set_variable", "name": name, "value": value}


def say(text: Any) -> dict[str, Any]:
    return {"action": "say", "text": text}


def when(condition: Any, *commands: Any) -> dict[str, Any]:
    return {"action": "conditional_execution", "condition": condition, "commands": list(commands)}


def give(*value: Any) -> dict[str, Any]:
    return {"action": "return", "value": value[0]} if value else {"action": "return"}


def function(name: str, parameters: list[str], *commands: Any) -> dict[str, Any]:
    return {"name": name, "parameters": parameters, "commands": list(commands)}


def call(name: str, **arguments: Any) -> dict[str, Any]:
    return {"action": "call", "function": name, "arguments": arguments}


def value(name: str, **arguments: Any) -> dict[str, Any]:
    return {"call": name, "arguments": arguments}


FACTORIAL = function(
    "factorial",
    ["n"],
    when(op("<=", var("n"), 1), give(1)),
    give(op("*", var("n"), value("factorial", n=op("-", var("n"), 1)))),
)
DANCE = function("dance", [], {"action": "turn", "angle": 90, "block": "t"}, give(0.5))
DOWN = function(
    "down",
    ["n"],
    when(op("<=", var("n"), 1), give(1)),
    give(op("+", 1, value("down", n=op("-", var("n"), 1)))),
)


def test_function_returns_a_value_also_through_recursion(execute_commands: Any) -> None:
    result, _ = execute_commands(
        put("x", op("+", value("factorial", n=5), value("factorial", n=3))), functions=[FACTORIAL]
    )
    assert result.variables == {"x": 126}


def test_parameters_are_the_functions_own_and_other_variables_everybodys(
    execute_commands: Any,
) -> None:
    change = function(
        "change", ["a"], put("a", op("+", var("a"), 1)), put("b", var("a")), say(var("a"))
    )
    result, _ = execute_commands(
        put("a", 1), put("b", 1), call("change", a=10), say(var("a")), functions=[change]
    )
    assert result.shown_texts == ["11", "1"]
    assert result.variables == {"a": 1, "b": 11}


def test_parameters_of_the_caller_are_not_seen_inside(execute_commands: Any) -> None:
    outer, inner = function("outer", ["p"], call("inner")), function("inner", [], say(var("p")))
    result, _ = execute_commands(call("outer", p=1), functions=[outer, inner])
    assert (result.ended.reason, result.ended.params) == ("unset_variable", {"name": "p"})


def test_list_given_to_a_function_is_a_copy(execute_commands: Any) -> None:
    add = function("add", ["l"], {"action": "append", "list": "l", "value": 2}, give(var("l")))
    result, _ = execute_commands(put("l", [1]), put("m", value("add", l=var("l"))), functions=[add])
    assert result.variables == {"l": [1], "m": [1, 2]}


def test_value_read_before_a_call_is_not_changed_by_it(execute_commands: Any) -> None:
    grow = function("grow", [], {"action": "append", "list": "l", "value": 2}, give(1))
    result, _ = execute_commands(
        put("l", [1]), put("s", op("join", var("l"), ";", value("grow"))), functions=[grow]
    )
    assert result.variables["s"] == "1;1"


def test_return_leaves_all_loops_and_ends_their_blocks(execute_commands: Any) -> None:
    find = function(
        "find",
        [],
        {
            "action": "forever",
            "commands": [
                {
                    "action": "for",
                    "variable": "i",
                    "from": 1,
                    "to": 9,
                    "commands": [when(op("==", var("i"), 4), give(var("i")), say("never"))],
                }
            ],
        },
    )
    result, log = execute_commands(say(value("find")), say("after"), functions=[find])
    assert result.shown_texts == ["4", "after"]
    started = [event.pointer for _, event in log if isinstance(event, BlockStarted)]
    ended = [event.pointer for _, event in log if isinstance(event, BlockEnded)]
    assert sorted(started) == sorted(ended)
    assert "/functions/0/commands/0/commands/0/commands/0/commands/0" in started


def test_expression_waits_for_the_motion_in_its_calls(execute_commands: Any) -> None:
    result, log = execute_commands(
        {
            "action": "move_forward",
            "distance": op("+", value("dance"), value("dance")),
            "block": "m",
        },
        functions=[DANCE],
    )
    pose = result.ended.pose
    assert (pose["x_m"], pose["y_m"]) == pytest.approx((-1, 0), abs=1e-4)
    blocks = [(event.block, event.amount) for _, event in log if isinstance(event, BlockStarted)]
    assert [entry for entry in blocks if entry[0]] == [("m", None), ("t", 90), ("t", 90)]
    assert result.ended.n_executed == 1 + 2 * 2


@pytest.mark.parametrize(
    "command",
    [
        {"action": "wait", "seconds": value("dance")},
        {"action": "repeat", "times": op("*", 2, value("dance")), "commands": [say("x")]},
        {"action": "while", "condition": op("<", value("dance"), 0), "commands": []},
        {"action": "until", "condition": op("==", value("dance"), 0.5), "commands": []},
        {"action": "wait_until", "condition": op("==", value("dance"), 0.5)},
        when(op("and", True, op("==", value("dance"), 0.5)), say("x")),
        {"action": "for", "variable": "i", "from": value("dance"), "to": 1, "commands": []},
        say(op("join", "x", value("dance"))),
        {"action": "append", "list": "l", "value": value("dance")},
        {"action": "set_speed", "linear": value("dance")},
        {"action": "drive", "linear": op("-", value("dance"), 0.5), "angular": 0},
        {"action": "set_gesture_result", "result": op("join", value("dance"))},
        put("d", {"sensor": "sonar", "index": op("*", 2, value("dance"))}),
        put("d", {"sensor": "lidar", "angle": value("dance")}),
        put("d", op("min", *[1] * 600, value("dance"))),
        call("echo", p=value("dance")),
        put("d", value("echo", p=value("dance"))),
    ],
    ids=lambda command: command["action"],
)
def test_calls_with_motion_stand_wherever_an_expression_stands(
    command: dict[str, Any], execute_commands: Any
) -> None:
    echo = function("echo", ["p"], give(var("p")))
    result, _ = execute_commands(put("l", []), command, functions=[DANCE, echo])
    assert result.ended.state == "finished", result.ended
    assert result.ended.pose["yaw_rad"] == pytest.approx(1.5708, abs=1e-3)


def test_short_circuit_does_not_call(execute_commands: Any) -> None:
    result, _ = execute_commands(
        when(op("or", True, op("==", value("dance"), 1)), say("x")),
        when(op("and", False, op("==", value("dance"), 1)), say("y")),
        functions=[DANCE],
    )
    assert (result.shown_texts, result.ended.duration_s) == (["x"], 0)


@pytest.mark.parametrize(("depth", "state"), [(100, "finished"), (101, "failed")])
def test_recursion_goes_100_deep(depth: int, state: str, execute_commands: Any) -> None:
    result, _ = execute_commands(
        {**put("x", value("down", n=depth)), "block": "p"}, functions=[DOWN]
    )
    assert result.ended.state == state
    if state == "failed":
        assert result.ended.reason == "recursion_too_deep"
        assert result.ended.params == {"function": "down", "max": 100}
    else:
        assert result.variables == {"x": 100}


def test_calls_as_commands_are_as_deep(execute_commands: Any) -> None:
    endless = function("endless", [], {**call("endless"), "block": "again"})
    result, _ = execute_commands(call("endless"), functions=[endless])
    assert (result.ended.reason, result.ended.block) == ("recursion_too_deep", "again")


def test_deep_recursion_with_deep_expressions_does_not_overflow(execute_commands: Any) -> None:
    nested = value("deep", n=op("-", var("n"), 1))
    for _ in range(25):
        nested = op("+", 0, nested)
    deep = function("deep", ["n"], when(op("<=", var("n"), 1), give(1)), give(nested))
    result, _ = execute_commands(put("x", value("deep", n=99)), functions=[deep])
    assert result.variables == {"x": 1}


def test_function_that_ends_without_a_value_in_an_expression_fails_at_the_callers_block(
    execute_commands: Any,
) -> None:
    sometimes = function("sometimes", ["p"], when(var("p"), give(1)))
    result, _ = execute_commands(
        {**put("x", value("sometimes", p=False)), "block": "here"}, functions=[sometimes]
    )
    ended = result.ended
    assert (ended.reason, ended.params, ended.block) == (
        "function_gave_nothing",
        {"function": "sometimes"},
        "here",
    )


def test_return_without_a_value_ends_a_function_called_as_a_command(execute_commands: Any) -> None:
    early = function("early", [], say("a"), give(), say("never"))
    result, _ = execute_commands(call("early"), call("early"), functions=[early])
    assert result.shown_texts == ["a", "a"]


def test_failure_inside_a_function_names_the_block_inside(execute_commands: Any) -> None:
    bad = function("bad", [], {"action": "turn", "angle": op("/", 1, var("z")), "block": "inside"})
    result, _ = execute_commands(put("z", 0), {**call("bad"), "block": "outside"}, functions=[bad])
    assert (result.ended.reason, result.ended.block) == ("division_by_zero", "inside")


def test_stop_inside_a_function_ends_the_run_there(execute_commands: Any) -> None:
    control = RunControl()
    result, _ = execute_commands(
        {"action": "move_forward", "distance": value("dance"), "block": "m"},
        functions=[DANCE],
        control=control,
        listener=lambda tick, _event: control.stop() if tick == 5 else None,
    )
    assert (result.ended.state, result.ended.block) == ("stopped", "t")


def test_blocks_nest_properly_whatever_is_called(execute_commands: Any) -> None:
    _, log = execute_commands(
        put("x", value("factorial", n=3)),
        {"action": "wait", "seconds": value("dance")},
        functions=[FACTORIAL, DANCE],
    )
    opened: list[str] = []
    for event in itertools.chain(event for _, event in log):
        if isinstance(event, BlockStarted):
            opened.append(event.pointer)
        elif isinstance(event, BlockEnded):
            assert opened.pop() == event.pointer
    assert opened == []
