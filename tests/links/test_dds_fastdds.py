"""The DDS link drives a robot on eProsima's Fast DDS, which shares no code with it (`fastdds_peer/`)."""

import threading
import time
from collections.abc import Callable, Iterator

import pytest
from rosbags.typesys import Stores, get_typestore

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.links.real import ODOMETRY_TIMEOUT_S
from pinel_desktop.robot import STANDSTILL, RobotLink
from pinel_desktop.robot.robot_profile import DdsProfile
from pinel_desktop.runs.spec import RunSpec
from tests.in_time import in_time
from tests.links.dds_domains import local_profile, own_domain
from tests.links.fastdds_peer.build import built_peer
from tests.links.fastdds_peer.process import CommandType, FastDdsPeer
from tests.links.real_link_contract import AHEAD, FAR, MAX_STOPPING_TIME_S, LiveRun

pytestmark = pytest.mark.waits

HASHES = get_typestore(Stores.ROS2_JAZZY)
Robots = Callable[..., FastDdsPeer]
DDS_LEASE_S = 10.0  # lease duration of participants


@pytest.fixture
def profile() -> Iterator[DdsProfile]:
    with own_domain() as domain:
        yield local_profile(domain)


@pytest.fixture
def start_robot(profile: DdsProfile) -> Iterator[Robots]:
    """Starts robots in the record's domain; they end with the test."""
    built_peer()
    started: list[FastDdsPeer] = []

    def start(command: CommandType = "twist", user_data: tuple[str, str] = ("", "")) -> FastDdsPeer:
        started.append(FastDdsPeer(profile.domain, command, user_data))
        return started[-1]

    yield start
    for robot in started:
        robot.close()


@pytest.fixture
def link(profile: DdsProfile) -> Iterator[RobotLink]:
    """Not yet connected."""
    link = open_link("dds", world="empty_room", robot=profile)
    yield link
    link.close()


def type_hash(ros_name: str) -> str:
    return f"typehash={HASHES.hash_rihs01(ros_name)};"


def drive(link: RobotLink, seconds: float) -> None:
    until_s = time.monotonic() + seconds
    while time.monotonic() < until_s:
        link.command(AHEAD)
        link.read()
        time.sleep(0.02)


def run_of(profile: DdsProfile, document: list[dict[str, object]]) -> LiveRun:
    run = LiveRun(RunSpec(document, "empty_room", link="dds", robot=profile))
    run.thread.start()
    return run


def wait_for_standstill_s(robot: FastDdsPeer) -> float:
    """Gives the time of the first of the zeros."""
    due_s = time.monotonic() + 5.0
    while (since_s := robot.standstill_since_s()) is None:
        assert time.monotonic() < due_s, "the robot drives on"
        time.sleep(0.01)
    return since_s


def test_a_program_drives_the_robot_a_metre_by_its_odometry(
    profile: DdsProfile, start_robot: Robots
) -> None:
    robot = start_robot()
    ended = run_of(profile, [{"action": "move_forward", "distance": 1.0}]).result().ended
    assert ended.state == "finished", ended
    assert ended.pose is not None
    assert ended.pose["x_m"] == pytest.approx(1.0, abs=0.02)
    wait_for_standstill_s(robot)
    assert [twist for _, twist in robot.received[-2:]] == [STANDSTILL, STANDSTILL]


def test_stop_reaches_the_robot(profile: DdsProfile, start_robot: Robots) -> None:
    robot = start_robot()
    run = run_of(profile, FAR)
    robot.wait_until_driven()
    stopped_s = time.monotonic()
    run.control.stop()
    assert run.result().ended.state == "stopped"
    assert wait_for_standstill_s(robot) - stopped_s < MAX_STOPPING_TIME_S


def test_velocities_come_back_as_odometry(link: RobotLink, start_robot: Robots) -> None:
    robot = start_robot()
    link.connect()
    drive(link, 1.0)
    state = link.read()
    assert state.twist == pytest.approx(AHEAD)
    assert state.pose.x_m > 0.1
    assert all(twist in (STANDSTILL, AHEAD) for _, twist in robot.received)


@pytest.mark.parametrize("happens", [FastDdsPeer.freeze, FastDdsPeer.kill])
def test_a_robot_that_freezes_or_is_switched_off_is_lost_long_before_dds_says_so(
    profile: DdsProfile, start_robot: Robots, happens: Callable[[FastDdsPeer], None]
) -> None:
    robot = start_robot()
    run = run_of(profile, FAR)
    robot.wait_until_driven()
    happens(robot)
    lost_s = time.monotonic()
    ended = run.result().ended
    assert (ended.state, ended.reason) == ("failed", "link_lost")
    assert in_time(time.monotonic() - lost_s, DDS_LEASE_S / 2)


def test_a_robot_that_is_mute_hears_zeros_in_the_end(link: RobotLink, start_robot: Robots) -> None:
    robot = start_robot()
    link.connect()
    drive(link, 0.3)
    robot.is_mute = True
    with pytest.raises(PinelError, match="link_lost"):
        drive(link, 5 * ODOMETRY_TIMEOUT_S)
    wait_for_standstill_s(robot)


def test_a_robot_that_starts_after_the_link_is_found(link: RobotLink, start_robot: Robots) -> None:
    connecting = threading.Thread(target=link.connect)
    connecting.start()
    time.sleep(1.0)  # as a person who switches the robot on after Run
    robot = start_robot()
    connecting.join(20.0)
    drive(link, 0.5)
    robot.wait_until_driven()


def test_a_robot_that_takes_stamped_velocities_gets_them(
    link: RobotLink, start_robot: Robots
) -> None:
    hashes = (
        type_hash("geometry_msgs/msg/TwistStamped"),
        type_hash("nav_msgs/msg/Odometry"),
    )
    robot = start_robot("twist_stamped", hashes)
    link.connect()
    drive(link, 0.5)
    assert link.read().twist == pytest.approx(AHEAD)
    last_command = robot.commands[-1]
    assert last_command["frame"] == "base_link"
    assert last_command["stamp"] == pytest.approx(time.time(), abs=5.0)


@pytest.mark.parametrize(
    ("command", "ros_name"),
    [
        ("twist", "geometry_msgs/msg/Twist"),
        ("twist_stamped", "geometry_msgs/msg/TwistStamped"),
    ],
)
def test_the_robot_is_told_type_and_hash_as_ros_does(
    link: RobotLink, start_robot: Robots, command: CommandType, ros_name: str
) -> None:
    robot = start_robot(command)
    link.connect()
    package, _, short = ros_name.split("/")
    robot.wait_for_endpoint(
        {
            "writer": "rt/cmd_vel",
            "type": f"{package}::msg::dds_::{short}_",
            "user_data": type_hash(ros_name),
            "reliable": True,
        }
    )
    robot.wait_for_endpoint(
        {
            "reader": "rt/odom",
            "type": "nav_msgs::msg::dds_::Odometry_",
            "user_data": type_hash("nav_msgs/msg/Odometry"),
            "reliable": False,
        }
    )
