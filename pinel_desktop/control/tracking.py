"""Trajectory tracking controllers: feedforward of the set-point's velocity plus feedback of the pose error."""

import math
from typing import NamedTuple

from pinel_desktop.control.trim import Trim
from pinel_desktop.robot.geometry import Pose2D, Twist2D, wrap_angle


class Gains(NamedTuple):
    """Controller gains. docs/control.md explains their choice; `scripts/sweep_gains.py` repeats the search.

    Attributes:
        along: proportional gain of the along-track error, in 1/s.
        across: proportional gain of the cross-track error, in rad/m per metre driven.
        yaw: proportional gain of the heading error, in 1/s.
        integral: integral gain of the cross-track error, in rad/m per m²; 0 turns it off.
    """

    along: float = 4.0
    across: float = 8.0
    yaw: float = 5.0
    integral: float = 0.0

    def for_delay(self, delay_s: float) -> "Gains":
        """Returns gains at which a control loop with this delay does not oscillate: these, or smaller ones."""
        slower = _STABLE / max(self.along * delay_s, _STABLE)
        return Gains(*(gain * slower for gain in self))


# Limit of a gain (1/s) times the delay of its loop (s). Oscillation grows from pi / 2 on. The limit
# is far below that, because the true delay is longer than the estimated one.
_STABLE = 0.5
DEFAULT_GAINS = Gains()
# for wheels that slip and poses with noise
SLIPPING_GAINS = Gains(integral=10.0)


TICK_S = 1.0 / 30.0  # control period
_CREEP_MPS = 0.015
# Below this radius, position noise hides the progress along an arc; the heading is used instead.
_SMALL_RADIUS_M = 0.1


class LineTracker:
    """Tracks a set-point on the straight line through `start` along its yaw.

    All poses are in the frame in which `start` is given. Control law: Y. Kanayama et al., "A stable tracking control
    method for an autonomous mobile robot" (1990), with a reference turning speed of zero.
    """

    def __init__(
        self, start: Pose2D, gains: Gains = DEFAULT_GAINS, trim: Trim | None = None
    ) -> None:
        self.start = start
        self.gains = gains
        self._trim = trim or Trim()
        self._cos, self._sin = math.cos(start.yaw_rad), math.sin(start.yaw_rad)

    def along(self, pose: Pose2D) -> float:
        """Returns the progress of `pose` along the line, in metres."""
        return self._cos * (pose.x_m - self.start.x_m) + self._sin * (pose.y_m - self.start.y_m)

    def across(self, pose: Pose2D) -> float:
        """Returns the cross-track error: distance of `pose` from the line, in metres, positive to the left."""
        return self._cos * (pose.y_m - self.start.y_m) - self._sin * (pose.x_m - self.start.x_m)

    def point(self, distance_m: float) -> Pose2D:
        """Returns the pose on the line at `distance_m` from its start."""
        x, y, yaw = self.start
        return Pose2D(x + distance_m * self._cos, y + distance_m * self._sin, yaw)

    def correct(self, pose: Pose2D, error_m: float, v_mps: float) -> Twist2D:
        """Returns the twist that drives at `v_mps` and reduces the pose errors.

        Args:
            error_m: distance along the line from `pose` to the set-point, positive if the set-point is ahead.
        """
        x, y, yaw = pose
        x0, y0, yaw0 = self.start
        across_m = self._cos * (y - y0) - self._sin * (x - x0)
        yaw_error = math.remainder(yaw0 - yaw, math.tau)
        along, across, turn, integral = self.gains
        omega = turn * yaw_error - across * v_mps * across_m
        if integral:
            self._trim.integrate(across_m, v_mps * TICK_S, integral)
            omega += v_mps * self._trim.per_m
        return Twist2D(v_mps + along * error_m, omega)


class ArcTracker:
    """Tracks a set-point on the circular arc from `start`, by the control law of `LineTracker`.

    The set-point is given as the angle turned since the start. The arc changes the heading by `angle_rad`. If the
    radius is positive, the robot drives forwards; if negative, backwards; if 0, it turns on the spot.
    """

    def __init__(
        self,
        start: Pose2D,
        radius_m: float,
        angle_rad: float,
        gains: Gains = DEFAULT_GAINS,
        trim: Trim | None = None,
    ) -> None:
        self.start, self.gains, self._trim = start, gains, trim or Trim()
        # signed: path length along the heading per radian of heading
        self._radius = math.copysign(radius_m, radius_m * angle_rad)
        self._center = self._center_of(start)
        self._done, self._direction = 0.0, self._direction_of(start)

    def _center_of(self, start: Pose2D) -> tuple[float, float]:
        x, y, yaw = start
        return x - self._radius * math.sin(yaw), y + self._radius * math.cos(yaw)

    def _direction_of(self, pose: Pose2D) -> float:
        """Returns the angle that measures progress: direction from the arc's centre to the robot, or heading.

        The heading serves arcs below `_SMALL_RADIUS_M`.
        """
        if abs(self._radius) < _SMALL_RADIUS_M:
            return pose.yaw_rad
        return math.atan2(pose.y_m - self._center[1], pose.x_m - self._center[0])

    def done(self, pose: Pose2D) -> float:
        """Returns the progress as an angle in rad, also beyond a full circle; must be called at every tick."""
        direction = self._direction_of(pose)
        self._done += wrap_angle(direction - self._direction)
        self._direction = direction
        return self._done

    def point(self, turned_rad: float) -> Pose2D:
        """Returns the pose on the arc after the heading has turned by `turned_rad`."""
        x, y, yaw = self.start
        end = yaw + turned_rad
        return Pose2D(
            x + self._radius * (math.sin(end) - math.sin(yaw)),
            y - self._radius * (math.cos(end) - math.cos(yaw)),
            wrap_angle(end),
        )

    def errors(self, pose: Pose2D, turned_rad: float) -> tuple[float, float, float]:
        """Returns the error of `pose`: along-track (m), cross-track (m) and heading (rad).

        Each is the set-point minus the pose, in the frame of the set-point: ahead, left and counterclockwise positive.
        """
        goal = self.point(turned_rad)
        along, across = _offset(goal, pose)
        return along, across, wrap_angle(goal.yaw_rad - pose.yaw_rad)

    def correct(self, pose: Pose2D, turned_rad: float, omega_radps: float) -> Twist2D:
        """Returns the twist that follows the set-point, which turns at `omega_radps`, and reduces the pose errors."""
        goal = self.point(turned_rad)
        along_m, across_m = _offset(goal, pose)
        yaw_error = wrap_angle(goal.yaw_rad - pose.yaw_rad)
        along, across, turn, integral = self.gains
        v = self._radius * omega_radps
        omega = omega_radps + turn * yaw_error + across * v * across_m
        if integral:
            self._trim.integrate(-across_m, v * TICK_S, integral)
            omega += v * self._trim.per_m
        return Twist2D(v + along * along_m, omega)


def _offset(goal: Pose2D, pose: Pose2D) -> tuple[float, float]:
    """Returns the vector from `pose` to `goal` in the frame of `goal`: metres ahead and to the left."""
    cos, sin = math.cos(goal.yaw_rad), math.sin(goal.yaw_rad)
    dx, dy = goal.x_m - pose.x_m, goal.y_m - pose.y_m
    return cos * dx + sin * dy, cos * dy - sin * dx


def hold_position(goal: Pose2D, pose: Pose2D, gains: Gains) -> float:
    """Returns the forward speed in m/s that holds the position of a robot while it turns on the spot.

    The robot can correct only the error along its heading, which rotates with the robot. The speed stays below the
    limit of `GoalCheck`, so that a robot pushed against an obstacle still counts as being at rest.
    """
    dx, dy = goal.x_m - pose.x_m, goal.y_m - pose.y_m
    v = gains.along * (math.cos(pose.yaw_rad) * dx + math.sin(pose.yaw_rad) * dy)
    return min(max(v, -_CREEP_MPS), _CREEP_MPS)
