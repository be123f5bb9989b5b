"""All beams of a scanner at once: numpy against the edges of what stands around.

One ray at a time costs more than all of them this way as long as a world has less than some hundred edges. Of the round
ends of walls, which are 2 cm thick, the corners are cut: a beam there differs from a ray by less than 2 mm.
"""

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sim.world import Box, Wall

Array = NDArray[np.float64]
Point = tuple[float, float]


class Scan:
    """Beams against the edges of fixed walls and boxes, and of boxes where they are now.

    An edge looks outward: beams meet it from its right-hand side as it is walked along, corners counterclockwise.
    """

    def __init__(
        self,
        walls: Iterable[Wall],
        boxes: Iterable[Box],
        wall_radius_m: float,
        angles: Sequence[float],
    ) -> None:
        rings = [_ring(wall, wall_radius_m) for wall in walls]
        self._fixed = _edges([*rings, *(box.corners() for box in boxes)])
        beams = np.array(angles)
        self._cos, self._sin = np.cos(beams), np.sin(beams)

    def ranges(
        self, x: float, y: float, yaw: float, length_m: float, movable: Sequence[Box] = ()
    ) -> list[float]:
        """Distance to what is nearest along each beam from a pose; at most `length_m`."""
        edges = self._fixed
        if movable:
            edges = np.concatenate((edges, _edges([box.corners() for box in movable])), axis=1)
        seen = self._facing(edges, x, y, length_m)
        cos, sin = math.cos(yaw), math.sin(yaw)
        ahead = self._cos * cos - self._sin * sin
        left = self._sin * cos + self._cos * sin
        normal_x, normal_y, gap, middle, half = seen
        with np.errstate(divide="ignore", invalid="ignore"):
            distances = gap / (normal_x * ahead + normal_y * left)
            along = distances * (normal_x * left - normal_y * ahead) + middle
        met = (np.abs(along) <= half) & (distances > 0.0)
        nearest = np.where(met, distances, length_m).min(axis=0, initial=length_m)
        return nearest.tolist()  # type: ignore[no-any-return] # numpy's types do not tell the shape

    @staticmethod
    def _facing(edges: Array, x: float, y: float, length_m: float) -> list[Any]:
        """Of the edges that look at the point and are in reach: normal, gap to the line, middle, half the length."""
        normal_x, normal_y, offset, middle, half = edges
        gap = offset - (normal_x * x + normal_y * y)
        use = (gap < 0.0) & (gap > -length_m)
        seen = edges[:, use]
        normal_x, normal_y, _, middle, half = seen
        here = normal_x * y - normal_y * x
        return [row[:, None] for row in (normal_x, normal_y, gap[use], here - middle, half)]


def _edges(rings: Iterable[Sequence[Point]]) -> Array:
    """Rings of corners as columns: outward normal x and y, its offset, the middle along the edge, half the length."""
    rows = []
    for ring in rings:
        for (x0, y0), (x1, y1) in zip(ring, (*ring[1:], ring[0]), strict=True):
            length = math.hypot(x1 - x0, y1 - y0)
            nx, ny = (y1 - y0) / length, (x0 - x1) / length
            middle = nx * (y0 + y1) / 2.0 - ny * (x0 + x1) / 2.0
            rows.append((nx, ny, nx * x0 + ny * y0, middle, length / 2.0))
    return np.array(rows, dtype=np.float64).reshape(-1, 5).T


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
