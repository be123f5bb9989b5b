"""How much of the bare physics engine's speed is left when a program drives the robot.

Both sides step a space of the same bodies, shapes and joints along the same path. Not the same work: the bare side
has its wheel velocities given beforehand and measures nothing; ours reads the program, plans, controls, measures
the pose at every tick and keeps and hashes the telemetry.
"""

import statistics
import time
from collections.abc import Callable
from pathlib import Path

from pinel_desktop.execution.executor import RunResult, execute
from pinel_desktop.links import open_link
from pinel_desktop.links.sim import SimLink
from pinel_desktop.program.model import Program
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import SimulationConfig
from sim.simulator import SUBSTEP_S, SUBSTEPS

SQUARE = Path(__file__).parents[1] / "programs" / "square.json"
PAIRS, RUNS_A_SIDE = 15, 5
MIN_RATIO = 0.6


def ours(program: Program) -> RunResult:
    return execute(program, open_link("sim", world="empty_room"))


def wheel_velocities(result: RunResult) -> list[tuple[tuple[float, float], float]]:
    """The velocities that the run gave the kinematic body, tick by tick."""
    link, velocities = SimLink(world="empty_room", setting=SimulationConfig(), seed=0), []
    simulator, rows = link.simulator, result.telemetry.rows
    for i in range(0, len(rows), 8):
        simulator.tick(rows[i + 6], rows[i + 7])
        wheels = simulator.wheels
        velocities.append(((wheels.velocity.x, wheels.velocity.y), wheels.angular_velocity))
    return velocities


def bare(velocities: list[tuple[tuple[float, float], float]]) -> None:
    simulator = SimLink(world="empty_room", setting=SimulationConfig(), seed=0).simulator
    step, wheels = simulator.space.step, simulator.wheels
    for velocity, omega in velocities:
        wheels.velocity = velocity
        wheels.angular_velocity = omega
        for _ in range(SUBSTEPS):
            step(SUBSTEP_S)


def seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    for _ in range(RUNS_A_SIDE):
        work()
    return (time.perf_counter() - start) / RUNS_A_SIDE


def test_headless_square_keeps_most_of_the_speed_of_bare_pymunk() -> None:
    program = read_document(SQUARE.read_bytes()).program
    assert program is not None
    result = ours(program)
    velocities = wheel_velocities(result)
    pairs = [
        (seconds(lambda: ours(program)), seconds(lambda: bare(velocities))) for _ in range(PAIRS)
    ]
    ratio = statistics.median(b / a for a, b in pairs)
    mine, theirs = (statistics.median(side) for side in zip(*pairs, strict=True))
    robot_s = result.ended.duration_s
    print(f"\nsquare of 1 m, {robot_s:.1f} s of robot time, medians of {PAIRS} pairs")
    print(
        f"  this simulator, program and telemetry  {mine * 1e3:7.2f} ms  {robot_s / mine:7.0f} x real time"
    )
    print(
        f"  bare pymunk, same space, same path     {theirs * 1e3:7.2f} ms  {robot_s / theirs:7.0f} x real time"
    )
    print(f"  rate kept                              {ratio:7.2f}     at least {MIN_RATIO}")
    assert ratio >= MIN_RATIO
