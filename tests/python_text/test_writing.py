import ast
import math
import subprocess
import sys
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.program.python_text import TextLine, read_python, write_python
from pinel_desktop.program.python_text.write_expressions import number_text, string_literal


def value_of(expression: Any) -> str:
    command = {"action": "set_variable", "name": "x", "value": expression}
    return write_python({"commands": [command]}).text.removeprefix("x = ").rstrip("\n")


def op(name: str, *args: Any) -> dict[str, Any]:
    return {"op": name, "args": list(args)}


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (op("-", op("-", 1, 2), 3), "1 - 2 - 3"),
        (op("-", 1, op("-", 2, 3)), "1 - (2 - 3)"),
        (op("**", op("**", 2, 3), 4), "(2**3) ** 4"),
        (op("**", 2, op("**", 3, 4)), "2 ** 3**4"),
        (op("**", -2, 2), "(-2) ** 2"),
        (op("**", 2, -2), "2**-2"),
        (op("*", -2, op("+", 1, 2)), "-2 * (1 + 2)"),
        (op("and", True, op("and", True, False)), "True and (True and False)"),
        (op("and", True, True, False), "True and True and False"),
        (op("or", op("and", True, False), op("not", True)), "True and False or not True"),
        (op("not", op("==", 1, 2)), "not 1 == 2"),
        (op("==", op("not", True), False), "(not True) == False"),
        (op("==", op("<", 1, 2), True), "(1 < 2) == True"),
        (op("join", op("or", True, False)), "join(True or False)"),
    ],
)
def test_parentheses_stand_only_where_they_are_needed(expression: Any, text: str) -> None:
    assert value_of(expression) == text
    document = read_python(f"x = {text}").document
    assert document is not None
    assert document["commands"][0]["value"] == expression


@given(st.floats(allow_nan=False, allow_infinity=False), st.booleans())
def test_numbers_read_back_to_the_same_double(value: float, metres: bool) -> None:
    again = float(number_text(value, metres=metres))
    assert (again, math.copysign(1, again)) == (value, math.copysign(1, value))


@given(st.text())
def test_texts_stand_on_one_line_and_read_back(value: str) -> None:
    text = string_literal(value)
    assert len(text.splitlines()) == 1
    assert ast.literal_eval(text) == value


@pytest.mark.parametrize("value", ["it's", 'say "hi"', "\"'", "\\", "😀", "a\nb\t\x00", "\u2028"])
def test_odd_texts_survive_in_commands_and_in_the_name(value: str) -> None:
    command = {"action": "say", "text": value}
    document = read_python(write_python({"name": value, "commands": [command]}).text).document
    assert document is not None
    assert (document["name"], document["commands"]) == (value, [command])


def test_each_line_with_a_command_has_its_pointer_and_block() -> None:
    loop = {
        "action": "repeat",
        "times": 2,
        "block": "r",
        "comment": "two\nlines",
        "commands": [{"action": "stop", "block": "s"}],
    }
    written = write_python({"name": "a", "commands": [loop]})
    assert written.text.splitlines()[4] == "for _ in range(2):"
    assert written.lines == {
        5: TextLine("/commands/0", "r"),
        6: TextLine("/commands/0/commands/0", "s"),
    }


def test_the_formatter_has_nothing_to_change() -> None:
    text = write_python(
        {
            "name": "a program",
            "functions": [
                {"name": "f", "parameters": [], "commands": []},
                {"name": "g", "parameters": ["a"], "commands": [], "comment": "why"},
            ],
            "commands": [
                {"action": "say", "text": 'a "quoted" word'},
                {
                    "action": "while",
                    "condition": op("<", op("**", op("abs", -1), 2), 3),
                    "commands": [],
                },
                {"action": "set_variable", "name": "y", "value": [1, 2.5, "it's"]},
                {"action": "set_variable", "name": "z", "value": op("**", {"var": "y"}, 2)},
            ],
        }
    ).text
    formatted = subprocess.run(
        [sys.executable, "-m", "ruff", "format", "-"],
        input=text.encode(),
        capture_output=True,
        check=True,
    )
    assert formatted.stdout.decode() == text
