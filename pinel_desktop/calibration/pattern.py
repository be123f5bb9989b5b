"""The offered pattern: a line, and squares in both directions; recognised by the path, whatever program drove it."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

Shape = Literal["line", "left", "right"]
Point = Sequence[float]

_MIN_LINE_M, _MIN_SIDE_M = 0.9, 0.4
_TOLERANCE = 0.1


def shape_of(path: Sequence[Point]) -> Shape | None:
    """Returns which part of the pattern a run drove; None for another run.

    Args:
        path: points (x, y) in m of the run's odometry, from its start.
    """
    if len(path) < 2:
        return None
    length_m = sum(math.dist(one, other) for one, other in pairwise(path))
    away_m = math.dist(path[0], path[-1])
    if away_m >= _MIN_LINE_M and away_m >= (1.0 - _TOLERANCE / 2.0) * length_m:
        return "line"
    side_m = length_m / 4.0
    if side_m < _MIN_SIDE_M or away_m > _TOLERANCE * side_m:
        return None
    # of all figures with four sides of this length only a square has this area
    part = _area(path) / side_m**2
    if abs(abs(part) - 1.0) > _TOLERANCE:
        return None
    return "left" if part > 0.0 else "right"


def _area(path: Sequence[Point]) -> float:
    """Returns the area of the closed path, positive if it turns to the left."""
    closed = [*path, path[0]]
    return sum(one[0] * other[1] - other[0] * one[1] for one, other in pairwise(closed)) / 2.0
