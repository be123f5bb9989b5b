"""What a robot can sense, as a capability: a link offers what its robot has, and the rest fails in words."""

import math
from collections.abc import Callable
from typing import Any, NoReturn

from pinel_desktop.errors import PinelError

SCAN_RAD = tuple(math.radians(angle) for angle in range(-90, 91))
Segment = tuple[float, float, float, float]  # x1, y1, x2, y2 in m


class Sensors:
    """The sensors of a link; every link has one of these and adds a method for each sensor that its robot has.

    A method has the name of a row of `program.sensors.SENSORS`. It takes and gives SI units and radians, is called when
    the sensor is read and not before, and may raise PinelError. What has no method raises `sensor_missing`, which fails
    the run in words. `sonar` and `lidar` stand here for those who look at them without a program.
    """

    def reader(self, name: str) -> Callable[..., Any]:
        """The method that reads a sensor; where there is none, a function that raises PinelError `sensor_missing`."""
        found: Callable[..., Any] = getattr(self, name, lambda *_: missing(name))
        return found

    def sonar(self, index: int) -> float:
        """Distance in m from the hull to what is ahead of sonar `index`; its range when nothing is near."""
        missing("sonar")

    def lidar(self, angle_rad: float) -> float:
        """Distance in m from the scanner at an angle from the heading; its range when nothing is near."""
        missing("lidar")

    def sonars(self) -> list[float]:
        """What all sonars measure, by index."""
        missing("sonar")

    def scan(self) -> list[float]:
        """What the scanner measures from -90 to 90 degrees, a beam for each degree; right to left."""
        return [self.lidar(angle) for angle in SCAN_RAD]

    def obstacles(self) -> tuple[Segment, ...]:
        """What is known beforehand to stand in the way, as on a map, in the link's frame; nothing without a map."""
        return ()


def missing(sensor: str) -> NoReturn:
    """Says in words that the robot lacks a sensor."""
    raise PinelError("sensor_missing", sensor=sensor)
