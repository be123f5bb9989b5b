"""Poses, twists, sensors, the RobotLink protocol, robot models and profiles. PURE: no IO, thread or clock."""

from pinel_desktop.robot.geometry import STANDSTILL, Pose2D, Twist2D, wrap_angle
from pinel_desktop.robot.link import RobotLink, RobotState
from pinel_desktop.robot.models import PIONEER_3DX, ROBOTS, SMALL_ROBOT, Laser, RobotModel, Sonar
from pinel_desktop.robot.robot_parameters import BOUNDS, RobotParameters, robot_parameters_from
from pinel_desktop.robot.sensors import Segment, Sensors
from pinel_desktop.robot.simulation_config import (
    FEEDBACKS,
    PRESETS,
    Feedback,
    Preset,
    SimulationConfig,
    simulation_config_from,
)

__all__ = [
    "BOUNDS",
    "FEEDBACKS",
    "PIONEER_3DX",
    "PRESETS",
    "ROBOTS",
    "SMALL_ROBOT",
    "STANDSTILL",
    "Feedback",
    "Laser",
    "Pose2D",
    "Preset",
    "RobotLink",
    "RobotModel",
    "RobotParameters",
    "RobotState",
    "Segment",
    "Sensors",
    "SimulationConfig",
    "Sonar",
    "Twist2D",
    "robot_parameters_from",
    "simulation_config_from",
    "wrap_angle",
]
