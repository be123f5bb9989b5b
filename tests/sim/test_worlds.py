"""The worlds that ship: room for the robot, and something to do in each."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pinel_desktop.execution.executor import execute
from pinel_desktop.links.sim import SimLink
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.messages.content import titled, world_titles
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import PIONEER_3DX, SimulationConfig
from sim.floor import color_at, zone_at
from sim.geometry import distances_to_boxes, distances_to_segments
from sim.parsing import read_world
from sim.world import WALL_RADIUS_M, World, list_worlds, load_world

PROGRAMS = Path(__file__).parents[1] / "programs"
STEP_M = 0.05


def names() -> list[str]:
    return [document["name"] for document in list_worlds()]


def test_there_are_at_least_eight_each_under_its_file_s_name_with_titles_of_its_own() -> None:
    assert len(names()) >= 8
    files = {path.stem for path in (Path(__file__).parents[2] / "sim" / "worlds").glob("*.json")}
    assert set(names()) == files
    for language in LANGUAGES:
        assert len({titled(document)["title"][language] for document in list_worlds()}) == len(
            names()
        )
        assert set(world_titles(language)) == files


def test_they_are_listed_from_first_steps_to_projects() -> None:
    assert names()[:3] == ["empty_room", "tic_tac_toe", "obstacles"]
    assert names()[-2:] == ["classroom", "furnished_room"]


def test_no_name_is_that_of_a_version_s_own_world() -> None:
    assert "own" not in names()


@pytest.mark.parametrize("document", list_worlds(), ids=lambda d: d["name"])
def test_a_pioneer_has_a_hand_s_breadth_of_room_at_the_start(document: dict[str, Any]) -> None:
    assert read_world(document, robot_radius_m=PIONEER_3DX.radius_m + 0.1).faults == ()


@pytest.mark.parametrize("document", list_worlds(), ids=lambda d: d["name"])
def test_worlds_start_with_the_robot_looking_along_x(document: dict[str, Any]) -> None:
    """So that the axes of the scene, which are those of the start, run as in mathematics."""
    assert document["start"]["heading_deg"] == 0


@pytest.mark.parametrize("name", names())
def test_a_pioneer_can_reach_every_zone(name: str) -> None:
    world = load_world(name)
    reached = reachable(world)
    assert {zone.name for zone in world.zones} <= {zone_at(world.zones, x, y) for x, y in reached}


@pytest.mark.parametrize("name", names())
def test_every_zone_can_be_told_by_the_robot_in_its_middle(name: str) -> None:
    world = load_world(name)
    for zone in world.zones:
        center = zone.shape.center
        assert zone_at(world.zones, *center) == zone.name


def test_some_program_of_the_tests_is_driven_in_every_world() -> None:
    values = [json.loads(path.read_text("utf-8")) for path in PROGRAMS.glob("*.values.json")]
    assert {value.get("world", "empty_room") for value in values} == set(names())


def test_pushed_boxes_end_in_their_places() -> None:
    link = SimLink(world="pushing", setting=SimulationConfig(), seed=0)
    program = read_document((PROGRAMS / "push_the_boxes.json").read_bytes()).program
    assert program is not None
    assert execute(program, link).ended.state == "finished"
    zones = load_world("pushing").zones
    places = [zone_at(zones, x, y) for x, y, _ in link.simulator.boxes().values()]
    assert places == ["A", "B", "C"]


def test_the_line_is_one_closed_band() -> None:
    """Walks around it in its middle: black, or the colour of a station, and white on both sides."""
    world = load_world("lines")
    colors = [color_at(world.floor, *point) for point in line_middle(0.0)]
    assert set(colors) == {"black", "red", "blue", "orange", "purple"}
    for side in (-0.2, 0.2):
        assert {color_at(world.floor, *point) for point in line_middle(side)} == {"white"}


def line_middle(side: float) -> list[tuple[float, float]]:
    """Points around a rectangle of 6 x 3.4 m with corners of 1.1 m, moved outwards by `side`."""
    radius = 1.1 + side
    angles = [math.radians(degrees + 0.5) for degrees in range(0, 360, 5)]
    turns = [(math.cos(angle), math.sin(angle)) for angle in angles]
    corners = [
        (math.copysign(1.9, x) + radius * x, math.copysign(0.6, y) + radius * y) for x, y in turns
    ]
    pairs = zip(corners, [*corners[1:], corners[0]], strict=True)
    return [
        (x + (to_x - x) * part / 40, y + (to_y - y) * part / 40)
        for (x, y), (to_x, to_y) in pairs
        for part in range(40)
    ]


def has_room(point: tuple[float, float], walls: Any, corners: Any) -> bool:
    here = np.array(point)
    to_walls = distances_to_segments(here, walls).min()
    to_boxes = distances_to_boxes(here, corners).min(initial=math.inf)
    return bool(min(to_walls - WALL_RADIUS_M, to_boxes) > PIONEER_3DX.radius_m)


def reachable(world: World) -> set[tuple[float, float]]:
    """Points of a grid that a Pioneer gets to without touching anything, by flooding from the start."""
    walls = np.array([(wall.start, wall.end) for wall in world.walls])
    corners = np.array([box.corners() for box in world.boxes]).reshape(-1, 4, 2)
    x0, y0, _ = world.start
    free: set[tuple[int, int]] = set()
    ahead, known = [(0, 0)], {(0, 0)}
    while ahead:
        i, j = ahead.pop()
        if not has_room((x0 + i * STEP_M, y0 + j * STEP_M), walls, corners):
            continue
        free.add((i, j))
        near = {(i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)} - known
        known |= near
        ahead += near
    return {(x0 + i * STEP_M, y0 + j * STEP_M) for i, j in free}
