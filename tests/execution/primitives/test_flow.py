"""Loops, decisions, waiting."""

from typing import Any

import pytest

from pinel_desktop.events.model import BlockEnded, BlockStarted, Telemetry


def op(name: str, *args: Any) -> dict[str, Any]:
    return {"op": name, "args": list(args)}


def var(name: str) -> dict[str, Any]:
    return {"var": name}


def put(name: str, value: Any) -> dict[str, Any]:
    return {"action": "set_variable", "name": name, "value": value}


def change(name: str, by: Any) -> dict[str, Any]:
    return {"action": "change_variable", "name": name, "by": by}


def say(text: Any) -> dict[str, Any]:
    return {"action": "say", "text": text}


def when(condition: Any, *commands: Any) -> dict[str, Any]:
    return {"action": "conditional_execution", "condition": condition, "commands": list(commands)}


def loop(action: str, *commands: Any, **parameters: Any) -> dict[str, Any]:
    return {"action": action, "commands": list(commands), **parameters}


def count(start: Any, end: Any, by: Any = None) -> dict[str, Any]:
    step = {} if by is None else {"by": by}
    return loop("for", say(var("i")), variable="i", **{"from": start, "to": end}, **step)


BREAK, CONTINUE = {"action": "break"}, {"action": "continue"}


@pytest.mark.parametrize(
    ("start", "end", "by", "texts"),
    [
        (1, 3, None, ["1", "2", "3"]),
        (3, 1, -1, ["3", "2", "1"]),
        (1, 10, 4, ["1", "5", "9"]),
        (3, 1, None, []),
        (1, 3, -1, []),
        (0, 0.3, 0.1, ["0", "0.1", "0.2", "0.3"]),
        (2, 2, 5, ["2"]),
    ],
)
def test_for_counts_to_the_end_and_down_where_the_step_is_negative(
    start: float, end: float, by: float | None, texts: list[str], execute_commands: Any
) -> None:
    result, _ = execute_commands(count(start, end, by))
    assert result.shown_texts == texts


def test_for_fixes_its_values_on_entry_and_sets_its_variable_every_round(
    execute_commands: Any,
) -> None:
    result, _ = execute_commands(
        put("n", 3),
        put("s", 1),
        loop(
            "for",
            say(var("i")),
            put("i", 100),
            put("n", 50),
            put("s", 7),
            variable="i",
            **{"from": var("s"), "to": var("n"), "by": var("s")},
        ),
    )
    assert result.shown_texts == ["1", "2", "3"]
    assert result.variables["i"] == 100


def test_for_by_zero_fails_the_run_at_its_block(execute_commands: Any) -> None:
    result, _ = execute_commands(put("z", 0), {**count(1, 2, var("z")), "block": "f"})
    ended = result.ended
    assert (ended.reason, ended.params, ended.block) == ("step_is_zero", {"variable": "i"}, "f")


def test_for_over_all_numbers_ends_in_words(execute_commands: Any) -> None:
    wild = {**count(-1.7e308, 1.7e308, 1.1e308), "commands": []}
    result, _ = execute_commands(wild)
    assert result.ended.state in ("finished", "failed")
    assert result.ended.reason != "internal_error"


@pytest.mark.parametrize("times", [2.5, -1, 100_001])
def test_repeat_needs_a_whole_number_in_its_range(times: float, execute_commands: Any) -> None:
    result, _ = execute_commands(put("n", times), {**loop("repeat", times=var("n")), "block": "r"})
    whole = float(times).is_integer()
    assert result.ended.reason == ("times_out_of_range" if whole else "wrong_type_whole_number")
    assert result.ended.block == "r"


def test_while_and_until_test_first(execute_commands: Any) -> None:
    result, _ = execute_commands(
        put("i", 0),
        loop("while", change("i", 1), condition=op("<", var("i"), 5)),
        say(var("i")),
        loop("until", change("i", 1), condition=op(">=", var("i"), 8)),
        say(var("i")),
        loop("while", say("never"), condition=False),
        loop("until", say("never"), condition=True),
    )
    assert result.shown_texts == ["5", "8"]


def test_break_ends_the_innermost_loop_and_continue_its_round(execute_commands: Any) -> None:
    result, log = execute_commands(
        put("n", 0),
        loop(
            "repeat",
            loop(
                "forever",
                change("n", 1),
                when(op("==", op("%", var("n"), 2), 1), CONTINUE, say("never")),
                when(op(">", var("n"), 3), when(True, BREAK, say("never"))),
                say(var("n")),
            ),
            put("n", 0),
            say("round"),
            times=2,
        ),
    )
    assert result.shown_texts == ["2", "round", "2", "round"]
    started = [event.pointer for _, event in log if isinstance(event, BlockStarted)]
    ended = [event.pointer for _, event in log if isinstance(event, BlockEnded)]
    assert sorted(started) == sorted(ended)


@pytest.mark.parametrize("action", ["while", "until", "for", "repeat", "forever"])
def test_break_and_continue_work_in_every_loop(action: str, execute_commands: Any) -> None:
    parameters: dict[str, dict[str, Any]] = {
        "while": {"condition": True},
        "until": {"condition": False},
        "for": {"variable": "i", "from": 1, "to": 99},
        "repeat": {"times": 99},
        "forever": {},
    }
    result, _ = execute_commands(
        put("n", 0),
        loop(
            action,
            change("n", 1),
            when(op("<", var("n"), 5), CONTINUE),
            say(var("n")),
            BREAK,
            **parameters[action],
        ),
        say("after"),
    )
    assert result.shown_texts == ["5", "after"]


def test_forever_without_motion_lets_time_pass_and_ends_at_the_hour(execute_commands: Any) -> None:
    result, _ = execute_commands(loop("forever", {"action": "wait", "seconds": 300}, CONTINUE))
    assert (result.ended.reason, result.ended.duration_s) == ("time_limit", 3600)


def test_first_true_branch_is_taken(execute_commands: Any) -> None:
    def branches(value: int) -> dict[str, Any]:
        return {
            **when(op("==", value, 1), say("if")),
            "elif": [
                {"condition": op("==", value, 2), "commands": [say("elif 1")]},
                {"condition": op("<", value, 4), "commands": [say("elif 2")]},
            ],
            "else": [say("else")],
        }

    result, _ = execute_commands(*[branches(value) for value in (1, 2, 3, 4)])
    assert result.shown_texts == ["if", "elif 1", "elif 2", "else"]


@pytest.mark.parametrize(
    "command",
    [
        when(var("n")),
        loop("while", condition=var("n")),
        loop("until", condition=var("n")),
        {"action": "wait_until", "condition": var("n")},
    ],
    ids=lambda command: command["action"],
)
def test_condition_that_is_no_boolean_fails_the_run_at_its_block(
    command: dict[str, Any], execute_commands: Any
) -> None:
    result, _ = execute_commands(put("n", 1), {**command, "block": "c"})
    assert (result.ended.reason, result.ended.block) == ("condition_not_boolean", "c")


def test_wait_until_goes_on_when_the_condition_is_true(execute_commands: Any) -> None:
    near = op("<", {"sensor": "distance", "direction": "front"}, 1)
    result, _ = execute_commands(
        {"action": "drive", "linear": 0.5, "angular": 0},
        {"action": "wait_until", "condition": near, "timeout": 30},
        {"action": "stop"},
    )
    # 10 degrees off to the wall at 3.99 m, seen from the hull: (3.99 - x) / cos 10 - 0.2225 = 1
    assert result.ended.pose["x_m"] == pytest.approx(2.786, abs=0.04)


def test_wait_until_that_is_true_at_once_takes_no_time(execute_commands: Any) -> None:
    result, log = execute_commands({"action": "wait_until", "condition": True})
    assert result.ended.duration_s == 0
    assert not [event for _, event in log if isinstance(event, Telemetry)]


@pytest.mark.parametrize(("timeout", "ticks"), [(1, 30), (0.5, 15), (0.001, 1)])
def test_wait_until_goes_on_when_its_time_is_over(
    timeout: float, ticks: int, execute_commands: Any
) -> None:
    result, _ = execute_commands({"action": "wait_until", "condition": False, "timeout": timeout})
    assert (result.ended.state, round(result.ended.duration_s * 30)) == ("finished", ticks + 1)


def test_wait_until_without_timeout_waits_to_the_hour(execute_commands: Any) -> None:
    result, _ = execute_commands({"action": "wait_until", "condition": False})
    assert result.ended.reason == "time_limit"
