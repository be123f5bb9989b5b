import math
import subprocess
import sys
from typing import Any

import pytest

from sim.world import WorldError, list_worlds, load_world, world_from_document


def test_the_default_world_is_an_empty_room_of_8_by_8_metres_with_the_start_in_its_middle() -> None:
    first = list_worlds()[0]
    assert first["name"] == "empty_room"
    assert first["size_m"] == [8, 8]
    assert load_world("empty_room").start == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("document", list_worlds(), ids=lambda d: d["name"])
def test_every_world_that_ships_is_closed(
    document: dict[str, Any],
) -> None:
    world = world_from_document(document)
    width, height = document["size_m"]
    corners = [(s * width / 2, t * height / 2) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    outer = {wall.start for wall in world.walls[:4]}
    assert outer == set(corners)
    assert all(wall.end in outer for wall in world.walls[:4])


def test_box_corners_turn_with_its_heading() -> None:
    box = world_from_document(
        {
            "name": "one",
            "start": {"x_m": 0, "y_m": 0, "heading_deg": 90},
            "walls": [],
            "boxes": [{"center": [1, 0], "size": [2, 1], "heading_deg": 90}],
        }
    ).boxes[0]
    assert box.corners()[0] == pytest.approx((1.5, -1.0))


def test_worlds_that_ship_are_told_without_loading_what_takes_long() -> None:
    """The app starts with them."""
    code = "import sys, sim.world; sim.world.list_worlds(); print({'numpy', 'pydantic'} & {*sys.modules})"
    printed = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert printed.stdout.strip() == "set()"


def test_boxes_are_fixed_unless_they_are_said_to_be_movable() -> None:
    place = {"center": [1, 0], "size": [0.4, 0.4]}
    boxes = world_from_document(
        {
            "name": "two",
            "start": {"x_m": 0, "y_m": 0, "heading_deg": 0},
            "walls": [],
            "boxes": [place, {**place, "movable": True, "mass_kg": 3}],
        }
    ).boxes
    assert [(box.movable, box.mass_kg) for box in boxes] == [(False, 2.0), (True, 3.0)]


def test_unknown_world_names_those_there_are() -> None:
    for name in ("nowhere", "../worlds/empty_room", "", "a" * 1000):
        with pytest.raises(WorldError) as caught:
            load_world(name)
        assert caught.value.code == "unknown_world"
        assert "empty_room" in str(caught.value.params["allowed"])


@pytest.mark.parametrize(
    "broken",
    [
        {"walls": [{"from": [0, 0]}]},
        {"walls": [{"from": [0, 0, 0], "to": [1, 1]}]},
        {"walls": [{"from": [0, math.nan], "to": [1, 1]}]},
        {"boxes": [{"center": ["x", 0], "size": [1, 1]}]},
        {"start": {}},
    ],
)
def test_broken_world_is_an_error_that_says_where(broken: dict[str, Any]) -> None:
    whole = {
        "name": "broken",
        "start": {"x_m": 0, "y_m": 0, "heading_deg": 0},
        "walls": [],
        "boxes": [],
    }
    with pytest.raises(WorldError) as caught:
        world_from_document({**whole, **broken})
    assert caught.value.code == "world_invalid"
    assert caught.value.params["world"] == "broken"
