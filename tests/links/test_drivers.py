"""Who commands a robot: the rule that both ways to ROS 2 share."""

import pytest

from pinel_desktop.links.ros2.node.drivers import drivers

ROBOT, TELEOP, RECORDER = "robot", "teleop", "recorder"


@pytest.mark.parametrize(
    ("publish", "listen", "report", "others"),
    [
        pytest.param({TELEOP}, {ROBOT}, {ROBOT}, {TELEOP}, id="who commands"),
        pytest.param({TELEOP}, {ROBOT, TELEOP}, {ROBOT}, {TELEOP}, id="who listens as well"),
        pytest.param({TELEOP}, {ROBOT, TELEOP}, {"ekf"}, {TELEOP}, id="odometry of another"),
        pytest.param({ROBOT}, {ROBOT, RECORDER}, {ROBOT}, set(), id="a bridge, and a recorder"),
        pytest.param({ROBOT}, {ROBOT}, {"ekf"}, set(), id="a bridge of commands only"),
        pytest.param(set(), {ROBOT, RECORDER}, {ROBOT}, set(), id="who only listens"),
    ],
)
def test_the_robot_itself_and_who_only_listens_do_not_drive(
    publish: set[str], listen: set[str], report: set[str], others: set[str]
) -> None:
    assert drivers(publish, listen, report) == others
