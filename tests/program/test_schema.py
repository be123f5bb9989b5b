from typing import Any

import jsonschema_rs
import pytest

from scripts.reference import schemas
from tests.program.test_language import COMMANDS, document


@pytest.fixture(scope="module")
def validator() -> jsonschema_rs.Draft202012Validator:
    return jsonschema_rs.Draft202012Validator(schemas.of_programs())


def test_the_schema_takes_what_the_models_take(
    validator: jsonschema_rs.Draft202012Validator,
) -> None:
    trees = [c for c in COMMANDS if not isinstance(c.get("condition"), str)]
    assert [str(error) for error in validator.iter_errors(document(*trees))] == []


@pytest.mark.parametrize(
    "command",
    [
        {"action": "fly"},
        {"action": "move_forward", "distance": 101},
        {"action": "move_forward", "distance": True},
        {"action": "turn", "angle": {"what": 1}},
        {"action": "mark", "symbol": "Z"},
        {"action": "stop", "speed": 1},
        {"action": "say", "text": {"sensor": "sonar", "index": 16}},
    ],
)
def test_the_schema_refuses_what_the_models_refuse(
    validator: jsonschema_rs.Draft202012Validator, command: Any
) -> None:
    assert not validator.is_valid(document(command))
