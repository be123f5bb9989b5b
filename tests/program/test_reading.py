import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.messages import LANGUAGES, describe
from pinel_desktop.program.limits import MAX_BYTES, MAX_COMMANDS, MAX_NESTING
from pinel_desktop.program.reading import read_document
from pinel_desktop.program.sensors import SENSORS


def document(*commands: Any) -> dict[str, Any]:
    return {"pinel_ir": 1, "name": "test", "commands": list(commands)}


def faults(source: Any) -> list[tuple[str, str]]:
    reading = read_document(source)
    assert reading.program is None
    assert reading.document is None
    return [(fault.code, fault.pointer) for fault in reading.faults]


def test_document_is_read_into_its_normal_form() -> None:
    square = document(
        {
            "action": "repeat",
            "times": 4.0,
            "block": "r",
            "commands": [{"action": "move_forward", "distance": 1}],
        }
    )
    assert read_document(json.dumps(square)).document == {
        "pinel_ir": 1,
        "name": "test",
        "functions": [],
        "commands": [
            {
                "action": "repeat",
                "times": 4,
                "block": "r",
                "commands": [{"action": "move_forward", "distance": 1.0}],
            }
        ],
    }


def test_reading_the_normal_form_again_changes_nothing() -> None:
    given_document = document(
        {
            "action": "conditional_execution",
            "condition": "result == 'B' or not result == 'A'",
            "commands": [],
            "elif": [{"condition": "1 < 2", "commands": [{"action": "stop"}]}],
            "else": [{"action": "wait", "seconds": 1}],
        },
        {"action": "classify_gestures"},
    )
    normal = read_document(given_document).document
    assert normal is not None
    assert read_document(normal).document == normal


def test_both_spellings_of_the_original_are_read() -> None:
    reading = read_document(
        [
            {"action": "classificar_gestos", "status": "pending"},
            {"action": "set_gesture_result", "resultado": "B"},
            {"action": "conditional_execution", "condition": "resultado == 'B'", "commands": []},
        ]
    )
    assert reading.document is not None
    actions = [command["action"] for command in reading.document["commands"]]
    assert actions == ["classify_gestures", "set_gesture_result", "conditional_execution"]
    assert reading.document["commands"][1]["result"] == "B"
    assert [(w.code, w.pointer) for w in reading.warnings] == [("unknown_key", "/0/status")]


def test_unknown_keys_are_faults_in_a_document() -> None:
    assert faults(document({"action": "stop", "status": 1})) == [
        ("unknown_key", "/commands/0/status")
    ]


def test_all_faults_are_reported_with_their_places_and_blocks() -> None:
    reading = read_document(
        document(
            {"action": "move_forward", "distance": -1, "block": "a"},
            {"action": "fly", "block": "b"},
            {"action": "repeat", "times": 2, "block": "c", "commands": [{"action": "turn"}]},
            {"block": "d"},
        )
    )
    assert [(f.code, f.pointer, f.block) for f in reading.faults] == [
        ("distance_out_of_range", "/commands/0/distance", "a"),
        ("unknown_action", "/commands/1", "b"),
        ("missing_parameter", "/commands/2/commands/0", "c"),
        ("missing_action", "/commands/3", "d"),
    ]
    assert reading.faults[0].params == {"value": -1, "min": 0, "max": 100.0}


@pytest.mark.parametrize(
    ("command", "code", "place"),
    [
        ({"action": "move_forward", "distance": 100.1}, "distance_out_of_range", "/distance"),
        ({"action": "move_backward", "distance": -0.1}, "distance_out_of_range", "/distance"),
        ({"action": "turn", "angle": 3601}, "angle_out_of_range", "/angle"),
        ({"action": "turn", "angle": True}, "wrong_type_number", "/angle"),
        ({"action": "turn", "angle": "90"}, "wrong_type_number", "/angle"),
        ({"action": "turn", "angle": None}, "wrong_type_number", "/angle"),
        ({"action": "turn", "angle": float("nan")}, "not_finite", "/angle"),
        ({"action": "turn", "angle": {"what": "a"}}, "unknown_expression", "/angle"),
        ({"action": "turn", "angle": [90]}, "wrong_type_number", "/angle"),
        ({"action": "wait", "seconds": 601}, "seconds_out_of_range", "/seconds"),
        ({"action": "classify_gestures", "timeout": 0}, "timeout_out_of_range", "/timeout"),
        ({"action": "repeat", "times": 2.5, "commands": []}, "wrong_type_whole_number", "/times"),
        ({"action": "repeat", "times": 100_001, "commands": []}, "times_out_of_range", "/times"),
        ({"action": "repeat", "times": 1, "commands": {}}, "wrong_type_list", "/commands"),
        ({"action": "set_gesture_result", "result": 5}, "wrong_type_text", "/result"),
        ({"action": "set_gesture_result", "result": "x" * 10_001}, "text_too_long", "/result"),
        ({"action": "set_gesture_result", "result": "\ud800"}, "text_not_unicode", "/result"),
        ({"action": "stop", "block": 7}, "wrong_type_text", "/block"),
        ({"action": "conditional_execution", "commands": []}, "missing_condition", ""),
        ("stop", "wrong_type_object", ""),
    ],
)
def test_each_wrong_parameter_is_one_fault_at_its_place(
    command: Any, code: str, place: str
) -> None:
    assert faults(document(command)) == [(code, f"/commands/0{place}")]


@pytest.mark.parametrize(
    ("condition", "code", "place"),
    [
        ("__import__('os').system('x')", "condition_syntax", ""),
        ("result", "condition_not_boolean", ""),
        (5, "condition_not_boolean", ""),
        (None, "unknown_expression", ""),
        ({"variable": "x"}, "unknown_expression", ""),
        ({"op": "xor", "args": [True, False]}, "unknown_operator", ""),
        ({"op": "not", "args": []}, "wrong_argument_count", ""),
        ({"op": "and", "args": [True, "B"]}, "not_boolean", ""),
        ({"op": "<", "args": [1, "B"]}, "not_comparable", ""),
        ({"op": "not", "args": [{"op": "or", "args": [True]}]}, "too_few_arguments", "/args/0"),
        ({"op": "==", "args": [{"gesture": "colour"}, "B"]}, "wrong_value", "/args/0/gesture"),
    ],
)
def test_each_wrong_condition_is_a_fault(condition: Any, code: str, place: str) -> None:
    command = {"action": "conditional_execution", "condition": condition, "commands": []}
    assert faults(document(command)) == [(code, f"/commands/0/condition{place}")]


def nested(depth: int) -> dict[str, Any]:
    command: dict[str, Any] = {"action": "stop", "block": "innermost"}
    for _ in range(depth - 1):
        command = {"action": "repeat", "times": 1, "commands": [command]}
    return document(command)


def test_nesting_is_allowed_up_to_its_limit() -> None:
    assert read_document(nested(MAX_NESTING)).program is not None
    assert [code for code, _ in faults(nested(MAX_NESTING + 1))] == ["nesting_too_deep"]


def test_too_many_commands_are_a_fault() -> None:
    assert read_document(document(*[{"action": "stop"}] * MAX_COMMANDS)).program is not None
    assert faults(document(*[{"action": "stop"}] * (MAX_COMMANDS + 1))) == [
        ("too_many_commands", "")
    ]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "json_syntax"),
        ("{", "json_syntax"),
        (b"\xff\xfe", "json_syntax"),
        ("1" * 5000, "json_syntax"),
        ("[" * 100_000, "nesting_too_deep"),
        ("[" * 200 + "]" * 200, "nesting_too_deep"),
        ("[" + " " * MAX_BYTES + "]", "document_too_large"),
        ("3", "not_a_program"),
        ('"x"', "not_a_program"),
        ("null", "not_a_program"),
    ],
)
def test_text_that_is_no_program_is_a_fault(text: str | bytes, code: str) -> None:
    assert faults(text) == [(code, faults(text)[0][1])]


def test_other_versions_are_faults() -> None:
    assert faults({"pinel_ir": 2, "commands": []}) == [("wrong_value", "/pinel_ir")]
    assert faults({"pinel_ir": True, "commands": []}) == [("wrong_value", "/pinel_ir")]


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(
                [
                    "action",
                    "commands",
                    "condition",
                    "times",
                    "op",
                    "args",
                    "else",
                    "elif",
                    "block",
                    "x/~y",
                    "distance",
                    "value",
                    "name",
                    "variable",
                    "var",
                    "call",
                    "function",
                    "arguments",
                    "sensor",
                    "index",
                    "functions",
                    "parameters",
                ]
            ),
            inner
            | st.sampled_from(
                [
                    "repeat",
                    "turn",
                    "stop",
                    "conditional_execution",
                    "and",
                    "result == 'A'",
                    "set_variable",
                    "for",
                    "call",
                    "return",
                    "break",
                    "sonar",
                    "+",
                ]
            ),
            max_size=5,
        )
    ),
    max_leaves=30,
)


@given(json_values)
def test_no_document_raises_and_every_pointer_leads_somewhere(value: Any) -> None:
    functions = {"pinel_ir": 1, "functions": value, "commands": [value]}
    for source in (value, {"pinel_ir": 1, "commands": value}, [value], functions):
        reading = read_document(source)
        assert (reading.program is None) == bool(reading.faults)
        for fault in reading.faults:
            resolve(source, fault.pointer)


def resolve(value: Any, pointer: str) -> Any:
    for part in pointer.split("/")[1:]:
        key = part.replace("~1", "/").replace("~0", "~")
        value = value[int(key)] if isinstance(value, list) else value[key]
    return value


def test_faults_can_always_be_written_whatever_the_file_holds() -> None:
    huge = 10**4000
    reading = read_document(
        {
            "pinel_ir": 1,
            "name": "\ud800",
            "functions": [{"name": "\ud800", "parameters": [], "commands": []}],
            "commands": [
                {"action": "call", "function": "dance"},
                {"action": "repeat", "times": huge, "commands": [], "block": "\ud800"},
                {"action": "move_forward", "distance": huge},
                {"action": "\ud800" * 5000},
            ],
        }
    )
    codes = [fault.code for fault in reading.faults]
    assert {
        "text_not_unicode",
        "times_out_of_range",
        "unknown_action",
        "unknown_function",
    } <= set(codes)
    for fault in reading.faults:
        written = json.dumps([fault.pointer, fault.block, fault.params], ensure_ascii=False)
        assert len(written.encode("utf-8")) < 1000


def test_key_that_is_no_text_is_a_fault() -> None:
    assert faults({"pinel_ir": 1, "\udfff": 1, "commands": []})[0][0] in (
        "text_not_unicode",
        "unknown_key",
    )


def test_parsed_data_has_the_same_limit_of_size_as_text() -> None:
    big = document(*[{"action": "stop", "comment": "x" * 9000}] * 200)
    assert [code for code, _ in faults(big)] == ["document_too_large"]
    assert [code for code, _ in faults(json.dumps(big))] == ["document_too_large"]


def until(condition: Any) -> dict[str, Any]:
    return {"action": "until", "block": "u", "condition": condition, "commands": []}


FLOOR = {"sensor": "floor"}


@pytest.mark.parametrize("operator", ["==", "!="])
@pytest.mark.parametrize("text", ["vermelho", "Red", ""])
def test_a_colour_that_the_floor_never_has_is_a_warning_at_its_block(
    operator: str, text: str
) -> None:
    never = {"op": operator, "args": [FLOOR, text]}
    either = {"op": "or", "args": [{"sensor": "bumper"}, never]}
    reading = read_document(json.dumps(document(until(either))))
    assert reading.program is not None  # it ran before, and still does
    [warning] = reading.warnings
    assert (warning.code, warning.block, warning.params) == ("never_floor", "u", {"value": text})
    assert warning.pointer == "/commands/0/condition/args/1/args/1"


def test_a_warning_in_a_bare_list_has_its_place_there_beside_ignored_keys() -> None:
    never = {"op": "==", "args": ["azul", FLOOR]}
    reading = read_document([{**until(never), "status": "done"}])
    assert [(one.code, one.pointer) for one in reading.warnings] == [
        ("unknown_key", "/0/status"),
        ("never_floor", "/0/condition/args/0"),
    ]


@pytest.mark.parametrize(
    "condition",
    [
        {"op": "==", "args": [FLOOR, "red"]},
        {"op": "==", "args": [FLOOR, {"var": "colour"}]},
        {"op": "==", "args": [{"gesture": "result"}, "vermelho"]},
        {"op": "==", "args": [{"sensor": "cell"}, "vermelho"]},
        {"op": "<", "args": [FLOOR, "vermelho"]},
    ],
)
def test_what_may_be_equal_is_no_warning(condition: Any) -> None:
    assert read_document(document(until(condition))).warnings == ()


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_remedy_names_all_colours_of_the_floor(language: str) -> None:
    remedy = describe("never_floor", {"value": "x"}, language).remedy
    assert all(colour in remedy for colour in SENSORS["floor"].texts)
