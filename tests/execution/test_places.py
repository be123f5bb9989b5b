"""Places of the world by name, and what marks are found in them."""

from typing import Any

import pytest

from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.execution.places import MarkedPlaces, middle_of, place_under
from pinel_desktop.robot import Pose2D, Sensors


def go(place: Any, **more: Any) -> dict[str, Any]:
    return {"action": "go_to_place", "place": place, "block": "go", **more}


@pytest.mark.parametrize("name", ["E", "e", " e "])
def test_robot_drives_to_the_middle_of_the_place(name: str, execute_commands: Any) -> None:
    result, _ = execute_commands({"action": "turn", "angle": 30}, go(name), world="tic_tac_toe")
    pose = result.ended.pose
    assert (pose["x_m"], pose["y_m"]) == pytest.approx((2, -1), abs=2e-3)


def test_place_may_be_a_sign_an_answer_or_computed(execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "classify_gestures"},
        go({"gesture": "result"}),
        {"action": "mark", "symbol": "X"},
        {"action": "ask", "question": "?", "variable": "v"},
        go({"var": "v"}),
        {"action": "mark", "symbol": "O"},
        go({"op": "item", "args": [["A", "B"], 2]}, avoid=True),
        world="tic_tac_toe",
        inputs=ScriptedInputs(["L"], ["g"]),
    )
    places = [(round(mark.x_m), round(mark.y_m)) for mark in result.marks]
    assert (result.ended.state, places) == ("finished", [(3, -2), (1, -2)])
    pose = result.ended.pose
    assert (pose["x_m"], pose["y_m"]) == pytest.approx((2, 0), abs=2e-2)


@pytest.mark.parametrize(
    ("world", "name", "code", "params"),
    [
        ("tic_tac_toe", "H", "unknown_place", {"value": "H", "allowed": list("ABCDEFGIL")}),
        ("tic_tac_toe", "", "place_not_named", {}),
        ("tic_tac_toe", "  ", "place_not_named", {}),
        ("empty_room", "A", "no_places", {"value": "A"}),
    ],
)
def test_place_that_is_not_there_is_said_at_the_block(
    world: str, name: str, code: str, params: dict[str, Any], execute_commands: Any
) -> None:
    result, _ = execute_commands(go(name), world=world)
    ended = result.ended
    assert (ended.state, ended.reason, ended.params, ended.block) == ("failed", code, params, "go")


def test_place_is_a_text(execute_commands: Any) -> None:
    put = {"action": "set_variable", "name": "n", "value": 3}
    result, _ = execute_commands(put, go({"var": "n"}), world="tic_tac_toe")
    assert (result.ended.reason, result.ended.params) == ("wrong_type_text", {"name": "place"})


def test_names_that_differ_in_case_are_two_places() -> None:
    places = {"a": (1.0, 0.0), "A": (2.0, 0.0)}
    assert middle_of("A", places, Pose2D()) == (2.0, 0.0)
    assert middle_of("a", places, Pose2D()) == (1.0, 0.0)


def test_robot_without_a_map_knows_of_no_places() -> None:
    assert Sensors().places() == {}
    assert place_under(Sensors()) == ""


def test_last_mark_of_a_place_counts() -> None:
    marked = MarkedPlaces()
    marked.put("X", "A", Pose2D(1.0, 0.0))
    marked.put("O", "A", Pose2D(1.1, 0.0))
    marked.put("X", "", Pose2D(0.0, 0.0))
    marked.put("O", "", Pose2D(0.2, 0.0))
    assert marked.here("A", Pose2D(9.0, 9.0)) == "O"
    assert marked.here("B", Pose2D(1.0, 0.0)) == ""
    assert marked.here("", Pose2D(0.1, 0.0)) == "O"
    assert marked.here("", Pose2D(-0.25, 0.0)) == "X"
    assert marked.here("", Pose2D(1.0, 0.0)) == ""
