"""Motions that would take longer than a run may, and what follows `drive`."""

import time
from typing import Any

import pytest

from pinel_desktop.events.model import TextShown
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from tests.in_time import in_time

Json = dict[str, Any]


def program(*commands: Json) -> Any:
    found = read_document({"pinel_ir": 1, "commands": list(commands)}).program
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("speed", "motion"),
    [
        ({"linear": 1e-300}, {"action": "move_forward", "distance": 1}),
        ({"linear": 1e-5}, {"action": "move_forward", "distance": 100}),
        ({"linear": 1e-3}, {"action": "move_backward", "distance": 100}),
        ({"angular": 1e-300}, {"action": "turn", "angle": 90}),
        ({"angular": 1e-3}, {"action": "turn", "angle": -3600}),
        ({"linear": 1e-3}, {"action": "arc", "radius": 100, "angle": 3600}),
    ],
)
def test_a_snails_pace_is_planned_at_once_and_ends_in_words(speed: Json, motion: Json) -> None:
    start_s = time.monotonic()
    ended = execute(
        program({"action": "set_speed", **speed}, motion), open_link("sim", world="empty_room")
    ).ended
    assert (ended.state, ended.reason) == ("failed", "blocked")
    assert in_time(
        time.monotonic() - start_s, 5.0
    )  # a plan of all of it took a minute and gigabytes


def test_stop_is_heard_in_a_motion_of_hours() -> None:
    control = RunControl()
    started: list[float] = []

    def observe(tick: int, _event: Any) -> None:
        if tick == 3 and not started:
            started.append(time.monotonic())
            control.stop()

    commands = (
        {"action": "set_speed", "linear": 0.02},
        {"action": "move_forward", "distance": 100},
    )
    options = RunOptions(observer=observe, control=control)
    ended = execute(program(*commands), open_link("sim", world="empty_room"), options).ended
    assert ended.state == "stopped"


def test_go_to_where_the_robot_is_ends_what_drive_began(execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "drive", "linear": 0.3, "angular": 0},
        {"action": "wait", "seconds": 1},
        {"action": "go_to", "x": {"sensor": "x"}, "y": {"sensor": "y"}},
        {"action": "wait", "seconds": 5},
    )
    assert result.ended.pose["x_m"] < 0.5


@pytest.mark.parametrize(
    "motion",
    [{"action": "arc", "radius": 0, "angle": 30}, {"action": "arc", "radius": 0.1, "angle": 20}],
)
def test_motions_after_a_fast_drive_begin_at_rest(motion: Json, execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "set_speed", "linear": 1.2},
        {"action": "drive", "linear": 1.2, "angular": 0},
        {"action": "wait", "seconds": 2},
        {"action": "turn", "angle": 90},
        motion,
    )
    assert result.ended.state == "finished"


def test_straight_back_is_180_degrees(execute_commands: Any) -> None:
    _, log = execute_commands(
        {"action": "turn", "angle": 180},
        {"action": "say", "text": {"sensor": "heading"}},
        {"action": "go_to", "x": -0.5, "y": 0},
        {"action": "say", "text": {"op": ">", "args": [{"sensor": "heading"}, 179]}},
    )
    assert [event.text for _, event in log if isinstance(event, TextShown)] == ["180", "true"]


def test_exactly_an_hour_is_within_the_limit(execute_commands: Any) -> None:
    result, _ = execute_commands(*[{"action": "wait", "seconds": 600}] * 6)
    assert (result.ended.state, result.ended.duration_s) == ("finished", 3600.0)
