"""Examples: finished programs that a group opens as copies, to run and to modify them."""

import json
from functools import cache
from importlib import resources

from pinel_desktop.activities.goals import GOAL_FILE, Goal
from pinel_desktop.activities.model import Activity
from pinel_desktop.activities.reading import solution_of
from pinel_desktop.messages.content import program_in_language, with_texts
from pinel_desktop.program.python_text import read_python
from pinel_desktop.program.reading import ParseResult, read_document

_CATALOGUE = resources.files(__name__.rpartition(".")[0]) / "example_catalogue"

# in the order of the page
EXAMPLES = (
    "flower_of_arcs",
    "spiral",
    "vacuum_cleaner",
    "dice",
    "snail",
    "dance_of_signs",
    "line_follower",
    "snowflake",
    "guessing_game",
    "shy",
    "board_game",
    "board_game_alone",
)
# examples whose program is the solution of a mission
_SOLUTIONS = {"board_game": "two_teams"}


@cache
def example(name: str) -> Activity:
    """Returns an example: an activity without checks.

    Its only case has the inputs of its picture; its `story` is one sentence.
    """
    document = json.loads((_CATALOGUE / name / "example.json").read_text("utf-8"))
    return Activity.model_validate(with_texts(document, "examples"))


@cache
def program_of_example(name: str, language: str) -> ParseResult:
    """Returns the program of an example, with names and texts in `language`."""
    if name in _SOLUTIONS:
        source = solution_of(_SOLUTIONS[name])
    else:
        source = read_python((_CATALOGUE / name / "program.py").read_text("utf-8")).result.document
    assert source is not None, name
    return read_document(program_in_language(source, language))


@cache
def example_picture(name: str) -> Goal:
    """Returns the drawing or the path of an example's program, which `python -m scripts.reference` generates."""
    return Goal.model_validate_json((_CATALOGUE / name / GOAL_FILE).read_text("utf-8"))
