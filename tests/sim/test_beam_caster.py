"""All beams at once give what single rays give."""

import math
import random

import pytest

from pinel_desktop.robot import PIONEER_3DX
from sim.simulator import Simulator
from sim.world import list_worlds, world_from_document
from tests.sim.rooms import box, room

BEAMS = tuple(math.radians(angle) for angle in range(-180, 180, 2))
WORLDS = {document["name"]: world_from_document(document) for document in list_worlds()}


def differences(sim: Simulator, seed: int) -> list[float]:
    """How far beams and rays differ in m, here and there on a wild drive."""
    draw, scan = random.Random(seed), sim.scanner(BEAMS)
    found = []
    for _ in range(60):
        v, omega = draw.uniform(-1.2, 1.2), draw.uniform(-4, 4)
        for _ in range(12):
            sim.tick(v, omega)
        rays = [sim.ray(angle, 4.0) for angle in BEAMS]
        found += [abs(a - b) for a, b in zip(scan(4.0), rays, strict=True)]
    return sorted(found)


@pytest.mark.parametrize("name", WORLDS)
def test_beams_see_what_rays_see_in_every_world(name: str) -> None:
    found = differences(Simulator(WORLDS[name], PIONEER_3DX), seed=4)
    # a beam that just misses the corner of something may see far behind it
    assert found[int(0.999 * len(found))] < 0.002
    assert sum(d > 0.002 for d in found) <= 0.001 * len(found)


def test_beams_see_boxes_where_they_are_now() -> None:
    world = room(
        box(0.7, 0.1, movable=True, mass_kg=1.0), box(-0.8, 0.0, movable=True), box(0.0, 1.3)
    )
    sim = Simulator(world, PIONEER_3DX)
    found = differences(sim, seed=9)
    assert any(math.dist(sim.boxes()[i][:2], world.boxes[i].center) > 0.05 for i in (0, 1))
    assert sum(d > 0.002 for d in found) <= 0.001 * len(found)


def test_beam_that_meets_nothing_is_as_long_as_it_may_be() -> None:
    sim = Simulator(WORLDS["empty_room"], PIONEER_3DX)
    assert sim.scanner(BEAMS)(1.5) == [1.5] * len(BEAMS)
