"""Zones and painted areas of worlds, and the rays of sensors."""

import math
from typing import Any

import pytest

from pinel_desktop.robot import PIONEER_3DX
from sim.floor import Disc, Paint, Rectangle, Zone, color_at, zone_at
from sim.simulator import Simulator
from sim.world import WorldError, load_world, world_from_document

BARE: dict[str, Any] = {
    "name": "one",
    "start": {"x_m": 0, "y_m": 0, "heading_deg": 0},
    "walls": [],
}


def test_points_are_inside_up_to_the_edge() -> None:
    assert Disc((1, 0), 0.5).contains(1.5, 0)
    assert not Disc((1, 0), 0.5).contains(1.4, 0.4)
    box = Rectangle((0, 0), (2, 1), math.radians(90))
    assert box.contains(0.5, 1)
    assert not box.contains(1, 0.5)


def test_last_of_overlapping_areas_is_on_top() -> None:
    big, small = Rectangle((0, 0), (2, 2)), Disc((0, 0), 0.5)
    assert color_at([Paint("red", big), Paint("blue", small)], 0.1, 0) == "blue"
    assert color_at([Paint("red", big), Paint("blue", small)], 0.9, 0) == "red"
    assert color_at([], 0, 0) == "white"
    assert zone_at([Zone("A", big), Zone("B", small)], 0, 0) == "B"
    assert zone_at([Zone("A", small)], 3, 0) == ""


def test_world_may_have_zones_and_paint() -> None:
    world = world_from_document(
        {
            **BARE,
            "zones": [{"name": "A", "center": [0, 0], "size": [1, 1]}],
            "floor": [{"color": "green", "center": [0, 0], "radius": 0.3}],
        }
    )
    simulator = Simulator(world, PIONEER_3DX)
    assert (simulator.zone(), simulator.floor_color()) == ("A", "green")


@pytest.mark.parametrize(
    "broken",
    [
        {"zones": [{"name": "A", "center": [0, 0]}]},
        {"zones": [{"name": "", "center": [0, 0], "radius": 1}]},
        {"zones": [{"name": 7, "center": [0, 0], "radius": 1}]},
        {"zones": [{"center": [0, 0], "radius": 1}]},
        {"zones": [{"name": "A", "center": [0, math.nan], "radius": 1}]},
        {"zones": [{"name": "A", "center": [0, 0], "size": [1, -1]}]},
        {"floor": [{"color": "pink", "center": [0, 0], "radius": 1}]},
        {"floor": [{"color": "red", "center": [0, 0], "radius": 0}]},
        {"floor": [{"color": "red", "center": [0, 0], "radius": math.inf}]},
        {"floor": 3},
    ],
)
def test_broken_floor_is_an_error_that_says_where(broken: dict[str, Any]) -> None:
    with pytest.raises(WorldError) as caught:
        world_from_document({**BARE, **broken})
    assert (caught.value.code, caught.value.params["world"]) == ("world_invalid", "one")


def test_board_has_nine_cells_a_metre_apart_and_the_robot_starts_outside() -> None:
    world = load_world("tic_tac_toe")
    cells = {zone.name: zone.shape for zone in world.zones}
    assert list(cells) == list("ABCDEFGIL")
    x, y, _ = world.start
    assert zone_at(world.zones, x, y) == ""
    names = [[zone_at(world.zones, x + 1 + j, y - i) for j in range(3)] for i in range(3)]
    assert names == [list("ABC"), list("DEF"), list("GIL")]


def test_ray_hits_walls_and_boxes_and_never_the_robot() -> None:
    simulator = Simulator(load_world("obstacles"), PIONEER_3DX)
    assert simulator.ray(math.pi, 8) == pytest.approx(1 - 0.01)
    assert simulator.ray(0, 0.5) == 0.5
    # the box at (-1.5, 0), 1.2 x 0.8, seen from (-3, -2) at 45 degrees: its lower edge at y = -0.4
    assert simulator.ray(math.radians(45), 8) == pytest.approx(1.6 * math.sqrt(2), abs=1e-6)


def test_rays_turn_with_the_robot() -> None:
    simulator = Simulator(load_world("empty_room"), PIONEER_3DX)
    for _ in range(45):
        simulator.tick(0.0, 1.0)
    yaw = simulator.state()[2]
    assert simulator.ray(-yaw, 8) == pytest.approx(3.99, abs=1e-6)


def test_looking_does_not_change_what_happens() -> None:
    def drive(*, looking: bool) -> tuple[float, ...]:
        simulator = Simulator(load_world("obstacles"), PIONEER_3DX)
        for i in range(300):
            simulator.tick(0.7, 0.3)
            if looking:
                simulator.ray(i / 10, 5)
        return simulator.state()

    assert drive(looking=True) == drive(looking=False)
