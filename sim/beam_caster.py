"""Vectorised ray casting: all beams of a laser scanner at once, against the edges of walls and boxes.

Up to some hundred edges this is faster than casting the rays one by one. The round ends of the walls, which are 2 cm
thick, are polygons here. Distances therefore differ from the distances of `Simulator.ray` by less than 2 mm.
"""

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from sim.world import Box, Wall

Array = NDArray[np.float64]
Point = tuple[float, float]
Side = tuple[float, float, float, float]
_MANY = 60  # number of shapes above which finding covered sides costs more than it saves
_ROUNDING_M = 1e-6
_ROWS = 5  # rows of the matrix per edge


class BeamCaster:
    """Casts beams against the edges of fixed walls and boxes, and of movable boxes at their current poses.

    The coefficients of an edge are linear in a few terms of the robot's pose. One matrix product computes them for all
    edges, and another one intersects all beams with all edges that face the robot. This needs few calls of numpy, of
    which each costs more than its arithmetic.
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
        """Returns the distance (m) to the nearest edge along each beam from a pose (m, rad), at most `length_m`."""
        edges = self._fixed
        if movable:
            moved = _edges([side for box in movable for side in _sides(box.corners())])
            edges = np.concatenate((edges, moved))
        c, s = math.cos(yaw), math.sin(yaw)
        coefficients = edges.dot((c, s, c * x + s * y, s * x - c * y, x, y, 1.0)).reshape(-1, _ROWS)
        gap = coefficients[:, 4]
        coefficients = coefficients.take(((gap < 0.0) & (gap > -length_m)).nonzero()[0], axis=0)
        # single precision for speed; its error is a micrometre at 8 m
        rows = (coefficients[:, :4] / coefficients[:, 4:]).astype(np.float32)
        # near: 1 / distance along each beam to the edge's line, in 1/m; negative if the beam points
        # away from the line. aside: near times the distance of the intersection from the edge's
        # centre, in half edges. A beam hits the edge itself if near >= |aside|.
        near, aside = rows[:, :2].dot(self._beams), rows[:, 2:].dot(self._beams)
        near *= near >= np.abs(aside, out=aside)
        nearest = np.maximum.reduce(near, axis=0, initial=1.0 / length_m)
        distances: list[float] = np.reciprocal(nearest).tolist()
        return distances


def _edges(sides: Sequence[Side]) -> Array:
    """Returns the matrix (5 n, 7) of n sides, to multiply by (c, s, cx + sy, sx - cy, x, y, 1) of a pose x, y, yaw.

    c and s are the cosine and sine of yaw. Each side has five rows:

    - two for its outward normal in the robot's frame;
    - two for its centre in the robot's frame, rotated left by 90 degrees and divided by half the side's length;
    - one for the signed distance of its line from the robot along the normal, negative if the side faces the robot.
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
    """Returns the sides of a polygon with counterclockwise corners."""
    return [(*a, *b) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)]


def _uncovered(rings: Sequence[Sequence[Point]]) -> list[Side]:
    """Returns the sides of all shapes, except sides inside another shape, such as wall ends that meet in a corner."""
    shapes = [_sides(ring) for ring in rings]
    sides = [side for shape in shapes for side in shape]
    if not 1 < len(shapes) <= _MANY:
        return sides
    ends = np.array(sides).reshape(-1, 2, 2)
    points = np.concatenate((ends[:, 0], ends[:, 1], ends.mean(axis=1)))
    depths = _edges(sides)[4::_ROWS, 4:].dot(np.column_stack((points, np.ones(len(points)))).T)
    sizes = [len(shape) for shape in shapes]
    starts = np.cumsum([0, *sizes[:-1]])
    # depth of each side's ends a, b and its middle inside each shape, in m
    a, b, middle = np.split(np.minimum.reduceat(depths, starts, axis=0), 3, axis=1)
    # inside or on the edge, but not along the edge
    covered = (middle > _ROUNDING_M) & (a > -_ROUNDING_M) & (b > -_ROUNDING_M)
    own = np.repeat(np.arange(len(shapes)), sizes)
    covered[own, np.arange(len(sides))] = False
    return [sides[i] for i in np.flatnonzero(~covered.any(axis=0))]


def _ring(wall: Wall, radius: float) -> list[Point]:
    """Returns the wall's outline, counterclockwise: two long sides, and three short sides for each round end."""
    (x0, y0), (x1, y1) = wall.start, wall.end
    length = math.hypot(x1 - x0, y1 - y0)
    ux, uy = (x1 - x0) / length * radius, (y1 - y0) / length * radius
    bevel = math.tan(math.pi / 8.0)
    offsets = ((bevel, -1.0), (1.0, -bevel), (1.0, bevel), (bevel, 1.0))
    ahead = [(x1 + a * ux - b * uy, y1 + a * uy + b * ux) for a, b in offsets]
    back = [(x0 - a * ux + b * uy, y0 - a * uy - b * ux) for a, b in offsets]
    return [*ahead, *back]
