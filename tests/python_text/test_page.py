"""docs/python-text.md is complete, and the round trip of every form on it gives the same text."""

import re
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.program.model import action_names
from pinel_desktop.program.operators import OPERATORS
from pinel_desktop.program.python_text import read_python, write_python
from pinel_desktop.program.python_text.forms import ASK, COMMANDS, SENSOR_CALLS
from pinel_desktop.program.python_text.names import program_name, python_name
from pinel_desktop.program.sensors import SENSORS

PAGE = (Path(__file__).parents[2] / "docs" / "python-text.md").read_text("utf-8")


def section(title: str) -> str:
    return PAGE.split(f"\n## {title}\n")[1].split("\n## ")[0]


def rows(title: str) -> list[tuple[str, str]]:
    """The first two columns of a table, without backticks."""
    found = re.findall(r"^\| (`.+?) \| (.+?) \|", section(title), re.MULTILINE)
    return [(first.strip("`"), second.strip("`")) for first, second in found]


AREA = "def area(a, b):\n    return a * b\n\n\n"
COMMAND_ROWS = rows("Commands")
VALUE_ROWS = rows("Values")


def program_around(line: str) -> str:
    if line.startswith("return"):
        return f"def area(a, b):\n    {line}\n"
    if line in ("break", "continue"):
        return f"{AREA}while True:\n    {line}\n"
    body = "\n    robot.stop()" if line.endswith(":") else ""
    return f"{AREA}{line}{body}\n"


def there_and_back(text: str) -> tuple[Any, str]:
    reading = read_python(text)
    assert reading.faults == ()
    assert reading.document is not None
    return reading.document, write_python(reading.document).text


def kinds_in(value: Any) -> set[str]:
    """Actions, operators, sensors and other kinds of expression in a document."""
    if isinstance(value, list):
        return set().union(*map(kinds_in, value))
    if not isinstance(value, dict):
        return set()
    own = {value[key] for key in ("action", "op", "sensor") if key in value}
    own |= {key for key in ("var", "gesture", "call") if key in value}
    return own.union(*map(kinds_in, value.values()))


def test_the_page_lists_every_command_in_the_order_of_the_language() -> None:
    assert [action for _, action in COMMAND_ROWS] == action_names()


def test_the_page_lists_every_operator_and_sensor() -> None:
    kinds = [kind for _, kind in VALUE_ROWS]
    assert {*OPERATORS, *SENSORS, "var", "gesture", "call"} <= set(kinds)
    assert len(set(kinds)) == len(kinds)


@pytest.mark.parametrize(("line", "action"), COMMAND_ROWS)
def test_a_command_is_read_and_written_as_on_the_page(line: str, action: str) -> None:
    text = program_around(line)
    document, written = there_and_back(text)
    assert written == text
    assert action in kinds_in(document)


@pytest.mark.parametrize(("value", "kind"), VALUE_ROWS)
def test_a_value_is_read_and_written_as_on_the_page(value: str, kind: str) -> None:
    text = f"{AREA}x = {value}\n"
    document, written = there_and_back(text)
    assert written == text
    literals = {"number": float, "text": str, "boolean": bool, "list": list}
    given = document["commands"][0]["value"]
    assert isinstance(given, literals[kind]) if kind in literals else kind in kinds_in(given)


@pytest.mark.parametrize(("name", "python"), rows("Names"))
def test_a_name_is_written_as_on_the_page(name: str, python: str) -> None:
    assert python_name(name) == python
    assert program_name(python) == name


@pytest.mark.parametrize(("written", "read_as"), rows("Further accepted forms"))
def test_another_spelling_is_read_as_on_the_page(written: str, read_as: str) -> None:
    value = written == "-x"
    text, expected = (program_around(f"z = {w}" if value else w) for w in (written, read_as))
    assert there_and_back(text)[1] == expected


@pytest.mark.parametrize("example", re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL))
def test_the_examples_of_the_page_are_programs_in_their_normal_form(example: str) -> None:
    assert there_and_back(example)[1] == example


@pytest.mark.parametrize("form", [*COMMANDS.values(), *SENSOR_CALLS.values(), ASK])
def test_the_examples_shown_to_people_stand_on_the_page(form: Any) -> None:
    assert f"`{form.example}`" in PAGE
