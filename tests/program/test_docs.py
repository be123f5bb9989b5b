import json
import re
from pathlib import Path

from pinel_desktop.execution.primitives import TABLE
from pinel_desktop.program.base import Model, annotations
from pinel_desktop.program.model import COMMANDS, action_names
from pinel_desktop.program.operators import OPERATORS
from pinel_desktop.program.reading import read_document
from pinel_desktop.program.sensors import SENSORS

PAGE = (Path(__file__).parents[2] / "docs" / "program-document.md").read_text("utf-8")
SECTIONS = dict(re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", PAGE, re.MULTILINE | re.DOTALL))
ROWS = dict(re.findall(r"^\| `(\w+)` \| (.*?) \|", SECTIONS["Commands"], re.MULTILINE))
OF_EVERY_COMMAND = {"action", "block", "comment"}


def test_the_page_lists_every_action_with_its_parameters() -> None:
    assert list(ROWS) == action_names()
    models: tuple[type[Model], ...] = COMMANDS
    for action, model in zip(action_names(), models, strict=True):
        parameters = set(annotations(model))
        assert parameters - OF_EVERY_COMMAND <= set(re.findall(r"`(\w+)`", ROWS[action])), action


def test_every_action_has_a_primitive_and_every_primitive_an_action() -> None:
    assert set(TABLE) == set(action_names())


def test_the_page_lists_every_operator_and_sensor() -> None:
    page = SECTIONS["Expressions"]
    operators = re.findall(r"^\| ((?:`[^`]+` ?)+)\| (?!.*sensor)", page, re.MULTILINE)
    names = [name for row in operators for name in re.findall(r"`([^`{]+)`", row)]
    assert sorted(names) == sorted(OPERATORS)
    for sensor in SENSORS:
        assert f'"{sensor}"' in page or f"`{sensor}`" in page, sensor


def test_the_examples_on_the_page_are_read() -> None:
    program, function, *_ = re.findall(r"```json\n(.*?)```", PAGE, re.DOTALL)
    document = json.loads(program)
    assert read_document(document).faults == ()
    document["functions"] = [json.loads(function)]
    assert read_document(document).faults == ()
    for form in re.findall(r"^\| `(\{.*?\})` \|", SECTIONS["Expressions"], re.MULTILINE):
        command = {"action": "say", "text": json.loads(form)}
        found = read_document({**document, "commands": [command]}).faults
        assert [fault.code for fault in found] in ([], ["unknown_function"]), form
