"""The pictures of the activities' goals: `goal.json` of each shipped activity."""

import json

from pinel_desktop.activities import (
    activity_names,
    check_program,
    choose_activity,
    goal_of,
    solution_of,
)
from pinel_desktop.program.reading import read_document


def goals() -> dict[str, str]:
    """Text of each file by its path from the repository's root."""
    return {
        f"pinel_desktop/activities/catalogue/{name}/goal.json": _goal(name)
        for name in activity_names()
    }


def _goal(name: str) -> str:
    activity, document = choose_activity(name), solution_of(name)
    solution = read_document(document) if document is not None else None
    if solution is not None and not check_program(activity, solution).passed:
        raise SystemExit(f"solution.py of the activity {name} does not pass it")
    return json.dumps(goal_of(activity, solution).model_dump(), ensure_ascii=False) + "\n"
