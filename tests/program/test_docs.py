import json
import re
from pathlib import Path

from pinel_desktop.execution.primitives import TABLE
from pinel_desktop.program.expressions import Model
from pinel_desktop.program.model import COMMANDS, action_names
from pinel_desktop.program.reading import read_document

PAGE = (Path(__file__).parents[2] / "docs" / "program-document.md").read_text("utf-8")
ROWS = dict(re.findall(r"^\| `(\w+)` \| (.*?) \|", PAGE, re.MULTILINE))
OF_EVERY_COMMAND = {"action", "block", "comment"}


def test_the_page_lists_every_action_with_its_parameters() -> None:
    assert list(ROWS) == action_names()
    models: tuple[type[Model], ...] = COMMANDS
    for action, model in zip(action_names(), models, strict=True):
        parameters = {field.alias or name for name, field in model.model_fields.items()}
        assert parameters - OF_EVERY_COMMAND <= set(re.findall(r"`(\w+)`", ROWS[action])), action


def test_every_action_has_a_primitive_and_every_primitive_an_action() -> None:
    assert set(TABLE) == set(action_names())


def test_the_example_on_the_page_is_a_program() -> None:
    example = re.search(r"```json\n(.*?)```", PAGE, re.DOTALL)
    assert example is not None
    assert read_document(json.loads(example[1])).faults == ()
