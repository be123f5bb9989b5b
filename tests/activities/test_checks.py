"""Each kind of check, true and false, on real runs; and the shipped activities."""

from pathlib import Path
from typing import Any

import pytest
from pydantic import TypeAdapter

from pinel_desktop.activities import (
    Activity,
    Report,
    activity_names,
    check_program,
    choose_activity,
)
from pinel_desktop.activities.check_kinds import Check
from pinel_desktop.messages import LANGUAGES, SOURCE_LANGUAGE, catalogue, describe
from pinel_desktop.program.reading import read_document
from sim.world import world_document

DOCS = Path(__file__).parents[2] / "docs" / "activities.md"
TITLE = {"pt-BR": "x", "en": "x", "es": "x"}
KINDS = sorted(TypeAdapter(Check).json_schema()["discriminator"]["mapping"])


def activity(*checks: dict[str, Any], **more: Any) -> Activity:
    document = {"pinel_activity": 1, "name": "a", "title": TITLE, "world": "tic_tac_toe"}
    return Activity.model_validate({**document, "checks": list(checks), **more})


def run(wanted: Activity, *commands: dict[str, Any]) -> Report:
    return check_program(wanted, read_document({"pinel_ir": 1, "commands": list(commands)}))


def move(distance: float) -> dict[str, Any]:
    return {"action": "move_forward", "distance": distance}


def turn(angle: float) -> dict[str, Any]:
    return {"action": "turn", "angle": angle}


MARK = {"action": "mark", "symbol": "X"}
HELLO = {"action": "say", "text": "Olá, Turma"}
TO_B: list[dict[str, Any]] = [move(2), MARK, HELLO]  # from left of A through A into B


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
    ],
)
def test_a_check_holds_or_not(
    check: dict[str, Any], commands: list[dict[str, Any]], expected: bool
) -> None:
    report = run(activity(check), *commands)
    assert [one.holds for one in report.cases[0].checks] == [expected]
    assert report.passed == expected


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


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_has_words_and_a_row_in_the_docs(kind: str) -> None:
    assert f"check_{kind}" in catalogue(SOURCE_LANGUAGE)
    assert f"| `{kind}` |" in DOCS.read_text("utf-8")


@pytest.mark.parametrize("name", activity_names())
def test_activities_that_ship_have_words_for_all_they_ask(name: str) -> None:
    wanted = choose_activity(name)
    assert set(wanted.title.model_dump(by_alias=True)) == set(LANGUAGES)
    for check in [*wanted.checks, *(one for case in wanted.cases for one in case.checks)]:
        for language in LANGUAGES:
            params = check.model_dump(exclude={"check"})
            assert "{" not in describe(f"check_{check.check}", params, language).message
