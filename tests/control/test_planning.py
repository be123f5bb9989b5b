"""Path planning: paths are free of collisions and short, and None if there is none."""

import math
from collections.abc import Generator
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.control.planning import (
    TIGHT_M,
    Point,
    Segment,
    as_array,
    path_clearance,
    plan_path,
)

RADIUS_M = 0.2225
ROOM = [
    (-4.0, -4.0, 4.0, -4.0),
    (4.0, -4.0, 4.0, 4.0),
    (4.0, 4.0, -4.0, 4.0),
    (-4.0, 4.0, -4.0, -4.0),
]


def planned(
    obstacles: list[Segment], start: Point, goal: Point, radius_m: float = RADIUS_M
) -> list[Point] | None:
    search: Generator[None, None, list[Point] | None] = plan_path(
        as_array(obstacles), start, goal, radius_m
    )
    while True:
        try:
            next(search)
        except StopIteration as end:
            return end.value  # type: ignore[no-any-return]


def length(start: Point, path: list[Point]) -> float:
    return sum(math.dist(a, b) for a, b in pairwise([start, *path]))


def test_where_nothing_is_in_the_way_it_is_one_leg() -> None:
    assert planned([], (0, 0), (3, 1)) == [(3, 1)]
    assert planned(ROOM, (0, 0), (3, 1)) == [(3, 1)]


def test_around_a_wall_it_is_hardly_longer_than_it_must_be() -> None:
    wall = (1.0, -1.0, 1.0, 1.0)
    path = planned([*ROOM, wall], (0, 0), (2, 0))
    assert path is not None
    assert path[-1] == (2, 0)
    assert path_clearance([(0, 0), *path], as_array([*ROOM, wall])) >= RADIUS_M + TIGHT_M
    min_length = 2 * math.hypot(1.0, 1.0 + RADIUS_M)
    assert min_length <= length((0, 0), path) < 1.15 * min_length


def test_through_a_door_that_just_fits_and_not_through_a_smaller_one() -> None:
    def rooms(door_m: float) -> list[Segment]:
        return [*ROOM, (0.0, -4.0, 0.0, -door_m / 2), (0.0, door_m / 2, 0.0, 4.0)]

    wide, narrow = 2 * (RADIUS_M + TIGHT_M) + 0.06, 2 * RADIUS_M
    path = planned(rooms(wide), (-2, 1), (2, -1))
    assert path is not None
    assert path_clearance([(-2, 1), *path], as_array(rooms(wide))) >= RADIUS_M + TIGHT_M
    assert planned(rooms(narrow), (-2, 1), (2, -1)) is None


def test_to_a_place_inside_something_there_is_no_way() -> None:
    ring = [
        (1.0, -1.0, 3.0, -1.0),
        (3.0, -1.0, 3.0, 1.0),
        (3.0, 1.0, 1.0, 1.0),
        (1.0, 1.0, 1.0, -1.0),
    ]
    assert planned([*ROOM, *ring], (0, 0), (2, 0)) is None
    assert planned(ROOM, (0, 0), (3.9, 0)) is None
    assert planned(ROOM, (0, 0), (30, 0)) is None


def test_a_robot_that_touches_a_wall_gets_away_from_it() -> None:
    start = (4.0 - RADIUS_M, 0.0)
    path = planned([*ROOM, (0.0, -2.0, 0.0, 2.0)], start, (-2, 0))
    assert path is not None
    assert path[-1] == (-2, 0)


coordinates = st.floats(-3.5, 3.5)


@given(
    st.lists(st.tuples(coordinates, coordinates, coordinates, coordinates), max_size=12),
    st.tuples(coordinates, coordinates),
)
def test_a_path_touches_nothing(walls: list[Segment], goal: Point) -> None:
    obstacles, start = as_array([*ROOM, *walls]), (0.0, 0.0)
    room_to_start = path_clearance([start, start], obstacles)
    path = planned([*ROOM, *walls], start, goal)
    if path is not None:
        assert path[-1] == goal
        assert path_clearance([start, *path], obstacles) >= min(
            RADIUS_M + TIGHT_M - 0.03, room_to_start - 0.08
        )


def test_the_way_back_is_as_long_as_the_way_there() -> None:
    walls = [*ROOM, (1.0, -3.0, 1.0, 2.0), (2.0, -2.0, 2.0, 4.0)]
    there, back = planned(walls, (0, 0), (3, 0)), planned(walls, (3, 0), (0, 0))
    assert there is not None
    assert back is not None
    assert length((0, 0), there) == pytest.approx(length((3, 0), back), rel=0.05)
