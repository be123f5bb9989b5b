"""Path simplification: reduces the path of a run to few points for its picture."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
MAX_POINTS = 64
_FINEST_M = 0.005
_COARSEST = 0.05  # share of the path's extent; less cannot be distinguished in a small picture
_GROWTH = 1.5
_ROUNDED = 4  # decimals: 0.1 mm


def outline(points: Points) -> list[list[float]]:
    """Returns at most 64 of the points (n, 2) in m, chosen by the method of Douglas and Peucker.

    A path with more corners is cut off after its first 64: ten laps look like one. A greater tolerance would draw lines
    that the robot never drove.
    """
    simplified = _coarsened(points, _FINEST_M, limit=_COARSEST * _extent(points))[:MAX_POINTS]
    return [[round(float(x), _ROUNDED), round(float(y), _ROUNDED)] for x, y in simplified]


def outline_of_trail(trail: Sequence[float]) -> list[list[float]]:
    """Returns the same for x, y, x, y... in m."""
    return outline(np.array(trail, dtype=np.float64).reshape(-1, 2))


def _extent(points: Points) -> float:
    return float(np.ptp(points, axis=0).max()) if len(points) else 0.0


def _coarsened(points: Points, tolerance: float, *, limit: float) -> Points:
    """Raises the tolerance until the points are few enough or the tolerance reaches the limit."""
    simplified = _simplified(points, tolerance)
    while len(simplified) > MAX_POINTS and tolerance * _GROWTH <= limit:
        tolerance *= _GROWTH
        simplified = _simplified(simplified, tolerance)
    return simplified


def _simplified(points: Points, tolerance: float) -> Points:
    if len(points) < 3:
        return points
    mask = np.zeros(len(points), dtype=bool)
    mask[[0, -1]] = True
    spans = [(0, len(points) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        distances = _distances(points[first + 1 : last], points[first], points[last])
        farthest = int(np.argmax(distances))
        if distances[farthest] > tolerance:
            middle = first + 1 + farthest
            mask[middle] = True
            spans += [(first, middle), (middle, last)]
    return points[mask]


def _distances(points: Points, start: Points, end: Points) -> Points:
    """Returns the distance of each point from the segment start to end, in m."""
    along = end - start
    length2 = float(along @ along)
    share = np.clip((points - start) @ along / length2, 0, 1) if length2 else np.zeros(len(points))
    nearest = start + share[:, None] * along
    dx, dy = (points - nearest).T
    distances: Points = np.hypot(dx, dy)
    return distances
