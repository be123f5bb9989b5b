"""What a robot may have done since its last report, by the velocities that it was commanded; all else is a jump."""

import math
from collections import deque
from typing import NamedTuple

from pinel_desktop.robot import Pose2D, Twist2D, wrap_angle

# A velocity may still work for so long after another took its place: a robot that asks once a second follows it until
# then, and drives need time to brake.
_LINGERS_S = 1.0
# Reports come over a network, some later than others: so much more time than between two arrivals may have passed.
_LATE_S, _MAX_LATE_S = 0.2, 1.0
# Beside what was commanded: coarse odometry and overshoot, and for each second what somebody pushes.
_TOLERANCE_M, _PUSH_MPS = 0.1, 0.1
_TOLERANCE_RAD, _PUSH_RADPS = math.radians(15.0), math.radians(15.0)


class _Speeds(NamedTuple):
    """The greatest speed in each direction, m/s and rad/s, none negative."""

    ahead: float
    back: float
    left: float
    right: float


# Before the first command anybody may drive the robot, as fast as the fastest record allows.
_ANYBODY = _Speeds(1.2, 1.2, math.radians(300.0), math.radians(300.0))


class CommandedReach:
    """Which poses can be reached from one report to the next. Times are of this PC's monotonic clock."""

    def __init__(self) -> None:
        # from when on each was in force
        self._commands: deque[tuple[float, _Speeds]] = deque([(-math.inf, _ANYBODY)])

    def command(self, twist: Twist2D, now_s: float) -> None:
        """The robot is commanded this velocity until the next one."""
        v, omega = twist
        speeds = _Speeds(max(v, 0.0), max(-v, 0.0), max(omega, 0.0), max(-omega, 0.0))
        if speeds != self._commands[-1][1]:
            self._commands.append((now_s, speeds))

    def allows(self, step: Pose2D, since_s: float, now_s: float, late_s: float) -> bool:
        """Whether the robot can have come so far.

        Args:
            step: its pose, seen from the pose of the report before.
            since_s, now_s: when the two reports arrived.
            late_s: how late reports have been lately.
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
        """Drops commands that had been replaced by then."""
        while len(self._commands) > 1 and self._commands[1][0] <= before_s:
            self._commands.popleft()


class _Angles(NamedTuple):
    """All headings from one to another, counterclockwise, rad; the first is negative, the last positive."""

    first: float
    last: float

    def away_rad(self, angle_rad: float) -> float:
        """From an angle to the nearest of them."""
        half = (self.last - self.first) / 2
        return max(abs(wrap_angle(angle_rad - self.first - half)) - half, 0.0)

    def beyond_m(self, x_m: float, y_m: float, reach_m: float) -> float:
        """From a point to the nearest one that a drive of at most `reach_m` with these headings can end at."""
        distance_m = math.hypot(x_m, y_m)
        # a curve of more than half a turn can end in any direction
        is_any = self.last - self.first >= math.pi
        away_rad = 0.0 if is_any else self.away_rad(math.atan2(y_m, x_m))
        along_m = min(max(distance_m * math.cos(away_rad), 0.0), reach_m)
        return math.hypot(
            distance_m * math.cos(away_rad) - along_m, distance_m * math.sin(away_rad)
        )
