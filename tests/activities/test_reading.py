"""Reading activities: both formats, every fault with its place, and those that ship."""

import json
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.activities import (
    PATHS,
    ActivityError,
    activity_names,
    check_program,
    choose_activity,
    solution_of,
)
from pinel_desktop.activities.faults import require_fulfillable
from pinel_desktop.activities.reading import read_activity
from pinel_desktop.activities.wording import blocks_named
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import LANGUAGES, SOURCE_LANGUAGE, catalogue, describe
from pinel_desktop.program.reading import read_document

TITLE = {"pt-BR": "x", "en": "x", "es": "x"}
TURN_HINT = {"pt-BR": "Falta “girar à direita”.", "en": "x", "es": "x"}
FORWARD = {"pinel_ir": 1, "commands": [{"action": "move_forward", "distance": 1}]}


def faults_of(tmp_path: Path, **change: Any) -> list[tuple[str, str]]:
    file = tmp_path / "a.json"
    checks = [{"check": "finished"}]
    document = {"pinel_activity": 1, "name": "a", "title": TITLE, "world": "pushing"}
    file.write_text(json.dumps({**document, "checks": checks, **change}), "utf-8")
    with pytest.raises(ActivityError, match="activity_invalid") as raised:
        choose_activity(str(file))
    faults = raised.value.faults
    for fault in faults:
        for language in LANGUAGES:
            description = describe(fault.code, fault.params, language)
            assert fault.code in catalogue(SOURCE_LANGUAGE)
            assert "{" not in description.message + description.remedy
    return [(fault.code, fault.pointer) for fault in faults]


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"pinel_activity": 3, "later": 1}, "activity_newer", "/pinel_activity"),
        ({"story": TITLE}, "activity_unknown_key", "/story"),
        (
            {"cases": [{"start": {"x_m": 0, "y_m": 0}}]},
            "activity_unknown_key",
            "/cases/0/start",
        ),
        ({"checks": [{"check": "dances"}]}, "unknown_check", "/checks/0"),
        ({"checks": [{}]}, "missing_parameter", "/checks/0"),
        ({"checks": [5]}, "wrong_type_object", "/checks/0"),
        ({"checks": [{"check": "ends_at", "x_m": 1}]}, "missing_parameter", "/checks/0"),
        ({"checks": [{"check": "ends_in", "zone": 5}]}, "wrong_type_text", "/checks/0/zone"),
        ({"limit_s": -1}, "activity_value_too_small", "/limit_s"),
        ({"limit_s": "5"}, "wrong_type_number", "/limit_s"),
        ({"limit_s": 1e9}, "activity_value_too_large", "/limit_s"),
        ({"extra": 1}, "activity_unknown_key", "/extra"),
        ({"pinel_activity": True}, "activity_value_wrong", "/pinel_activity"),
        ({"pinel_activity": 10**400}, "activity_value_wrong", "/pinel_activity"),
        ({"world": 5}, "wrong_type_text", "/world"),
        ({"world": "mars"}, "unknown_world", "/world"),
        ({"world": {"pinel_world": 1}}, "missing_parameter", "/world"),
        ({"model": "r2d2"}, "unknown_robot", "/model"),
        ({"cases": []}, "activity_value_wrong", "/cases"),
        ({"cases": [{"seed": True}]}, "wrong_type_whole_number", "/cases/0/seed"),
        ({"checks": []}, "activity_without_checks", "/cases/0"),
        (
            {"checks": [{"check": "ends_in", "zone": "Z"}]},
            "activity_unknown_zone",
            "/checks/0/zone",
        ),
        (
            {"checks": [{"check": "visits", "zones": ["A", "Z"]}]},
            "activity_unknown_zone",
            "/checks/0/zones/1",
        ),
        (
            {"cases": [{"checks": [{"check": "marks", "symbol": "X", "zone": "Z"}]}]},
            "activity_unknown_zone",
            "/cases/0/checks/0/zone",
        ),
        (
            {"checks": [{"check": "pushed", "box": 99, "zone": "A"}]},
            "activity_unknown_box",
            "/checks/0/box",
        ),
        ({"checks": [{"check": "uses", "action": "fly"}]}, "unknown_action", "/checks/0/action"),
        (
            {"checks": [{"check": "uses", "action": "turn", "at_least": 3, "at_most": 2}]},
            "activity_limits_crossed",
            "/checks/0/at_least",
        ),
        (
            {"checks": [{"check": "path_length", "at_least_m": 3, "at_most_m": 2}]},
            "activity_limits_crossed",
            "/checks/0/at_least_m",
        ),
    ],
)
def test_a_file_with_an_error_says_where(
    change: dict[str, Any], code: str, pointer: str, tmp_path: Path
) -> None:
    assert (code, pointer) in faults_of(tmp_path, **change)


def test_all_errors_of_a_file_are_told() -> None:
    activity, faults = read_activity(json.dumps({"name": "a", "limit_s": 0, "x": 1}))
    assert activity is None
    places = [(fault.params["name"], fault.pointer) for fault in faults]
    assert places == [
        ("pinel_activity", ""),
        ("title", ""),
        ("world", ""),
        ("limit_s", "/limit_s"),
        ("x", "/x"),
    ]


@pytest.mark.parametrize("text", ["{", b"\xff", "[" * 100_000, "1" * 9_999])
def test_what_is_no_json_is_one_fault(text: str | bytes) -> None:
    assert [fault.code for fault in read_activity(text)[1]] == ["activity_syntax"]


@pytest.mark.parametrize("text", ["[]", "5", "null"])
def test_what_is_no_object_is_one_fault(text: str) -> None:
    assert [fault.code for fault in read_activity(text)[1]] == ["wrong_type_object"]


def test_an_activity_that_is_not_there_is_refused_with_those_there_are() -> None:
    with pytest.raises(PinelError, match="unknown_activity") as raised:
        choose_activity("dance")
    assert "square" in str(raised.value.params["allowed"])
    with pytest.raises(PinelError, match="file_unreadable"):
        choose_activity("/nowhere/a.json")


IN_FORMAT_2: dict[str, Any] = {
    "pinel_activity": 2,
    "path": "moves",
    "number": "1.1",
    "minutes": 5,
    "level": 1,
    "blocks": ["move_forward", "turn"],
    "story": TITLE,
    "criteria": TITLE,
    "hints": [TITLE, TITLE, TITLE],
    "question": TITLE,
    "cases": [{}, {"start": {"x_m": -1, "y_m": 0, "heading_deg": 90}}],
    "diagnoses": [
        {"when": {"path_m": [0, 1], "n_turn": 0}, "block": "last turn", "say": TITLE},
        {"when": {"reason": "blocked"}, "block": "touching", "general": "hit"},
    ],
    "solution": FORWARD,
}


def test_an_activity_of_format_2_has_all_that_a_group_reads() -> None:
    document = {"name": "a", "title": TITLE, "world": "empty_room", **IN_FORMAT_2}
    text = json.dumps({**document, "checks": [{"check": "finished"}]})
    activity, faults = read_activity(text)
    assert activity is not None
    assert faults == ()
    assert activity.hints[2].of("es") == "x"
    assert check_program(activity, read_document(FORWARD)).passed


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"path": "dreams"}, "activity_value_wrong", "/path"),
        ({"number": "first"}, "activity_value_wrong", "/number"),
        ({"minutes": 0}, "activity_value_too_small", "/minutes"),
        ({"level": 4}, "activity_value_wrong", "/level"),
        ({"blocks": ["fly"]}, "unknown_action", "/blocks/0"),
        ({"blocks": ["move_forward"], "hints": [TURN_HINT]}, "activity_hint_block", "/hints/0"),
        ({"story": {"en": "x", "es": "x"}}, "missing_parameter", "/story"),
        ({"story": TITLE | {"en": "x" * 1001}}, "text_too_long", "/story/en"),
        ({"hints": [TITLE] * 4}, "activity_value_wrong", "/hints"),
        ({"cases": [{"start": {"x_m": 0}}]}, "missing_parameter", "/cases/0/start"),
        (
            {"cases": [{"start": {"x_m": 9, "y_m": 0}}]},
            "start_off_floor",
            "/cases/0/start",
        ),
        (
            {"diagnoses": [{"when": {"mood": 1}, "say": TITLE}]},
            "activity_unknown_fact",
            "/diagnoses/0/when/mood",
        ),
        (
            {"diagnoses": [{"when": {"x_fly": 1}, "say": TITLE}]},
            "activity_unknown_fact",
            "/diagnoses/0/when/x_fly",
        ),
        (
            {"diagnoses": [{"when": {"path_m": "far"}, "say": TITLE}]},
            "wrong_type_number",
            "/diagnoses/0/when/path_m",
        ),
        (
            {"diagnoses": [{"when": {"path_m": [1]}, "say": TITLE}]},
            "activity_value_wrong",
            "/diagnoses/0/when/path_m",
        ),
        (
            {"diagnoses": [{"when": {"path_m": 1}, "block": "the red one", "say": TITLE}]},
            "activity_value_wrong",
            "/diagnoses/0/block",
        ),
        ({"diagnoses": [{"when": {"path_m": 1}}]}, "activity_diagnosis_words", "/diagnoses/0"),
        (
            {"solution": {"pinel_ir": 1, "commands": [{"action": "fly"}]}},
            "unknown_action",
            "/solution/commands/0",
        ),
    ],
)
def test_a_file_of_format_2_with_an_error_says_where(
    change: dict[str, Any], code: str, pointer: str, tmp_path: Path
) -> None:
    assert (code, pointer) in faults_of(tmp_path, **{**IN_FORMAT_2, **change})


def test_activities_that_ship_stand_along_the_paths() -> None:
    places = [(one.path, one.number) for one in map(choose_activity, activity_names())]
    assert places == sorted(
        places, key=lambda p: (PATHS.index(p[0]) if p[0] else len(PATHS), p[1] or "")
    )


def test_a_solution_is_read_from_its_python_text() -> None:
    document = solution_of("square")
    assert document is not None
    assert document["commands"][0]["action"] == "repeat"
    assert solution_of("nothing_of_the_kind") is None
    assert solution_of("../catalogue/square") is None


@pytest.mark.parametrize(
    ("pt", "named"),
    [
        ("Um giro de ? graus: girar à esquerda", {"turn": "girar"}),
        (
            "Usem “repetir até que” e “se”.",
            {"until": "repetir até que", "conditional_execution": "se"},
        ),
        ("Repetir 4: levantar a caneta, ir até x 2, y ?", {"repeat", "pen", "go_to"}),
        ("Onde parar? Se ele não parar, contem os passos e marquem.", {}),
        ("“Ir até o lugar” vai ao meio da casa.", {"go_to_place": "ir até o lugar"}),
    ],
)
def test_blocks_that_a_hint_names_are_found(pt: str, named: Any) -> None:
    found = blocks_named({"pt-BR": pt, "en": "x", "es": "x"})
    assert (set(found) if isinstance(named, set) else found) == named


def test_a_hint_names_a_block_in_quotation_marks_in_any_language() -> None:
    assert blocks_named({"pt-BR": "x", "en": "Try “turn left 90 °”.", "es": "x"}) == {
        "turn": "turn"
    }
    assert blocks_named({"pt-BR": "x", "en": "Whose turn is it?", "es": "x"}) == {}


def test_no_hint_that_ships_names_a_block_which_is_not_offered() -> None:
    offering = [one for one in map(choose_activity, activity_names()) if one.blocks]
    assert [one.name for one in offering] == [
        "to_the_bakery",
        "bread_and_back",
        "around_the_corner",
        "left_right",
    ]
    for one in offering:
        require_fulfillable(one)
