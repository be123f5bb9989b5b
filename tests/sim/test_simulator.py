import math
import random

import pymunk
import pytest

from pinel_desktop.robot import PIONEER_3DX
from sim.simulator import SUBSTEP_S, TICK_S, Simulator
from sim.world import load_world

RADIUS = PIONEER_3DX.radius_m
WALL_X = 4.0 - 0.01  # inner face of the empty room's wall


def simulator(world: str = "empty_room") -> Simulator:
    return Simulator(load_world(world), PIONEER_3DX)


def drive(sim: Simulator, v: float, omega: float, seconds: float) -> None:
    for _ in range(round(seconds / TICK_S)):
        sim.tick(v, omega)


def test_robot_starts_where_the_world_says_at_rest() -> None:
    assert simulator("obstacles").state() == (-3.0, -2.0, 0.0, 0.0, 0.0)


def test_straight_drive_covers_speed_times_time() -> None:
    sim = simulator()
    drive(sim, 0.5, 0.0, 0.5)  # the wheels' limited force needs a moment to speed up
    start = sim.state()
    drive(sim, 0.5, 0.0, 2.0)
    x, y, yaw, v, omega = sim.state()
    assert x - start[0] == pytest.approx(1.0, abs=1e-9)
    assert (y, yaw, v, omega) == pytest.approx((0, 0, 0.5, 0), abs=1e-9)


def test_circle_closes_although_ticks_are_long() -> None:
    sim = simulator()
    omega = math.tau / 6.0
    drive(sim, 0.6, omega, 0.5)
    x0, y0, yaw0, *_ = sim.state()
    drive(sim, 0.6, omega, 6.0)
    x, y, yaw, *_ = sim.state()
    assert math.hypot(x - x0, y - y0) < 1e-6
    assert yaw - yaw0 == pytest.approx(math.tau)


def test_robot_stalls_at_a_wall_and_feels_it() -> None:
    sim = simulator()
    assert not sim.touching()
    drive(sim, 1.2, 0.0, 6.0)
    x, _, _, v, _ = sim.state()
    assert x + RADIUS == pytest.approx(WALL_X, abs=0.0006)
    assert abs(v) < 1e-6
    assert sim.touching()


def test_impact_at_full_speed_sinks_less_than_6_mm_into_the_wall() -> None:
    sim = simulator()
    deepest = 0.0
    for _ in range(200):
        sim.tick(1.2, 0.0)
        deepest = max(deepest, sim.state()[0] + RADIUS - WALL_X)
    assert deepest < 0.006


def test_blocked_robot_does_not_jump_when_it_turns_away() -> None:
    sim = simulator()
    drive(sim, 1.2, 0.0, 10.0)
    before = sim.state()
    drive(sim, 0.0, 1.0, 0.5)
    assert math.hypot(sim.state()[0] - before[0], sim.state()[1] - before[1]) < 0.01


def wild_drives(world: str, n_drives: int) -> tuple[float, float]:
    """The farthest from the middle that the robot comes in each direction, in m."""
    draw, farthest_x, farthest_y = random.Random(7), 0.0, 0.0
    for _ in range(n_drives // 30):
        sim = simulator(world)
        for _ in range(30):
            v, omega = draw.uniform(-1.2, 1.2), draw.uniform(-5, 5)
            drive(sim, v, omega, draw.uniform(0.1, 1.0))
            x, y, *_ = sim.state()
            farthest_x, farthest_y = max(farthest_x, abs(x)), max(farthest_y, abs(y))
    return farthest_x, farthest_y


ROOMS = {"empty_room": (4.0, 4.0), "obstacles": (4.0, 3.0)}


@pytest.mark.parametrize("world", ROOMS)
def test_no_wild_drive_leaves_the_room(world: str) -> None:
    assert_inside(wild_drives(world, 1200), ROOMS[world])


@pytest.mark.nightly
@pytest.mark.parametrize("world", ROOMS)
def test_none_of_10000_wild_drives_leaves_the_room(world: str) -> None:
    assert_inside(wild_drives(world, 10_000), ROOMS[world])


def assert_inside(farthest: tuple[float, float], half: tuple[float, float]) -> None:
    inner = [side - 0.01 - RADIUS + 0.006 for side in half]
    assert farthest[0] <= inner[0]
    assert farthest[1] <= inner[1]


def test_same_commands_give_the_same_numbers_to_the_bit() -> None:
    def numbers() -> list[tuple[float, ...]]:
        sim, draw = simulator("obstacles"), random.Random(3)
        rows: list[tuple[float, ...]] = []
        for _ in range(600):
            sim.tick(draw.uniform(-1.2, 1.2), draw.uniform(-3, 3))
            rows.append(sim.state())
        return rows

    assert numbers() == numbers()


def test_fast_calls_give_what_pymunk_gives_to_the_bit() -> None:
    ours, theirs = simulator("obstacles"), simulator("obstacles")

    def steps(number: int) -> None:
        for _ in range(number):
            theirs.space.step(SUBSTEP_S)

    theirs._steps = steps
    for tick in range(200):
        for sim in (ours, theirs):
            sim.tick(0.8, math.sin(tick / 20))
    assert ours.state() == theirs.state()
    x, y, yaw, *_ = ours.state()
    for degrees in range(-180, 180, 7):
        angle = math.radians(degrees)
        end = (x + 8.0 * math.cos(yaw + angle), y + 8.0 * math.sin(yaw + angle))
        hit = ours.space.segment_query_first(
            (x, y), end, 0.0, pymunk.ShapeFilter(mask=pymunk.ShapeFilter.ALL_MASKS() ^ 0b10)
        )
        assert hit is not None
        assert ours.ray(angle, 8.0) == hit.alpha * 8.0


def test_ray_that_meets_nothing_is_as_long_as_it_may_be() -> None:
    assert simulator().ray(0.3, 2.0) == 2.0
