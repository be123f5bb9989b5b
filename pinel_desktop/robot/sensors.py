"""The sensors of a robot: a link implements those that its robot has; reading any other raises an error."""

from collections.abc import Callable, Mapping
from typing import Any, NoReturn

from pinel_desktop.errors import PinelError

Segment = tuple[float, float, float, float]  # x1, y1, x2, y2 in m


class Sensors:
    """Base class of a link's sensors; a subclass adds a method for each sensor of its robot.

    A method has the name of a row of `program.sensors.SENSORS`, uses SI units and radians, is called when a program
    reads the sensor, and may raise PinelError. A sensor without a method raises `sensor_missing`, which fails the
    run. `sonar` and `lidar` are declared here because `sonars`, `scan` and the stream to the page call them.
    """

    def reader(self, name: str) -> Callable[..., Any]:
        """The method that reads a sensor; without one, a function that raises PinelError `sensor_missing`."""
        found: Callable[..., Any] = getattr(self, name, lambda *_: missing(name))
        return found

    def sonar(self, index: int) -> float:
        """Distance in m from the hull to the nearest obstacle of sonar `index`, at most the sonar's range."""
        missing("sonar")

    def lidar(self, angle_rad: float) -> float:
        """Distance in m from the scanner at an angle from the heading, at most the scanner's range."""
        missing("lidar")

    def sonars(self) -> list[float]:
        """Readings of all sonars in m, by index."""
        missing("sonar")

    def scan(self) -> list[float]:
        """Readings of the scanner in m over its field, from the right to the left, one per degree."""
        missing("lidar")

    def obstacles(self) -> tuple[Segment, ...]:
        """Obstacles of the map, in the link's frame; empty without a map."""
        return ()

    def places(self) -> Mapping[str, tuple[float, float]]:
        """Middles of the world's places (m, in the link's frame) by their names; empty where the world is not known."""
        return {}


def missing(sensor: str) -> NoReturn:
    """Raises PinelError `sensor_missing`."""
    raise PinelError("sensor_missing", sensor=sensor)
