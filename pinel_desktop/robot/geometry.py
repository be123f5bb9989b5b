"""Poses, twists and angles in the plane, in metres and radians; counterclockwise is positive."""

import math
from typing import NamedTuple


def wrap_angle(angle_rad: float) -> float:
    """Returns the equivalent angle in (-pi, pi]."""
    if -math.pi < angle_rad <= math.pi:
        return angle_rad
    wrapped = math.remainder(angle_rad, math.tau)
    return math.pi if wrapped == -math.pi else wrapped


class Pose2D(NamedTuple):
    """Position and heading: x and y in metres, yaw in radians, in (-pi, pi]."""

    x_m: float = 0.0
    y_m: float = 0.0
    yaw_rad: float = 0.0

    def compose(self, local: "Pose2D") -> "Pose2D":
        """Transforms `local` from the frame of this pose into the frame in which this pose is given."""
        cos, sin = math.cos(self.yaw_rad), math.sin(self.yaw_rad)
        return Pose2D(
            self.x_m + cos * local.x_m - sin * local.y_m,
            self.y_m + sin * local.x_m + cos * local.y_m,
            wrap_angle(self.yaw_rad + local.yaw_rad),
        )

    def relative_to(self, origin: "Pose2D") -> "Pose2D":
        """Transforms this pose into the frame of `origin`: the inverse of `origin.compose`."""
        cos, sin = math.cos(origin.yaw_rad), math.sin(origin.yaw_rad)
        dx, dy = self.x_m - origin.x_m, self.y_m - origin.y_m
        return Pose2D(
            cos * dx + sin * dy,
            cos * dy - sin * dx,
            wrap_angle(self.yaw_rad - origin.yaw_rad),
        )

    def distance_to(self, other: "Pose2D") -> float:
        """Returns the distance between the two positions, in metres."""
        return math.hypot(other.x_m - self.x_m, other.y_m - self.y_m)


class Twist2D(NamedTuple):
    """Velocity of a differential-drive robot: v in m/s ahead, omega in rad/s counterclockwise."""

    v_mps: float = 0.0
    omega_radps: float = 0.0


STANDSTILL = Twist2D()
