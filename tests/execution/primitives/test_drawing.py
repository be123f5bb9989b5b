"""The pen and the marks."""

from typing import Any

import pytest

from pinel_desktop.events.model import Event, Marked, Pen

FORWARD = {"action": "move_forward", "distance": 0.5}
MARK = {"action": "mark", "symbol": "X", "block": "m"}


def pen(*, down: bool, **more: Any) -> dict[str, Any]:
    return {"action": "pen", "down": down, "block": "p", **more}


def of_type(log: Any, kind: type[Event]) -> list[Any]:
    return [event for _, event in log if isinstance(event, kind)]


def test_pen_is_reported_when_it_changes(execute_commands: Any) -> None:
    _, log = execute_commands(
        pen(down=True, color="red"),
        FORWARD,
        pen(down=True, color="red"),
        FORWARD,
        pen(down=False),
        FORWARD,
    )
    assert of_type(log, Pen) == [Pen("p", True, "red"), Pen("p", False, "blue")]


def test_pen_without_a_colour_is_blue_and_up_at_the_start(execute_commands: Any) -> None:
    _, log = execute_commands(pen(down=False), FORWARD, pen(down=True), FORWARD)
    assert of_type(log, Pen) == [Pen("p", True, "blue")]


def test_pen_in_a_loop_without_motion_is_reported_once_a_tick(execute_commands: Any) -> None:
    both = [pen(down=True), pen(down=False, color="red"), pen(down=True, color="green")]
    _, log = execute_commands({"action": "repeat", "times": 5_000, "commands": both})
    ticks = [tick for tick, event in log if isinstance(event, Pen)]
    assert len(ticks) == len(set(ticks)) > 1


def test_pen_at_the_end_is_reported(execute_commands: Any) -> None:
    _, log = execute_commands(pen(down=True))
    assert of_type(log, Pen) == [Pen("p", True, "blue")]


def test_mark_is_where_the_robot_stands_in_the_start_frame(execute_commands: Any) -> None:
    result, log = execute_commands(MARK, FORWARD, {**MARK, "symbol": "O"}, world="tic_tac_toe")
    assert result.marks == of_type(log, Marked)
    assert [(mark.block, mark.symbol) for mark in result.marks] == [("m", "X"), ("m", "O")]
    assert (result.marks[0].x_m, result.marks[0].y_m) == (0, 0)
    assert (result.marks[1].x_m, result.marks[1].y_m) == pytest.approx((0.5, 0), abs=1e-4)


def test_thousand_marks_are_enough(execute_commands: Any) -> None:
    result, log = execute_commands({"action": "forever", "commands": [MARK]})
    ended = result.ended
    assert (ended.reason, ended.params, ended.block) == ("too_many_marks", {"max": 1000}, "m")
    assert len(of_type(log, Marked)) == len(result.marks) == 1_000


def store(sensor: str, name: str) -> dict[str, Any]:
    return {"action": "set_variable", "name": name, "value": {"sensor": sensor}}


@pytest.mark.parametrize(("value", "symbol"), [("X", "X"), ("o", "O")])
def test_symbol_may_be_computed(value: str, symbol: str, execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "set_variable", "name": "s", "value": value},
        {**MARK, "symbol": {"var": "s"}},
    )
    assert [mark.symbol for mark in result.marks] == [symbol]


@pytest.mark.parametrize("value", ["Z", "", "XO", 3, True])
def test_what_is_no_symbol_is_said_at_the_block(value: Any, execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "set_variable", "name": "s", "value": value},
        {**MARK, "symbol": {"var": "s"}},
    )
    ended = result.ended
    assert (ended.reason, ended.params, ended.block) == ("symbol_unknown", {"value": value}, "m")
    assert result.marks == []


def test_mark_is_found_in_its_place_of_the_world_and_nowhere_else(execute_commands: Any) -> None:
    to_a, to_b = ({"action": "go_to_place", "place": name} for name in "AB")
    result, _ = execute_commands(
        to_a,
        store("has_mark", "before"),
        {"action": "move_forward", "distance": 0.4},
        MARK,
        to_a,
        store("mark_here", "a"),
        to_b,
        store("has_mark", "b"),
        to_a,
        {**MARK, "symbol": "O"},
        store("mark_here", "last"),
        world="tic_tac_toe",
    )
    assert result.variables == {"before": False, "a": "X", "b": False, "last": "O"}


def test_mark_outside_of_all_places_is_found_where_it_is(execute_commands: Any) -> None:
    a_bit = {"action": "move_forward", "distance": 0.25}
    result, _ = execute_commands(
        MARK, a_bit, store("has_mark", "near"), a_bit, store("mark_here", "far"), world="empty_room"
    )
    assert result.variables == {"near": True, "far": ""}
