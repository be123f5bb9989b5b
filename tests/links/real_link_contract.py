"""Tests common to all links of real robots: what protects people and robot. Time is real here."""

import threading
import time
from collections.abc import Callable, Iterator
from statistics import median
from typing import Any, Protocol

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunResult
from pinel_desktop.links import open_link
from pinel_desktop.links.real import ODOMETRY_TIMEOUT_S, RealLink
from pinel_desktop.robot import STANDSTILL, RobotLink, Twist2D
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from tests.in_time import in_time
from tests.links.link_contract import LinkContract

# 0.3 s on a PC at rest, measured by tests/benchmarks/bench_robot_stops.py; other tests may keep this one busy
MAX_STOPPING_TIME_S = 1.0
AHEAD = Twist2D(0.3, 0.0)
FAR = [{"action": "move_forward", "distance": 1.5}]


class Peer(Protocol):
    """The robot at the other end, a unicycle that the test may look at."""

    is_mute: bool
    received: list[tuple[float, Twist2D]]

    def standstill_since_s(self) -> float | None:
        """Since when only zeros have come (monotonic); None if the last velocity was another one."""
        ...


class RealLinkContract(LinkContract):
    """A subclass names its backend and starts the robot (`start_peer`)."""

    farthest_m, farthest_rad = 0.45, 1.5  # wall-clock time, on a busy PC

    @pytest.fixture(autouse=True)
    def _robot(self) -> Iterator[None]:
        yield from self.with_robot()

    def with_robot(self) -> Iterator[None]:
        """Starts the robot, and ends it and all opened links."""
        self.opened: list[RobotLink] = []
        self.peer, self.profile = self.start_peer()
        yield
        for link in self.opened:
            link.close()
        self.stop_peer()

    def start_peer(self) -> tuple[Peer, RobotProfile]:
        """Starts a robot, and gives the record that leads to it: as fast as a Pioneer, in a room of 20 m."""
        raise NotImplementedError

    def stop_peer(self) -> None:
        """Ends the robot."""

    def open(self) -> RobotLink:
        link = open_link(self.link, world="empty_room", robot=self.profile)
        self.opened.append(link)
        link.connect()
        return link

    def drive(self, link: RobotLink, twist: Twist2D, seconds: float) -> None:
        until_s = time.monotonic() + seconds
        while time.monotonic() < until_s:
            link.command(twist)
            time.sleep(0.02)

    def drive_and_read(self, link: RobotLink, seconds: float) -> None:
        until_s = time.monotonic() + seconds
        while time.monotonic() < until_s:
            link.command(AHEAD)
            link.read()
            time.sleep(0.02)

    def measured_twist(self, link: RobotLink, twist: Twist2D) -> Twist2D:
        """The median of half a second: single messages come early or late."""
        measured = []
        for _ in range(25):
            self.drive(link, twist, 0.02)
            measured.append(link.read().twist)
        return Twist2D(
            median(one.v_mps for one in measured), median(one.omega_radps for one in measured)
        )

    def drive_until(self, link: RobotLink, twist: Twist2D, is_so: Callable[[], bool]) -> None:
        due_s = time.monotonic() + 15.0
        while not is_so():
            assert time.monotonic() < due_s, "the robot hears nothing"
            self.drive(link, twist, 0.1)

    def start_run(self, document: list[Any] | None = None, **options: Any) -> "LiveRun":
        run = LiveRun(
            RunSpec(document or FAR, "empty_room", link=self.link, robot=self.profile, **options)
        )
        run.thread.start()
        return run

    def wait_until_driving(self) -> None:
        due_s = time.monotonic() + 15.0
        while not any(twist.v_mps > 0.1 for _, twist in self.peer.received[-3:]):
            assert time.monotonic() < due_s, "the robot does not drive"
            time.sleep(0.01)

    def wait_for_standstill_s(self) -> float:
        """Waits for the robot to stand; gives the time of the first of the zeros."""
        due_s = time.monotonic() + 3.0
        while (since_s := self.peer.standstill_since_s()) is None:
            assert time.monotonic() < due_s, "the robot drives on"
            time.sleep(0.01)
        return since_s

    def test_a_command_expires(self) -> None:
        link = self.open()
        self.drive(link, AHEAD, 0.5)
        last_s = time.monotonic()
        time.sleep(1.0)
        assert self.wait_for_standstill_s() - last_s < MAX_STOPPING_TIME_S

    def test_commands_are_repeated(self) -> None:
        link = self.open()
        started_s = time.monotonic()
        self.drive_until(link, AHEAD, lambda: len(self.peer.received) > 20)
        at_s, _ = self.peer.received[20]
        assert in_time(at_s - started_s, 1.0)

    def test_a_robot_that_falls_silent_is_lost_within_a_second_and_stopped(self) -> None:
        link = self.open()
        self.drive(link, AHEAD, 0.3)
        self.peer.is_mute = True
        muted_s = time.monotonic()
        with pytest.raises(PinelError, match="link_lost"):
            self.drive_and_read(link, 3 * ODOMETRY_TIMEOUT_S)
        assert in_time(time.monotonic() - muted_s, ODOMETRY_TIMEOUT_S + 1.0)
        self.wait_for_standstill_s()

    def test_closing_sends_zeros(self) -> None:
        link = self.open()
        self.drive(link, AHEAD, 0.3)
        link.close()
        self.wait_for_standstill_s()
        assert [twist for _, twist in self.peer.received[-2:]] == [STANDSTILL, STANDSTILL]

    def test_impossible_commands_are_zeros(self) -> None:
        link = self.open()
        self.drive(link, Twist2D(float("nan"), float("inf")), 0.3)
        self.drive_until(
            link, Twist2D(float("nan"), float("inf")), lambda: bool(self.peer.received)
        )
        assert {twist for _, twist in self.peer.received} == {STANDSTILL}

    def test_connecting_can_be_cancelled(self) -> None:
        self.peer.is_mute = True
        run = self.start_run()
        time.sleep(0.3)
        stopped_s = time.monotonic()
        run.control.stop()
        assert run.result().ended.state == "stopped"
        assert in_time(time.monotonic() - stopped_s, 3.0)

    def test_a_run_drives_in_real_time_whatever_its_pace(self) -> None:
        started_s = time.monotonic()
        result = self.start_run([{"action": "move_forward", "distance": 0.5}], pace="max").result()
        assert result.ended.state == "finished", result.ended
        assert time.monotonic() - started_s > 0.5 / 0.6
        self.wait_for_standstill_s()

    def test_stop_ends_a_run_with_zeros(self) -> None:
        run = self.start_run()
        self.wait_until_driving()
        stopped_s = time.monotonic()
        run.control.stop()
        assert run.result().ended.state == "stopped"
        assert self.wait_for_standstill_s() - stopped_s < MAX_STOPPING_TIME_S

    def test_an_app_that_reads_no_events_does_not_keep_the_robot_driving(self) -> None:
        run = self.start_run()
        self.wait_until_driving()
        run.blocked.clear()  # as a full pipe to an app that is frozen
        blocked_s = time.monotonic()
        try:
            time.sleep(1.0)
            assert self.wait_for_standstill_s() - blocked_s < MAX_STOPPING_TIME_S
        finally:
            run.control.stop()
            run.blocked.set()
        assert run.result().ended.state == "stopped"

    def test_a_run_that_fails_ends_with_zeros(self) -> None:
        run = self.start_run()
        self.wait_until_driving()
        self.peer.is_mute = True
        ended = run.result().ended
        assert (ended.state, ended.reason) == ("failed", "link_lost")
        self.wait_for_standstill_s()

    def test_without_a_robot_a_run_says_so(self) -> None:
        self.peer.is_mute = True
        ended = self.start_run().result().ended
        assert (ended.state, ended.reason) == ("failed", "robot_silent")
        assert not any(twist != STANDSTILL for _, twist in self.peer.received)

    def test_listening_hears_the_robot_and_leaves_it_to_whoever_drives_it(self) -> None:
        link = self.listen()
        assert link.pose is not None
        assert not any(twist != STANDSTILL for _, twist in self.peer.received)
        link.close()
        self.drive_until(self.open(), AHEAD, self.has_received_a_velocity)

    def has_received_a_velocity(self) -> bool:
        return any(twist != STANDSTILL for _, twist in self.peer.received)

    def listen(self) -> RealLink:
        """A link that has heard the robot."""
        link = open_link(self.link, world="empty_room", robot=self.profile)
        assert isinstance(link, RealLink)
        self.opened.append(link)
        link.listen()
        due_s = time.monotonic() + 15.0
        while not link.n_odometry:
            assert time.monotonic() < due_s, "the robot is not heard"
            time.sleep(0.01)
        return link

    def test_the_edge_of_the_room_stops_the_robot(self) -> None:
        room = self.profile.room.model_copy(update={"width_m": 1.0, "depth_m": 1.0})
        self.profile = self.profile.model_copy(update={"room": room})
        ended = self.start_run().result().ended
        assert (ended.state, ended.reason) == ("failed", "left_room")
        assert ended.params == {"width": 1.0, "depth": 1.0}
        assert ended.pose is not None
        assert ended.pose["x_m"] < 0.5
        self.wait_for_standstill_s()


class LiveRun:
    """A run on a thread of its own, whose observer can be blocked."""

    def __init__(self, spec: RunSpec) -> None:
        self.control = RunControl()
        self.blocked = threading.Event()
        self.blocked.set()
        self._spec = spec
        self._result: RunResult | None = None
        self.thread = threading.Thread(target=self._run, daemon=True)

    def _run(self) -> None:
        self._result = start(self._spec, self._observe, self.control)

    def _observe(self, tick: int, event: Event) -> None:
        self.blocked.wait()

    def result(self, timeout_s: float = 40.0) -> RunResult:
        """Waits for the end."""
        self.thread.join(timeout_s)
        assert self._result is not None, "the run has not ended"
        return self._result
