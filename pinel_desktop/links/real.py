"""The link of all real robots, over any transport, with safety limits. Poses are in the robot's odometry frame."""

import contextlib
import math
import threading
import time
from collections.abc import Callable
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.links.localisation import Localisation, LocalisedPose
from pinel_desktop.links.odometry import OdometryFilter
from pinel_desktop.links.robot_lock import RobotLock
from pinel_desktop.links.transport import Localised, Odometry, Transport
from pinel_desktop.links.velocity_publisher import VelocityPublisher
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotState, SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import RobotProfile, Room, RosProfile

ODOMETRY_TIMEOUT_S = 1.0
_FIRST_ODOMETRY_S = 5.0
_POLL_S = 0.05
# Polls before the odometry counts as timed out. After a pause of this PC, received messages may
# still be in a queue.
_MAX_POLLS = 4
# Longest time for which the period of the odometry is measured.
_LISTEN_S = 1.0
_PAUSE_S = 0.4  # a gap of the odometry that ends the measurement of its period
# Delay from a command until its effect is measured: the value for an unknown period, and the
# maximum.
_DELAY_S, _MAX_DELAY_S = 0.1, 0.3
# The part of that delay that does not depend on the period of the odometry: network and drives
# (tests/links/test_late_robot.py).
_REACTS_S = 0.08


class RealLink:
    """Drives a real robot in real time.

    The protection of people and robot is here, the same for every transport:

    - A command expires after 0.2 s.
    - The profile limits velocities.
    - The robot is stopped if its odometry is missing for 1 s, if its pose jumps, or if it leaves the room.

    Attributes:
        battery: charge from 0 to 1; None if unknown.
        holder: name of another program that drives the robot, found on the network; None without one.
    """

    simulated = False
    slips = True
    command_delay_s = _DELAY_S

    def __init__(
        self, profile: RobotProfile, setting: SimulationConfig, transport: Transport
    ) -> None:
        robot = profile.limited(setting.robot)
        self._max_v, self._max_omega = robot.max_v_mps, robot.max_omega_radps
        self._edge = _Edge(profile.room, robot.radius_m)
        self._robot_lock = RobotLock(profile)
        self._transport = transport
        self.sensors = transport.sensors
        self._publisher = VelocityPublisher(transport.send)
        self._lock = threading.Lock()
        self._odometry = OdometryFilter()
        frame = profile.localisation_frame if isinstance(profile, RosProfile) else ""
        self._localisation = Localisation(frame)
        self._start: Pose2D | None = None
        self._problem: PinelError | None = None
        # Without this lock, a velocity that is being set could replace the zeros of a new problem.
        self._commanding = threading.Lock()
        self._closed = False
        self.battery: float | None = None
        self.holder: str | None = None

    def listen(self, cancelled: Callable[[], bool] = lambda: False) -> None:
        """Connects to receive only, in place of `connect`; another program may drive the robot.

        Raises the errors of `connect`.
        """
        self._transport.listen(self, cancelled)

    def connect(self, cancelled: Callable[[], bool] = lambda: False) -> None:
        self._robot_lock.acquire()
        self._transport.open(self, cancelled)
        self._publisher.start()
        self._command(STANDSTILL)
        due_s = time.monotonic() + _FIRST_ODOMETRY_S
        while self._odometry.state is None and not cancelled():
            if self._problem is not None:
                raise self._problem
            if time.monotonic() > due_s:
                raise self._timeout_problem()
            time.sleep(_POLL_S)
        if self._odometry.state is None:
            return
        self._estimate_delay(cancelled)
        if self._start is None:
            self._start = self._odometry.state.pose

    def begin_at(self, pose: Pose2D) -> None:
        """Sets the pose of the room's start in the odometry frame; call it before `connect`."""
        self._start = pose

    def _estimate_delay(self, cancelled: Callable[[], bool]) -> None:
        """Measures the period of the odometry and estimates the command delay from it."""
        due_s = time.monotonic() + _LISTEN_S
        while not self._odometry.is_period_known and time.monotonic() < due_s and not cancelled():
            if self.age_s > _PAUSE_S:
                break
            time.sleep(_POLL_S / 5)
        self.command_delay_s = delay_s(self._odometry.period_s)

    def read(self) -> RobotState:
        if self._odometry.state is not None and self.age_s > ODOMETRY_TIMEOUT_S:
            self._poll_again()
        with self._lock:
            state, age_s = self._odometry.state, self.age_s
        if self._problem is not None:
            raise self._problem
        if state is None or age_s > ODOMETRY_TIMEOUT_S:
            raise self._timeout_problem()
        return state

    def _poll_again(self) -> None:
        """Gives the receiving thread time to process queued messages; commands zero velocity meanwhile."""
        self._command(STANDSTILL)
        for _ in range(_MAX_POLLS):
            if self._problem is not None or self.age_s <= ODOMETRY_TIMEOUT_S:
                return
            time.sleep(_POLL_S)

    @property
    def start(self) -> Pose2D | None:
        """Pose of the room's start in the odometry frame; None before the connection."""
        return self._start

    @property
    def pose(self) -> Pose2D | None:
        """The newest pose in the odometry frame, of any age; None before the first."""
        state = self._odometry.state
        return state and state.pose

    @property
    def problem(self) -> PinelError | None:
        """Why the robot must not be driven any more; None without a reason."""
        return self._problem

    @property
    def age_s(self) -> float:
        """Time since the newest valid odometry message; infinite before the first."""
        return time.monotonic() - self._odometry.arrived_s

    @property
    def n_odometry(self) -> int:
        """Number of valid odometry messages."""
        return self._odometry.n_valid

    def bumper(self) -> bool:
        return self._transport.bumper()

    def movable_boxes(self) -> dict[int, Pose2D]:
        return {}

    def command(self, twist: Twist2D) -> None:
        v, omega = twist
        if not (math.isfinite(v) and math.isfinite(omega)) or self.age_s > ODOMETRY_TIMEOUT_S:
            v = omega = 0.0
        v = min(max(v, -self._max_v), self._max_v)
        omega = min(max(omega, -self._max_omega), self._max_omega)
        self._command(Twist2D(v, omega))

    def _command(self, twist: Twist2D) -> None:
        with self._lock:
            self._odometry.command(twist, time.monotonic())
        with self._commanding:
            self._publisher.command(STANDSTILL if self._problem else twist)

    def advance(self, dt_s: float) -> None:
        """Does nothing: a real robot runs in real time."""

    def close(self) -> None:
        if self._closed:
            return
        self._closed = True
        self._publisher.close()
        # The robot has received zeros, so an error of the disconnection has no consequence.
        with contextlib.suppress(Exception):
            self._transport.close()
        self._robot_lock.release()

    def on_odometry(self, odometry: Odometry) -> None:
        try:
            with self._lock:
                self._odometry.add(odometry, time.monotonic())
            self._require_inside()
        except PinelError as problem:
            self.on_problem(problem)

    def _require_inside(self) -> None:
        start, state = self._start, self._odometry.state
        if start is not None and state is not None:
            self._edge.require_inside(state.pose.relative_to(start))

    def on_holder(self, name: str | None) -> None:
        self.holder = name

    def on_localised(self, localised: Localised) -> None:
        now_s = time.monotonic()
        with self._lock:
            robot_now_s = self._odometry.robot_s(now_s)
        self._localisation.add(localised, now_s, robot_now_s)

    def pop_localised(self) -> LocalisedPose | PinelError | None:
        """Returns the newest pose of the robot's own localisation once, or why it does not count."""
        return self._localisation.pop()

    def on_battery(self, level: float) -> None:
        self.battery = level if 0.0 <= level <= 1.0 else None

    def on_problem(self, problem: PinelError) -> None:
        with self._commanding:
            self._problem = self._problem or problem
            self._publisher.command(STANDSTILL)

    def _timeout_problem(self) -> PinelError:
        """Returns the error for a robot without a valid odometry message within the time-out."""
        odometry = self._odometry
        timeout_s = ODOMETRY_TIMEOUT_S if odometry.state else _FIRST_ODOMETRY_S
        if time.monotonic() - odometry.invalid_s <= timeout_s:
            return PinelError("odometry_invalid", count=odometry.n_invalid)
        return PinelError("link_lost" if odometry.state else "robot_silent")


def delay_s(period_s: float | None) -> float:
    """Returns the mean time in s from a command until its effect is measured.

    An odometry message is half a period old on average. If the robot's control loop has the same period, a command also
    waits half a period on average. Together they are one period.

    Args:
        period_s: period of the odometry messages; None if unknown.
    """
    if period_s is None:
        return _DELAY_S
    return min(period_s + _REACTS_S, _MAX_DELAY_S)


class _Edge:
    """The edge of the room, which the robot's body must not cross."""

    def __init__(self, room: Room, radius_m: float) -> None:
        self._start = room.start
        self._room, self._radius_m = room, radius_m

    def require_inside(self, pose: Pose2D) -> None:
        """Raises PinelError `left_room` if the body crosses the edge; `pose` is in the start frame."""
        room, radius = self._room, self._radius_m
        x, y, _ = self._start.compose(pose)
        if abs(x) + radius > room.width_m / 2 or abs(y) + radius > room.depth_m / 2:
            raise PinelError("left_room", width=room.width_m, depth=room.depth_m)


def real_link(
    make: Callable[[Any], Transport], setting: SimulationConfig, robot: RobotProfile | None
) -> RealLink:
    """Returns a link over the transport that `make` builds from the robot's profile.

    Raises PinelError `robot_not_set_up` without a profile.
    """
    if robot is None:
        raise PinelError("robot_not_set_up")
    return RealLink(robot, setting, make(robot))
