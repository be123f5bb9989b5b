"""Robot models of the simulator."""

from flask import Response

from pinel_desktop.robot import ROBOTS, RobotModel
from pinel_desktop.web.api import answers, resource
from pinel_desktop.web.models.robots import Robot, RobotList
from pinel_desktop.web.responses import answer

api = resource("robots", "Robot models of the simulator.", __name__)


@api.get("/robots", responses=answers(RobotList))
def list_robots() -> Response:
    """All robot models, the default first."""
    return answer(RobotList(robots=[_model(robot) for robot in ROBOTS.values()]))


def _model(robot: RobotModel) -> Robot:
    angles, range_m = list(robot.sonar_angles_rad), robot.lidar_range_m or None
    return Robot.of(robot, sonar_angles_rad=angles, lidar_range_m=range_m)
