"""Sensors of a robot of ROS: its newest messages, read in the units and directions of a program's sensors."""

import math
import re
import time
from collections.abc import Sequence
from dataclasses import dataclass, field

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotModel, Sensors
from pinel_desktop.robot.sensors import missing

# An older reading says nothing about what is ahead of the robot now.
_MAX_AGE_S = 1.0
_NUMBER = re.compile(r"(\d+)(?!.*\d)")


@dataclass(frozen=True, slots=True)
class LidarScan:
    """One turn of a laser scanner (sensor_msgs/LaserScan).

    Attributes:
        first_rad, step_rad: angle of the first reading from the heading, and from one reading to the next.
        min_range_m, max_range_m: what the scanner can measure.
        ranges_m: its readings; what lies beyond its bounds, or is no number, found nothing.
    """

    first_rad: float
    step_rad: float
    min_range_m: float
    max_range_m: float
    ranges_m: Sequence[float]
    arrived_s: float = field(default_factory=time.monotonic)

    def at(self, angle_rad: float, reach_m: float) -> float | None:
        """Reading in m at an angle from the heading, at most `reach_m`; None outside of the scanner's field."""
        index = round(math.remainder(angle_rad - self.first_rad, math.tau) / (self.step_rad or 1.0))
        if index < 0:  # a field of more than half a turn from its first reading
            index += round(math.tau / abs(self.step_rad or 1.0))
        if not 0 <= index < len(self.ranges_m):
            return None
        return self._checked(self.ranges_m[index], reach_m)

    def _checked(self, range_m: float, reach_m: float) -> float:
        """REP 117: minus infinity is too near to be measured, infinity and everything impossible is nothing found."""
        if range_m == -math.inf:
            return min(self.min_range_m, reach_m)
        is_measured = self.min_range_m <= range_m <= self.max_range_m and range_m > 0.0
        return min(range_m, reach_m) if is_measured else reach_m


class RosSensors(Sensors):
    """Sensors of which there are those whose topic the robot publishes.

    Readings come from the receiving thread; each is replaced as a whole.
    """

    def __init__(self, robot: RobotModel) -> None:
        self._robot = robot
        self._offered: set[str] = set()
        self._scan: LidarScan | None = None
        self._sonars: dict[int, tuple[float, float]] = {}  # index: m from the hull, arrived (s)
        self._bumper: bool | None = None

    def offer(self, sensor: str) -> None:
        """The robot has a sensor: `lidar`, `sonar` or `bumper`."""
        self._offered.add(sensor)

    def withdraw(self, sensor: str) -> None:
        """Nobody tells a sensor's readings any more: the last one counts no longer."""
        if sensor == "lidar":
            self._scan = None
        elif sensor == "sonar":
            self._sonars = {}
        else:
            self._bumper = None

    def on_scan(self, scan: LidarScan) -> None:
        self._scan = scan

    def on_range(self, frame: str, range_m: float, max_range_m: float) -> None:
        """A reading of one sonar, whose number is the last one in the name of its frame; 0 without any."""
        number = _NUMBER.search(frame)
        self._update_sonar(int(number[1]) if number else 0, range_m, max_range_m)

    def on_points(self, points: Sequence[tuple[float, float]]) -> None:
        """Where each sonar found something, in the robot's frame in m, as RosAria publishes them."""
        for index, (x, y) in enumerate(points):
            self._update_sonar(index, math.hypot(x, y) - self._robot.radius_m, math.inf)

    def on_bumper(self, pressed: bool) -> None:
        self._bumper = pressed

    def touches(self) -> bool:
        """Whether the bumper is pressed, for telemetry; False without a bumper."""
        return bool(self._bumper)

    def sonar(self, index: int) -> float:
        self._require("sonar")
        if not self._sonars:
            raise PinelError("sensor_silent", sensor="sonar")
        if index not in self._sonars:
            missing("sonar")
        range_m, arrived_s = self._sonars[index]
        _require_fresh("sonar", arrived_s)
        return range_m

    def sonars(self) -> list[float]:
        self._require("sonar")
        return [self.sonar(index) for index in range(max(self._sonars, default=-1) + 1)]

    def lidar(self, angle_rad: float) -> float:
        reading = self._fresh_scan().at(angle_rad, self._robot.lidar_range_m)
        return reading if reading is not None else missing("lidar")

    def scan(self) -> list[float]:
        """Beams outside of the scanner's field find nothing."""
        scan, laser = self._fresh_scan(), self._robot.laser or missing("lidar")
        readings = (scan.at(angle, laser.range_m) for angle in laser.angles_rad)
        return [laser.range_m if reading is None else reading for reading in readings]

    def bumper(self) -> bool:
        self._require("bumper")
        if self._bumper is None:
            raise PinelError("sensor_silent", sensor="bumper")
        return self._bumper

    def _update_sonar(self, index: int, range_m: float, max_range_m: float) -> None:
        reach_m = self._robot.sonar_range_m
        is_measured = math.isfinite(range_m) and range_m < max_range_m
        found_m = min(max(range_m, 0.0), reach_m) if is_measured else reach_m
        if range_m == -math.inf:
            found_m = 0.0
        if index < len(self._robot.sonars):
            self._sonars = {**self._sonars, index: (found_m, time.monotonic())}

    def _fresh_scan(self) -> LidarScan:
        self._require("lidar")
        if self._scan is None:
            raise PinelError("sensor_silent", sensor="lidar")
        _require_fresh("lidar", self._scan.arrived_s)
        return self._scan

    def _require(self, sensor: str) -> None:
        if sensor not in self._offered:
            missing(sensor)


def _require_fresh(sensor: str, arrived_s: float) -> None:
    if time.monotonic() - arrived_s > _MAX_AGE_S:
        raise PinelError("sensor_silent", sensor=sensor)
