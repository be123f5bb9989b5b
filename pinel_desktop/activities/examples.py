"""Examples: finished programs that a group opens as copies, to run and to modify them."""

import json
from functools import cache
from importlib import resources

from pinel_desktop.activities.goals import GOAL_FILE, Goal
from pinel_desktop.activities.model import Activity
from pinel_desktop.messages.content import with_texts
from pinel_desktop.program.python_text import read_python
from pinel_desktop.program.reading import ParseResult

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


@cache
def example(name: str) -> Activity:
    """Returns an example: an activity without checks.

    Its only case has the inputs of its picture; its `story` is one sentence.
    """
    document = json.loads((_CATALOGUE / name / "example.json").read_text("utf-8"))
    return Activity.model_validate(with_texts(document, "examples"))


@cache
def program_of_example(name: str, language: str) -> ParseResult:
    """Returns the program of an example.

    Its names and texts are in `language` if the example ships in that language, else in Portuguese.
    """
    folder = _CATALOGUE / name
    of_language = folder / f"program.{language}.py"
    file = of_language if of_language.is_file() else folder / "program.py"
    reading = read_python(file.read_text("utf-8")).result
    assert reading.document is not None, f"{file}: {reading.faults}"
    return reading


@cache
def example_picture(name: str) -> Goal:
    """Returns the drawing or the path of an example's program, which `python -m scripts.reference` generates."""
    return Goal.model_validate_json((_CATALOGUE / name / GOAL_FILE).read_text("utf-8"))
