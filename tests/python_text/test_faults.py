"""Anything outside the language is a fault with its place and a message; all are reported at once."""

import re
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.messages import LANGUAGES, SOURCE_LANGUAGE, catalogue, describe
from pinel_desktop.program import python_text
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.python_text import read_python

SOURCES = Path(python_text.__file__).parent


def faults(text: str) -> list[tuple[int, int, str]]:
    reading = read_python(text)
    assert reading.document is None
    return [(fault.params["line"], fault.params["column"], fault.code) for fault in reading.faults]  # type: ignore[misc]


ONE_FAULT: list[tuple[str, int, int, str]] = [
    ("import math\n", 1, 1, "python_import"),
    ("from os import system", 1, 1, "python_import"),
    ("class A:\n    pass", 1, 1, "python_statement"),
    ("try:\n    pass\nexcept E:\n    pass", 1, 1, "python_statement"),
    ("with x:\n    pass", 1, 1, "python_statement"),
    ("del x", 1, 1, "python_statement"),
    ("async def f():\n    pass", 1, 1, "python_statement"),
    ("x = lambda: 1", 1, 5, "python_expression"),
    ("x = [y for y in z]", 1, 5, "python_expression"),
    ("x = {1: 2}", 1, 5, "python_expression"),
    ("x = (1, 2)", 1, 5, "python_expression"),
    ("x = (y := 1)", 1, 6, "python_expression"),
    ('x = f"{y}"', 1, 5, "python_format_text"),
    ("x = y[0]", 1, 5, "python_index"),
    ("x = 1 if y else 2", 1, 5, "python_choice"),
    ("x = 1 < y < 3", 1, 5, "python_chained_comparison"),
    ("x = 7 // 2", 1, 5, "python_operator"),
    ("x = 1 in y", 1, 5, "python_operator"),
    ("x = ~1", 1, 5, "python_operator"),
    ("x //= 2", 1, 1, "python_operator"),
    ("x = None", 1, 5, "python_value"),
    ("x = b'a'", 1, 5, "python_value"),
    ("x = 2j", 1, 5, "python_value"),
    ("x = 1e999", 1, 5, "python_number_too_large"),
    (f"x = {'9' * 5000}", 1, 5, "python_number_too_large"),
    (f"x = {'9' * 350}", 1, 5, "python_number_too_large"),
    ("x = y.z", 1, 5, "python_attribute"),
    ("x = [1, y]", 1, 9, "python_list_items"),
    ("x = [[1]]", 1, 6, "python_list_items"),
    ("a, b = 1, 2", 1, 1, "python_assignment"),
    ("a = b = 1", 1, 1, "python_assignment"),
    ("a: int = 1", 1, 1, "python_assignment"),
    ("robot = 1", 1, 1, "python_reserved_name"),
    ("x = robot", 1, 5, "python_reserved_name"),
    ("if_ = item", 1, 7, "python_reserved_name"),
    ("robot.jump()", 1, 1, "python_unknown_command"),
    ("x = robot.z", 1, 5, "python_unknown_command"),
    ("robot.turn()", 1, 1, "python_arguments"),
    ("robot.turn(x, 2)", 1, 1, "python_arguments"),
    ("robot.turn(angel=1)", 1, 1, "python_arguments"),
    ("robot.turn(*x)", 1, 1, "python_arguments"),
    ("robot.turn(**x)", 1, 1, "python_arguments"),
    ("robot.turn(1, angle=1)", 1, 1, "python_arguments"),
    ("x = robot.sonar", 1, 5, "python_arguments"),
    ("x = min(1, key=2)", 1, 5, "python_arguments"),
    ("x.append(1, 2)", 1, 1, "python_arguments"),
    ("robot.stop", 1, 1, "python_parentheses"),
    ("x = robot.bumper()", 1, 5, "python_no_parentheses"),
    ("x = robot.stop()", 1, 5, "python_command_as_value"),
    ('robot.ask("x")', 1, 1, "python_ask"),
    ('x = 1 + robot.ask("x")', 1, 9, "python_ask"),
    ("print(1)", 1, 1, "python_instead"),
    ("x = random.randint(1, 6)", 1, 5, "python_instead"),
    ("x = len(y)", 1, 5, "python_instead"),
    ("jump()", 1, 1, "python_unknown_function"),
    ("x = __import__('os')", 1, 5, "python_unknown_function"),
    ("x = __import__('os').system('ls')", 1, 5, "python_attribute"),
    ("1 + 2", 1, 1, "python_no_effect"),
    ("robot.x", 1, 1, "python_no_effect"),
    ("min(1, 2)", 1, 1, "python_no_effect"),
    ("robot.stop()\n'text'", 2, 1, "python_no_effect"),
    ("for x in y:\n    pass", 1, 1, "python_for"),
    ("for x in range(1, 2, y):\n    pass", 1, 1, "python_for"),
    ("for a, b in steps(1, 2):\n    pass", 1, 1, "python_for"),
    ("for _ in range(2):\n    pass\nelse:\n    robot.stop()", 4, 5, "python_loop_else"),
    ("while True:\n    def f():\n        pass", 2, 5, "python_function_inside"),
    ("def f(a=1):\n    pass", 1, 1, "python_parameters"),
    ("def f(a: int):\n    pass", 1, 1, "python_parameters"),
    ("@x\ndef f():\n    pass", 2, 1, "python_parameters"),
    ("def f():\n    x = 1", 2, 5, "python_global_missing"),
    ("def f():\n    for i in steps(1, 2):\n        pass", 2, 9, "python_global_missing"),
    ("def f(a):\n    global a\n    a = 1", 2, 5, "python_global_parameter"),
    ("robot.stop()\nelif x:\n    pass", 2, 1, "python_elif"),
    ("if x:\n    pass\nelse:\n    pass\nelif y:\n    pass", 5, 1, "python_elif"),
    ("if 'result == 1':\n    pass", 1, 4, "python_condition_text"),
    ("robot.pen(down=True, color=x)", 1, 27, "python_literal_text"),
    ("robot.pen(down=x)", 1, 16, "python_literal_boolean"),
    ("robot.turn(90", 1, 11, "python_bracket_not_closed"),
    ("robot.turn(90))", 1, 15, "python_bracket_not_opened"),
    ("robot.turn(90]", 1, 14, "python_bracket_not_opened"),
    ("x = 'abc", 1, 5, "python_text_not_closed"),
    ('x = """abc\n', 1, 5, "python_text_not_closed"),
    ("if x = 1:\n    pass", 1, 4, "python_equals"),
    ("while True\n    pass", 1, 11, "python_colon_missing"),
    ("while True:\nrobot.stop()", 1, 1, "python_indent_missing"),
    ("robot.stop()\n  robot.stop()", 2, 1, "python_indent_wrong"),
    ("x = “a”", 1, 5, "python_character"),
    ("x = 1\x00", 1, 6, "python_character"),
    ("x = '\ud800'", 1, 6, "python_character"),
    ("x x", 1, 3, "python_syntax"),
    ("if x:\n    pass\nelse if y:\n    pass", 3, 6, "python_else_if"),
    ("x++", 1, 4, "python_step"),
    ("x = 1\nx--", 2, 4, "python_step"),
    ("if x =< 1:\n    pass", 1, 7, "python_turned_round"),
    ("If x == 1:\n    pass", 1, 4, "python_word"),
    ("enquanto x == 1:\n    break", 1, 10, "python_word"),
    ("sinon:\n    pass", 1, 6, "python_word"),
    ("robot.move_forward(1,5)", 1, 20, "python_decimal_comma"),
    ("robot.arc(-1,5, 90)", 1, 11, "python_decimal_comma"),
    ("x = " + "(" * 100 + ")" * 100, 1, 85, "nesting_too_deep"),
    ("x = 1" + " + 1" * 100, 1, 5, "nesting_too_deep"),
    ("a;" * 200_000, 1, 200_002, "too_many_commands"),
    ("robot.stop()\n" * 20_001, 1, 1, "too_many_commands"),
    ("x = " + "~" * 50_000 + "1", 1, 1, "nesting_too_deep"),
    ("x = 1" + " + 1" * 100_000, 1, 1, "nesting_too_deep"),
]


@pytest.mark.parametrize(("text", "line", "column", "code"), ONE_FAULT)
def test_what_is_not_in_the_language_is_a_fault_at_its_place(
    text: str, line: int, column: int, code: str
) -> None:
    found = faults(text)
    assert len(found) == 1
    assert found[0][::2] == (line, code)
    assert abs(found[0][1] - column) <= 1  # versions of Python point at neighbouring characters


def test_faults_of_the_document_are_placed_in_the_text() -> None:
    text = "robot.turn(90)\nwhile True:\n    robot.move_forward(\n        -1)\n    é = min('x') + 1e3\nbreak\n"
    assert faults(text) == [
        (4, 9, "distance_out_of_range"),
        (5, 9, "not_number"),
        (6, 1, "break_outside_loop"),
    ]


def test_columns_count_characters() -> None:
    assert faults('robot.say("ação 😀"); robot.jump()') == [(1, 22, "python_unknown_command")]


def test_all_faults_are_said_at_once_in_the_order_of_the_text() -> None:
    text = (
        "import math\nrobot.turn(90\nrobot.turn(9999)\nif x = 1:\n    robot.jump()\n"
        "robot.say('a)\nwhile True:\nx x\nprint(1)\n"
    )
    assert [(line, code) for line, _, code in faults(text)] == [
        (1, "python_import"),
        (2, "python_bracket_not_closed"),
        (3, "angle_out_of_range"),
        (4, "python_equals"),
        (5, "python_unknown_command"),
        (6, "python_text_not_closed"),
        (7, "python_indent_missing"),
        (8, "python_syntax"),
        (9, "python_instead"),
    ]


def test_a_broken_line_makes_no_other_line_seem_wrong() -> None:
    text = "def f(a b):\n    return 1\nx = f(1)\nfor i in in:\n    break\n"
    assert [line for line, _, _ in faults(text)] == [1, 4]


def test_a_text_beyond_the_limit_is_a_fault() -> None:
    assert faults("#" * (MAX_BYTES + 1)) == [(1, 1, "document_too_large")]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "\n\n",
        "# only a comment",
        "\ufeffrobot.stop()",
        "pass",
        "x = 1\r\ny = 2\r",
        "\x0cx = 1\n",
    ],
)
def test_these_are_programs(text: str) -> None:
    assert read_python(text).faults == ()


def codes() -> set[str]:
    text = "".join(file.read_text("utf-8") for file in SOURCES.glob("*.py"))
    literals = {"python_literal_text", "python_literal_boolean"}
    return {*re.findall(r'"(python_\w+)"', text)} | literals


def test_every_fault_has_words_and_every_word_a_fault() -> None:
    from_other_modules = {"python_not_utf8", "python_at"}
    assert (
        codes()
        == {code for code in catalogue(SOURCE_LANGUAGE) if code.startswith("python_")}
        - from_other_modules
    )


def test_every_fault_is_provoked_above() -> None:
    assert codes() <= {code for _, _, _, code in ONE_FAULT}


@pytest.mark.parametrize(("text", "code"), [(text, code) for text, _, _, code in ONE_FAULT])
def test_the_words_of_a_fault_are_complete(text: str, code: str) -> None:
    fault: Any = read_python(text).faults[0]
    for language in LANGUAGES:
        description = describe(code, fault.params, language)
        assert description.remedy
        assert not re.search(r"\{\w+\}", description.message + description.remedy)
