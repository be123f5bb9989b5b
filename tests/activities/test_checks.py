"""Each kind of check, true and false, on real runs: what it measures, what it says, which block it points at."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.activities import (
    Activity,
    Report,
    check_program,
    goal_of,
)
from pinel_desktop.activities.checks import KINDS
from pinel_desktop.activities.faults import semantic_faults
from pinel_desktop.messages import LANGUAGES, SOURCE_LANGUAGE, catalogue
from pinel_desktop.program.reading import read_document
from sim.world import world_document

DOCS = Path(__file__).parents[2] / "docs" / "activities.md"
TITLE = {"pt-BR": "x", "en": "x", "es": "x"}


def activity(*checks: dict[str, Any], **more: Any) -> Activity:
    document = {"pinel_activity": 1, "name": "a", "title": TITLE, "world": "tic_tac_toe"}
    return Activity.model_validate({**document, "checks": list(checks), **more})


def run(mission: Activity, *commands: dict[str, Any]) -> Report:
    return check_program(mission, read_document({"pinel_ir": 1, "commands": list(commands)}))


def move(distance: float) -> dict[str, Any]:
    return {"action": "move_forward", "distance": distance}


def turn(angle: float) -> dict[str, Any]:
    return {"action": "turn", "angle": angle}


def twice(command: dict[str, Any]) -> dict[str, Any]:
    return {"action": "repeat", "times": 2, "commands": [command]}


SQUARE = {"action": "repeat", "times": 4, "commands": [move(1), turn(-90)]}
PEN = {"action": "pen", "down": True}
ARC = {"action": "arc", "radius": 0.8, "angle": 360}
CORNER = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]]
L = [PEN, move(2), turn(90), move(1)]
IN_B = {"check": "ends_in", "zone": "B"}
BACK = {"action": "move_backward", "distance": 0.3}
MARK = {"action": "mark", "symbol": "X"}
HELLO = {"action": "say", "text": "Olá, Turma"}
TO_B: list[dict[str, Any]] = [move(2), MARK, HELLO]  # from left of A through A into B


# parameters of a kind that has some
ONE_OF_EACH: Mapping[str, Mapping[str, Any]] = {
    "ends_at": {"x_m": 1.0, "y_m": -2.0},
    "ends_heading": {"heading_deg": -90.0},
    "ends_in": {"zone": "A"},
    "visits": {"zones": ["A", "E"]},
    "avoids": {"zone": "A"},
    "pushed": {"box": 0, "zone": "A"},
    "uses": {"action": "repeat", "at_least": 2, "at_most": 3},
    "marks": {"symbol": "X", "zone": "A"},
    "says": {"text": "oi"},
    "path_length": {"at_least_m": 1.0, "at_most_m": 3.0},
    "draws": {"template": [[[0.0, 0.0], [1.0, 0.0]]]},
    "symmetric": {"axes": 2},
    "turned_total": {"at_least_deg": 90.0, "net_deg": 90.0},
    "block_count": {"at_most": 3},
    "nesting": {"at_least": 2},
    "executed": {"action": "turn", "n": 0},
    "mark_count": {"n": 1},
    "time": {"at_most_s": 20.0},
    "any_of": {"checks": [{"check": "closed"}, {"check": "finished"}]},
}
# what kinds need that only the simulator tells
SIMULATOR_ONLY = {
    "ends_in": "zones",
    "visits": "zones",
    "avoids": "zones",
    "marks": "zones",
    "pushed": "boxes",
    "touches_nothing": "contact",
    "time": "pace",
}


@pytest.mark.parametrize(
    ("check", "commands", "expected"),
    [
        ({"check": "finished"}, TO_B, True),
        ({"check": "finished"}, [move(50)], False),
        ({"check": "ends_at", "x_m": 2.0, "y_m": 0.0, "within_m": 0.01}, TO_B, True),
        ({"check": "ends_at", "x_m": 2.1, "y_m": 0.0, "within_m": 0.01}, TO_B, False),
        ({"check": "ends_heading", "heading_deg": -90.0}, [turn(270)], True),
        ({"check": "ends_heading", "heading_deg": 90.0}, [turn(270)], False),
        ({"check": "ends_in", "zone": "B"}, TO_B, True),
        ({"check": "ends_in", "zone": "A"}, TO_B, False),
        ({"check": "visits", "zones": ["A", "B"]}, TO_B, True),
        ({"check": "visits", "zones": ["B", "A"]}, TO_B, False),
        ({"check": "visits", "zones": ["B", "A"], "ordered": False}, TO_B, True),
        ({"check": "visits", "zones": ["A", "C"], "ordered": False}, TO_B, False),
        ({"check": "avoids", "zone": "C"}, TO_B, True),
        ({"check": "avoids", "zone": "A"}, TO_B, False),
        ({"check": "touches_nothing"}, TO_B, True),
        ({"check": "touches_nothing"}, [turn(180), move(9)], False),
        ({"check": "uses", "action": "say"}, TO_B, True),
        (
            {"check": "uses", "action": "say", "at_least": 2},
            [{"action": "repeat", "times": 2, "commands": [HELLO]}],
            False,
        ),
        ({"check": "uses", "action": "say", "at_least": 0, "at_most": 0}, TO_B, False),
        ({"check": "marks", "symbol": "X", "zone": "B"}, TO_B, True),
        ({"check": "marks", "symbol": "O", "zone": "B"}, TO_B, False),
        ({"check": "marks", "symbol": "X", "zone": "A"}, TO_B, False),
        ({"check": "says", "text": "TURMA"}, TO_B, True),
        ({"check": "says", "text": "tchau"}, TO_B, False),
        ({"check": "path_length", "at_least_m": 1.99, "at_most_m": 2.01}, TO_B, True),
        ({"check": "path_length", "at_least_m": 2.01}, TO_B, False),
        ({"check": "path_length", "at_most_m": 0.02}, TO_B, False),
        ({"check": "draws", "template": [CORNER]}, L, True),
        ({"check": "draws", "template": [CORNER], "of": "path"}, L, True),
        (
            {"check": "draws", "template": [CORNER], "scale": False},
            [PEN, move(1), turn(90), move(0.5)],
            False,
        ),
        (
            {"check": "draws", "template": [CORNER], "scale": True},
            [PEN, move(1), turn(90), move(0.5)],
            True,
        ),
        ({"check": "draws", "template": [CORNER]}, [PEN, move(2), turn(-90), move(1)], False),
        (
            {"check": "draws", "template": [CORNER], "mirror": True},
            [PEN, move(2), turn(-90), move(1)],
            True,
        ),
        ({"check": "draws", "template": [CORNER], "rotate": False}, [turn(45), *L], False),
        ({"check": "draws", "template": [CORNER], "move": False, "scale": False}, L, True),
        (
            {"check": "draws", "template": [CORNER], "move": False, "scale": False},
            [move(0.5), *L],
            False,
        ),
        ({"check": "draws", "template": [CORNER]}, [move(2), turn(90), move(1)], False),
        ({"check": "draws", "template": [CORNER]}, [], False),
        ({"check": "closed"}, [PEN, ARC], True),
        ({"check": "closed"}, L, False),
        ({"check": "closed"}, [move(1)], False),
        ({"check": "symmetric", "axes": 9}, [PEN, ARC], True),
        ({"check": "symmetric", "axes": 2}, [PEN, move(1)], True),
        ({"check": "symmetric", "axes": 1}, L, False),
        (
            {"check": "turned_total", "at_least_deg": 269, "at_most_deg": 271},
            [turn(180), turn(-90)],
            True,
        ),
        ({"check": "turned_total", "at_least_deg": 271}, [turn(180), turn(-90)], False),
        ({"check": "turned_total", "at_most_deg": 269}, [turn(180), turn(-90)], False),
        ({"check": "turned_total", "net_deg": 90}, [turn(180), turn(-90)], True),
        ({"check": "turned_total", "net_deg": 270}, [turn(180), turn(-90)], False),
        ({"check": "block_count", "at_most": 3}, TO_B, True),
        ({"check": "block_count", "at_most": 2}, TO_B, False),
        ({"check": "nesting", "at_least": 2}, [twice(twice(HELLO))], True),
        ({"check": "nesting", "at_least": 2}, [twice(HELLO), twice(HELLO)], False),
        ({"check": "executed", "action": "say", "n": 4}, [twice(twice(HELLO))], True),
        ({"check": "executed", "action": "say", "n": 1}, [twice(twice(HELLO))], False),
        ({"check": "executed", "action": "move_forward", "n": 2}, [twice(move(0.1))], True),
        ({"check": "mark_count", "n": 1}, TO_B, True),
        ({"check": "mark_count", "n": 0}, TO_B, False),
        ({"check": "time", "at_most_s": 5}, TO_B, True),
        ({"check": "time", "at_most_s": 3}, TO_B, False),
        ({"check": "any_of", "checks": [{"check": "ends_in", "zone": "A"}, IN_B]}, TO_B, True),
        ({"check": "any_of", "checks": [{"check": "ends_in", "zone": "A"}]}, TO_B, False),
    ],
)
def test_a_check_holds_or_not(
    check: dict[str, Any], commands: list[dict[str, Any]], expected: bool
) -> None:
    report = run(activity(check), *commands)
    (found,) = report.cases[0].checks
    assert found.holds == report.passed == expected
    assert set(found.words) == (set() if expected else set(LANGUAGES))
    assert not any("{" in text for text in found.words.values())


def test_a_box_is_pushed_into_a_zone() -> None:
    world = world_document("pushing")
    pushed = activity({"check": "pushed", "box": 0, "zone": "A"}, world=world)
    assert not run(pushed, turn(90)).passed
    box, start = world["boxes"][0]["center"][0], world["start"]["x_m"]
    goal = world["zones"][0]["center"][0]
    # the hull pushes half a box ahead of it
    distance = goal - start - 0.2225 - world["boxes"][0]["size"][0] / 2
    assert box < goal
    assert run(pushed, move(distance)).passed
    there_is_no_such = activity({"check": "pushed", "box": 99, "zone": "A"}, world=world)
    assert not run(there_is_no_such, move(1)).passed


def test_a_zone_that_was_to_be_avoided_is_reported_with_the_block_that_drove_into_it() -> None:
    commands = [turn(0.5), {**move(1), "block": "in"}, {**move(1), "block": "out"}]
    mission = activity({"check": "avoids", "zone": "A"})
    (found,) = run(mission, *commands).cases[0].checks
    assert (found.holds, found.block, found.measured) == (False, "in", "A, B")
    assert found.words["pt-BR"].startswith("O robô passou por “A”, onde não devia.")
    assert goal_of(mission, None).zones == []  # it is no place to get to
    (fault,) = semantic_faults(activity({"check": "avoids", "zone": "?"}))
    assert (fault.code, fault.pointer) == ("activity_unknown_zone", "/checks/0/zone")


@pytest.mark.parametrize(
    ("commands", "block"),
    [
        pytest.param(
            [{**move(0.3), "block": "short"}, {**BACK, "block": "back"}], "short", id="short"
        ),
        pytest.param(
            [{**move(2), "block": "past"}, {**move(0.1), "block": "on"}], "past", id="passed by"
        ),
        pytest.param(
            [{**turn(180), "block": "turned"}, {**move(1), "block": "away"}], "away", id="away"
        ),
    ],
)
def test_a_zone_that_was_missed_is_reported_with_the_block_that_came_nearest(
    commands: list[dict[str, Any]], block: str
) -> None:
    zones = ["B"] if block != "past" else ["I"]
    (found,) = run(activity({"check": "visits", "zones": zones}), *commands).cases[0].checks
    assert (found.holds, found.block) == (False, block)


def test_each_case_has_its_own_gestures_and_checks() -> None:
    cases = [
        {"gestures": ["B"], "checks": [{"check": "says", "text": "B!"}]},
        {"gestures": ["A"], "checks": [{"check": "says", "text": "A!"}]},
    ]
    letter = {"op": "join", "args": [{"gesture": "result"}, "!"]}
    program: list[dict[str, Any]] = [
        {"action": "classify_gestures"},
        {"action": "say", "text": letter},
    ]
    assert run(activity(cases=cases), *program).passed
    report = run(activity(cases=cases), {"action": "classify_gestures"}, {**HELLO, "text": "B!"})
    assert [case.checks[0].holds for case in report.cases] == [True, False]


def test_a_sign_is_shown_where_a_program_reads_it() -> None:
    mission = activity({"check": "sign_shown"}, cases=[{"gestures": ["B"]}, {"gestures": [""]}])
    read: dict[str, Any] = {"action": "classify_gestures", "block": "read"}
    assert run(mission, read).passed
    assert not run(mission, move(1)).passed


def test_a_program_that_never_ends_is_stopped_and_does_not_pass() -> None:
    forever = {"action": "forever", "commands": [{"action": "wait", "seconds": 1}]}
    report = run(activity({"check": "finished"}, limit_s=5.0), forever)
    assert (report.cases[0].state, report.cases[0].reason) == ("failed", "too_long")
    assert report.cases[0].duration_s < 6.0
    assert not report.passed


def test_a_program_with_faults_is_not_run() -> None:
    report = run(activity({"check": "finished"}), {"action": "fly"})
    assert [fault.code for fault in report.faults] == ["unknown_action"]
    assert (report.cases, report.passed) == ((), False)


def test_without_any_check_nothing_is_passed() -> None:
    assert not run(activity(), move(1)).passed


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_every_kind_has_words_and_a_row_in_the_docs(kind: str) -> None:
    assert f"check_{kind}" in catalogue(SOURCE_LANGUAGE)
    assert f"| `{kind}` |" in DOCS.read_text("utf-8")


def test_a_check_tells_what_it_measured_and_which_block_to_look_at() -> None:
    home = {"check": "ends_at", "x_m": 0.0, "y_m": 0.0, "within_m": 0.05}
    turned = [move(1), {**turn(180), "block": "t"}, {**move(0.88), "block": "m"}]
    (found,) = run(activity(home), *turned).cases[0].checks
    assert (round(float(found.measured or 0), 2), found.target, found.block) == (0.12, 0.0, "m")
    assert found.words["pt-BR"] == (
        "O caminho termina a 12 cm da partida. Olhem “andar para frente 0,88 m”."
    )
    assert found.words["en"].startswith("The path ends 12 cm from the start.")


def test_a_missing_block_is_named_as_on_the_screen() -> None:
    (found,) = run(activity({"check": "uses", "action": "classify_gestures"})).cases[0].checks
    assert found.words["pt-BR"] == "Usem o bloco “ler sinal”."


def test_jitter_of_the_measured_pose_is_no_way() -> None:
    """A square of 1 m: 4 m, with the realistic robot too."""
    square = [{"action": "repeat", "times": 4, "commands": [move(1), turn(90)]}]
    check = {"check": "path_length", "at_least_m": 3.97, "at_most_m": 4.03}
    assert run(activity(check, world="empty_room"), *square).passed
    assert run(activity(check, world="empty_room", preset="realistic"), *square).passed


def test_a_program_that_reads_on_after_the_last_gesture_fails_with_that_reason() -> None:
    read: dict[str, Any] = {"action": "classify_gestures"}
    is_b = {"op": "==", "args": [{"gesture": "result"}, "B"]}
    until: dict[str, Any] = {"action": "until", "condition": is_b, "commands": [read]}
    mission = activity({"check": "finished"}, cases=[{"gestures": ["A", ""]}])
    (case,) = run(mission, until).cases
    assert (case.state, case.reason) == ("failed", "no_more_gestures")
    assert case.duration_s < 1.0
    assert run(mission, read, read).passed


@pytest.mark.parametrize(("preset", "passed"), [("ideal", True), ("realistic", False)])
def test_a_robot_is_judged_by_where_it_truly_stands(preset: str, passed: bool) -> None:
    back = {"check": "ends_at", "x_m": 0.0, "y_m": 0.0, "within_m": 0.02}
    on_wheels = {"world": "empty_room", "preset": preset, "feedback": "odometry"}
    assert run(activity(back, **on_wheels), SQUARE).passed is passed
