"""Whatever a robot says and a program asks for: problems have names, and after one of them only zeros are sent."""

import math
import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from pinel_desktop.errors import PinelError
from pinel_desktop.links.odometry import OdometryFilter
from pinel_desktop.links.real import RealLink, real_link
from pinel_desktop.links.transport import Cancelled, Odometry, Receiver
from pinel_desktop.robot import STANDSTILL, RobotState, Sensors, SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import BridgeProfile, Room

PROFILE = BridgeProfile(host=f"fuzz-{os.getpid()}", room=Room(width_m=50.0, depth_m=50.0))
MAX_V_MPS, MAX_OMEGA_RADPS = PROFILE.max_v_mps, math.radians(PROFILE.max_omega_dps)
# The link keeps a problem of the first kind; those of the second pass with their cause.
LASTING = {"reference_lost", "odometry_frame_changed"}
PASSING = {"left_room", "link_lost"}

small = st.floats(-0.3, 0.3)
anything = small | st.floats() | st.sampled_from([1e5, -1e5, 20.0, math.tau, 1e300])
odometry = st.builds(
    Odometry,
    x_m=anything,
    y_m=small,
    yaw_rad=anything,
    v_mps=st.none() | anything,
    omega_radps=st.none() | anything,
    stamp_s=st.none() | anything,
    frame=st.sampled_from(["odom", "odom", "odom", "", "map"]),
)
believable = st.builds(
    Odometry, small, small, small, small, small, st.none() | small, st.just("odom")
)
messages = believable | odometry
floods = st.lists(messages, min_size=1, max_size=5).map(lambda some: some * 40)
velocities = st.builds(Twist2D, anything, anything)


class RecordingTransport:
    """A transport that keeps what it is given; its robot says a few times that it is there.

    Attributes:
        sent: all velocities.
    """

    def __init__(self) -> None:
        self.sensors = Sensors()
        self.sent: list[Twist2D] = []

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        for _ in range(6):
            receiver.on_odometry(Odometry(0.0, 0.0, 0.0, 0.0, 0.0, None, "odom"))

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        self.open(receiver, cancelled)

    def send(self, twist: Twist2D) -> None:
        self.sent.append(twist)

    def wait_for_more(self) -> None:
        """Waits until what was commanded last has been sent, and whatever was on its way before."""
        n_expected, due_s = len(self.sent) + 3, time.monotonic() + 10.0
        while len(self.sent) < n_expected:
            assert time.monotonic() < due_s, "nothing is sent any more"
            time.sleep(0.001)

    def bumper(self) -> bool:
        return False

    def close(self) -> None:
        """Nothing to end."""


@contextmanager
def opened() -> Iterator[tuple[RealLink, RecordingTransport]]:
    transport = RecordingTransport()
    link = real_link(lambda record: transport, SimulationConfig(), PROFILE)
    link.connect()
    try:
        yield link, transport
    finally:
        link.close()


def require_possible(state: RobotState) -> None:
    assert all(map(math.isfinite, (*state.pose, *state.twist))), state
    assert abs(state.pose.x_m) <= 1e5


def code_of(action: Callable[[], None]) -> str | None:
    """Code of the problem that an action meets; None if there is none."""
    try:
        action()
    except PinelError as problem:
        return problem.code
    return None


@given(st.lists(st.tuples(messages, st.floats(0.0, 1.0)), max_size=30))
def test_checked_odometry_is_finite_or_a_named_problem(
    sequence: list[tuple[Odometry, float]],
) -> None:
    checked, now_s = OdometryFilter(), 0.0
    for message, passes_s in sequence:
        now_s += passes_s
        assert code_of(partial(checked.add, message, now_s)) in {None, *LASTING}
        if checked.state is not None:
            require_possible(checked.state)


def apply(link: RealLink, step: Any) -> None:
    """Lets the robot or the program do one thing."""
    match step:
        case Odometry():
            link.on_odometry(step)
        case Twist2D():
            link.command(step)
        case list():
            for message in step:
                link.on_odometry(message)
        case _:
            link.on_battery(step)


@settings(max_examples=30, deadline=None)
@given(st.lists(messages | velocities | floods | anything, min_size=1, max_size=25))
def test_after_a_problem_only_zeros_are_sent(steps: list[Any]) -> None:
    with opened() as (link, transport):
        n_before: int | None = None
        for step in steps:
            apply(link, step)
            code = code_of(lambda: require_possible(link.read()))
            assert code in {None, *LASTING, *PASSING}
            assert n_before is None or code in LASTING
            if code in LASTING and n_before is None:
                n_before = len(transport.sent) + 1  # one may be on its way
        transport.wait_for_more()
        link.command(Twist2D(0.2, 0.2))
        transport.wait_for_more()
        assert all(
            abs(v) <= MAX_V_MPS and abs(omega) <= MAX_OMEGA_RADPS for v, omega in transport.sent
        )
        if n_before is not None:
            assert set(transport.sent[n_before:]) == {STANDSTILL}
        assert link.battery is None or 0.0 <= link.battery <= 1.0


@settings(max_examples=20, deadline=None)
@given(st.lists(messages, min_size=1, max_size=60), st.lists(velocities, min_size=1, max_size=60))
def test_messages_and_commands_at_the_same_time_end_in_zeros_too(
    reports: list[Odometry], commanded: list[Twist2D]
) -> None:
    with opened() as (link, transport):
        robot = threading.Thread(target=apply, args=(link, reports))
        robot.start()
        for twist in commanded:
            link.command(twist)
            assert code_of(lambda: require_possible(link.read())) in {None, *LASTING, *PASSING}
        robot.join()
        link.on_problem(PinelError("link_lost"))
        n_before = len(transport.sent) + 1
        for twist in commanded:
            link.command(twist)
        transport.wait_for_more()
        assert set(transport.sent[n_before:]) == {STANDSTILL}
