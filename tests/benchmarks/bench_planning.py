"""go_to with avoid in the maze: how good its way is, and what planning costs.

The same grid search without its estimate of the rest (Dijkstra's algorithm) is the bare baseline; the shortest way that
the robot fits through at all is the measure of the way.
"""

import math
import statistics
import time
from collections.abc import Callable, Generator
from itertools import pairwise

from pinel_desktop.control import planning
from pinel_desktop.control.planning import (
    TIGHT_M,
    Array,
    Point,
    as_array,
    path_clearance,
    plan_path,
)
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links.sim import SimLink
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import PIONEER_3DX, SimulationConfig
from sim.world import world_document

ROUNDS = 9
MAX_RATIO = 3.0  # planning with all that belongs to it, to the bare search
MAX_LENGTH_RATIO = 1.15  # of the shortest way
RADIUS_M = PIONEER_3DX.radius_m


def finished(search: Generator[None, None, list[Point] | None]) -> list[Point]:
    while True:
        try:
            next(search)
        except StopIteration as end:
            path: list[Point] = end.value
            return path


def milliseconds(work: Callable[[], object]) -> float:
    start = time.process_time()
    work()
    return (time.process_time() - start) * 1e3


def length(start: Point, path: list[Point]) -> float:
    return sum(math.dist(a, b) for a, b in pairwise([start, *path]))


def maze() -> tuple[Array, Point, Point]:
    """Obstacles, start and goal in the world's frame; the start looks along x."""
    link = SimLink(world="maze", setting=SimulationConfig(), seed=0)
    x, y, _ = link.read().pose
    goal_x, goal_y = world_document("maze")["zones"][0]["center"]
    return as_array(link.sensors.obstacles()), (x, y), (goal_x, goal_y)


def optimal_length_m(obstacles: Array, start: Point, goal: Point) -> float:
    """Length of a way on a fine grid whose cells all cost the same, pulled straight: nearly the shortest there is."""
    fine, comfortable = planning.CELL_M, planning.COMFORTABLE_M
    planning.CELL_M, planning.COMFORTABLE_M = 0.02, TIGHT_M + 1e-6
    try:
        return length(start, finished(plan_path(obstacles, start, goal, RADIUS_M)))
    finally:
        planning.CELL_M, planning.COMFORTABLE_M = fine, comfortable


def dijkstra(obstacles: Array, start: Point, goal: Point) -> None:
    search = planning._Grid(obstacles, start, goal, RADIUS_M).search(estimate=0.0)
    while next(search, "done") != "done":
        pass


def test_the_way_through_the_maze_is_short_and_found_fast() -> None:
    obstacles, start, goal = maze()
    path = finished(plan_path(obstacles, start, goal, RADIUS_M))
    ours = [
        milliseconds(lambda: finished(plan_path(obstacles, start, goal, RADIUS_M)))
        for _ in range(ROUNDS)
    ]
    bare = [milliseconds(lambda: dijkstra(obstacles, start, goal)) for _ in range(ROUNDS)]
    ratio = statistics.median(ours) / statistics.median(bare)
    length_m, optimum_m = length(start, path), optimal_length_m(obstacles, start, goal)
    clearance = path_clearance([start, *path], obstacles) - RADIUS_M
    there = {"x": goal[0] - start[0], "y": goal[1] - start[1], "avoid": True}
    program = read_document({"pinel_ir": 1, "commands": [{"action": "go_to", **there}]}).program
    assert program is not None
    ended = execute(
        program, SimLink(world="maze", setting=SimulationConfig(), seed=0), RunOptions()
    ).ended
    print(
        f"\nmaze: {length_m:.2f} m in {len(path)} legs, shortest {optimum_m:.2f} m, ratio {length_m / optimum_m:.3f}, "
        f"clearance {clearance * 100:.1f} cm; planning {statistics.median(ours):.0f} ms, the grid's search alone "
        f"without an estimate {statistics.median(bare):.0f} ms, ratio {ratio:.2f}; driven in {ended.duration_s:.1f} s"
    )
    assert ended.state == "finished"
    assert clearance >= TIGHT_M - 1e-9
    assert length_m <= MAX_LENGTH_RATIO * optimum_m
    assert ratio <= MAX_RATIO
