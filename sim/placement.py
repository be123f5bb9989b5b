"""Where things of a world must not be: across each other, off the floor, in the robot's place at the start.

And what a box must be that the robot can push.
"""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from sim.floor import Disc, Paint, Rectangle, Shape, Zone
from sim.geometry import Array, crossings, distances_to_boxes, distances_to_segments, overlaps
from sim.world import (
    LEAST_PUSHED_KG,
    LEAST_PUSHED_SIDE_M,
    MOST_PUSHED_KG,
    WALL_RADIUS_M,
    Box,
    Wall,
)
from sim.world_faults import Placed, placed, pointer

SHORTEST_WALL_M = 0.01
_ROUNDING_M = 1e-6
_PRESSED_M = 1e-3  # a box to push may touch a wall, but not stand in it


@dataclass(frozen=True, slots=True)
class Parts:
    """The parts of a world that are sound in themselves; those of lists by their index in the document."""

    size_m: tuple[float, float] | None = None
    start: tuple[float, float] | None = None
    walls: Mapping[int, Wall] = field(default_factory=dict)
    boxes: Mapping[int, Box] = field(default_factory=dict)
    zones: Mapping[int, Zone] = field(default_factory=dict)
    floor: Mapping[int, Paint] = field(default_factory=dict)


def misplaced(parts: Parts, robot_radius_m: float) -> Iterator[Placed]:
    """Everything that is not where it may be, list by list."""
    if parts.size_m is not None:
        yield from _off_the_floor(parts, parts.size_m, robot_radius_m)
    yield from _short_walls(parts)
    yield from _crossing_walls(parts)
    yield from _boxes_that_cannot_be_pushed(parts)
    yield from _pressed_boxes(parts)
    yield from _same_names(parts)
    if parts.start is not None:
        yield from _robot_without_room(parts, parts.start, robot_radius_m)


def _off_the_floor(
    parts: Parts, size_m: tuple[float, float], robot_radius_m: float
) -> Iterator[Placed]:
    half_width, half_height = size_m[0] / 2 + _ROUNDING_M, size_m[1] / 2 + _ROUNDING_M
    for points, fault in _reaches(parts, robot_radius_m):
        if any(abs(x) > half_width or abs(y) > half_height for x, y in points):
            yield fault


def _reaches(
    parts: Parts, robot_radius_m: float
) -> Iterator[tuple[Sequence[tuple[float, float]], Placed]]:
    """How far everything reaches, with the fault that it is where that is too far."""
    if parts.start is not None:
        robot = Disc(parts.start, robot_radius_m)
        yield _extremes(robot), placed(("start",), "start_off_floor", min=robot_radius_m)
    for i, wall in parts.walls.items():
        yield (wall.start, wall.end), placed(("walls", i), "wall_off_floor", wall=i + 1)
    for i, box in parts.boxes.items():
        yield box.corners(), placed(("boxes", i), "box_off_floor", box=i + 1)
    for i, zone in parts.zones.items():
        yield _extremes(zone.shape), placed(("zones", i), "zone_off_floor", name=zone.name)
    for i, paint in parts.floor.items():
        yield _extremes(paint.shape), placed(("floor", i), "paint_off_floor", paint=i + 1)


def _extremes(shape: Shape) -> Sequence[tuple[float, float]]:
    """Points that are on a floor of straight edges just when the whole shape is."""
    if isinstance(shape, Rectangle):
        return Box(shape.center, shape.size, shape.angle_rad).corners()
    assert isinstance(shape, Disc)
    (x, y), r = shape.center, shape.radius
    return [(x - r, y - r), (x + r, y + r)]


def _short_walls(parts: Parts) -> Iterator[Placed]:
    for i, wall in parts.walls.items():
        if math.dist(wall.start, wall.end) < SHORTEST_WALL_M:
            yield placed(("walls", i), "wall_too_short", wall=i + 1, min=SHORTEST_WALL_M)


def _crossing_walls(parts: Parts) -> Iterator[Placed]:
    indices = list(parts.walls)
    for one, other in crossings(_segments(parts), WALL_RADIUS_M):
        i, j = indices[one], indices[other]
        walls = {"wall": j + 1, "other": i + 1, "other_pointer": pointer(("walls", i))}
        yield placed(("walls", j), "walls_cross", **walls)


def _boxes_that_cannot_be_pushed(parts: Parts) -> Iterator[Placed]:
    for i, box in parts.boxes.items():
        if box.movable and min(box.size) < LEAST_PUSHED_SIDE_M:
            yield placed(("boxes", i, "size"), "box_too_thin", box=i + 1, min=LEAST_PUSHED_SIDE_M)
        if box.movable and not LEAST_PUSHED_KG <= box.mass_kg <= MOST_PUSHED_KG:
            limits = {"min": LEAST_PUSHED_KG, "max": MOST_PUSHED_KG}
            place = ("boxes", i, "mass_kg")
            yield placed(place, "box_mass_wrong", box=i + 1, value=box.mass_kg, **limits)


def _pressed_boxes(parts: Parts) -> Iterator[Placed]:
    """Boxes to push that stand in a wall or another box: the physics would throw them out at the start."""
    indices, movable = list(parts.boxes), [i for i, box in parts.boxes.items() if box.movable]
    corners = _corners(parts)
    loose = corners[[indices.index(i) for i in movable]]
    walls = list(parts.walls)
    for one, other in overlaps(loose, _thick_walls(parts), _PRESSED_M):
        yield _pressed(movable[one], ("walls", walls[other]), "box_in_wall")
    for one, other in overlaps(loose, corners, _PRESSED_M):
        i, j = movable[one], indices[other]
        if i != j and not (j in movable and j > i):  # two movable ones: the later is at fault
            yield _pressed(i, ("boxes", j), "box_in_box")


def _pressed(box: int, other: tuple[str, int], code: str) -> Placed:
    numbers = {"box": box + 1, "other": other[1] + 1, "other_pointer": pointer(other)}
    return placed(("boxes", box), code, **numbers)


def _same_names(parts: Parts) -> Iterator[Placed]:
    seen: Counter[str] = Counter()
    for i, zone in parts.zones.items():
        if seen[zone.name]:
            yield placed(("zones", i, "name"), "duplicate_zone", name=zone.name)
        seen[zone.name] += 1


def _robot_without_room(
    parts: Parts, start: tuple[float, float], robot_radius_m: float
) -> Iterator[Placed]:
    here = np.array(start)
    to_walls = distances_to_segments(here, _segments(parts)) - WALL_RADIUS_M
    for i, distance in zip(parts.walls, to_walls, strict=True):
        if distance < robot_radius_m:
            yield _in_the_way(("walls", i), "start_in_wall", robot_radius_m + WALL_RADIUS_M)
    to_boxes = distances_to_boxes(here, _corners(parts))
    for i, distance in zip(parts.boxes, to_boxes, strict=True):
        if distance < robot_radius_m:
            yield _in_the_way(("boxes", i), "start_in_box", robot_radius_m)


def _in_the_way(other: tuple[str, int], code: str, needed_m: float) -> Placed:
    return placed(
        ("start",),
        code,
        other=other[1] + 1,
        other_pointer=pointer(other),
        min=math.ceil(needed_m * 100) / 100,
    )


def _segments(parts: Parts) -> Array:
    ends = [(wall.start, wall.end) for wall in parts.walls.values()]
    return np.array(ends, dtype=np.float64).reshape(-1, 2, 2)


def _thick_walls(parts: Parts) -> Array:
    """The walls as rectangles, which reach beyond their ends as far as to their sides."""
    walls = (_thick(*wall.start, *wall.end) for wall in parts.walls.values())
    return np.array([wall.corners() for wall in walls], dtype=np.float64).reshape(-1, 4, 2)


def _thick(x1: float, y1: float, x2: float, y2: float) -> Box:
    size = (math.hypot(x2 - x1, y2 - y1) + 2 * WALL_RADIUS_M, 2 * WALL_RADIUS_M)
    return Box(((x1 + x2) / 2, (y1 + y2) / 2), size, math.atan2(y2 - y1, x2 - x1))


def _corners(parts: Parts) -> Array:
    corners = [box.corners() for box in parts.boxes.values()]
    return np.array(corners, dtype=np.float64).reshape(-1, 4, 2)
