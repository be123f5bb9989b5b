"""The link over an installed ROS 2: its node runs in a process of its own, against a ROS that is not one (fake_ros)."""

import contextlib
import json
import math
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.links.localisation import LocalisedPose
from pinel_desktop.links.real import RealLink
from pinel_desktop.links.ros2 import installed, transport
from pinel_desktop.robot import PIONEER_3DX, RobotLink, Twist2D
from pinel_desktop.robot.robot_profile import RobotProfile, Room, Ros2Profile
from tests.links.dds_domains import own_domain
from tests.links.real_link_contract import Peer, RealLinkContract
from tests.links.socket_robot import GRAPH, SocketRobot, use_fake_ros
from tests.links.test_dds import localised

pytestmark = pytest.mark.waits


_until_the_process_ends = contextlib.ExitStack()


@cache
def domain() -> int:
    """A domain of this process alone: a PC lets only one run at a time drive a robot of the same address."""
    return _until_the_process_ends.enter_context(own_domain())


def a_profile() -> Ros2Profile:
    """A robot of its own: other tests drive theirs at the same time."""
    return Ros2Profile(
        domain=domain(),
        max_v_mps=1.2,
        max_omega_dps=300.0,
        room=Room(width_m=20.0, depth_m=20.0),
    )


class TestRos2Link(RealLinkContract):
    link = "ros2"

    def open(self) -> RobotLink:
        """Waits for the robot's sensors, so that the contract's test of sensors meets them."""
        link = super().open()
        read = link.sensors.reader
        wait_for(lambda: all(answers(read(name)) for name in ("scan", "sonars", "bumper")))
        return link

    @pytest.fixture(autouse=True)
    def _ros(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self._robot_process = SocketRobot()
        use_fake_ros(monkeypatch, self._robot_process)

    @pytest.fixture(autouse=True)
    def _robot(self, _ros: None) -> Iterator[None]:
        yield from self.with_robot()

    def start_peer(self) -> tuple[Peer, RobotProfile]:
        return self._robot_process.unicycle, a_profile()

    def stop_peer(self) -> None:
        self._robot_process.close()


@pytest.fixture
def robot() -> Iterator[SocketRobot]:
    it = SocketRobot()
    yield it
    it.close()


@contextlib.contextmanager
def connected(**more: Any) -> Iterator[RobotLink]:
    link = open_link("ros2", world="empty_room", robot=a_profile().model_copy(update=more))
    try:
        link.connect()
        yield link
    finally:
        link.close()


def why_not(**more: Any) -> PinelError:
    with pytest.raises(PinelError) as refused, connected(**more):
        pass
    return refused.value


def wait_for(condition: Any) -> None:
    due_s = time.monotonic() + 10.0
    while not condition():
        assert time.monotonic() < due_s
        time.sleep(0.01)


def test_a_robot_that_wants_stamped_twists_gets_them(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, command_type="geometry_msgs/msg/TwistStamped")
    with connected() as link:
        link.command(Twist2D(0.3, 0.0))
        wait_for(lambda: any(twist.v_mps == 0.3 for _, twist in robot.unicycle.received))
    assert robot.types == {"TwistStamped"}


def test_a_robot_that_tells_its_pose_only_can_be_driven(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    published = {"/odom": "geometry_msgs/msg/PoseStamped"}
    use_fake_ros(monkeypatch, robot, published=published)
    robot.unicycle.x_m = 2.0
    with connected() as link:
        assert link.read().pose.x_m == 2.0


def test_the_robots_own_localisation_is_read_where_the_profile_names_it(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    kind = "geometry_msgs/msg/PoseWithCovarianceStamped"
    use_fake_ros(monkeypatch, robot, published={**GRAPH["published"], "/amcl_pose": kind})
    robot.is_localised, robot.unicycle.x_m = True, 2.0
    with connected(localisation_topic="amcl_pose") as link:
        found = localised(link)
        assert isinstance(found, LocalisedPose)
        assert found.pose == pytest.approx((2.0, 0.0, 0.0))
        assert found.sigma_m == pytest.approx(0.02)


def test_without_a_robot_topic_and_domain_are_named(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, command_type="")
    error = why_not()
    assert (error.code, error.params["topic"]) == ("robot_not_found", "/cmd_vel")


def test_a_topic_of_another_type_is_named(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, published={"/odom": "std_msgs/msg/String"})
    error = why_not()
    assert (error.code, error.params["found"]) == ("robot_wrong_type", "std_msgs/msg/String")


def test_a_robot_that_another_node_commands_is_not_driven(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, others=["joystick"])
    error = why_not()
    assert (error.code, error.params["holder"]) == ("robot_held", "joystick")


def test_another_node_that_begins_to_command_stops_the_run(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot)
    with connected() as link:
        robot.let_drive(["joystick"])
        wait_for(lambda: problem_of(link) == "robot_held")
        wait_for(lambda: robot.unicycle.standstill_since_s() is not None)


def test_while_another_pinel_is_there_the_robot_stands_and_drives_on_when_that_withdraws(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Both may have heard of each other late, and each believe that it was here first."""
    use_fake_ros(monkeypatch, robot)
    with connected() as link:
        time.sleep(2.5)  # what came earlier began together with this one
        drive_until(link, lambda: robot.unicycle.twist.v_mps > 0.0)
        robot.let_drive(["pinel_blue_1"])
        drive_until(link, lambda: robot.unicycle.twist.v_mps == 0.0)
        robot.let_drive([])
        drive_until(link, lambda: robot.unicycle.twist.v_mps > 0.0)
        robot.let_drive(["pinel_blue_1"])
        wait_for(lambda: problem_of(link) == "robot_held")


def drive_until(link: RobotLink, is_so: Callable[[], bool]) -> None:
    def drives() -> bool:
        link.read()
        link.command(Twist2D(0.3, 0.0))
        return is_so()

    wait_for(drives)


def test_another_node_with_the_name_of_the_robot_stops_the_run(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot)
    with connected() as link:
        robot.let_drive(["robot#2"])
        wait_for(lambda: problem_of(link) == "robot_held")


def test_a_robot_that_is_silent_at_the_end_is_told_for_a_while_to_stand(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It may have been out of reach, and drive on with the last velocity that it heard."""
    use_fake_ros(monkeypatch, robot)
    with connected() as link:
        drive_until(link, lambda: robot.unicycle.twist.v_mps > 0.0)
        robot.unicycle.is_mute = True
        wait_for(lambda: problem_of(link) == "link_lost")
        closing_s = time.monotonic()
    assert robot.unicycle.received[-1][0] > closing_s + 0.3
    assert robot.unicycle.standstill_since_s() is not None


def test_a_node_that_also_listens_to_commands_is_the_robot(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, others=["robot"])
    with connected() as link:
        assert link.read().pose.x_m == 0.0


def answers(read: Callable[[], Any]) -> bool:
    try:
        read()
    except PinelError:
        return False
    return True


def test_sensors_are_those_that_the_robot_publishes(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot)
    with connected() as link:
        assert isinstance(link, RealLink)
        wait_for(lambda: link.battery == 0.75)
        wait_for(link.bumper)
        sensors = link.sensors
        wait_for(lambda: answers(lambda: (sensors.lidar(0.0), sensors.sonars())))
        assert (sensors.lidar(0.0), sensors.lidar(math.pi / 2)) == (1.25, 8.0)
        assert sensors.sonars() == pytest.approx([1.5 + n / 10 for n in range(16)], abs=1e-3)


def is_unresponsive(read: Callable[[], Any]) -> bool:
    """Whether a sensor is told to be silent, not missing."""
    try:
        read()
    except PinelError as problem:
        return problem.code == "sensor_silent"
    return False


def test_a_ring_of_sonars_on_one_topic_is_heard_as_a_whole(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot)
    with connected(sonar_topic="sonar_ring") as link:
        wait_for(lambda: answers(lambda: link.sensors.sonar(15)))
        assert link.sensors.sonars() == pytest.approx([1.5 + n / 10 for n in range(16)])


def test_what_vanishes_in_a_run_is_told(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot)
    with connected() as link:
        assert isinstance(link, RealLink)
        sensors = link.sensors
        wait_for(lambda: link.battery == 0.75)
        reads = {
            "/scan": lambda: sensors.lidar(0.0),
            "/sonar": lambda: sensors.sonar(0),
            "/bumper_state": sensors.reader("bumper"),
        }
        for count, read in enumerate(reads.values(), 1):
            wait_for(partial(answers, read))
            robot.withdraw(list(reads)[:count])
            wait_for(partial(is_unresponsive, read))
        robot.withdraw([*reads, "/battery_state"])
        wait_for(lambda: link.battery is None)
        robot.withdraw(["/cmd_vel"])
        wait_for(lambda: problem_of(link) == "robot_deaf")


def problem_of(link: RobotLink) -> str | None:
    try:
        link.read()
    except PinelError as error:
        return error.code
    return None


def test_without_ros_the_link_says_so(robot: SocketRobot, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(transport, "node_command", lambda configuration: None)
    assert why_not().code == "ros_missing"


def test_a_ros_that_does_not_start_is_named(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(transport, "node_command", lambda configuration: [os.devnull])
    assert why_not().code == "ros_does_not_start"


def test_a_node_that_breaks_at_its_start_is_named(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(transport, "node_command", lambda configuration: [sys.executable, "-c", ""])
    assert why_not().code == "ros_node_ended"


def test_a_ros_that_is_still_starting_does_not_hold_up_the_end(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow = [sys.executable, "-c", "import time; time.sleep(60)"]
    monkeypatch.setattr(transport, "node_command", lambda configuration: slow)
    monkeypatch.setattr(transport, "_END_S", 60.0)
    started_s = time.monotonic()
    link = open_link("ros2", world="empty_room", robot=a_profile())
    link.connect(lambda: True)
    link.close()
    assert time.monotonic() - started_s < 30.0


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGSTOP")
class TestNode:
    """What the node does by itself."""

    @pytest.fixture(autouse=True)
    def _fake(self, robot: SocketRobot, monkeypatch: pytest.MonkeyPatch) -> None:
        use_fake_ros(monkeypatch, robot)

    def node(self) -> psutil.Process:
        mine = psutil.Process().children()
        return next(child for child in mine if any("node.py" in part for part in child.cmdline()))

    def test_a_node_that_is_killed_is_a_problem_of_the_link(self) -> None:
        with connected() as link:
            self.node().kill()
            wait_for(lambda: problem_of(link) is not None)
            assert problem_of(link) == "ros_node_ended"

    def test_a_node_that_hangs_does_not_hold_up_the_end(self) -> None:
        with connected():
            self.node().send_signal(signal.SIGSTOP)
            started_s = time.monotonic()
        assert time.monotonic() - started_s < 20.0

    @pytest.mark.parametrize("graph", [{"command_type": ""}, {"others": ["joystick"]}])
    def test_a_node_whose_app_has_gone_ends_in_the_middle_of_its_search(
        self, robot: SocketRobot, monkeypatch: pytest.MonkeyPatch, graph: dict[str, Any]
    ) -> None:
        """One that went on would end by itself, and say what it did not find."""
        use_fake_ros(monkeypatch, robot, **graph)
        output, _ = self.start_node().communicate()
        assert "problem" not in output

    def start_node(self) -> subprocess.Popen[str]:
        it = transport.Ros2Transport(a_profile(), PIONEER_3DX)
        configuration = json.dumps(it._configuration())
        return it._started([sys.executable, str(installed.NODE), configuration])

    def test_a_silent_app_leaves_the_robot_standing(self, robot: SocketRobot) -> None:
        """The whole process is frozen, so that the link's own sender is, too."""
        node = self.start_node()
        assert node.stdin is not None
        with node:
            wait_for(lambda: len(robot.unicycle.received) > 3)  # its own zeros
            node.stdin.write('{"twist": [0.3, 0.0]}\n')
            node.stdin.flush()
            wait_for(lambda: any(twist.v_mps == 0.3 for _, twist in robot.unicycle.received))
            wait_for(lambda: robot.unicycle.standstill_since_s() is not None)
        assert node.returncode == 0


def test_the_newest_ros_is_chosen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installed, "_ON_LINUX", (tmp_path,))
    monkeypatch.setattr(installed, "_FOLDERS", {})
    assert installed.newest_setup() is None
    assert installed.node_command("{}", {}) is None
    for release in ("foxy", "jazzy", "humble"):
        (tmp_path / release).mkdir()
        (tmp_path / release / "setup.bash").touch()
    assert installed.newest_setup() == tmp_path / "jazzy" / "setup.bash"


def test_a_terminal_with_ros_wins() -> None:
    command = installed.node_command("{}", {"ROS_VERSION": "2"})
    assert command is not None
    assert command[1:] == [str(installed.NODE), "{}"]
