"""The link over an installed ROS 2: its node runs in a process of its own, against a ROS that is not one (fake_ros)."""

import contextlib
import json
import os
import signal
import socket
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.links.real import RealLink
from pinel_desktop.links.ros2 import installed, transport
from pinel_desktop.robot import RobotLink, Twist2D
from pinel_desktop.robot.record import RobotRecord, Room, Ros2Record
from tests.links.real_link_contract import Peer, RealLinkContract
from tests.links.unicycle import Unicycle

FAKE = Path(__file__).parent / "fake_ros"
GRAPH: dict[str, Any] = {
    "command_type": "geometry_msgs/msg/Twist",
    "odometry_type": "nav_msgs/msg/Odometry",
    "others": [],
}


class SocketRobot:
    """A unicycle that the fake ROS reaches over a socket; reports 100 times a second.

    Attributes:
        types: message types of the velocities that came.
        level: charge that it reports.
    """

    def __init__(self) -> None:
        self.unicycle = Unicycle()
        self.types: set[str] = set()
        self.level: float | None = None
        self._server = socket.create_server(("127.0.0.1", 0))
        self.port = self._server.getsockname()[1]
        self._ending = threading.Event()
        self._threads = [threading.Thread(target=self._accept, daemon=True)]
        self._threads[0].start()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                node, _ = self._server.accept()
                for work in (self._hear, self._report):
                    thread = threading.Thread(target=work, args=(node,), daemon=True)
                    self._threads.append(thread)
                    thread.start()

    def _hear(self, node: socket.socket) -> None:
        with node, contextlib.suppress(OSError), node.makefile("r", encoding="utf-8") as lines:
            for line in lines:
                sent = json.loads(line)
                self.types.add(sent["type"])
                self.unicycle.hear(Twist2D(*sent["twist"]))

    def _report(self, node: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while not self._ending.wait(0.01):
                if not self.unicycle.is_mute:
                    report = {"kind": "odometry", "pose": list(self.unicycle.report())}
                    node.sendall(json.dumps(report).encode() + b"\n")
                if self.level is not None:
                    battery = {"kind": "battery", "level": self.level}
                    node.sendall(json.dumps(battery).encode() + b"\n")

    def close(self) -> None:
        self._ending.set()
        self._server.shutdown(socket.SHUT_RDWR)
        self._server.close()
        for thread in self._threads:
            thread.join(5.0)


def a_record() -> Ros2Record:
    """A robot of its own: other tests drive theirs at the same time."""
    domain = os.getpid() % 233
    return Ros2Record(
        domain=domain,
        max_v_mps=1.2,
        max_omega_dps=300.0,
        room=Room(width_m=20.0, depth_m=20.0),
    )


def use_fake_ros(monkeypatch: pytest.MonkeyPatch, robot: SocketRobot, **graph: Any) -> None:
    """Lets the link find the fake ROS in place of an installed one."""
    monkeypatch.setenv("PINEL_FAKE_ROS", json.dumps({**GRAPH, "port": robot.port, **graph}))
    monkeypatch.setenv("PYTHONPATH", str(FAKE))
    monkeypatch.setattr(
        transport,
        "node_command",
        lambda configuration: [sys.executable, str(installed.NODE), configuration],
    )


class TestRos2Link(RealLinkContract):
    link = "ros2"

    @pytest.fixture(autouse=True)
    def _ros(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self._robot_process = SocketRobot()
        use_fake_ros(monkeypatch, self._robot_process)

    @pytest.fixture(autouse=True)
    def _robot(self, _ros: None) -> Iterator[None]:
        yield from self.with_robot()

    def start_peer(self) -> tuple[Peer, RobotRecord]:
        return self._robot_process.unicycle, a_record()

    def stop_peer(self) -> None:
        self._robot_process.close()


@pytest.fixture
def robot() -> Iterator[SocketRobot]:
    it = SocketRobot()
    yield it
    it.close()


@contextlib.contextmanager
def connected(**more: Any) -> Iterator[RobotLink]:
    link = open_link("ros2", world="empty_room", robot=a_record().model_copy(update=more))
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
        wait_for(lambda: any(twist.v_mps == 0.3 for _, twist in robot.unicycle.heard))
    assert robot.types == {"TwistStamped"}


def test_a_robot_that_tells_its_pose_only_can_be_driven(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, odometry_type="geometry_msgs/msg/PoseStamped")
    robot.unicycle.x_m = 2.0
    with connected() as link:
        assert link.read().pose.x_m == 2.0


def test_without_a_robot_topic_and_domain_are_named(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, command_type="")
    error = why_not()
    assert (error.code, error.params["topic"]) == ("robot_not_found", "/cmd_vel")


def test_a_topic_of_another_type_is_named(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, odometry_type="std_msgs/msg/String")
    error = why_not()
    assert (error.code, error.params["found"]) == ("robot_wrong_type", "std_msgs/msg/String")


def test_a_robot_that_another_node_commands_is_not_driven(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, others=["joystick"])
    error = why_not()
    assert (error.code, error.params["holder"]) == ("robot_held", "joystick")


def test_a_node_that_also_listens_to_commands_is_the_robot(
    robot: SocketRobot, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_ros(monkeypatch, robot, others=["robot"])
    with connected() as link:
        assert link.read().pose.x_m == 0.0


def test_the_battery_is_known(robot: SocketRobot, monkeypatch: pytest.MonkeyPatch) -> None:
    use_fake_ros(monkeypatch, robot)
    robot.level = 0.75
    with connected() as link:
        assert isinstance(link, RealLink)
        wait_for(lambda: link.battery == 0.75)


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
            wait_for(lambda: self.problem(link) is not None)
            assert self.problem(link) == "ros_node_ended"

    def problem(self, link: RobotLink) -> str | None:
        try:
            link.read()
        except PinelError as error:
            return error.code
        return None

    def test_a_node_that_hangs_does_not_hold_up_the_end(self) -> None:
        with connected():
            self.node().send_signal(signal.SIGSTOP)
            began_s = time.monotonic()
        assert time.monotonic() - began_s < 20.0

    def test_a_silent_app_leaves_the_robot_standing(self, robot: SocketRobot) -> None:
        """The whole process is frozen, so that the link's own sender is, too."""
        configuration = transport.Ros2Transport(a_record())._configuration()
        node = transport.Ros2Transport(a_record())._started(
            [sys.executable, str(installed.NODE), json.dumps(configuration)]
        )
        assert node.stdin is not None
        with node:
            wait_for(lambda: len(robot.unicycle.heard) > 3)  # its own zeros
            node.stdin.write('{"twist": [0.3, 0.0]}\n')
            node.stdin.flush()
            wait_for(lambda: any(twist.v_mps == 0.3 for _, twist in robot.unicycle.heard))
            wait_for(lambda: robot.unicycle.stood_from_s() is not None)
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
