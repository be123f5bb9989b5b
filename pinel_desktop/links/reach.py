"""Reachable poses: how far a robot can move between two odometry messages by its commands; all else is a jump."""

import math
from collections import deque
from typing import NamedTuple

from pinel_desktop.robot import Pose2D, Twist2D, wrap_angle

# A velocity may take effect for this time after its replacement: a robot that polls once a second
# still follows it, and drives need time to brake.
_LINGERS_S = 1.0
# The network's delay varies, so the time between two measurements may exceed the time between their
# arrivals. The allowance for that is the longest recent gap between messages, within these limits.
_LATE_S, _MAX_LATE_S = 0.2, 1.0
# Tolerances beyond the commanded motion: for coarse odometry and overshoot, and per second for a
# person who pushes the robot.
_TOLERANCE_M, _PUSH_MPS = 0.1, 0.1
_TOLERANCE_RAD, _PUSH_RADPS = math.radians(15.0), math.radians(15.0)


class _Speeds(NamedTuple):
    """The maximum speed in each direction, in m/s and rad/s, none negative."""

    ahead: float
    back: float
    left: float
    right: float


# Before the first command another program may drive the robot, as fast as any profile allows.
_ANYBODY = _Speeds(1.2, 1.2, math.radians(300.0), math.radians(300.0))


class CommandedReach:
    """Decides which poses a robot can reach between two odometry messages. Times are by this PC's monotonic clock."""

    def __init__(self) -> None:
        # each command with the time from which it counts
        self._commands: deque[tuple[float, _Speeds]] = deque([(-math.inf, _ANYBODY)])

    def command(self, twist: Twist2D, now_s: float) -> None:
        """Records the velocity that the robot is commanded from `now_s` until the next call."""
        v, omega = twist
        speeds = _Speeds(max(v, 0.0), max(-v, 0.0), max(omega, 0.0), max(-omega, 0.0))
        if speeds != self._commands[-1][1]:
            self._commands.append((now_s, speeds))

    def allows(self, step: Pose2D, since_s: float, now_s: float, late_s: float) -> bool:
        """Returns whether the robot can have made this step.

        Args:
            step: the new pose in the frame of the previous pose.
            since_s, now_s: arrival times of the two messages.
            late_s: longest recent time between two messages.
        """
        self._forget(since_s - _LINGERS_S)
        passed_s = now_s - since_s
        tolerance_m = _TOLERANCE_M + _PUSH_MPS * passed_s
        tolerance_rad = _TOLERANCE_RAD + _PUSH_RADPS * passed_s
        if math.hypot(step.x_m, step.y_m) <= tolerance_m and abs(step.yaw_rad) <= tolerance_rad:
            return True
        time_s = passed_s + min(max(late_s, _LATE_S), _MAX_LATE_S)
        speeds = _Speeds(*map(max, zip(*(speeds for _, speeds in self._commands), strict=True)))
        headings = _Angles(
            -speeds.right * time_s - tolerance_rad, speeds.left * time_s + tolerance_rad
        )
        beyond_m = min(
            headings.beyond_m(step.x_m, step.y_m, speeds.ahead * time_s),
            headings.beyond_m(-step.x_m, -step.y_m, speeds.back * time_s),
        )
        return headings.away_rad(step.yaw_rad) == 0.0 and beyond_m <= tolerance_m

    def _forget(self, before_s: float) -> None:
        """Drops the commands that were replaced before that time."""
        while len(self._commands) > 1 and self._commands[1][0] <= before_s:
            self._commands.popleft()


class _Angles(NamedTuple):
    """A range of headings in rad, counterclockwise from `first` (negative) to `last` (positive)."""

    first: float
    last: float

    def away_rad(self, angle_rad: float) -> float:
        """Returns the distance in rad from an angle to the range; 0 inside."""
        half = (self.last - self.first) / 2
        return max(abs(wrap_angle(angle_rad - self.first - half)) - half, 0.0)

    def beyond_m(self, x_m: float, y_m: float, reach_m: float) -> float:
        """Returns the distance in m from a point to the nearest point that a drive can reach.

        The drive is at most `reach_m` long and has headings of this range.
        """
        distance_m = math.hypot(x_m, y_m)
        # a curve with headings over half a turn or more can end in any direction
        is_any = self.last - self.first >= math.pi
        away_rad = 0.0 if is_any else self.away_rad(math.atan2(y_m, x_m))
        along_m = min(max(distance_m * math.cos(away_rad), 0.0), reach_m)
        return math.hypot(
            distance_m * math.cos(away_rad) - along_m, distance_m * math.sin(away_rad)
        )
