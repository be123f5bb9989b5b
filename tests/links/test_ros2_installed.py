"""The node of the link over ROS 2, and the direct connection, against a robot on a real rclpy, where there is one."""

import json
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.links import open_link
from pinel_desktop.links.real import RealLink
from pinel_desktop.links.ros2 import installed
from pinel_desktop.robot.record import DdsRecord, RobotRecord, Room, Ros2Record
from pinel_desktop.runs.spec import RunSpec
from tests.links.dds_domains import own_domain
from tests.links.real_link_contract import LiveRun
from tests.links.test_dds import eventually, wait_for

pytestmark = pytest.mark.waits

ROBOT = Path(__file__).parent / "rclpy_robot.py"
NEAR = [{"action": "move_forward", "distance": 0.3}]


def robot_command(domain: int) -> list[str]:
    """Runs the robot by the Python of the ROS that the link would take. Skips where there is none."""
    command = installed.node_command(str(domain))
    ours = str(installed.NODE)
    command = command and [str(ROBOT) if part == ours else part for part in command]
    needs = "import rclpy, nav_msgs.msg, sensor_msgs.msg"
    if command:
        python = [*command[: command.index(str(ROBOT))], "-c", needs]
        if subprocess.run(python, capture_output=True, check=False).returncode == 0:
            return command
    pytest.skip("this PC has no ROS 2 with rclpy: its node is tested with a fake one only")


@pytest.fixture
def robot() -> Iterator[tuple[int, "subprocess.Popen[str]"]]:
    """The domain of a robot, and its process."""
    with own_domain() as domain:
        command = robot_command(domain)
        with subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        ) as process:
            assert process.stdout is not None
            assert process.stdout.readline() == "ready\n"
            yield domain, process


@pytest.mark.parametrize("kind", [Ros2Record, DdsRecord])
def test_a_robot_on_a_real_rclpy_is_driven_and_its_sensors_are_read(
    robot: tuple[int, "subprocess.Popen[str]"], kind: type[RobotRecord]
) -> None:
    domain, process = robot
    record = kind.model_validate({"domain": domain, "room": Room(width_m=20.0, depth_m=20.0)})
    run = LiveRun(RunSpec(NEAR, "empty_room", link=record.link, robot=record))
    run.thread.start()
    assert run.result().ended.state == "finished", run.result().ended
    link = open_link(record.link, world="empty_room", robot=record)
    link.connect()
    assert isinstance(link, RealLink)
    assert eventually(lambda: link.sensors.lidar(0.0)) == pytest.approx(1.25)
    assert link.read().pose.x_m == pytest.approx(0.3, abs=0.05)
    wait_for(lambda: link.battery == 0.75)
    link.close()
    heard, _ = process.communicate(timeout=20)
    velocities = [json.loads(line)[1:] for line in heard.splitlines()]
    assert max(v for v, _ in velocities) > 0.1
    assert velocities[-1] == [0.0, 0.0]
