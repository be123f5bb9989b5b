"""Robots that the simulator has."""

from flask import Response

from pinel_desktop.robot import ROBOTS, RobotModel
from pinel_desktop.web.answers import answer
from pinel_desktop.web.api import answers, resource
from pinel_desktop.web.models.robots import Robot, RobotList

api = resource("robots", "Robots that the simulator has.", __name__)


@api.get("/robots", responses=answers(RobotList))
def list_robots() -> Response:
    """All robots with what is needed to draw them; the usual one first."""
    return answer(RobotList(robots=[_model(robot) for robot in ROBOTS.values()]))


def _model(robot: RobotModel) -> Robot:
    return Robot(
        name=robot.name,
        title=robot.title,
        radius_m=robot.radius_m,
        max_v_mps=robot.max_v_mps,
        max_omega_radps=robot.max_omega_radps,
        sonar_angles_rad=list(robot.sonar_angles_rad),
        sonar_range_m=robot.sonar_range_m,
        lidar_range_m=robot.lidar_range_m or None,
    )
