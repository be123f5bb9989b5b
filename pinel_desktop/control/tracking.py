"""Tracking a moving set-point: feedforward of its velocity plus proportional correction of the pose error."""

import math
from typing import NamedTuple

from pinel_desktop.robot.geometry import Pose2D, Twist2D


class Gains(NamedTuple):
    """Proportional gains, in 1/s; `across` in rad/m per metre driven.

    At 30 Hz a discrete loop with one tick of delay stays well damped up to about 8 1/s; half of that settles
    an error to 1 % in just over a second without magnifying measurement noise.
    """

    along: float = 4.0
    across: float = 8.0
    yaw: float = 5.0


DEFAULT_GAINS = Gains()


class Line:
    """The straight line through `start` along its yaw: errors of a pose against a set-point on it.

    After Y. Kanayama et al., "A stable tracking control method for an autonomous mobile robot" (1990), with the
    reference turning speed zero.
    """

    def __init__(self, start: Pose2D, gains: Gains = DEFAULT_GAINS) -> None:
        self.start = start
        self.gains = gains
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
        along, across, turn = self.gains
        return Twist2D(v_mps + along * error_m, turn * yaw_error - across * v_mps * across_m)
