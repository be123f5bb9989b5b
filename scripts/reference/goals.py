"""Generates the pictures of activities and examples: `goal.json` of each shipped one."""

import json

from pinel_desktop.activities import (
    EXAMPLES,
    Goal,
    activity_names,
    check_program,
    choose_activity,
    example,
    goal_of,
    program_of_example,
    solution_of,
)
from pinel_desktop.messages import SOURCE_LANGUAGE
from pinel_desktop.program.reading import read_document


def goals() -> dict[str, str]:
    """Returns the text of each file by its path from the repository's root."""
    folder = "pinel_desktop/activities"
    of_activities = {
        f"{folder}/catalogue/{name}/goal.json": _text(_goal(name)) for name in activity_names()
    }
    of_examples = {
        f"{folder}/example_catalogue/{name}/goal.json": _text(_picture(name)) for name in EXAMPLES
    }
    return of_activities | of_examples


def _picture(name: str) -> Goal:
    return goal_of(example(name), program_of_example(name, SOURCE_LANGUAGE))


def _goal(name: str) -> Goal:
    activity, document = choose_activity(name), solution_of(name)
    solution = read_document(document) if document is not None else None
    if solution is not None and not check_program(activity, solution).passed:
        raise SystemExit(f"solution.py of the activity {name} does not pass it")
    return goal_of(activity, solution)


def _text(goal: Goal) -> str:
    return json.dumps(goal.model_dump(), ensure_ascii=False) + "\n"
