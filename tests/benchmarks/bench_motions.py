"""Where arcs and straight motions end on an empty floor: the figures of docs/control.md.

These are no ratios: the figures do not depend on the PC.
"""

import math
from collections.abc import Iterator
from random import Random
from typing import Any, NamedTuple

import pytest

from pinel_desktop.events.model import BlockEnded, BlockStarted, Event, Telemetry
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import SMALL_ROBOT, Pose2D, SimulationConfig

IDEAL, REALISTIC = SimulationConfig(), SimulationConfig(preset="realistic")
FLOOR = {
    "name": "floor",
    "start": {"x_m": 0, "y_m": 0, "heading_deg": 0},
    "walls": [],
    "boxes": [],
}
RADII_M = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, -0.1, -1.0, -5.0)
ANGLES = (30, 90, 180, 360, 720, -30, -180, -720)
SEEDS = range(3)
N_PROGRAMS = 180
SETTINGS = {
    "ideal": IDEAL,
    "camera": REALISTIC,
    "wheels": SimulationConfig(preset="realistic", feedback="odometry"),
    "small, camera": SimulationConfig(SMALL_ROBOT.name, "realistic"),
    "small, wheels": SimulationConfig(SMALL_ROBOT.name, "realistic", "odometry"),
}
Command = dict[str, Any]


class Miss(NamedTuple):
    """How far a motion ended from its goal, in the frame of the goal."""

    along_mm: float
    across_mm: float
    degrees: float


class Motion(NamedTuple):
    """A motion with where the robot was at its end: by its own estimate, and truly; and its goal."""

    action: str
    estimated: Pose2D
    true: Pose2D
    goal: Pose2D


def driven(commands: list[Command], setting: SimulationConfig, seed: int) -> list[Event]:
    """What happens in a program, which must finish."""
    program = read_document({"pinel_ir": 1, "commands": commands}).program
    assert program is not None
    log: list[Event] = []
    link = open_link("sim", world=FLOOR, setting=setting, seed=seed)
    options = RunOptions(
        observer=lambda _tick, event: log.append(event), seed=seed, robot=setting.robot
    )
    ended = execute(program, link, options).ended
    assert ended.state == "finished", (ended.reason, ended.params, commands)
    return log


def motions(log: list[Event]) -> Iterator[Motion]:
    action, last = "", None
    for event in log:
        if isinstance(event, BlockStarted):
            action = event.action
        elif isinstance(event, Telemetry):
            last = event
        elif isinstance(event, BlockEnded) and last is not None:
            yield Motion(action, *poses_in(last))


def poses_in(tick: Telemetry) -> tuple[Pose2D, Pose2D, Pose2D]:
    assert tick.true_x_m is not None
    assert tick.true_y_m is not None
    assert tick.true_yaw_rad is not None
    return (
        Pose2D(tick.x_m, tick.y_m, tick.yaw_rad),
        Pose2D(tick.true_x_m, tick.true_y_m, tick.true_yaw_rad),
        Pose2D(tick.goal_x_m, tick.goal_y_m, tick.goal_yaw_rad),
    )


def miss(pose: Pose2D, goal: Pose2D) -> Miss:
    off = pose.relative_to(goal)
    return Miss(abs(off.x_m) * 1e3, abs(off.y_m) * 1e3, abs(math.degrees(off.yaw_rad)))


def worst(misses: list[Miss]) -> Miss:
    return Miss(*(max(column) for column in zip(*misses, strict=True)))


@pytest.mark.parametrize(
    ("setting", "seeds", "bounds"),
    [(IDEAL, range(1), Miss(0.02, 0.1, 0.003)), (REALISTIC, SEEDS, Miss(5.0, 10.0, 0.3))],
    ids=["ideal", "realistic"],
)
def test_arcs_end_where_they_should(setting: SimulationConfig, seeds: range, bounds: Miss) -> None:
    arcs = [(radius_m, angle) for radius_m in RADII_M for angle in ANGLES]
    misses = []
    for radius_m, angle in arcs:
        command = {"action": "arc", "radius": radius_m, "angle": angle}
        for seed in seeds:
            ticks = [one for one in driven([command], setting, seed) if isinstance(one, Telemetry)]
            _, true, goal = poses_in(ticks[-1])  # at rest
            misses.append(miss(true, goal))
    found = worst(misses)
    print(
        f"\n{len(misses)} drives of {len(arcs)} arcs of 0.1 to 5 m and 30 to 720 degrees, {setting.preset}, at most: "
        f"across {found.across_mm:.3f} mm, along {found.along_mm:.4f} mm, heading {found.degrees:.5f} degrees"
    )
    assert all(value < bound for value, bound in zip(found, bounds, strict=True))


def program_of(random: Random) -> list[Command]:
    makers = (
        lambda: {"action": "move_forward", "distance": random.uniform(0.05, 2.0)},
        lambda: {"action": "move_backward", "distance": random.uniform(0.05, 2.0)},
        lambda: {"action": "turn", "angle": random.uniform(-180, 180)},
        lambda: {
            "action": "arc",
            "radius": random.choice((-1, 1)) * random.uniform(0.1, 2.0),
            "angle": random.uniform(-360, 360),
        },
        lambda: {
            "action": "set_speed",
            "linear": random.uniform(0.1, 0.5),
            "angular": random.uniform(30, 90),
        },
    )
    return [random.choice(makers)() for _ in range(8)]


def test_without_an_obstacle_no_straight_motion_is_taken_for_one_that_slides() -> None:
    random, across_mm, n_lines = Random(24), 0.0, 0
    for number in range(N_PROGRAMS):
        setting = list(SETTINGS.values())[number % len(SETTINGS)]
        for motion in motions(driven(program_of(random), setting, number)):
            if motion.action in ("move_forward", "move_backward"):
                n_lines += 1
                across_mm = max(across_mm, miss(motion.estimated, motion.goal).across_mm)
    print(
        f"\n{n_lines} straight motions in {N_PROGRAMS} random programs, {len(SETTINGS)} robot settings: all finished, "
        f"across at the end at most {across_mm:.1f} mm by the robot's estimate; 100 would be blocked"
    )
    assert across_mm < 100.0
