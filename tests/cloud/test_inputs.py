"""What the robots of a cloud read, and where they start."""

from typing import Any

import pytest

from pinel_desktop.activities import Activity, choose_activity
from pinel_desktop.cloud.inputs import inputs_of
from pinel_desktop.errors import PinelError
from pinel_desktop.runs.fixed_inputs import FixedInputs

ASKS = {"pinel_ir": 1, "commands": [{"action": "ask", "question": "?", "variable": "d"}]}
DRIVES = {"pinel_ir": 1, "commands": [{"action": "move_forward", "distance": 1}]}
EVENTS: list[dict[str, Any]] = [
    {"type": "asked", "tick": 3, "question": "?"},
    {"type": "answered", "tick": 3, "value": 4},
]


def case(name: str, number: int) -> Activity:
    activity = choose_activity(name)
    return activity.model_copy(update={"cases": [activity.cases[number - 1]]})


def test_a_mission_gives_the_signs_and_answers_of_its_case() -> None:
    assert inputs_of(ASKS, case("polygon", 2), None) == FixedInputs(answers=("5",))
    assert inputs_of(ASKS, case("sign_b", 3), lambda: EVENTS) == FixedInputs(gestures=("",))


def test_without_those_a_program_reads_what_people_gave_in_a_run() -> None:
    given = FixedInputs.of_run(EVENTS)
    assert inputs_of(ASKS, None, lambda: EVENTS) == given
    assert inputs_of(ASKS, case("stop_before_wall", 2), lambda: EVENTS) == given
    with pytest.raises(PinelError, match="cloud_needs_inputs"):
        inputs_of(ASKS, None, None)


def test_a_program_that_reads_nothing_needs_no_run() -> None:
    assert inputs_of(DRIVES, None, None) == FixedInputs()
