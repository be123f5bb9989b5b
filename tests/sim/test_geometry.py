"""How walls and boxes lie to each other, against slow but plain ways to know it."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.geometry import crossings, distances_to_boxes, distances_to_segments, overlaps
from sim.world import Box

Point = tuple[float, float]
Segment = tuple[Point, Point]
# on a coarse grid much meets, touches and is parallel
GRID = st.integers(-4, 4).map(float)
POINTS = st.tuples(GRID, GRID)
SEGMENTS = st.tuples(POINTS, POINTS).filter(lambda ends: ends[0] != ends[1])
BOXES = st.builds(
    Box,
    st.tuples(st.floats(-3, 3), st.floats(-3, 3)),
    st.tuples(st.floats(0.1, 3), st.floats(0.1, 3)),
    st.floats(-math.pi, math.pi),
)
FREE_POINTS = st.tuples(st.floats(-5, 5), st.floats(-5, 5))


def side(segment: Segment, point: Point) -> Fraction:
    (ax, ay), (bx, by) = segment
    x, y = point
    ax, ay, bx, by, x, y = map(Fraction, (ax, ay, bx, by, x, y))  # type: ignore[assignment]
    return Fraction((bx - ax) * (y - ay) - (by - ay) * (x - ax))


def cross(one: Segment, other: Segment) -> bool:
    return (
        side(one, other[0]) * side(one, other[1]) < 0
        and side(other, one[0]) * side(other, one[1]) < 0
    )


@given(st.lists(SEGMENTS, max_size=8))
def test_segments_cross_when_each_has_its_ends_on_both_sides_of_the_other(
    segments: list[Segment],
) -> None:
    found = crossings(np.array(segments, dtype=float).reshape(-1, 2, 2), 1e-9).tolist()
    n = len(segments)
    expected = [
        [i, j] for i in range(n) for j in range(i + 1, n) if cross(segments[i], segments[j])
    ]
    assert found == expected


def samples(start: Point, end: Point) -> list[Point]:
    (ax, ay), (bx, by) = start, end
    return [(ax + (bx - ax) * i / 400, ay + (by - ay) * i / 400) for i in range(401)]


@given(FREE_POINTS, SEGMENTS)
def test_the_distance_to_a_segment_is_that_to_its_nearest_point(
    point: Point, segment: Segment
) -> None:
    (distance,) = distances_to_segments(np.array(point), np.array([segment]))
    nearest = min(math.dist(point, at) for at in samples(*segment))
    assert nearest - 0.015 <= distance <= nearest + 1e-9


def is_in(box: Box, point: Point) -> bool:
    dx, dy = point[0] - box.center[0], point[1] - box.center[1]
    cos, sin = math.cos(box.angle_rad), math.sin(box.angle_rad)
    ahead, left = cos * dx + sin * dy, cos * dy - sin * dx
    return abs(ahead) <= box.size[0] / 2 and abs(left) <= box.size[1] / 2


@given(FREE_POINTS, BOXES)
def test_the_distance_to_a_box_is_0_inside_and_else_that_to_its_edge(
    point: Point, box: Box
) -> None:
    (distance,) = distances_to_boxes(np.array(point), np.array([box.corners()]))
    corners = box.corners()
    sides = zip(corners, [*corners[1:], corners[0]], strict=True)
    nearest = min(math.dist(point, at) for start, end in sides for at in samples(start, end))
    if is_in(box, point):
        assert distance == pytest.approx(0, abs=1e-9)
    else:
        assert nearest - 0.01 <= distance <= nearest + 1e-9


@given(BOXES, BOXES)
def test_boxes_overlap_when_a_point_of_one_is_in_the_other(one: Box, other: Box) -> None:
    overlap = len(overlaps(np.array([one.corners()]), np.array([other.corners()]), 1e-6)) == 1
    grid = [i / 12 - 0.5 for i in range(13)]
    cos, sin = math.cos(one.angle_rad), math.sin(one.angle_rad)
    inside = [(u * one.size[0], v * one.size[1]) for u in grid for v in grid]
    points = [
        (one.center[0] + cos * dx - sin * dy, one.center[1] + sin * dx + cos * dy)
        for dx, dy in inside
    ]
    if overlap:
        step = math.hypot(*one.size) / 12
        wider = Box(other.center, (other.size[0] + step, other.size[1] + step), other.angle_rad)
        assert any(is_in(wider, point) for point in points)
    elif any(is_in(other, point) for point in points):  # they touch at most
        assert len(overlaps(np.array([one.corners()]), np.array([other.corners()]), -1e-6)) == 1


def test_boxes_that_touch_at_their_corners_overlap_within_a_negative_slack() -> None:
    one, other = Box((0, 0), (2, 2)).corners(), Box((2, 2), (2, 2)).corners()
    for tolerance_m, expected in ((1e-6, 0), (-1e-6, 1)):
        assert len(overlaps(np.array([one]), np.array([other]), tolerance_m)) == expected


@pytest.mark.parametrize(("away", "together"), [(1.9, False), (1.6, True)])
def test_a_box_in_front_of_another_s_corner_is_apart_by_its_own_edge(
    away: float, together: bool
) -> None:
    straight = Box((0, 0), (2, 2)).corners()
    turned = Box((away, away), (2, 2), math.radians(45)).corners()
    for one, other in ((straight, turned), (turned, straight)):
        assert (len(overlaps(np.array([one]), np.array([other]), 1e-6)) == 1) == together
