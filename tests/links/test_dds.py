"""The link to robots of ROS 2 over DDS, against a robot in a process of its own."""

import contextlib
import platform
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.links.dds import session
from pinel_desktop.robot import RobotLink, Twist2D
from pinel_desktop.robot.record import RobotRecord
from tests.links.dds_domains import local_record, own_domain
from tests.links.dds_peer import DdsPeer
from tests.links.real_link_contract import RealLinkContract


class TestDdsLink(RealLinkContract):
    link = "dds"
    peer: DdsPeer

    def start_peer(self) -> tuple[DdsPeer, RobotRecord]:
        self._ending = contextlib.ExitStack()
        domain = self._ending.enter_context(own_domain())
        peer = DdsPeer(domain)
        self._ending.callback(peer.close)
        return peer, local_record(domain)

    def stop_peer(self) -> None:
        self._ending.close()


@pytest.fixture
def domain() -> Iterator[int]:
    with own_domain() as free:
        yield free


@pytest.fixture
def start_robot(domain: int) -> Iterator[Callable[..., DdsPeer]]:
    with contextlib.ExitStack() as ending:

        def begin(**behaviour: Any) -> DdsPeer:
            peer = DdsPeer(domain, **behaviour)
            ending.callback(peer.close)
            return peer

        yield begin


@pytest.fixture
def connect(domain: int) -> Iterator[Callable[..., RobotLink]]:
    with contextlib.ExitStack() as ending:

        def begin(**fields: Any) -> RobotLink:
            link = open_link("dds", world="empty_room", robot=local_record(domain, **fields))
            try:
                link.connect()
            except PinelError:
                link.close()
                raise
            ending.callback(link.close)
            return link

        yield begin


def refused(connect: Callable[..., RobotLink], **fields: Any) -> PinelError:
    """The problem of a robot that cannot be connected with."""
    with pytest.raises(PinelError) as problem:
        connect(**fields)
    return problem.value


def problem_of(link: RobotLink, within_s: float = 20.0) -> str:
    """Drives until the link refuses; the code of the problem."""
    due_s = time.monotonic() + within_s
    while time.monotonic() < due_s:
        link.command(Twist2D(0.2, 0.0))
        try:
            link.read()
        except PinelError as problem:
            return problem.code
        time.sleep(0.02)
    raise AssertionError("the link drives on")


def wait_for(condition: Callable[[], bool]) -> None:
    due_s = time.monotonic() + 20.0
    while not condition():
        assert time.monotonic() < due_s
        time.sleep(0.01)


def commanded(link: RobotLink, twist: Twist2D) -> Twist2D:
    """Commands once more: a command expires."""
    link.command(twist)
    return twist


def test_a_robot_that_takes_stamped_commands_gets_them_in_its_own_time(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot(command="TwistStamped", broken="clock")
    link = connect()
    wait_for(lambda: commanded(link, Twist2D(0.3, 0.0)) in [twist for _, twist in robot.heard])
    assert robot.stamps[-1] == pytest.approx(time.time() - 1e6, abs=30.0)


def test_a_robot_that_tells_its_pose_only_is_driven_by_it(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(odometry="PoseStamped")
    link = connect()
    for _ in range(50):
        link.command(Twist2D(0.3, 0.0))
        link.read()
        time.sleep(0.02)
    assert link.read().pose.x_m > 0.1
    assert link.read().twist.v_mps == pytest.approx(0.3, abs=0.2)


def test_a_robot_that_starts_late_is_found(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    started = threading.Timer(1.0, start_robot)
    started.start()
    assert connect().read().pose.x_m == 0.0
    started.join()


def test_without_a_robot_the_topic_and_domain_are_named(
    connect: Callable[..., RobotLink], domain: int
) -> None:
    problem = refused(connect, namespace="p3dx")
    assert problem.code == "robot_not_found"
    assert problem.params == {"topic": "/p3dx/cmd_vel", "domain": domain}


def test_a_robot_of_another_namespace_is_named(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(namespace="red")
    problem = refused(connect, namespace="blue")
    assert (problem.code, problem.params["found"]) == ("robot_elsewhere", "/red/cmd_vel")


def test_a_topic_of_another_type_is_named(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(command="Bool")
    problem = refused(connect)
    assert (problem.code, problem.params["found"]) == ("robot_wrong_type", "std_msgs/msg/Bool")


def test_a_robot_without_the_odometry_topic_says_what_there_is(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot()
    problem = refused(connect, odometry_topic="pose")
    assert (problem.code, problem.params["found"]) == ("odometry_elsewhere", "/odom")


def test_without_a_network_the_app_says_so(
    connect: Callable[..., RobotLink], monkeypatch: pytest.MonkeyPatch
) -> None:
    # of a documentation network (RFC 5737): no interface of this PC has it
    monkeypatch.setattr(session, "_address_towards", lambda peer: "203.0.113.7")
    assert refused(connect).code == "network_missing"


def test_an_unknown_peer_is_named(connect: Callable[..., RobotLink]) -> None:
    problem = refused(connect, peers=("robot.invalid",))
    assert (problem.code, problem.params["peer"]) == ("peer_unknown", "robot.invalid")


def test_a_frozen_robot_holds_up_nobody_and_is_lost_within_a_second(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot()
    link = connect()
    robot.process.send_signal(signal.SIGSTOP)
    frozen_s = time.monotonic()
    assert problem_of(link) == "link_lost"
    assert time.monotonic() - frozen_s < 3.0
    robot.process.send_signal(signal.SIGCONT)


def test_a_killed_robot_is_lost_and_found_again(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot()
    link = connect()
    robot.process.kill()
    assert problem_of(link) == "link_lost"
    link.close()
    start_robot()
    assert connect().read().pose.x_m == 0.0


@pytest.mark.parametrize(
    ("broken", "code"),
    [
        ("nan", "link_lost"),
        ("quaternion", "link_lost"),
        ("jump", "reference_lost"),
        ("frame", "odometry_frame_changed"),
    ],
)
def test_impossible_odometry_stops_the_robot(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink], broken: str, code: str
) -> None:
    robot = start_robot()
    link = connect()
    robot.change(broken=broken)
    assert problem_of(link) == code
    wait_for(lambda: robot.stood_from_s() is not None)


def test_a_clock_that_is_set_back_interrupts_for_less_than_a_second(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot()
    link = connect()
    robot.change(broken="clock")
    until_s = time.monotonic() + 2.0
    while time.monotonic() < until_s:
        link.command(Twist2D(0.2, 0.0))
        link.read()
        time.sleep(0.02)


def test_a_flood_of_messages_leaves_the_newest(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(period_s=0.0005)
    link = connect()
    for _ in range(50):
        link.command(Twist2D(0.3, 0.0))
        link.read()
        time.sleep(0.02)
    assert link.read().pose.x_m > 0.1


def test_sensors_are_those_that_the_robot_publishes(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(sensors=True)
    link = connect()
    wait_for(lambda: link.bumper() and link.battery == 0.75)  # type: ignore[attr-defined]
    sensors = link.sensors
    assert eventually(lambda: sensors.lidar(0.0)) == pytest.approx(1.9)
    assert eventually(lambda: sensors.scan()[::90]) == pytest.approx([1.0, 1.9, 2.8])
    assert eventually(lambda: sensors.sonars()[:2]) == pytest.approx([1.5, 1.6])
    assert eventually(sensors.reader("bumper")) is True


def eventually(read: Callable[[], Any]) -> Any:
    """A sensor's value, as soon as there is a fresh one: messages come late on a busy PC."""
    due_s = time.monotonic() + 20.0
    while True:
        try:
            return read()
        except PinelError:
            assert time.monotonic() < due_s
            time.sleep(0.01)


def test_a_robot_that_somebody_else_drives_is_refused(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot(publishes_commands=True)
    problem = refused(connect)
    assert (problem.code, problem.params["holder"]) == ("robot_held", platform.node())
    robot.change(publishes_commands=False)
    assert connect().read().pose.x_m == 0.0


def test_a_bridge_to_ros_1_that_publishes_commands_too_is_the_robot(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(relays=True)
    assert connect().read().pose.x_m == 0.0


def test_somebody_else_who_begins_to_drive_stops_the_run(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot()
    link = connect()
    robot.change(publishes_commands=True)
    assert problem_of(link) == "robot_held"
    wait_for(lambda: robot.stood_from_s() is not None)


def test_the_link_is_loaded_for_a_robot_only() -> None:
    code = (
        "import sys, pinel_desktop.links, pinel_desktop.app; "
        "pinel_desktop.links.open_link('sim', world='empty_room'); "
        "sys.exit('cyclonedds' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
