"""Path planning around obstacles: obstacles of the map, and obstacles that sensors detect while the robot drives."""

import math
from collections.abc import Generator

from pinel_desktop.control.planning import (
    CELL_M,
    TIGHT_M,
    Array,
    Point,
    as_array,
    clearances,
    path_clearance,
    plan_path,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.motion import drive_to, rest_first
from pinel_desktop.execution.requests import Preempt, Routine
from pinel_desktop.robot import Pose2D

_SCAN_TICKS = 3  # ten scans a second
_BEAMS_RAD = tuple(math.radians(angle) for angle in range(-90, 91, 3))
_KNOWN_M = 0.12  # a detected point this near to a mapped obstacle belongs to it
_NEAR = 0.98  # of a sensor's range; a longer measurement means no obstacle
_MAX_PLANS = 60


class Obstacles:
    """The known obstacles in the start frame (m): the map, and points scanned since."""

    def __init__(self, context: RunContext) -> None:
        self._context, self._robot = context, context.robot
        self._map = as_array(
            [_in_start_frame(s, context.origin) for s in context.sensors.obstacles()]
        )
        self._scanned: dict[tuple[int, int], Point] = {}
        self._has_range_sensors = True

    def obstacles(self) -> Array:
        """All obstacles, mapped and scanned."""
        points = as_array([(*point, *point) for point in self._scanned.values()])
        return points if not len(self._map) else as_array([*self._map, *points])

    def blocks(self, path: list[Point]) -> bool:
        """Scans; returns whether the robot, driving along the path, would touch a new point."""
        new = self.scan()
        if not len(new):
            return False
        return path_clearance(path, new) < self._robot.radius_m + TIGHT_M / 2.0

    def scan(self) -> Array:
        """Scans the surroundings; returns the new points."""
        hits = self._hits()
        if not hits:
            return as_array([])
        far = clearances(as_array(hits)[:, :2], self._map) > _KNOWN_M
        new = [hit for hit, is_new in zip(hits, far, strict=True) if is_new]
        fresh = {(round(x / CELL_M), round(y / CELL_M)): (x, y) for x, y, *_ in new}
        fresh = {cell: point for cell, point in fresh.items() if cell not in self._scanned}
        self._scanned |= fresh
        return as_array([(*point, *point) for point in fresh.values()])

    def _hits(self) -> list[tuple[float, float, float, float]]:
        """Returns the points (start frame, m) that the laser's or else the sonars' beams hit; empty without both."""
        if not self._has_range_sensors:
            return []
        pose = self._context.pose
        yaw = pose.yaw_rad
        hits = []
        try:
            for start, angle, distance in self._beams():
                x, y, _ = pose.compose(Pose2D(*start))
                px = x + distance * math.cos(yaw + angle)
                py = y + distance * math.sin(yaw + angle)
                hits.append((px, py, px, py))
        except PinelError:  # a robot without range sensors has only the map
            self._has_range_sensors = False
        return hits

    def _beams(self) -> list[tuple[Point, float, float]]:
        """Returns the start (robot frame, m), angle (rad) and length (m) of each beam that hit something."""
        robot, sensors = self._robot, self._context.sensors
        try:
            scan = [(angle, sensors.lidar(angle)) for angle in _BEAMS_RAD]
        except PinelError:
            sonars = [(*sonar.ray, sonar.angle_rad) for sonar in robot.sonars]
            measured = [sensors.sonar(index) for index in range(len(sonars))]
            reach = robot.sonar_range_m * _NEAR
            beams = zip(sonars, measured, strict=True)
            return [(start, a, along + one) for (start, along, a), one in beams if one < reach]
        place = (robot.laser.x_m, robot.laser.y_m) if robot.laser else (0.0, 0.0)
        reach = robot.lidar_range_m * _NEAR
        return [(place, angle, distance) for angle, distance in scan if distance < reach]


def drive_around(context: RunContext, x_m: float, y_m: float) -> Routine:
    """Drives to a point of the start frame (m) around obstacles; plans a new path when a new obstacle blocks the path.

    Raises RunFailureError `no_way` without a path.
    """
    known, goal = Obstacles(context), (x_m, y_m)
    known.scan()
    for _ in range(_MAX_PLANS):
        yield from rest_first(context)
        here = context.pose if context.reference_lost else context.reference
        path = yield from _planned(known, here, goal, context.robot.radius_m)
        if path is None:
            break
        yield from _follow(context, known, path)
        if not context.reference_lost:
            return None
    raise RunFailureError("no_way", x=x_m, y=y_m)


def _planned(
    known: Obstacles, here: Pose2D, goal: Point, radius_m: float
) -> Generator[Preempt, None, list[Point] | None]:
    search = plan_path(known.obstacles(), (here.x_m, here.y_m), goal, radius_m)
    while True:
        try:
            next(search)
        except StopIteration as end:
            path: list[Point] | None = end.value
            return path
        yield Preempt.YIELD


def _follow(context: RunContext, known: Obstacles, path: list[Point]) -> Routine:
    """Drives the legs in turn; ends early, at rest and without a reference, when the path is blocked."""
    for i, (x, y) in enumerate(path):

        def interrupted(rest: list[Point] = path[i:]) -> bool:
            if context.tick % _SCAN_TICKS:
                return False
            return known.blocks([(context.pose.x_m, context.pose.y_m), *rest])

        yield from drive_to(context, x, y, interrupted)
        if context.reference_lost:
            return None
    return None


def _in_start_frame(
    segment: tuple[float, float, float, float], origin: Pose2D
) -> tuple[float, float, float, float]:
    x1, y1, x2, y2 = segment
    a, b = (Pose2D(x, y).relative_to(origin) for x, y in ((x1, y1), (x2, y2)))
    return a.x_m, a.y_m, b.x_m, b.y_m
