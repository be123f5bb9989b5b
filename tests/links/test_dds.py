"""The link to robots of ROS 2 over DDS, against a robot in a process of its own."""

import contextlib
import platform
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.links.dds import session, transport
from pinel_desktop.links.dds.discovery import discover_robots
from pinel_desktop.links.dds.graph import Graph
from pinel_desktop.links.dds.messages import Twist, Vector3
from pinel_desktop.links.localisation import LocalisedPose
from pinel_desktop.links.real import RealLink
from pinel_desktop.robot import RobotLink, Twist2D
from pinel_desktop.robot.robot_profile import RobotProfile, RosProfile
from tests.in_time import in_time
from tests.links.dds_domains import local_profile, own_domain
from tests.links.dds_peer import DdsPeer
from tests.links.dds_robot import START_ON_MAP, reader_of_last
from tests.links.real_link_contract import RealLinkContract

pytestmark = pytest.mark.waits


class TestDdsLink(RealLinkContract):
    link = "dds"
    peer: DdsPeer

    def start_peer(self) -> tuple[DdsPeer, RobotProfile]:
        self._ending = contextlib.ExitStack()
        domain = self._ending.enter_context(own_domain())
        peer = DdsPeer(domain)
        self._ending.callback(peer.close)
        return peer, local_profile(domain)

    def stop_peer(self) -> None:
        self._ending.close()

    def test_nobody_sees_who_only_listens_as_the_holder(self) -> None:
        link = self.listen()
        for other in self.others_in_the_domain():
            assert other.publishers("cmd_vel") == []
        driver = self.open()  # not held up by who listens
        due_s = time.monotonic() + 10.0
        while link.holder is None:
            assert time.monotonic() < due_s, "the listener is not told who drives"
            time.sleep(0.05)
        assert link.holder == platform.node()
        driver.close()

    def others_in_the_domain(self) -> Iterator[Graph]:
        """A second party, which has had time to hear of everybody, and has heard of the robot."""
        assert isinstance(self.profile, RosProfile)
        party = session.Session(self.profile.domain, ("127.0.0.1",))
        try:
            graph, due_s = Graph(party), time.monotonic() + 10.0
            while not (graph.subscribers("cmd_vel") and graph.publishers("odom")):
                assert time.monotonic() < due_s, "the robot is not found"
                time.sleep(0.05)
            time.sleep(1.0)
            yield graph
        finally:
            party.close()


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
            link = open_link("dds", world="empty_room", robot=local_profile(domain, **fields))
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
    wait_for(lambda: commanded(link, Twist2D(0.3, 0.0)) in [twist for _, twist in robot.received])
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
    start_robot: Callable[..., DdsPeer],
    connect: Callable[..., RobotLink],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(transport, "_SEARCH_TIMEOUT_S", 60.0)  # its process may be slow to start
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
    assert in_time(time.monotonic() - frozen_s, 3.0)
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
        ("nan", "odometry_invalid"),
        ("quaternion", "odometry_invalid"),
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
    wait_for(lambda: robot.standstill_since_s() is not None)


@pytest.mark.parametrize("broken", ["clock", "ahead"])
def test_a_clock_that_is_set_interrupts_for_less_than_a_second(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink], broken: str
) -> None:
    robot = start_robot()
    link = connect()
    for state in (broken, ""):
        robot.change(broken=state)
        until_s = time.monotonic() + 1.5
        while time.monotonic() < until_s:
            link.command(Twist2D(0.2, 0.0))
            link.read()
            time.sleep(0.02)
    wait_for(lambda: commanded(link, Twist2D(0.25, 0.0)) == robot.received[-1][1])


def test_a_robot_that_no_longer_listens_ends_the_run(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot()
    link = connect()
    robot.change(left_topics=["cmd_vel"])
    assert problem_of(link) == "robot_deaf"


def test_sensors_that_vanish_are_silent_and_the_robot_drives_on(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot(sensors=True)
    link = connect()
    assert isinstance(link, RealLink)
    sensors = link.sensors
    reads = {
        "scan": ("lidar", lambda: sensors.lidar(0.0)),
        "sonar": ("sonar", lambda: sensors.sonar(0)),
        "bumper_state": ("bumper", sensors.reader("bumper")),
    }
    wait_for(lambda: link.battery == 0.75)
    for topic, (sensor, read) in reads.items():
        eventually(read)
        robot.change(left_topics=[topic])
        wait_for(partial(is_unresponsive, read, sensor))
    robot.change(left_topics=["battery_state"])
    wait_for(lambda: link.battery is None)
    wait_for(lambda: commanded(link, Twist2D(0.25, 0.0)) == robot.received[-1][1])
    assert not link.bumper()


def is_unresponsive(read: Callable[[], Any], sensor: str) -> bool:
    """Whether the sensor is told to be silent, not missing."""
    try:
        read()
    except PinelError as problem:
        return (problem.code, problem.params) == ("sensor_silent", {"sensor": sensor})
    return False


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


def test_a_ring_of_sonars_on_one_topic_is_heard_as_a_whole(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(sensors=True)
    sensors = connect(sonar_topic="sonar_ring").sensors
    wait_for(lambda: len(values_or_empty(sensors.sonars)) == 16)
    assert eventually(sensors.sonars) == pytest.approx([1.5 + index / 10 for index in range(16)])


def values_or_empty(read: Callable[[], list[float]]) -> list[float]:
    try:
        return read()
    except PinelError:
        return []


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


def test_somebody_else_who_listens_to_commands_and_gives_some_is_not_the_robot(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot(listens_to_commands=True)
    link = connect()
    robot.change(publishes_commands=True)
    assert problem_of(link) == "robot_held"
    wait_for(lambda: robot.standstill_since_s() is not None)


@pytest.mark.parametrize("asks_for_last", [False, True])
def test_the_last_command_is_kept_for_a_robot_that_asks_for_it_and_for_no_other(
    start_robot: Callable[..., DdsPeer],
    connect: Callable[..., RobotLink],
    domain: int,
    asks_for_last: bool,
) -> None:
    robot = start_robot(asks_for_last=asks_for_last)
    link, looking = connect(), session.Session(domain, ("127.0.0.1",))
    wait_for(lambda: commanded(link, Twist2D(0.3, 0.0)) in [twist for _, twist in robot.received])
    graph = Graph(looking)
    wait_for(lambda: bool(graph.publishers("cmd_vel")))
    assert [found.is_transient_local for found in graph.publishers("cmd_vel")] == [asks_for_last]
    looking.close()


def test_a_robot_that_comes_late_is_not_told_an_old_velocity(domain: int) -> None:
    pc, robot = (session.Session(domain, ("127.0.0.1",)) for _ in range(2))
    writer = pc.writer("cmd_vel", Twist, is_transient_local=True)
    writer.write(Twist(Vector3(x=0.3)))
    time.sleep(0.5)  # as a PC that was frozen: what it said has expired
    reader = reader_of_last(robot, "cmd_vel", Twist)
    wait_for(lambda: bool(writer.get_matched_subscriptions()))
    writer.write(Twist())
    received: list[Any] = []

    def has_received() -> bool:
        received.extend(reader.take(10))
        return bool(received)

    wait_for(has_received)
    assert [twist.linear.x for twist in received] == [0.0]
    for each in (pc, robot):
        each.close()


def test_a_robot_that_is_silent_at_the_end_is_told_for_a_while_to_stand(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    """It may have been out of reach, and drive on with the last velocity that it heard."""
    robot = start_robot()
    link = connect()
    wait_for(lambda: commanded(link, Twist2D(0.3, 0.0)) in [twist for _, twist in robot.received])
    robot.is_mute = True
    assert problem_of(link) == "link_lost"
    closing_s = time.monotonic()
    link.close()
    wait_for(lambda: robot.received[-1][0] > closing_s + 0.3)
    assert robot.standstill_since_s() is not None


def test_a_bridge_to_ros_1_that_publishes_commands_too_is_the_robot(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    start_robot(relays=True)
    assert connect().read().pose.x_m == 0.0


def test_a_pc_of_the_same_name_is_another_pc(
    start_robot: Callable[..., DdsPeer],
    connect: Callable[..., RobotLink],
    domain: int,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """PCs that were set up from one image have one name, and a process there is none of here."""
    start_robot()
    user_data = f"pinel={platform.node()}/4194304999/abc;".encode()
    with monkeypatch.context() as other_pc:
        other_pc.setattr(session, "own_user_data", lambda: user_data)
        other = session.Session(domain, ("127.0.0.1",))
    other.writer("cmd_vel", Twist)
    problem = refused(connect)
    other.close()
    assert (problem.code, problem.params["holder"]) == ("robot_held", platform.node())


def test_somebody_else_who_begins_to_drive_stops_the_run(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink]
) -> None:
    robot = start_robot()
    link = connect()
    robot.change(publishes_commands=True)
    assert problem_of(link) == "robot_held"
    wait_for(lambda: robot.standstill_since_s() is not None)


def test_the_link_is_loaded_for_a_robot_only() -> None:
    code = (
        "import sys, pinel_desktop.links, pinel_desktop.app; "
        "pinel_desktop.links.open_link('sim', world='empty_room'); "
        "sys.exit('cyclonedds' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_robots_of_a_domain_are_found_with_their_namespace_and_who_drives_them() -> None:
    with own_domain() as domain, contextlib.ExitStack() as ending:
        for namespace, more in {"": {}, "lab/r2": {"publishes_commands": True}}.items():
            ending.callback(DdsPeer(domain, namespace=namespace, **more).close)
        found = discover_robots(local_profile(domain, namespace="nobody"))
        assert discover_robots(local_profile(domain)) == found
    assert [(one.namespace, one.command_topic, one.odometry_topic) for one in found] == [
        ("", "cmd_vel", "odom"),
        ("lab/r2", "cmd_vel", "odom"),
    ]
    assert [one.holder for one in found] == [None, platform.node()]


@pytest.mark.parametrize(
    ("kind", "sigmas"),
    [("PoseStamped", (0.05, 0.052)), ("PoseWithCovarianceStamped", (0.02, 0.03))],
)
def test_the_robots_own_localisation_is_read(
    start_robot: Callable[..., DdsPeer],
    connect: Callable[..., RobotLink],
    kind: str,
    sigmas: tuple[float, float],
) -> None:
    start_robot(localisation=kind)
    link = connect(localisation_topic="amcl_pose")
    found = localised(link)
    assert isinstance(found, LocalisedPose)
    assert found.pose == pytest.approx(START_ON_MAP)
    assert (found.sigma_m, found.sigma_rad) == pytest.approx(sigmas, abs=0.001)
    assert 0.0 <= time.monotonic() - found.at_s < 1.0


@pytest.mark.parametrize(
    ("behaviour", "code"),
    [
        ({"localisation_frame": "odom"}, "localisation_other_frame"),
        ({"localisation_frame": ""}, "localisation_other_frame"),
        ({"localised_nan": True}, "localisation_invalid"),
    ],
)
def test_poses_of_another_frame_and_impossible_ones_are_refused(
    start_robot: Callable[..., DdsPeer],
    connect: Callable[..., RobotLink],
    behaviour: dict[str, Any],
    code: str,
) -> None:
    start_robot(localisation="PoseStamped", **behaviour)
    problem = localised(connect(localisation_topic="amcl_pose"))
    assert isinstance(problem, PinelError)
    assert problem.code == code


def test_without_the_topic_in_the_profile_no_localisation_is_read(
    start_robot: Callable[..., DdsPeer], connect: Callable[..., RobotLink], domain: int
) -> None:
    start_robot(localisation="PoseStamped")
    link = connect()
    assert isinstance(link, RealLink)
    party = session.Session(domain, ("127.0.0.1",))
    try:
        graph = Graph(party)
        wait_for(lambda: bool(graph.publishers("amcl_pose")))
        wait_for(lambda: bool(graph.subscribers("cmd_vel")))
        assert not graph.subscribers("amcl_pose")
    finally:
        party.close()
    assert link.pop_localised() is None


def localised(link: RobotLink) -> LocalisedPose | PinelError:
    """The next thing that the robot's localisation says."""
    assert isinstance(link, RealLink)
    due_s = time.monotonic() + 20.0
    while (found := link.pop_localised()) is None:
        assert time.monotonic() < due_s
        time.sleep(0.01)
    return found
