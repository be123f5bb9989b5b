"""The picture of an activity's goal: what its solution drives or draws, where, and with which sign."""

from typing import Any

from pinel_desktop.activities import Activity, Goal, goal_of
from pinel_desktop.program.python_text import read_python

TITLE = {"pt-BR": "x", "en": "x", "es": "x"}


def goal(solution: str, *checks: dict[str, Any], **more: Any) -> Goal:
    document = {"pinel_activity": 2, "name": "a", "title": TITLE, "world": "tic_tac_toe"}
    activity = Activity.model_validate({**document, "checks": list(checks), **more})
    return goal_of(activity, read_python(solution).result)


def test_is_the_path_in_the_world_from_the_start_of_the_case() -> None:
    start = {"x_m": 1.0, "y_m": 2.0, "heading_deg": 90.0}
    (line,) = goal("robot.move_forward(0.5)\n", world="empty_room", cases=[{"start": start}]).lines
    assert (line.sign, line.color, line.points) == (None, None, [(1.0, 2.0), (1.0, 2.5)])


def test_is_what_the_pen_draws_where_there_is_one() -> None:
    lines = goal(
        'robot.pen(True, "red")\nrobot.move_forward(0.5)\nrobot.pen(False)\nrobot.move_forward(0.5)\n'
        'robot.pen(True, "blue")\nrobot.move_forward(0.5)\n',
        world="empty_room",
    ).lines
    assert [(line.color, line.points) for line in lines] == [
        ("red", [(0.0, 0.0), (0.5, 0.0)]),
        ("blue", [(1.0, 0.0), (1.5, 0.0)]),
    ]


def test_has_a_line_for_each_sign_and_none_for_signs_together() -> None:
    cases = [{"gestures": ["B"]}, {"gestures": ["", "A"]}, {"gestures": ["B", "A"]}]
    lines = goal("robot.move_forward(0.5)\n", cases=cases).lines
    assert [line.sign for line in lines] == ["B", "A"]


def test_names_the_zones_of_the_checks_once_and_in_order() -> None:
    visits = {"check": "visits", "zones": ["A", "E"]}
    marks = {"check": "marks", "symbol": "X", "zone": "A"}
    case = {"checks": [{"check": "ends_in", "zone": "L"}]}
    assert goal("robot.stop()\n", visits, marks, cases=[case]).zones == ["A", "E", "L"]


def test_shows_where_a_box_is_pushed_to() -> None:
    assert goal("robot.move_forward(3)\n", world="pushing").boxes == {"0": (0.27, 0.0, 0.0)}


def test_keeps_the_path_for_itself_where_finding_it_is_the_activity() -> None:
    end = {"check": "ends_in", "zone": "L"}
    found = goal("robot.move_forward(0.5)\n", end, shows_path=False)
    assert (found.lines, found.zones) == ([], ["L"])


def test_without_a_solution_the_zones_remain() -> None:
    document = {"pinel_activity": 2, "name": "a", "title": TITLE, "world": "maze"}
    checks = [{"check": "ends_in", "zone": "meta"}]
    found = goal_of(Activity.model_validate({**document, "checks": checks}), None)
    assert (found.lines, found.zones) == ([], ["meta"])
