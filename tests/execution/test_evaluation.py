from typing import Any

import pytest

from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.evaluation import evaluate
from pinel_desktop.execution.gestures import ScriptedGestures
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import PIONEER_3DX


def value_of(condition: Any, gesture: str) -> object:
    program = read_document(
        [{"action": "conditional_execution", "condition": condition, "commands": []}]
    ).program
    assert program is not None
    context = RunContext(PIONEER_3DX, 0.0, ScriptedGestures(), lambda _event: None)
    context.gesture_result = gesture
    return evaluate(program.commands[0].condition, context)  # type: ignore[union-attr]


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
        ({"op": "==", "args": [True, 1]}, "", False),
        (True, "", True),
    ],
)
def test_conditions_mean_what_the_language_says(condition: Any, gesture: str, value: bool) -> None:
    assert value_of(condition, gesture) is value
