import math
import random

import pytest

from pinel_desktop.robot import PIONEER_3DX
from sim.simulator import BOX_FRICTION, GRAVITY_MPS2, Simulator
from sim.world import MAX_MOVABLE_KG, MIN_MOVABLE_KG, MIN_MOVABLE_SIDE_M
from tests.sim.rooms import (
    box,
    boxes_depth_m,
    boxes_now,
    robot_depth_m,
    room,
)

RESTING_M, IMPACT_M = 0.0006, 0.006


def in_room(*boxes: dict[str, object], start: tuple[float, float, float] = (0, 0, 0)) -> Simulator:
    return Simulator(room(*boxes, start=start), PIONEER_3DX)


def test_pushed_box_moves_with_the_robot_and_stands_when_nobody_pushes() -> None:
    sim = in_room(box(0.6, 0.0, movable=True, mass_kg=2.0))
    for _ in range(45):
        sim.tick(0.6, 0.0)
    assert sim.boxes()[0][0] > 1.0
    assert sim.touching()
    for _ in range(6):
        sim.tick(-0.6, 0.0)
    left = sim.boxes()[0]
    for _ in range(30):
        sim.tick(-0.6, 0.0)
    assert sim.boxes()[0] == pytest.approx(left, abs=1e-9)


def test_box_pushed_off_its_middle_turns() -> None:
    sim = in_room(box(0.6, 0.12, movable=True, mass_kg=2.0))
    for _ in range(45):
        sim.tick(0.6, 0.0)
    assert sim.boxes()[0][2] > math.radians(5)


def test_box_nobody_touches_never_moves() -> None:
    sim = in_room(box(1.2, 1.2, movable=True, mass_kg=0.5))
    for _ in range(300):
        sim.tick(0.3, 2.0)
    assert sim.boxes() == {0: (1.2, 1.2, 0.0)}


def test_box_whose_friction_is_stronger_than_the_wheels_stays_where_it_is() -> None:
    heavy = 1.1 * PIONEER_3DX.max_force_n / (BOX_FRICTION * GRAVITY_MPS2)
    sim = in_room(box(0.6, 0.0, movable=True, mass_kg=heavy))
    for _ in range(120):
        sim.tick(0.6, 0.0)
    # the impact itself shifts it a little
    assert sim.boxes()[0][0] == pytest.approx(0.6, abs=0.1)
    assert abs(sim.state()[3]) < 1e-6


def test_only_movable_boxes_are_reported_by_their_place_in_the_world() -> None:
    sim = in_room(box(1.2, 1.2), box(-1.2, 1.2, movable=True))
    assert list(sim.boxes()) == [1]


def test_ray_sees_a_box_where_it_is_now() -> None:
    sim = in_room(box(0.6, 0.0, movable=True, mass_kg=2.0))
    before = sim.ray(0.0, 5.0)
    assert before == pytest.approx(0.4)
    for _ in range(60):
        sim.tick(0.6, 0.0)
    for _ in range(30):
        sim.tick(-0.6, 0.0)
    x, *_ = sim.state()
    assert sim.ray(0.0, 5.0) == pytest.approx(sim.boxes()[0][0] - 0.2 - x, abs=1e-3)


@pytest.mark.parametrize("size", [(0.4, 0.4), (0.1, 0.4), (MIN_MOVABLE_SIDE_M, 0.3)])
@pytest.mark.parametrize("mass_kg", [MIN_MOVABLE_KG, 1.0, 5.0, MAX_MOVABLE_KG])
def test_box_between_robot_and_wall_keeps_both_out(
    mass_kg: float, size: tuple[float, float]
) -> None:
    world = room(box(0.8, 0.0, size, movable=True, mass_kg=mass_kg))
    sim = Simulator(world, PIONEER_3DX)
    deepest = 0.0
    for _ in range(300):
        sim.tick(1.2, 0.0)
        depths = robot_depth_m(world, sim), boxes_depth_m(boxes_now(world, sim))
        deepest = max(deepest, *depths)
    assert deepest < IMPACT_M
    assert max(depths) < RESTING_M
    assert abs(sim.state()[3]) < 1e-6


def test_fixed_box_is_hit_and_leaned_on_like_a_wall() -> None:
    world = room(box(1.2, 0.1))
    sim = Simulator(world, PIONEER_3DX)
    deepest = 0.0
    for _ in range(120):
        sim.tick(1.2, 0.0)
        deepest = max(deepest, robot_depth_m(world, sim))
    assert deepest < IMPACT_M
    assert robot_depth_m(world, sim) < RESTING_M


def wild_drives(n_drives: int, seed: int) -> tuple[float, float]:
    """Drives at random among fixed and movable boxes; how deep robot and boxes ever lay in anything, in m."""
    draw, robots, boxes = random.Random(seed), 0.0, 0.0
    for _ in range(n_drives // 50):
        world = room(
            box(1.2, 0.0, movable=True, mass_kg=draw.uniform(MIN_MOVABLE_KG, MAX_MOVABLE_KG)),
            box(
                -1.2,
                0.6,
                (0.1, 0.6),
                movable=True,
                mass_kg=draw.uniform(MIN_MOVABLE_KG, MAX_MOVABLE_KG),
            ),
            box(0.0, -1.2, (0.5, 0.05), movable=True, mass_kg=draw.uniform(MIN_MOVABLE_KG, 5.0)),
            box(0.0, 1.3, (0.3, 0.3)),
            start=(0.0, 0.0, draw.uniform(-180, 180)),
        )
        sim = Simulator(world, PIONEER_3DX)
        for _ in range(50):
            v, omega = draw.choice((-1.2, -0.6, 0.6, 1.2)), draw.uniform(-3, 3)
            for _ in range(draw.randint(3, 30)):
                sim.tick(v, omega)
                robots = max(robots, robot_depth_m(world, sim))
                boxes = max(boxes, boxes_depth_m(boxes_now(world, sim)))
    return robots, boxes


# The robot turns a box about its own corner, which is then faster than the robot when it meets a wall.
WHIPPED_M = 0.015


def test_nothing_is_driven_through_in_500_wild_drives_among_boxes() -> None:
    robots, boxes = wild_drives(500, seed=1)
    assert robots < IMPACT_M
    assert boxes < WHIPPED_M


@pytest.mark.nightly
@pytest.mark.timeout(900)
def test_nothing_is_driven_through_in_10000_wild_drives_among_boxes() -> None:
    robots, boxes = wild_drives(10_000, seed=2)
    print(f"deepest: robot {robots * 1e3:.1f} mm, a box's corner {boxes * 1e3:.1f} mm")
    assert robots < IMPACT_M
    assert boxes < WHIPPED_M


def thrown(velocity: tuple[float, float], size: tuple[float, float] = (0.4, 0.4)) -> Simulator:
    """A box that is thrown as nobody can push it."""
    sim = in_room(box(1.2, 0.3, size, movable=True, mass_kg=1.0))
    (body,) = (body for body in sim.space.bodies if body.mass == 1.0)
    body.velocity = velocity
    return sim


@pytest.mark.parametrize("velocity", [(300.0, 0.0), (1e6, 1e5), (-700.0, 900.0)])
def test_even_a_box_that_is_thrown_at_a_wall_stays_in_the_room(
    velocity: tuple[float, float],
) -> None:
    sim = thrown(velocity)
    for _ in range(30):
        sim.tick(0.0, 0.0)
        assert all(abs(c) < 2.0 for c in sim.boxes()[0][:2])
    before = sim.boxes()[0]
    sim.tick(0.0, 0.0)
    assert sim.boxes()[0] == pytest.approx(before, abs=1e-3)


def thin_boxes(n_drives: int, seed: int) -> float:
    """How far from the room's middle the middle of a box ever came that no document may hold any more."""
    draw, farthest = random.Random(seed), 0.0
    for _ in range(n_drives):
        size = draw.choice([(0.02, 0.3), (0.02, 0.2), (0.03, 0.3), (0.02, 0.5), (0.02, 0.02)])
        mass = draw.choice([0.1, 0.1, 0.2, 2.0, 100.0])
        turned = draw.uniform(-180.0, 180.0)
        thin = box(1.4, draw.uniform(-0.2, 0.2), size, movable=True, mass_kg=mass)
        sim = in_room({**thin, "heading_deg": turned})
        for _ in range(40):
            v, omega = draw.choice((1.2, 1.2, -1.2)), draw.choice((0, 0, 0.35, -0.35, 1.7, 5.2))
            for _ in range(draw.choice((6, 15, 30, 60))):
                sim.tick(v, omega)
                farthest = max(farthest, *map(abs, sim.boxes()[0][:2]))
    return farthest


def test_no_thin_light_box_of_an_old_world_is_pushed_through_a_wall() -> None:
    assert thin_boxes(20, seed=1) < 2.0


@pytest.mark.nightly
@pytest.mark.timeout(900)
def test_no_thin_light_box_is_pushed_through_a_wall_in_1000_drives() -> None:
    assert thin_boxes(1000, seed=2) < 2.0


def test_boxes_move_the_same_again_to_the_bit() -> None:
    def poses() -> list[object]:
        sim = in_room(
            box(0.6, 0.1, movable=True, mass_kg=2.0), box(1.1, 0.0, movable=True, mass_kg=1.0)
        )
        states: list[object] = []
        for tick in range(200):
            sim.tick(0.8, math.sin(tick / 9))
            states.append((sim.state(), sim.boxes()))
        return states

    assert poses() == poses()
