"""What the teacher's form proposes for a sample solution."""

from typing import Any

import pytest
from pydantic import TypeAdapter

from pinel_desktop.activities import Activity, proposal_for, trials
from pinel_desktop.activities.checks import KINDS, Check
from pinel_desktop.program.reading import read_document
from tests.activities.test_checks import HELLO, MARK, PEN, activity, move, turn

FINISHED = {"check": "finished"}
SQUARE = {"action": "repeat", "times": 4, "commands": [move(1), turn(90)]}


def proposed(mission: Activity, *commands: dict[str, Any]) -> dict[str, dict[str, Any]]:
    reading = read_document({"pinel_ir": 1, "commands": list(commands)})
    return {one["check"]: one for one in proposal_for(mission, reading).checks}


def test_numbers_are_those_of_the_solution() -> None:
    found = proposed(activity(FINISHED, world="empty_room"), PEN, SQUARE)
    assert found["path_length"] == {"check": "path_length", "at_least_m": 3.8, "at_most_m": 4.2}
    assert found["turned_total"]["at_least_deg"] == 350
    assert found["turned_total"]["at_most_deg"] == 370
    assert found["block_count"]["at_most"] == 4
    assert found["closed"]["within_m"] == 0.05
    assert (found["draws"]["of"], found["draws"]["scale"]) == ("trail", False)
    assert found["time"]["at_most_s"] == pytest.approx(1.5 * 18, abs=6)
    assert "nesting" in found


def test_what_the_solution_does_not_do_is_not_proposed() -> None:
    found = proposed(activity(FINISHED, world="empty_room"), move(1))
    never = {"ends_in", "visits", "closed", "turned_total", "nesting", "says", "mark_count"}
    assert not found.keys() & never
    assert found["draws"]["of"] == "path"


def test_each_kind_of_the_form_is_proposed_as_a_check_that_its_solution_passes() -> None:
    mission = activity(FINISHED)
    commands: list[dict[str, Any]] = [PEN, {**SQUARE, "times": 1}, MARK, HELLO]
    found = proposed(mission, *commands)
    assert found.keys() == {name for name, kind in KINDS.items() if kind.form is not None}
    del found["closed"]  # this line is open
    checks = [TypeAdapter(Check).validate_python(one) for one in found.values()]
    solution = {"pinel_ir": 1, "name": "", "functions": [], "commands": commands}
    made = mission.model_copy(update={"checks": checks, "solution": solution})
    of_solution, of_empty = trials(made, ("ideal",))
    assert of_solution.texts == {}
    assert of_solution.passed
    assert not of_empty.passed
