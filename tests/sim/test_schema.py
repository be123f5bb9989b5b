"""The published schema of worlds is of one mind with the reader."""

from typing import Any

import jsonschema_rs
import pytest

from scripts.reference import schemas
from sim.parsing import read_world
from sim.world import list_worlds
from tests.sim.test_parsing import BOX, DISC, world


@pytest.fixture(scope="module")
def validator() -> jsonschema_rs.Draft202012Validator:
    return jsonschema_rs.Draft202012Validator(schemas.of_worlds())


@pytest.mark.parametrize("document", [*list_worlds(), world()], ids=lambda d: d["name"])
def test_worlds_and_their_normal_forms_keep_to_the_schema(
    validator: jsonschema_rs.Draft202012Validator, document: dict[str, Any]
) -> None:
    normal = read_world(document, robot_radius_m=0.25).document
    for form in (document, normal):
        assert [str(error) for error in validator.iter_errors(form)] == []


@pytest.mark.parametrize(
    "parts",
    [
        {"pinel_world": 2},
        {"boxes": [{**BOX, "movable": True, "mass_kg": 0.4}]},
        {"boxes": [{**BOX, "movable": True, "mass_kg": 21}]},
        {"boxes": [{**BOX, "movable": True, "size": [0.4, 0.04]}]},
        {"title": 7},
        {"title": {"en": "Room", "es": "Sala"}},
        {"title": {"pt-BR": "Sala", "en": "Room", "es": "Sala", "PT_br": "Sala"}},
        {"size_m": [6]},
        {"colour": "red"},
        {"walls": [{"from": [0, 0]}]},
        {"walls": [{"from": [1, 1], "to": [1, 2]}] * 501},
        {"boxes": [{**BOX, "movable": 1}]},
        {"boxes": [{**BOX, "mass_kg": 101}]},
        {"zones": [{"name": " ", **DISC}]},
        {"zones": [{"name": "A", **DISC, **BOX}]},
        {"zones": [{"name": "A", "center": [0, 0]}]},
        {"floor": [{"color": "pink", **DISC}]},
    ],
    ids=str,
)
def test_the_schema_refuses_what_the_reader_refuses(
    validator: jsonschema_rs.Draft202012Validator, parts: dict[str, Any]
) -> None:
    assert not validator.is_valid(world(**parts))
    assert read_world(world(**parts), robot_radius_m=0.25).faults
