"""Expressions mean what the language says. Each is worked out by a run."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.program.operators import OPERATORS

L = [1, "a", True]
GESTURE = {"gesture": "result"}


def op(name: str, *args: Any) -> dict[str, Any]:
    return {"op": name, "args": list(args)}


@pytest.mark.parametrize(
    ("condition", "gesture", "value"),
    [
        ("result == 'B'", "B", True),
        ("result == 'B'", "b", True),
        ("result != 'B'", "b", False),
        ("result == 'B'", "", False),
        ("result == 1", "1", False),
        ("result != 1", "1", True),
        ("'a' == 'A'", "", False),
        ("result < 'c'", "B", True),
        ("1 < 2 and not 2 < 1", "", True),
        ("1 > 2 or result == 'A'", "a", True),
        (op("==", True, 1), "", False),
        (True, "", True),
    ],
)
def test_conditions_mean_what_the_language_says(
    condition: Any, gesture: str, value: bool, execute_commands: Any
) -> None:
    result, _ = execute_commands(
        {"action": "set_gesture_result", "result": gesture},
        {
            "action": "conditional_execution",
            "condition": condition,
            "commands": [{"action": "say", "text": "true"}],
            "else": [{"action": "say", "text": "false"}],
        },
    )
    assert result.shown_texts == [str(value).lower()]


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        (op("+", 0.1, 0.2), 0.1 + 0.2),
        (op("-", 1, 3), -2),
        (op("*", 4, 2.5), 10),
        (op("/", 1, 4), 0.25),
        (op("%", -1, 3), 2),
        (op("%", 5.5, -2), 5.5 % -2),
        (op("**", 2, 10), 1024),
        (op("**", -2, 3), -8),
        (op("**", 9, 0.5), 3),
        (op("**", 0, 0), 1),
        (op("abs", -3), 3),
        (op("round", 2.5), 2),
        (op("round", 3.5), 4),
        (op("round", -0.4), 0),
        (op("sqrt", 2), math.sqrt(2)),
        (op("min", 3, 1, 2), 1),
        (op("max", 3), 3),
        (op("==", 1, 1.0), True),
        (op("==", "1", 1), False),
        (op("!=", True, 1), True),
        (op("==", L, L), True),
        (op("==", [1], [True]), False),
        (op("==", [1, 2], [1]), False),
        (op("<", "a", "b"), True),
        (op(">=", 2, 2), True),
        (op(">", 2, 2), False),
        (op("<=", "b", "a"), False),
        (op("and", True, True, False), False),
        (op("or", False, True, op("==", 1, op("/", 1, 0))), True),
        (op("and", False, op("==", 1, op("/", 1, 0))), False),
        (op("not", False), True),
        (op("length", "ação"), 4),
        (op("length", L), 3),
        (op("length", []), 0),
        (op("item", L, 1), 1),
        (op("item", L, 3), True),
        (op("contains", L, "a"), True),
        (op("contains", L, "A"), True),
        (op("contains", L, 1), True),
        (op("contains", [1], True), False),
        (op("contains", ["1"], 1), False),
        (op("contains", [], ""), False),
        (op("contains", ["straße"], "STRASSE"), True),
        (op("position_of", L, "A"), 2),
        (op("position_of", ["b", "B", "c"], "B"), 1),
        (op("position_of", [0.5, True, 1], 1), 3),
        (op("position_of", L, "b"), 0),
        (op("join", 3, " ", 0.5, " ", True, " ", L), "3 0.5 true 1, a, true"),
        (op("join", op("+", 0.1, 0.2)), "0.3"),
        (op("join", op("/", 1, 3)), "0.333333333333"),
        (op("join", 1e15), "1000000000000000"),
        (op("join", op("*", -1, 0)), "0"),
        (op("join", 0.00001), "0.00001"),
        (op("join", 123456789012.5), "123456789012.5"),
        (op("join", 1e300), "1e+300"),
    ],
    ids=lambda v: json.dumps(v)[:60],
)
def test_operators_compute(expression: Any, value: Any, value_of: Any) -> None:
    assert value_of(expression) == value
    assert type(value_of(expression)) in (type(value), int, float)


@pytest.mark.parametrize("quarters", range(-8, 9))
def test_sine_cosine_and_tangent_are_exact_at_quarters_of_a_turn(
    quarters: int, value_of: Any
) -> None:
    angle = 90 * quarters
    assert value_of(op("sin", angle)) == (0, 1, 0, -1)[quarters % 4]
    assert value_of(op("cos", angle)) == (1, 0, -1, 0)[quarters % 4]
    if quarters % 2:
        assert value_of(op("tan", angle)) == ("not_finite_result", {"operator": "tan"})
    else:
        assert value_of(op("tan", angle)) == 0


def test_sine_takes_degrees(value_of: Any) -> None:
    assert value_of(op("sin", 30)) == pytest.approx(0.5)
    assert value_of(op("tan", -45)) == pytest.approx(-1)
    assert value_of(op("sin", -1e-30)) == 0


SET_LIST = {"action": "set_variable", "name": "l", "value": L}
SET_TEXT = {"action": "set_variable", "name": "t", "value": "a"}
LIST, TEXT = {"var": "l"}, {"var": "t"}


@pytest.mark.parametrize(
    ("expression", "reason", "params"),
    [
        (op("/", 1, 0), "division_by_zero", {"operator": "/"}),
        (op("%", 1, 0), "division_by_zero", {"operator": "%"}),
        (op("**", 0, -1), "division_by_zero", {"operator": "**"}),
        (op("*", 1e300, 1e300), "not_finite_result", {"operator": "*"}),
        (op("**", 10, 400), "not_finite_result", {"operator": "**"}),
        (op("-", -1.7e308, 1.7e308), "not_finite_result", {"operator": "-"}),
        (op("**", -8, 0.5), "power_not_real", {"value": -8, "exponent": 0.5}),
        (op("sqrt", -1), "root_of_negative", {"value": -1}),
        ({"var": "nobody"}, "unset_variable", {"name": "nobody"}),
        (op("item", LIST, 0), "index_out_of_range", {"value": 0, "min": 1, "max": 3}),
        (op("item", LIST, 4), "index_out_of_range", {"value": 4, "min": 1, "max": 3}),
        (op("item", LIST, 1.5), "not_whole", {"operator": "item", "value": 1.5}),
        (op("item", [], 1), "list_empty", {"operator": "item"}),
        (op("item", TEXT, 1), "not_list", {"operator": "item"}),
        (op("contains", TEXT, "a"), "not_list", {"operator": "contains"}),
        (op("position_of", TEXT, "a"), "not_list", {"operator": "position_of"}),
        (op("item", LIST, TEXT), "not_number", {"operator": "item"}),
        (op("+", TEXT, 1), "not_number", {"operator": "+"}),
        (op("+", True, {"var": "t"}), "not_number", {"operator": "+"}),
        (op("max", 1, TEXT), "not_number", {"operator": "max"}),
        (op("sqrt", TEXT), "not_number", {"operator": "sqrt"}),
        (op("not", TEXT), "not_boolean", {"operator": "not"}),
        (op("and", True, TEXT), "not_boolean", {"operator": "and"}),
        (op("or", TEXT, True), "not_boolean", {"operator": "or"}),
        (op("<", TEXT, 1), "not_comparable", {"operator": "<"}),
        (op(">=", LIST, LIST), "not_comparable", {"operator": ">="}),
        (op("<", {"var": "yes"}, {"var": "yes"}), "not_comparable", {"operator": "<"}),
        (op("length", {"var": "yes"}), "not_text_or_list", {"operator": "length"}),
        (op("random_int", 1, 2.5), "not_whole", {"operator": "random_int", "value": 2.5}),
        ({"sensor": "sonar", "index": op("+", 8, 8)}, "sonar_out_of_range", {"value": 16, "min": 0, "max": 15}),
        ({"sensor": "sonar", "index": op("/", 1, 2)}, "wrong_type_whole_number", {"name": "index"}),
        ({"sensor": "lidar", "angle": op("+", 90, 1)}, "angle_out_of_range", {"value": 91, "min": -90, "max": 90}),
        ({"sensor": "lidar", "angle": TEXT}, "wrong_type_number", {"name": "angle"}),
    ],
    ids=lambda v: json.dumps(v)[:60],
)  # fmt: skip
def test_what_only_the_run_can_know_fails_it_at_its_block(
    expression: Any, reason: str, params: Any, value_of: Any
) -> None:
    yes = {"action": "set_variable", "name": "yes", "value": True}
    if expression == op("+", True, {"var": "t"}):
        expression = op("+", {"var": "yes"}, 1)
    assert value_of(expression, SET_LIST, SET_TEXT, yes) == (reason, params)


def test_comparing_with_the_gesture_ignores_case_and_comparing_its_copy_does_not(
    value_of: Any,
) -> None:
    assert value_of(op("==", GESTURE, "B"), gesture="b") is True
    assert value_of(op("==", op("join", GESTURE), "B"), gesture="b") is False


def test_random_numbers_come_from_the_seed_and_stay_within_their_ends(value_of: Any) -> None:
    drawn = [value_of(op("random_int", 1, 6), seed=seed) for seed in range(30)]
    assert drawn == [value_of(op("random_int", 1, 6), seed=seed) for seed in range(30)]
    assert set(drawn) == {1, 2, 3, 4, 5, 6}
    assert value_of(op("random_int", 6, 1), seed=3) == value_of(op("random_int", 1, 6), seed=3)
    assert value_of(op("random_int", -2, -2)) == -2


def test_seed_gives_these_numbers_on_every_platform(execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "set_variable", "name": "l", "value": []},
        {
            "action": "repeat",
            "times": 8,
            "commands": [{"action": "append", "list": "l", "value": op("random_int", 1, 100)}],
        },
        seed=2026,
    )
    assert result.variables["l"] == [16, 41, 65, 66, 83, 14, 29, 77]


def test_text_longer_than_10_000_characters_fails_the_run(value_of: Any) -> None:
    half = {"action": "set_variable", "name": "h", "value": "x" * 5_000}
    joined = op("join", {"var": "h"}, {"var": "h"})
    assert len(value_of(joined, half)) == 10_000
    assert value_of(op("join", joined, "!"), half) == (
        "text_too_long",
        {"name": "join", "max": 10_000},
    )


def test_long_expression_is_evaluated_over_several_ticks(execute_commands: Any) -> None:
    terms = op("max", *[op("+", i, 1) for i in range(20_000)])
    result, _ = execute_commands({"action": "set_variable", "name": "v", "value": terms})
    assert result.variables["v"] == 20_000
    assert result.ended.duration_s * 30 >= 3


def test_every_operator_of_the_language_is_tried_here() -> None:
    text = Path(__file__).read_text("utf-8")
    assert [name for name in OPERATORS if f'op("{name}"' not in text] == []
