"""Geometric checks of a world: crossing walls, elements outside the floor, a blocked start, movable boxes."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from sim.floor import Disc, Paint, Rectangle, Shape, Zone
from sim.geometry import Array, crossings, distances_to_boxes, distances_to_segments, overlaps
from sim.world import (
    MAX_MOVABLE_KG,
    MIN_MOVABLE_KG,
    MIN_MOVABLE_SIDE_M,
    WALL_RADIUS_M,
    Box,
    Wall,
)
from sim.world_faults import LocatedFault, located, pointer

MIN_WALL_LENGTH_M = 0.01
_ROUNDING_M = 1e-6
_OVERLAP_M = 1e-3  # a movable box may touch a wall, but not overlap it


@dataclass(frozen=True, slots=True)
class Parts:
    """The valid elements of a world document; list elements are by their index in the document."""

    size_m: tuple[float, float] | None = None
    start: tuple[float, float] | None = None
    walls: Mapping[int, Wall] = field(default_factory=dict)
    boxes: Mapping[int, Box] = field(default_factory=dict)
    zones: Mapping[int, Zone] = field(default_factory=dict)
    floor: Mapping[int, Paint] = field(default_factory=dict)


def placement_faults(parts: Parts, robot_radius_m: float) -> Iterator[LocatedFault]:
    """Yields all placement faults; lengths are in metres."""
    if parts.size_m is not None:
        yield from _outside_the_floor(parts, parts.size_m, robot_radius_m)
    yield from _short_walls(parts)
    yield from _crossing_walls(parts)
    yield from _unpushable_boxes(parts)
    yield from _overlapping_boxes(parts)
    yield from _duplicate_zones(parts)
    if parts.start is not None:
        yield from _blocked_start(parts, parts.start, robot_radius_m)


def _outside_the_floor(
    parts: Parts, size_m: tuple[float, float], robot_radius_m: float
) -> Iterator[LocatedFault]:
    half_width, half_height = size_m[0] / 2 + _ROUNDING_M, size_m[1] / 2 + _ROUNDING_M
    for points, fault in _extents(parts, robot_radius_m):
        if any(abs(x) > half_width or abs(y) > half_height for x, y in points):
            yield fault


def _extents(
    parts: Parts, robot_radius_m: float
) -> Iterator[tuple[Sequence[tuple[float, float]], LocatedFault]]:
    """Yields the extreme points of every element, with the fault to report if one is outside the floor."""
    if parts.start is not None:
        robot = Disc(parts.start, robot_radius_m)
        yield _extremes(robot), located(("start",), "start_off_floor", min=robot_radius_m)
    for i, wall in parts.walls.items():
        yield (wall.start, wall.end), located(("walls", i), "wall_off_floor", wall=i + 1)
    for i, box in parts.boxes.items():
        yield box.corners(), located(("boxes", i), "box_off_floor", box=i + 1)
    for i, zone in parts.zones.items():
        yield _extremes(zone.shape), located(("zones", i), "zone_off_floor", name=zone.name)
    for i, paint in parts.floor.items():
        yield _extremes(paint.shape), located(("floor", i), "paint_off_floor", paint=i + 1)


def _extremes(shape: Shape) -> Sequence[tuple[float, float]]:
    """Returns points that are on a rectangular floor if and only if the whole shape is."""
    if isinstance(shape, Rectangle):
        return Box(shape.center, shape.size, shape.angle_rad).corners()
    assert isinstance(shape, Disc)
    (x, y), r = shape.center, shape.radius
    return [(x - r, y - r), (x + r, y + r)]


def _short_walls(parts: Parts) -> Iterator[LocatedFault]:
    for i, wall in parts.walls.items():
        if math.dist(wall.start, wall.end) < MIN_WALL_LENGTH_M:
            yield located(("walls", i), "wall_too_short", wall=i + 1, min=MIN_WALL_LENGTH_M)


def _crossing_walls(parts: Parts) -> Iterator[LocatedFault]:
    indices = list(parts.walls)
    for one, other in crossings(_segments(parts), WALL_RADIUS_M):
        i, j = indices[one], indices[other]
        walls = {"wall": j + 1, "other": i + 1, "other_pointer": pointer(("walls", i))}
        yield located(("walls", j), "walls_cross", **walls)


def _unpushable_boxes(parts: Parts) -> Iterator[LocatedFault]:
    for i, box in parts.boxes.items():
        if box.movable and min(box.size) < MIN_MOVABLE_SIDE_M:
            yield located(("boxes", i, "size"), "box_too_thin", box=i + 1, min=MIN_MOVABLE_SIDE_M)
        if box.movable and not MIN_MOVABLE_KG <= box.mass_kg <= MAX_MOVABLE_KG:
            limits = {"min": MIN_MOVABLE_KG, "max": MAX_MOVABLE_KG}
            place = ("boxes", i, "mass_kg")
            yield located(place, "box_mass_wrong", box=i + 1, value=box.mass_kg, **limits)


def _overlapping_boxes(parts: Parts) -> Iterator[LocatedFault]:
    """Yields a fault for each movable box that overlaps a wall or a box: the physics would eject it at the start."""
    indices, movable = list(parts.boxes), [i for i, box in parts.boxes.items() if box.movable]
    corners = _corners(parts)
    loose = corners[[indices.index(i) for i in movable]]
    walls = list(parts.walls)
    for one, other in overlaps(loose, _thick_walls(parts), _OVERLAP_M):
        yield _overlap_fault(movable[one], ("walls", walls[other]), "box_in_wall")
    for one, other in overlaps(loose, corners, _OVERLAP_M):
        i, j = movable[one], indices[other]
        if i != j and not (
            j in movable and j > i
        ):  # of two movable boxes, only the later one gets the fault
            yield _overlap_fault(i, ("boxes", j), "box_in_box")


def _overlap_fault(box: int, other: tuple[str, int], code: str) -> LocatedFault:
    numbers = {"box": box + 1, "other": other[1] + 1, "other_pointer": pointer(other)}
    return located(("boxes", box), code, **numbers)


def _duplicate_zones(parts: Parts) -> Iterator[LocatedFault]:
    counts: Counter[str] = Counter()
    for i, zone in parts.zones.items():
        if counts[zone.name]:
            yield located(("zones", i, "name"), "duplicate_zone", name=zone.name)
        counts[zone.name] += 1


def _blocked_start(
    parts: Parts, start: tuple[float, float], robot_radius_m: float
) -> Iterator[LocatedFault]:
    here = np.array(start)
    to_walls = distances_to_segments(here, _segments(parts)) - WALL_RADIUS_M
    for i, distance in zip(parts.walls, to_walls, strict=True):
        if distance < robot_radius_m:
            yield _start_fault(("walls", i), "start_in_wall", robot_radius_m + WALL_RADIUS_M)
    to_boxes = distances_to_boxes(here, _corners(parts))
    for i, distance in zip(parts.boxes, to_boxes, strict=True):
        if distance < robot_radius_m:
            yield _start_fault(("boxes", i), "start_in_box", robot_radius_m)


def _start_fault(other: tuple[str, int], code: str, needed_m: float) -> LocatedFault:
    return located(
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
    """Returns the walls as rectangles, extended at both ends by the wall's radius."""
    walls = (_thick(*wall.start, *wall.end) for wall in parts.walls.values())
    return np.array([wall.corners() for wall in walls], dtype=np.float64).reshape(-1, 4, 2)


def _thick(x1: float, y1: float, x2: float, y2: float) -> Box:
    size = (math.hypot(x2 - x1, y2 - y1) + 2 * WALL_RADIUS_M, 2 * WALL_RADIUS_M)
    return Box(((x1 + x2) / 2, (y1 + y2) / 2), size, math.atan2(y2 - y1, x2 - x1))


def _corners(parts: Parts) -> Array:
    corners = [box.corners() for box in parts.boxes.values()]
    return np.array(corners, dtype=np.float64).reshape(-1, 4, 2)
