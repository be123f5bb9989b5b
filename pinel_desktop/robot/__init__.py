"""Pose, twist, state, the RobotLink protocol and robot records. PURE: no IO, thread or clock."""

from pinel_desktop.robot.geometry import STANDSTILL, Pose2D, Twist2D, wrap_angle
from pinel_desktop.robot.link import RobotLink, RobotState
from pinel_desktop.robot.models import PIONEER_3DX, Direction, RobotModel
from pinel_desktop.robot.sensors import Sensors

__all__ = [
    "PIONEER_3DX",
    "STANDSTILL",
    "Direction",
    "Pose2D",
    "RobotLink",
    "RobotModel",
    "RobotState",
    "Sensors",
    "Twist2D",
    "wrap_angle",
]
