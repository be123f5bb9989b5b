"""Tracking a moving set-point: feedforward of its velocity plus correction of the pose error (docs/control.md)."""

import math
from typing import NamedTuple

from pinel_desktop.control.trim import Trim
from pinel_desktop.robot.geometry import Pose2D, Twist2D, wrap_angle


class Gains(NamedTuple):
    """Proportional gains in 1/s, `across` in rad/m per metre driven; `learn`, the integral one, in rad/m per m².

    How they were found is in docs/control.md, and `scripts/sweep_gains.py` finds them again.
    """

    along: float = 4.0
    across: float = 8.0
    yaw: float = 5.0
    learn: float = 0.0


DEFAULT_GAINS = Gains()
# for wheels that slip and poses that come with noise
SLIPPING_GAINS = Gains(learn=10.0)


TICK_S = 1.0 / 30.0  # the controller is asked once a tick
_CREEP_MPS = 0.015
# below, noise in the position would tell nothing of the way along an arc
_SMALL_RADIUS_M = 0.1


class Line:
    """The straight line through `start` along its yaw: errors of a pose against a set-point on it.

    After Y. Kanayama et al., "A stable tracking control method for an autonomous mobile robot" (1990), with the
    reference turning speed zero.
    """

    def __init__(
        self, start: Pose2D, gains: Gains = DEFAULT_GAINS, trim: Trim | None = None
    ) -> None:
        self.start = start
        self.gains = gains
        self._trim = trim or Trim()
        self._cos, self._sin = math.cos(start.yaw_rad), math.sin(start.yaw_rad)

    def along(self, pose: Pose2D) -> float:
        """How far `pose` has come along the line, in metres."""
        return self._cos * (pose.x_m - self.start.x_m) + self._sin * (pose.y_m - self.start.y_m)

    def point(self, distance_m: float) -> Pose2D:
        """The pose on the line, `distance_m` from its start."""
        x, y, yaw = self.start
        return Pose2D(x + distance_m * self._cos, y + distance_m * self._sin, yaw)

    def correct(self, pose: Pose2D, error_m: float, v_mps: float) -> Twist2D:
        """The twist that drives at `v_mps` and takes the errors away.

        `error_m` is how far the set-point is ahead of `pose` along the line.
        """
        x, y, yaw = pose
        x0, y0, yaw0 = self.start
        across_m = self._cos * (y - y0) - self._sin * (x - x0)
        yaw_error = math.remainder(yaw0 - yaw, math.tau)
        along, across, turn, learn = self.gains
        omega = turn * yaw_error - across * v_mps * across_m
        if learn:
            self._trim.learn(across_m, v_mps * TICK_S, learn)
            omega += v_mps * self._trim.per_m
        return Twist2D(v_mps + along * error_m, omega)


class Arc:
    """The circular arc from `start`: errors of a pose against a set-point on it, given as the angle turned so far.

    Driving along it changes the heading by the angle, ahead for a positive radius and backwards for a negative one;
    a radius of 0 turns on the spot. Same law of control as `Line`, in the frame of the set-point.
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
        # signed curvature radius: dx along the heading for each radian of heading
        self._radius = math.copysign(radius_m, radius_m * angle_rad)
        self._center = self._center_of(start)
        self._done, self._direction = 0.0, self._direction_of(start)

    def _center_of(self, start: Pose2D) -> tuple[float, float]:
        x, y, yaw = start
        return x - self._radius * math.sin(yaw), y + self._radius * math.cos(yaw)

    def _direction_of(self, pose: Pose2D) -> float:
        """What turns with the robot along the arc: the direction from the centre, the heading on very small arcs."""
        if abs(self._radius) < _SMALL_RADIUS_M:
            return pose.yaw_rad
        return math.atan2(pose.y_m - self._center[1], pose.x_m - self._center[0])

    def done(self, pose: Pose2D) -> float:
        """How far the robot has come, as an angle in radians, full circles too; to be asked at every tick."""
        direction = self._direction_of(pose)
        self._done += wrap_angle(direction - self._direction)
        self._direction = direction
        return self._done

    def point(self, turned_rad: float) -> Pose2D:
        """The pose on the arc where the heading has turned by so much."""
        x, y, yaw = self.start
        end = yaw + turned_rad
        return Pose2D(
            x + self._radius * (math.sin(end) - math.sin(yaw)),
            y - self._radius * (math.cos(end) - math.cos(yaw)),
            wrap_angle(end),
        )

    def errors(self, pose: Pose2D, turned_rad: float) -> tuple[float, float, float]:
        """How far the set-point is ahead of `pose` and to its left (m), and left of its heading (rad)."""
        goal = self.point(turned_rad)
        along, across = _offset(goal, pose)
        return along, across, wrap_angle(goal.yaw_rad - pose.yaw_rad)

    def correct(self, pose: Pose2D, turned_rad: float, omega_radps: float) -> Twist2D:
        """The twist that follows the set-point, which turns at `omega_radps`, and takes the errors away."""
        goal = self.point(turned_rad)
        along_m, across_m = _offset(goal, pose)
        yaw_error = wrap_angle(goal.yaw_rad - pose.yaw_rad)
        along, across, turn, learn = self.gains
        v = self._radius * omega_radps
        omega = omega_radps + turn * yaw_error + across * v * across_m
        if learn:
            self._trim.learn(-across_m, v * TICK_S, learn)
            omega += v * self._trim.per_m
        return Twist2D(v + along * along_m, omega)


def _offset(goal: Pose2D, pose: Pose2D) -> tuple[float, float]:
    """Where `goal` is from `pose`, ahead and to the left in the frame of `goal`, in metres."""
    cos, sin = math.cos(goal.yaw_rad), math.sin(goal.yaw_rad)
    dx, dy = goal.x_m - pose.x_m, goal.y_m - pose.y_m
    return cos * dx + sin * dy, cos * dy - sin * dx


def hold_place(goal: Pose2D, pose: Pose2D, gains: Gains) -> float:
    """The speed ahead with which a robot that turns on the spot stays over it, in m/s.

    It can correct what lies ahead of it or behind; as it turns, it comes to look in other directions. It is never so
    fast that it would not count as standing: something may be in the way.
    """
    dx, dy = goal.x_m - pose.x_m, goal.y_m - pose.y_m
    v = gains.along * (math.cos(pose.yaw_rad) * dx + math.sin(pose.yaw_rad) * dy)
    return min(max(v, -_CREEP_MPS), _CREEP_MPS)
