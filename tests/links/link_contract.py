"""Tests common to all robot links; subclassed once per backend."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any, ClassVar

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.clock import TICK_S
from pinel_desktop.links import open_link
from pinel_desktop.program.sensors import DEGREES, SENSORS, Sensor
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotLink, Twist2D


def _arguments(sensor: Sensor) -> list[tuple[Any, ...]]:
    """Arguments of a sensor at the bounds of the language, in the link's units."""
    argument = sensor.argument
    if argument is None:
        return [()]
    to_si = math.radians if argument.unit == DEGREES else int if argument.whole else float
    return [(to_si(bound),) for bound in (argument.low, argument.high)]


def _answers_or_is_missing(sensor: Sensor, answer: Callable[[], Any]) -> bool:
    try:
        value = answer()
    except PinelError as error:
        return (error.code, error.params) == ("sensor_missing", {"sensor": sensor.name})
    return sensor.is_possible(math.degrees(value) if sensor.unit == DEGREES else value)


class LinkContract:
    """A subclass names its backend, and overrides `open` if needed."""

    link: ClassVar[str]
    farthest_m, farthest_rad = 0.31, 1.05  # after a second at 0.3 m/s, 1 rad/s
    twist_error = 0.0  # of a measured velocity, as a part of it

    def open(self) -> RobotLink:
        """Opens and connects the link."""
        link = open_link(self.link, world="obstacles")
        link.connect()
        return link

    def drive(self, link: RobotLink, twist: Twist2D, seconds: float) -> None:
        for _ in range(round(seconds / TICK_S)):
            link.command(twist)
            link.advance(TICK_S)

    def moved(self, link: RobotLink, start: Pose2D) -> Pose2D:
        return link.read().pose.relative_to(start)

    def test_robot_stands_until_it_is_told_to_move(self) -> None:
        link = self.open()
        start = link.read()
        self.drive(link, STANDSTILL, 0.5)
        assert start.twist == STANDSTILL
        assert self.moved(link, start.pose) == Pose2D()
        link.close()

    def test_positive_velocity_drives_ahead_and_positive_omega_turns_left(self) -> None:
        link = self.open()
        start = link.read().pose
        self.drive(link, Twist2D(0.3, 0.0), 1.0)
        ahead = self.moved(link, start)
        assert 0.2 < ahead.x_m < self.farthest_m
        assert abs(ahead.y_m) < 0.01
        self.drive(link, Twist2D(0.0, 1.0), 1.0)
        assert 0.7 < self.moved(link, start).yaw_rad < self.farthest_rad
        link.close()

    def measured_twist(self, link: RobotLink, twist: Twist2D) -> Twist2D:
        """What the link measures while it drives with `twist`."""
        return link.read().twist

    def test_twist_is_measured_in_the_robots_frame(self) -> None:
        link = self.open()
        self.drive(link, Twist2D(0.0, 1.0), 1.5)
        self.drive(link, Twist2D(-0.3, 0.0), 1.0)
        measured = self.measured_twist(link, Twist2D(-0.3, 0.0))
        assert math.isclose(measured.v_mps, -0.3, abs_tol=0.02 + 0.3 * self.twist_error)
        assert math.isclose(measured.omega_radps, 0.0, abs_tol=0.02)
        link.close()

    def test_commands_beyond_the_robot_are_cut_to_what_it_can_do(self) -> None:
        link = self.open()
        self.drive(link, Twist2D(50.0, 0.0), 1.0)
        assert link.read().twist.v_mps <= 1.2 * (1.0 + self.twist_error) + 1e-6
        link.close()

    def test_closing_twice_is_fine(self) -> None:
        link = self.open()
        link.close()
        link.close()

    def test_every_sensor_answers_in_its_range_or_says_that_it_is_missing(self) -> None:
        link = self.open()
        for sensor in SENSORS.values():
            for asked in _arguments(sensor):
                answer = partial(link.sensors.reader(sensor.name), *asked)
                assert _answers_or_is_missing(sensor, answer), (sensor.name, asked)
        assert link.bumper() in (True, False)
        link.close()
