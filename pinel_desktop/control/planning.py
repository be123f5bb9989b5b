"""Path planning around obstacles: A* on a grid with clearance costs, then string pulling. PURE."""

from __future__ import annotations

import heapq
import math
from collections.abc import Generator, Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

Point = tuple[float, float]
Segment = tuple[float, float, float, float]  # x1, y1, x2, y2 in m; a point has two equal ends
Array = npt.NDArray[np.float64]

CELL_M = 0.05
# clearance between hull and obstacles: the minimum, and the limit beyond which a cell costs no more
TIGHT_M, COMFORTABLE_M = 0.02, 0.15
_MARGIN_M = 1.5  # margin of the grid around all obstacles, so that a path can pass outside of them
_MAX_CELLS = 250_000
_CELLS_PER_YIELD = 500  # takes a few milliseconds
# Within this radius of the start, less clearance is allowed: the robot may already be too close.
_START_ZONE_M = 0.3
_SAMPLE_M = 0.03
_STEPS = tuple(
    (dx, dy, math.hypot(dx, dy)) for dx in (-1, 0, 1) for dy in (-1, 0, 1) if (dx, dy) != (0, 0)
)


def clearances(points: Array, obstacles: Array) -> Array:
    """Returns the distance in m from each point (n, 2) to the nearest obstacle (m, 4), shape (n,); inf without any."""
    nearest = np.full(len(points), np.inf)
    for x1, y1, x2, y2 in obstacles:
        dx, dy = x2 - x1, y2 - y1
        length2 = dx * dx + dy * dy
        px, py = points[:, 0] - x1, points[:, 1] - y1
        along = np.clip((px * dx + py * dy) / length2, 0.0, 1.0) if length2 > 0.0 else 0.0
        np.minimum(nearest, np.hypot(px - along * dx, py - along * dy), out=nearest)
    return nearest


def path_clearance(path: Sequence[Point], obstacles: Array) -> float:
    """Returns the smallest distance in m between a polyline and the obstacles (m, 4); inf without obstacles."""
    return float(clearances(_sampled(path), obstacles).min(initial=np.inf))


def as_array(obstacles: Sequence[Segment]) -> Array:
    """Returns the obstacles as an array (m, 4) with rows x1, y1, x2, y2 in m."""
    return np.array(obstacles, dtype=np.float64).reshape(-1, 4)


def plan_path(
    obstacles: Array, start: Point, goal: Point, radius_m: float
) -> Generator[None, None, list[Point] | None]:
    """Returns a polyline for a round robot from `start` to `goal`, without the start; None if there is no path.

    All points are in m, in one frame of the caller's choice. The generator yields every few milliseconds, so that the
    caller can do other work. The result does not depend on when the caller resumes it.

    Method: A* (P. Hart, N. Nilsson, B. Raphael, "A formal basis for the heuristic determination of minimum cost paths",
    1968) on a grid of 5 cm, where cells near obstacles cost up to twice as much. String pulling then replaces runs of
    cells by straight legs with at least the clearance of the replaced cells.
    """
    if path_clearance([start, goal], obstacles) >= radius_m + COMFORTABLE_M:
        return [goal]
    grid = _Grid(obstacles, start, goal, radius_m)
    cells = yield from grid.search()
    if cells is None:
        return None
    points = [start, *(grid.center(cell) for cell in cells[1:-1]), goal]
    return (yield from _pull_string(points, obstacles, radius_m))


class _Grid:
    """Grid over start, goal and obstacles; the clearance of a cell determines its cost."""

    def __init__(self, obstacles: Array, start: Point, goal: Point, radius_m: float) -> None:
        corners = np.vstack([obstacles[:, :2], obstacles[:, 2:], [start, goal]])
        low, high = corners.min(axis=0) - _MARGIN_M, corners.max(axis=0) + _MARGIN_M
        width, height = (float(side) for side in high - low)
        self._cell = max(CELL_M, math.sqrt(width * height / _MAX_CELLS))
        self._x, self._y = float(low[0]), float(low[1])
        self._n_rows = math.ceil(height / self._cell) + 1
        self._n_columns = math.ceil(width / self._cell) + 1
        self._start, self._goal = self._index(start), self._index(goal)
        self._cell_cost = self._cell_costs(obstacles, start, radius_m)

    def _index(self, point: Point) -> int:
        column = round((point[0] - self._x) / self._cell)
        row = round((point[1] - self._y) / self._cell)
        return row * self._n_columns + column

    def center(self, index: int) -> Point:
        """Returns the centre of a cell, in m."""
        row, column = divmod(index, self._n_columns)
        return self._x + column * self._cell, self._y + row * self._cell

    def _cell_costs(self, obstacles: Array, start: Point, radius_m: float) -> list[float]:
        """Returns the cost per metre of each cell, row by row: 1 if free, up to 2 near obstacles, inf if closed."""
        xs: Array = self._x + self._cell * np.arange(self._n_columns, dtype=np.float64)
        ys: Array = self._y + self._cell * np.arange(self._n_rows, dtype=np.float64)
        wide, tight = radius_m + COMFORTABLE_M, radius_m + TIGHT_M
        room = np.full((self._n_rows, self._n_columns), wide)
        for obstacle in obstacles:
            self._add_obstacle(room, obstacle, xs, ys, wide)
        near_start = np.hypot(xs[None, :] - start[0], ys[:, None] - start[1]) < _START_ZONE_M
        here = float(clearances(np.array([start]), obstacles)[0])
        closed = np.where(near_start, room < min(tight, here - self._cell), room < tight)
        cost = np.where(closed, np.inf, 1.0 + np.clip((wide - room) / (wide - tight), 0.0, 1.0))
        cost[0, :] = cost[-1, :] = cost[:, 0] = cost[:, -1] = np.inf
        costs: list[float] = cost.ravel().tolist()
        costs[self._start] = costs[self._start] if costs[self._start] < math.inf else 2.0
        return costs

    def _add_obstacle(
        self, room: Array, obstacle: Array, xs: Array, ys: Array, reach: float
    ) -> None:
        """Lowers `room`, the clearance of each cell in m, to the distance from one obstacle, within `reach` m of it."""
        x1, y1, x2, y2 = obstacle
        left, right = np.searchsorted(xs, (min(x1, x2) - reach, max(x1, x2) + reach))
        bottom, top = np.searchsorted(ys, (min(y1, y2) - reach, max(y1, y2) + reach))
        part = room[bottom:top, left:right]
        px, py = np.meshgrid(xs[left:right], ys[bottom:top])
        points = np.column_stack([px.ravel(), py.ravel()])
        np.minimum(part, clearances(points, obstacle[None, :]).reshape(part.shape), out=part)

    def search(self, estimate: float = 1.0) -> Generator[None, None, list[int] | None]:
        """Returns the indices of the cells from start to goal, or None if there is no path.

        Args:
            estimate: factor of the heuristic; 1 is A*, 0 is Dijkstra's algorithm.
        """
        cell_cost, width, cell, goal = self._cell_cost, self._n_columns, self._cell, self._goal
        if cell_cost[goal] == math.inf:
            return None
        goal_row, goal_column = divmod(goal, width)
        steps = [(dy * width + dx, length * cell / 2.0) for dx, dy, length in _STEPS]
        cost, came_from = {self._start: 0.0}, {self._start: self._start}
        waiting, done, n_expanded = [(0.0, self._start)], set[int](), 0
        while waiting:
            _, here = heapq.heappop(waiting)
            if here == goal:
                return self._path(came_from)
            if here in done:
                continue
            done.add(here)
            n_expanded += 1
            if n_expanded % _CELLS_PER_YIELD == 0:
                yield
            for offset, half in steps:
                there = here + offset
                so_far = cost[here] + half * (cell_cost[here] + cell_cost[there])
                if so_far < cost.get(there, math.inf):
                    cost[there], came_from[there] = so_far, here
                    row, column = divmod(there, width)
                    dx, dy = abs(column - goal_column), abs(row - goal_row)
                    rest = max(dx, dy) + (math.sqrt(2.0) - 1.0) * min(dx, dy)
                    heapq.heappush(waiting, (so_far + estimate * rest * cell, there))
        return None

    def _path(self, came_from: dict[int, int]) -> list[int]:
        cells = [self._goal]
        while cells[-1] != self._start:
            cells.append(came_from[cells[-1]])
        return cells[::-1]


def _pull_string(
    points: list[Point], obstacles: Array, radius_m: float
) -> Generator[None, None, list[Point]]:
    """Returns the corners that remain after string pulling: each leg skips as many points as its clearance allows."""
    room = np.minimum(clearances(np.array(points), obstacles), radius_m + COMFORTABLE_M)
    tight = float(min(radius_m + TIGHT_M, room.min()))
    path, here = [], 0
    while here < len(points) - 1:
        there = here + 1
        # galloping search for the end of the leg: the step doubles, then halves
        step = 1
        while step:
            further = min(there + step, len(points) - 1)
            leg = [points[here], points[further]]
            min_clearance = max(float(room[here : further + 1].min()) - CELL_M / 2.0, tight)
            if further > there and path_clearance(leg, obstacles) >= min_clearance:
                there, step = further, step * 2
            else:
                step //= 2
            yield
        path.append(points[there])
        here = there
    return path


def _sampled(path: Sequence[Point]) -> Array:
    parts = []
    for (x1, y1), (x2, y2) in pairwise(path):
        n = max(2, math.ceil(math.hypot(x2 - x1, y2 - y1) / _SAMPLE_M) + 1)
        parts.append(np.column_stack([np.linspace(x1, x2, n), np.linspace(y1, y2, n)]))
    return np.vstack(parts)
