"""Base class of a robot's sensors. A link implements the sensors of its robot; reading any other raises an error."""

from collections.abc import Callable, Mapping
from typing import Any, NoReturn

from pinel_desktop.errors import PinelError

Segment = tuple[float, float, float, float]  # x1, y1, x2, y2 in m


class Sensors:
    """Base class of a link's sensors; a subclass adds a method for each sensor of its robot.

    A method has the name of a row of `program.sensors.SENSORS` and uses SI units and radians. It is called when a
    program reads the sensor, and it may raise PinelError. A sensor without a method raises `sensor_missing`, which
    fails the run. `sonar` and `lidar` are declared here because `sonars`, `scan` and the stream to the page call them.
    """

    def reader(self, name: str) -> Callable[..., Any]:
        """Returns the method of a sensor; without one, a function that raises PinelError `sensor_missing`."""
        found: Callable[..., Any] = getattr(self, name, lambda *_: missing(name))
        return found

    def sonar(self, index: int) -> float:
        """Returns the distance in m from the hull to the nearest obstacle of sonar `index`, at most its range."""
        missing("sonar")

    def lidar(self, angle_rad: float) -> float:
        """Returns the distance in m from the scanner at an angle from the heading, at most the scanner's range."""
        missing("lidar")

    def sonars(self) -> list[float]:
        """Returns the readings of all sonars in m, by index."""
        missing("sonar")

    def scan(self) -> list[float]:
        """Returns the readings of the scanner in m over its field, from right to left, one per degree."""
        missing("lidar")

    def obstacles(self) -> tuple[Segment, ...]:
        """Returns the obstacles of the map in m, in the link's frame; empty without a map."""
        return ()

    def places(self) -> Mapping[str, tuple[float, float]]:
        """Returns the centres of the world's places (m, in the link's frame) by name; empty without a known world."""
        return {}


def missing(sensor: str) -> NoReturn:
    """Raises PinelError `sensor_missing`."""
    raise PinelError("sensor_missing", sensor=sensor)
