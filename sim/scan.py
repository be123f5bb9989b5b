"""All beams of a scanner at once: numpy against the edges of what stands around.

One ray at a time costs more than all of them this way as long as a world has less than some hundred edges. Of the round
ends of walls, which are 2 cm thick, the corners are cut: a beam there differs from a ray by less than 2 mm.
"""

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from sim.world import Box, Wall

Array = NDArray[np.float64]
Point = tuple[float, float]
Side = tuple[float, float, float, float]
_MANY = 60  # shapes; among more, finding the covered sides would take longer than they ever cost
_ROUNDING_M = 1e-6
_ROWS = 5  # that tell of an edge


class Scan:
    """Beams against the edges of fixed walls and boxes, and of boxes where they are now.

    All that a beam needs to know of an edge is linear in a few numbers of the robot's pose, so one product of matrices
    gives it for all edges, and another one meets all beams with all edges that look at the robot. What is left are few
    calls of numpy, each of which costs more than its arithmetic.
    """

    def __init__(
        self,
        walls: Iterable[Wall],
        boxes: Iterable[Box],
        wall_radius_m: float,
        angles: Sequence[float],
    ) -> None:
        rings = [_ring(wall, wall_radius_m) for wall in walls]
        self._fixed = _edges(_uncovered([*rings, *(box.corners() for box in boxes)]))
        beams = np.array(angles)
        self._beams = np.array((np.cos(beams), np.sin(beams)), dtype=np.float32)

    def ranges(
        self, x: float, y: float, yaw: float, length_m: float, movable: Sequence[Box] = ()
    ) -> list[float]:
        """Distance to what is nearest along each beam from a pose; at most `length_m`."""
        edges = self._fixed
        if movable:
            moved = _edges([side for box in movable for side in _sides(box.corners())])
            edges = np.concatenate((edges, moved))
        c, s = math.cos(yaw), math.sin(yaw)
        seen = edges.dot((c, s, c * x + s * y, s * x - c * y, x, y, 1.0)).reshape(-1, _ROWS)
        gap = seen[:, 4]
        seen = seen.take(((gap < 0.0) & (gap > -length_m)).nonzero()[0], axis=0)
        # in single precision (a micrometre at 8 m), for speed
        rows = (seen[:, :4] / seen[:, 4:]).astype(np.float32)
        # How near the edge's line is along each beam, in 1/m; and how far from the edge's middle they meet, in halves
        # of the edge, times the same. Where a beam leads away from an edge, near is below 0: no aside is smaller.
        near, aside = rows[:, :2].dot(self._beams), rows[:, 2:].dot(self._beams)
        near *= near >= np.abs(aside, out=aside)
        nearest = np.maximum.reduce(near, axis=0, initial=1.0 / length_m)
        distances: list[float] = np.reciprocal(nearest).tolist()
        return distances


def _edges(sides: Sequence[Side]) -> Array:
    """Five rows for each side of a shape, to be multiplied by (c, s, cx + sy, sx - cy, x, y, 1) of a pose x, y, yaw.

    They give, c and s being the yaw's cosine and sine: the outward normal in the robot's frame (2); the middle from
    there, turned left by 90 degrees and divided by half the side's length (2); how far the side's line is beyond the
    robot along the normal, below 0 where the side looks at it.
    """
    ax, ay, bx, by = np.array(sides, dtype=np.float64).reshape(-1, 4).T
    half = np.hypot(bx - ax, by - ay) / 2.0
    nx, ny = (by - ay) / (2.0 * half), (ax - bx) / (2.0 * half)
    mx, my = (ax + bx) / 2.0, (ay + by) / 2.0
    o = np.zeros_like(half)
    rows = (
        (nx, ny, o, o, o, o, o),
        (ny, -nx, o, o, o, o, o),
        (-my / half, mx / half, o, -1.0 / half, o, o, o),
        (mx / half, my / half, -1.0 / half, o, o, o, o),
        (o, o, o, o, -nx, -ny, nx * mx + ny * my),
    )
    return np.array(rows).transpose(2, 0, 1).reshape(-1, 7)


def _sides(ring: Sequence[Point]) -> list[Side]:
    """From each corner to the next; the corners go around counterclockwise."""
    return [(*a, *b) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)]


def _uncovered(rings: Sequence[Sequence[Point]]) -> list[Side]:
    """The sides of all shapes but those that lie inside another, such as the ends of walls that meet in a corner."""
    shapes = [_sides(ring) for ring in rings]
    sides = [side for shape in shapes for side in shape]
    if not 1 < len(shapes) <= _MANY:
        return sides
    ends = np.array(sides).reshape(-1, 2, 2)
    points = np.concatenate((ends[:, 0], ends[:, 1], ends.mean(axis=1)))
    depths = _edges(sides)[4::_ROWS, 4:].dot(np.column_stack((points, np.ones(len(points)))).T)
    sizes = [len(shape) for shape in shapes]
    starts = np.cumsum([0, *sizes[:-1]])
    # how deep each point lies in each shape, in m: a, b and middle of each side
    a, b, middle = np.split(np.minimum.reduceat(depths, starts, axis=0), 3, axis=1)
    # on its edge or inside, and not along its edge
    covered = (middle > _ROUNDING_M) & (a > -_ROUNDING_M) & (b > -_ROUNDING_M)
    own = np.repeat(np.arange(len(shapes)), sizes)
    covered[own, np.arange(len(sides))] = False
    return [sides[i] for i in np.flatnonzero(~covered.any(axis=0))]


def _ring(wall: Wall, radius: float) -> list[Point]:
    """The wall's outline, counterclockwise: two long sides and at each end three short ones for the half circle."""
    (x0, y0), (x1, y1) = wall.start, wall.end
    length = math.hypot(x1 - x0, y1 - y0)
    ux, uy = (x1 - x0) / length * radius, (y1 - y0) / length * radius
    bevel = math.tan(math.pi / 8.0)
    offsets = ((bevel, -1.0), (1.0, -bevel), (1.0, bevel), (bevel, 1.0))
    ahead = [(x1 + a * ux - b * uy, y1 + a * uy + b * ux) for a, b in offsets]
    back = [(x0 - a * ux + b * uy, y0 - a * uy - b * ux) for a, b in offsets]
    return [*ahead, *back]
