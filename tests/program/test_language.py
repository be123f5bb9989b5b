"""The whole language: valid programs, and each fault of the semantic checks."""

import json
from typing import Any

import pytest

from pinel_desktop.program.limits import MAX_LIST, MAX_NAME, MAX_NESTING, MAX_TEXT, MAX_VARIABLES
from pinel_desktop.program.operators import OPERATORS
from pinel_desktop.program.reading import read_document

Json = dict[str, Any]
AREA: Json = {
    "name": "area",
    "parameters": ["width", "height"],
    "commands": [
        {"action": "return", "value": {"op": "*", "args": [{"var": "width"}, {"var": "height"}]}}
    ],
}
WAVE: Json = {"name": "wave", "parameters": [], "commands": [{"action": "beep"}]}
CALL: Json = {"call": "area", "arguments": {"width": 2, "height": 3}}


def document(*commands: Json, functions: list[Json] | None = None) -> Json:
    return {
        "pinel_ir": 1,
        "name": "test",
        "functions": [AREA, WAVE] if functions is None else functions,
        "commands": list(commands),
    }


def faults(source: Any) -> list[tuple[str, str]]:
    """The faults of a document, the same as text and as parsed data."""
    found = [(fault.code, fault.pointer) for fault in read_document(source).faults]
    assert [(f.code, f.pointer) for f in read_document(json.dumps(source)).faults] == found
    return found


def say(value: Any) -> Json:
    return {"action": "say", "text": value}


def op(name: str, *args: Any) -> Json:
    return {"op": name, "args": list(args)}


def var(name: str) -> Json:
    return {"var": name}


COMMANDS: list[Json] = [
    {"action": "drive", "linear": -0.3, "angular": 45},
    {"action": "arc", "radius": -0.5, "angle": -90},
    {"action": "set_speed", "linear": 0.3},
    {"action": "set_speed", "angular": var("fast")},
    {"action": "go_to", "x": -1, "y": {"sensor": "y"}, "avoid": True},
    {"action": "wait_until", "condition": {"sensor": "bumper"}, "timeout": 3},
    {"action": "wait_until", "condition": "result == 'A'"},
    {"action": "pen", "down": True, "color": "red"},
    {"action": "ask", "question": op("join", "how many", 2), "variable": "n"},
    {"action": "mark", "symbol": "X"},
    {"action": "mark", "symbol": var("symbol")},
    {"action": "go_to_place", "place": {"gesture": "result"}},
    {"action": "replace_item", "list": "l", "position": var("n"), "value": CALL},
    say([1, "a", True]),
    say(op("item", [1, 2], op("length", "ab"))),
    {"action": "beep"},
    {"action": "set_variable", "name": "a\u00e7\u00e3o 2", "value": False},
    {"action": "change_variable", "name": "n", "by": op("random_int", 1, 6)},
    {"action": "append", "list": "l", "value": CALL},
    {
        "action": "while",
        "condition": op("<", {"sensor": "time"}, 5),
        "commands": [{"action": "break"}],
    },
    {"action": "until", "condition": var("done"), "commands": [{"action": "continue"}]},
    {"action": "for", "variable": "i", "from": 10, "to": 1, "by": -3, "commands": []},
    {"action": "forever", "commands": [{"action": "repeat", "times": var("n"), "commands": []}]},
    {"action": "call", "function": "area", "arguments": {"width": 1, "height": CALL}},
    {"action": "call", "function": "wave"},
    {"action": "move_forward", "distance": {"sensor": "distance", "direction": "front"}},
    {"action": "turn", "angle": {"sensor": "lidar", "angle": op("-", 0, 90)}},
    say({"sensor": "sonar", "index": 15.0}),
    say(op("==", {"gesture": "result"}, {"sensor": "cell"})),
    say(op("and", True, var("b"), op("not", CALL))),
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command["action"])
def test_every_command_is_read_and_stays_itself(command: Json) -> None:
    reading = read_document(document(command))
    assert reading.faults == ()
    assert read_document(reading.document or {}).document == reading.document


@pytest.mark.parametrize("name", OPERATORS)
def test_every_operator_is_read(name: str) -> None:
    arguments: dict[str, list[Any]] = {
        "and": [True, False],
        "or": [True, False],
        "not": [True],
        "item": [[1], 1],
        "contains": [[1], "a"],
        "position_of": [var("l"), 1],
        "length": ["a"],
    }
    few = OPERATORS[name].n_min
    assert faults(document(say(op(name, *arguments.get(name, [1, 2][:few]))))) == []


@pytest.mark.parametrize(
    ("command", "code", "place"),
    [
        ({"action": "drive", "linear": 1}, "missing_parameter", ""),
        ({"action": "arc", "radius": 101, "angle": 1}, "radius_out_of_range", "/radius"),
        ({"action": "go_to", "x": 0, "y": -101}, "y_out_of_range", "/y"),
        ({"action": "set_speed"}, "missing_speed", ""),
        ({"action": "set_speed", "linear": 0}, "linear_not_positive", "/linear"),
        ({"action": "set_speed", "angular": -1}, "angular_not_positive", "/angular"),
        ({"action": "mark", "symbol": "Z"}, "symbol_unknown", "/symbol"),
        ({"action": "mark", "symbol": 5}, "symbol_unknown", "/symbol"),
        ({"action": "mark", "symbol": {"var": ""}}, "name_invalid", "/symbol/var"),
        ({"action": "mark", "symbol": {"op": "+"}}, "missing_parameter", "/symbol"),
        ({"action": "mark", "symbol": op("+", 1, 2)}, "wrong_type_text", "/symbol"),
        ({"action": "go_to_place", "place": 5}, "wrong_type_text", "/place"),
        ({"action": "go_to_place"}, "missing_parameter", ""),
        (
            {"action": "replace_item", "list": "l", "position": 0, "value": 1},
            "position_out_of_range",
            "/position",
        ),
        (
            {"action": "replace_item", "list": "l", "position": 1.5, "value": 1},
            "wrong_type_whole_number",
            "/position",
        ),
        ({"action": "replace_item", "list": "l", "position": 1}, "missing_parameter", ""),
        (say(op("contains", "abc", "a")), "not_list", "/text"),
        (say(op("position_of", [1])), "wrong_argument_count", "/text"),
        ({"action": "pen", "down": 1}, "wrong_type_boolean", "/down"),
        ({"action": "pen", "down": True, "color": "pink"}, "wrong_value", "/color"),
        ({"action": "go_to", "x": 0, "y": 0, "avoid": "yes"}, "wrong_type_boolean", "/avoid"),
        ({"action": "ask", "question": 5, "variable": "n"}, "wrong_type_text", "/question"),
        ({"action": "set_variable", "name": "", "value": 1}, "name_invalid", "/name"),
        ({"action": "set_variable", "name": " a", "value": 1}, "name_invalid", "/name"),
        ({"action": "set_variable", "name": "a-b", "value": 1}, "name_invalid", "/name"),
        (
            {"action": "set_variable", "name": "x" * (MAX_NAME + 1), "value": 1},
            "name_invalid",
            "/name",
        ),
        ({"action": "set_variable", "name": "a", "value": None}, "unknown_expression", "/value"),
        ({"action": "set_variable", "name": "a", "value": [[1]]}, "unknown_expression", "/value/0"),
        (
            {"action": "set_variable", "name": "a", "value": [1] * (MAX_LIST + 1)},
            "list_too_long",
            "/value",
        ),
        (say("x" * (MAX_TEXT + 1)), "text_too_long", "/text"),
        (say({"var": "a b "}), "name_invalid", "/text/var"),
        (say({"sensor": "nose"}), "wrong_value", "/text/sensor"),
        (say({"sensor": "sonar", "index": 16}), "sonar_out_of_range", "/text/index"),
        (say({"sensor": "sonar", "index": 1.5}), "wrong_type_whole_number", "/text/index"),
        (say({"sensor": "sonar"}), "missing_parameter", "/text"),
        (say({"sensor": "lidar", "angle": 181}), "angle_out_of_range", "/text/angle"),
        (say({"sensor": "distance", "direction": "up"}), "wrong_value", "/text/direction"),
        (say({"sensor": "x", "index": 1}), "unknown_key", "/text/index"),
        (say(op("+", 1)), "wrong_argument_count", "/text"),
        (say(op("+", 1, "a")), "not_number", "/text"),
        (say(op("sqrt", op("not", True))), "not_number", "/text"),
        (say(op("and", True, 1)), "not_boolean", "/text"),
        (say(op("item", "abc", 1)), "not_list", "/text"),
        (say(op("length", 5)), "not_text_or_list", "/text"),
        (say(op("<", True, False)), "not_comparable", "/text"),
        (say(op("min")), "too_few_arguments", "/text"),
        (say(op("+", 1, op("eval", 1))), "unknown_operator", "/text/args/1"),
        ({"action": "turn", "angle": op("join", 1)}, "wrong_type_number", "/angle"),
        ({"action": "turn", "angle": {"sensor": "bumper"}}, "wrong_type_number", "/angle"),
        (
            {"action": "set_gesture_result", "resultado": op("not", True)},
            "wrong_type_text",
            "/resultado",
        ),
        ({"action": "break"}, "break_outside_loop", ""),
        ({"action": "continue"}, "continue_outside_loop", ""),
        ({"action": "return"}, "return_outside_function", ""),
        ({"action": "call", "function": "fly"}, "unknown_function", "/function"),
        (
            {"action": "call", "function": "wave", "arguments": {"a": 1}},
            "unknown_argument",
            "/arguments/a",
        ),
        (
            {"action": "call", "function": "area", "arguments": {"width": 1}},
            "missing_argument",
            "",
        ),
        (say({"call": "wave"}), "function_without_value", "/text/call"),
        (say({"call": "fly", "arguments": {}}), "unknown_function", "/text/call"),
    ],
)
def test_each_fault_is_one_at_its_place(command: Json, code: str, place: str) -> None:
    assert faults(document(command)) == [(code, f"/commands/0{place}")]
    inside = {"action": "forever", "commands": [command], "block": "outer"}
    if not code.endswith("outside_loop"):
        assert faults(document(inside)) == [(code, f"/commands/0/commands/0{place}")]


def test_faults_of_all_kinds_come_together_in_the_order_of_the_document() -> None:
    assert faults(
        document(
            say(op("+", 1, "a")),
            {"action": "move_forward", "distance": 500},
            {"action": "call", "function": "nobody"},
            {"action": "jump"},
            {"action": "repeat", "times": 2.5, "commands": [{"action": "return"}]},
        )
    ) == [
        ("not_number", "/commands/0/text"),
        ("distance_out_of_range", "/commands/1/distance"),
        ("unknown_function", "/commands/2/function"),
        ("unknown_action", "/commands/3"),
        ("wrong_type_whole_number", "/commands/4/times"),
        ("return_outside_function", "/commands/4/commands/0"),
    ]


def test_functions_have_names_of_their_own() -> None:
    twice = [WAVE, {**WAVE, "commands": []}]
    assert faults(document(functions=twice)) == [("duplicate_function", "/functions/1/name")]
    same = {"name": "f", "parameters": ["a", "b", "a"], "commands": []}
    assert faults(document(functions=[same])) == [
        ("duplicate_parameter", "/functions/0/parameters/2")
    ]


def test_a_loop_around_a_call_is_not_around_the_commands_of_the_function() -> None:
    function = {"name": "f", "commands": [{"action": "break"}]}
    loop = {"action": "forever", "commands": [{"action": "call", "function": "f"}]}
    assert faults(document(loop, functions=[function])) == [
        ("break_outside_loop", "/functions/0/commands/0")
    ]


def test_a_function_that_returns_null_gives_no_value() -> None:
    function = {"name": "f", "commands": [{"action": "return", "value": None}]}
    assert faults(document(say({"call": "f"}), functions=[function])) == [
        ("function_without_value", "/commands/0/text/call")
    ]


def test_strings_of_conditions_are_checked_like_trees() -> None:
    command = {"action": "while", "condition": "not (1 < 'a')", "commands": []}
    assert faults(document(command)) == [("not_comparable", "/commands/0/condition")]
    command = {"action": "while", "condition": "'a'", "commands": []}
    assert faults(document(command)) == [("condition_not_boolean", "/commands/0/condition")]


@pytest.mark.parametrize(
    "condition",
    [
        "__import__('os').system('x')",
        'result == "B" == "C"',
        "re\u0455ult == 'A'",  # a Cyrillic letter
        "result == 'it's'",
        "result = 'A'",
        "result == 'A' and",
        "result" + " == 'A' or result" * 1000,
        "(" * 1000,
        "x" * 1_000_000,
        "result == A",
        "0x10 == 16",
        "\ud800 == 'A'",
    ],
)
def test_conditions_outside_the_grammar_are_one_fault(condition: str) -> None:
    command = {"action": "while", "condition": condition, "commands": []}
    assert [code for code, _ in faults([command])] == ["condition_syntax"]


def test_a_thousand_variables_are_the_limit() -> None:
    def program(n: int) -> Json:
        return document(
            *[{"action": "set_variable", "name": f"v{i}", "value": 1} for i in range(n)]
        )

    assert faults(program(MAX_VARIABLES)) == []
    assert faults(program(MAX_VARIABLES + 1)) == [("too_many_variables", "")]


def test_expressions_count_as_levels() -> None:
    def program(n: int) -> Json:
        value: Any = 1
        for _ in range(n):
            value = op("abs", value)
        return document(say(value))

    assert faults(program(MAX_NESTING - 1)) == []
    assert [code for code, _ in faults(program(MAX_NESTING))] == ["nesting_too_deep"]
    assert [code for code, _ in faults(program(5 * MAX_NESTING))] == ["nesting_too_deep"]


def test_block_of_a_fault_is_the_innermost_around_it() -> None:
    inner = {"action": "turn", "angle": op("+", 1, op("*", 2, "a")), "block": "inner"}
    outer = {"action": "forever", "commands": [inner], "block": "outer"}
    (fault,) = read_document(document(outer)).faults
    assert (fault.block, fault.pointer) == ("inner", "/commands/0/commands/0/angle/args/1")
