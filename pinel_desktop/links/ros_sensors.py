"""Sensors of a ROS 2 robot: converts its newest messages to the units and directions of a program's sensors."""

import math
import re
import time
from collections.abc import Sequence
from dataclasses import dataclass, field

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotModel, Sensors
from pinel_desktop.robot.sensors import missing

# An older reading does not describe the robot's present surroundings.
_MAX_AGE_S = 1.0
_NUMBER = re.compile(r"(\d+)(?!.*\d)")


@dataclass(frozen=True, slots=True)
class LidarScan:
    """One scan of a laser scanner (sensor_msgs/LaserScan).

    Attributes:
        first_rad, step_rad: angle of the first reading from the heading, and from one reading to the next.
        min_range_m, max_range_m: range of the scanner.
        ranges_m: the readings; a value out of range, or no number, means that the beam found no obstacle.
        arrived_s: arrival time of the scan, by this PC's monotonic clock.
    """

    first_rad: float
    step_rad: float
    min_range_m: float
    max_range_m: float
    ranges_m: Sequence[float]
    arrived_s: float = field(default_factory=time.monotonic)

    def at(self, angle_rad: float, reach_m: float) -> float | None:
        """Returns the reading in m at an angle from the heading, at most `reach_m`; None outside the field."""
        index = round(math.remainder(angle_rad - self.first_rad, math.tau) / (self.step_rad or 1.0))
        if index < 0:  # more than half a turn from the first reading
            index += round(math.tau / abs(self.step_rad or 1.0))
        if not 0 <= index < len(self.ranges_m):
            return None
        return self._checked(self.ranges_m[index], reach_m)

    def _checked(self, range_m: float, reach_m: float) -> float:
        """Returns a valid distance in m for a reading, by REP 117.

        Minus infinity means that an obstacle is too near. Infinity and impossible values mean that there is none.
        """
        if range_m == -math.inf:
            return min(self.min_range_m, reach_m)
        is_measured = self.min_range_m <= range_m <= self.max_range_m and range_m > 0.0
        return min(range_m, reach_m) if is_measured else reach_m


class RosSensors(Sensors):
    """Sensors of a ROS 2 robot; available are the sensors whose topics the robot publishes.

    The receiving thread writes the readings. It replaces each reading as a whole, so no lock is needed.
    """

    def __init__(self, robot: RobotModel) -> None:
        self._robot = robot
        self._offered: set[str] = set()
        self._scan: LidarScan | None = None
        self._sonars: dict[int, tuple[float, float]] = {}  # index: m from the hull, arrived (s)
        self._bumper: bool | None = None

    def offer(self, sensor: str) -> None:
        """Makes a sensor available: `lidar`, `sonar` or `bumper`."""
        self._offered.add(sensor)

    def withdraw(self, sensor: str) -> None:
        """Discards the last readings of a sensor whose topic has no publisher any more."""
        if sensor == "lidar":
            self._scan = None
        elif sensor == "sonar":
            self._sonars = {}
        else:
            self._bumper = None

    def on_scan(self, scan: LidarScan) -> None:
        self._scan = scan

    def on_range(self, frame: str, range_m: float, max_range_m: float) -> None:
        """Handles a reading of one sonar; its index is the last number in the name of its frame, or 0 without one."""
        number = _NUMBER.search(frame)
        self._update_sonar(int(number[1]) if number else 0, range_m, max_range_m)

    def on_points(self, points: Sequence[tuple[float, float]]) -> None:
        """Handles the point that each sonar measured, in the robot's frame in m, as RosAria publishes them."""
        for index, (x, y) in enumerate(points):
            self._update_sonar(index, math.hypot(x, y) - self._robot.radius_m, math.inf)

    def on_bumper(self, pressed: bool) -> None:
        self._bumper = pressed

    def touches(self) -> bool:
        """Returns whether the bumper is pressed, for telemetry; False without a bumper."""
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
        """Returns the readings of the robot model's beams; a beam outside the scanner's field has the maximum range."""
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
