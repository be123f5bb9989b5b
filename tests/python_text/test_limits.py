"""The round trip of the largest programs allowed."""

import json
from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.program.limits import MAX_COMMANDS, MAX_LIST, MAX_NESTING
from pinel_desktop.program.python_text import read_python, write_python
from pinel_desktop.program.reading import read_document
from tests.python_text.languages import normal

Wrap = Callable[[Any], Any]


def come_back(*commands: Any) -> None:
    document = {"pinel_ir": 1, "commands": list(commands)}
    read = read_document(document)
    assert read.faults == ()
    assert read.document is not None
    reading = read_python(write_python(read.document).text)
    assert reading.faults == ()
    assert normal(json.loads(json.dumps(reading.document))) == normal(document)


def deepest(wrap: Wrap, around: Wrap, innermost: Any) -> Any:
    """As many times wrapped as a document allows."""
    value, allowed = innermost, innermost
    for _ in range(MAX_NESTING + 2):
        command = around(value)
        if read_document({"pinel_ir": 1, "commands": [command]}).faults:
            break
        allowed, value = command, wrap(value)
    assert isinstance(allowed, dict)
    return allowed


def set_x(value: Any) -> Any:
    return {"action": "set_variable", "name": "x", "value": value}


def op(name: str, *args: Any) -> Any:
    return {"op": name, "args": list(args)}


@pytest.mark.parametrize(
    "wrap",
    [
        lambda value: op("-", 1, value),
        lambda value: op("-", value, 1),
        lambda value: op("**", value, 2),
        lambda value: op("abs", value),
        lambda value: op("*", op("+", 1, value), 2),
    ],
)
def test_the_deepest_numbers_come_back(wrap: Wrap) -> None:
    come_back(deepest(wrap, set_x, {"var": "y"}))


@pytest.mark.parametrize(
    "wrap", [lambda value: op("not", value), lambda value: op("and", True, op("or", value, False))]
)
def test_the_deepest_conditions_come_back(wrap: Wrap) -> None:
    come_back(deepest(wrap, set_x, {"var": "y"}))


@pytest.mark.parametrize(
    "wrap",
    [
        lambda command: {"action": "repeat", "times": 2, "commands": [command]},
        lambda command: {
            "action": "conditional_execution",
            "condition": True,
            "commands": [],
            "else": [command],
        },
    ],
)
def test_the_deepest_commands_come_back(wrap: Wrap) -> None:
    come_back(deepest(wrap, lambda command: command, {"action": "stop"}))


def test_the_longest_lists_and_joined_conditions_come_back() -> None:
    come_back(set_x([-1.5] * MAX_LIST), set_x(op("and", *[True] * MAX_LIST)))


def test_thousands_of_branches_come_back() -> None:
    branches = [{"condition": op("==", {"var": "x"}, i), "commands": []} for i in range(5000)]
    last = {"else": [{"action": "stop"}]}
    condition = {"action": "conditional_execution", "condition": True, "commands": []}
    come_back({**condition, "elif": branches, **last})


def test_the_most_commands_come_back() -> None:
    come_back(*[{"action": "turn", "angle": i % 360} for i in range(MAX_COMMANDS)])
