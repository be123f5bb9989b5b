"""Both ways to ROS 2 with nodes of a real rclpy: of the ROS of this PC, else the one that `make test` installs."""

import contextlib
import math
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.links import open_link
from pinel_desktop.links.localisation import LocalisedPose
from pinel_desktop.links.real import RealLink
from pinel_desktop.robot import STANDSTILL
from pinel_desktop.robot.robot_profile import DdsProfile, RobotProfile, Room, Ros2Profile
from pinel_desktop.runs.spec import RunSpec
from tests.links.dds_domains import own_domain
from tests.links.rclpy_process import RclpyProgram, use_real_ros
from tests.links.real_link_contract import LiveRun
from tests.links.test_dds import eventually, localised, wait_for
from tests.links.two_pcs import FOR_EVER

pytestmark = pytest.mark.waits

NEAR = [{"action": "move_forward", "distance": 0.3}]
FAR = [{"action": "move_forward", "distance": 8.0}]
# What a person drives by hand beside PINEL: enough to lead it astray, and never told as an obstacle.
SLOWLY = [0.05, 0.1]
COMMANDER = {"hears": False, "tells": False, "drives": SLOWLY}

both_links = pytest.mark.parametrize("kind", [Ros2Profile, DdsProfile])
Start = Callable[..., RclpyProgram]


@pytest.fixture(autouse=True)
def _ros(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    use_real_ros(monkeypatch, tmp_path)


@pytest.fixture
def domain() -> Iterator[int]:
    with own_domain() as free:
        yield free


@pytest.fixture
def begin(domain: int) -> Iterator[Start]:
    """Starts a robot, or what it is told to be."""
    with contextlib.ExitStack() as ending:

        def start(**behaviour: Any) -> RclpyProgram:
            program = RclpyProgram(domain, **behaviour)
            ending.callback(program.close)
            return program

        yield start


def profile_of(kind: type[RobotProfile], domain: int) -> RobotProfile:
    here = {"peers": ("127.0.0.1",)} if kind is DdsProfile else {}
    room = Room(width_m=20.0, depth_m=20.0)
    return kind.model_validate({"domain": domain, "room": room, **here})


def run_of(profile: RobotProfile, document: list[dict[str, Any]]) -> LiveRun:
    run = LiveRun(RunSpec(document, "empty_room", link=profile.link, robot=profile))
    run.thread.start()
    return run


def moves(robot: RclpyProgram) -> bool:
    return any(twist != STANDSTILL for _, twist in robot.received[-3:])


def has_moved_for_s(robot: RclpyProgram) -> float:
    first_s = next((at_s for at_s, twist in robot.received if twist != STANDSTILL), math.inf)
    return time.monotonic() - first_s


@both_links
def test_a_robot_is_driven_and_its_sensors_are_read(
    begin: Start, domain: int, kind: type[RobotProfile]
) -> None:
    robot, record = begin(), profile_of(kind, domain)
    ended = run_of(record, NEAR).result().ended
    assert ended.state == "finished", ended
    link = open_link(record.link, world="empty_room", robot=record)
    link.connect()
    assert isinstance(link, RealLink)
    assert eventually(lambda: link.sensors.lidar(0.0)) == pytest.approx(1.25)
    assert link.read().pose.x_m == pytest.approx(0.3, abs=0.05)
    wait_for(lambda: link.battery == 0.75)
    link.close()
    wait_for(lambda: robot.standstill_since_s() is not None)
    assert max(twist.v_mps for _, twist in robot.received) > 0.1


@both_links
@pytest.mark.parametrize(
    ("localisation", "sigma_m"), [("PoseStamped", 0.05), ("PoseWithCovarianceStamped", 0.02)]
)
def test_the_robots_own_localisation_is_read(
    begin: Start, domain: int, kind: type[RobotProfile], localisation: str, sigma_m: float
) -> None:
    begin(localisation=localisation)
    record = profile_of(kind, domain).model_copy(update={"localisation_topic": "amcl_pose"})
    link = open_link(record.link, world="empty_room", robot=record)
    link.connect()
    found = localised(link)
    assert isinstance(found, LocalisedPose)
    assert found.pose == pytest.approx((1.0, 0.0, 0.0))
    assert found.sigma_m == pytest.approx(sigma_m)
    link.close()


@both_links
@pytest.mark.parametrize(
    "who",
    [
        pytest.param({"node": "robot"}, id="the name of the robot"),
        pytest.param({"node": ""}, id="the name of who drives"),
        pytest.param({"node": "teleop", "hears": True}, id="listens too"),
    ],
)
def test_another_program_that_begins_to_command_the_robot_ends_the_run(
    begin: Start, domain: int, kind: type[RobotProfile], who: dict[str, Any]
) -> None:
    robot = begin()
    run = run_of(profile_of(kind, domain), FOR_EVER)
    wait_for(lambda: moves(robot))
    begin(**{**COMMANDER, **who})
    ended = run.result().ended
    assert (ended.state, ended.reason) == ("failed", "robot_held")


@both_links
def test_a_robot_that_another_program_commands_is_refused_whatever_its_name(
    begin: Start, domain: int, kind: type[RobotProfile]
) -> None:
    begin()
    begin(**{**COMMANDER, "node": "robot", "hears": True, "drives": None, "offers": True})
    ended = run_of(profile_of(kind, domain), NEAR).result().ended
    assert (ended.state, ended.reason) == ("failed", "robot_held")


@both_links
def test_programs_that_only_listen_and_a_robot_that_passes_commands_on_hold_nobody_up(
    begin: Start, domain: int, kind: type[RobotProfile]
) -> None:
    begin(offers=True)  # as a bridge to ROS 1
    begin(node="recorder", tells=False)
    ended = run_of(profile_of(kind, domain), NEAR).result().ended
    assert ended.state == "finished", ended


@both_links
def test_a_robot_that_asks_for_the_last_command_is_driven(
    begin: Start, domain: int, kind: type[RobotProfile]
) -> None:
    robot = begin(durability="transient_local")
    ended = run_of(profile_of(kind, domain), NEAR).result().ended
    assert ended.state == "finished", ended
    assert max(twist.v_mps for _, twist in robot.received) > 0.1


@both_links
def test_a_robot_that_asks_for_more_than_pinel_offers_is_said_to_hear_nothing(
    begin: Start, domain: int, kind: type[RobotProfile]
) -> None:
    begin(deadline_s=1.0)
    ended = run_of(profile_of(kind, domain), NEAR).result().ended
    assert (ended.state, ended.reason) == ("failed", "robot_deaf")


@both_links
def test_a_robot_whose_heading_jumps_ends_the_run_as_one_that_was_carried(
    begin: Start, domain: int, kind: type[RobotProfile]
) -> None:
    robot = begin()
    run = run_of(profile_of(kind, domain), FAR)
    # for a second after the first command, what another program commanded before may still turn the robot
    wait_for(lambda: has_moved_for_s(robot) > 1.5)
    robot.change(turned_rad=math.pi / 2)
    ended = run.result().ended
    assert (ended.state, ended.reason) == ("failed", "reference_lost")
    wait_for(lambda: robot.standstill_since_s() is not None)
