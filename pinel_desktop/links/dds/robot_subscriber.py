"""Subscribes to a robot's topics and receives their messages on its own thread."""

import logging
import math
import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from cyclonedds.core import InstanceState, ReadCondition, SampleState, ViewState, WaitSet
from cyclonedds.idl import IdlStruct
from cyclonedds.internal import InvalidSample
from cyclonedds.sub import DataReader
from cyclonedds.util import duration

from pinel_desktop.errors import PinelError
from pinel_desktop.links.dds import messages
from pinel_desktop.links.dds.session import Session, delete
from pinel_desktop.links.localisation import sigmas_of
from pinel_desktop.links.odometry import yaw_of
from pinel_desktop.links.ros_sensors import LidarScan, RosSensors
from pinel_desktop.links.transport import Localised, Odometry, Receiver
from pinel_desktop.robot import Twist2D

_WATCH_INTERVAL_S = 0.2
# Minimum time between two reads of a topic. Of faster messages only the newest counts.
_MIN_INTERVAL_S = 0.005
_NEW = SampleState.NotRead | ViewState.Any | InstanceState.Any
_MAX_SAMPLES = 4
_MAX_WAIT = duration(milliseconds=100)

_log = logging.getLogger(__name__)
Handler = Callable[[Any], None]


class RobotClock:
    """Estimates the robot's clock from the stamps of its odometry, because a robot ignores commands with old stamps."""

    def __init__(self) -> None:
        self._ahead_s: float | None = None  # robot's clock minus this PC's monotonic clock

    def set(self, stamp_s: float | None) -> None:
        """Records the stamp of a message that has just arrived; None for a message without a stamp."""
        if stamp_s is not None and math.isfinite(stamp_s):
            self._ahead_s = stamp_s - time.monotonic()

    def now(self) -> messages.Time:
        """Returns the robot's time; zero before the first message, which robots treat as now."""
        if self._ahead_s is None:
            return messages.Time()
        now_s = max(0.0, time.monotonic() + self._ahead_s)
        whole_s = math.floor(now_s)
        return messages.Time(whole_s, int((now_s - whole_s) * 1e9))


class RobotSubscriber:
    """Receives a robot's messages and passes them to its link and its sensors.

    Args:
        watch: called five times a second on the receiving thread; a PinelError that it raises stops the robot.

    Attributes:
        last_pose_s: arrival time of the newest odometry message (monotonic clock); None before the first.
    """

    def __init__(
        self,
        session: Session,
        receiver: Receiver,
        sensors: RosSensors,
        watch: Callable[[], None],
    ) -> None:
        self._clock = RobotClock()
        self._session, self._receiver, self._sensors = session, receiver, sensors
        self._watch = watch
        self.last_pose_s: float | None = None
        self._handlers: list[tuple[DataReader[Any], ReadCondition, Handler]] = []
        self._waitset = WaitSet(session.participant)
        self._ending = threading.Event()
        self._has_failed = False
        self._thread = threading.Thread(target=self._work, name="robot-receiver", daemon=True)

    def start(self) -> None:
        self._thread.start()

    def close(self) -> None:
        self._ending.set()
        if self._thread.is_alive():
            self._thread.join()
        delete(self._waitset)

    def stamped(self, twist: Twist2D) -> messages.TwistStamped:
        """Returns a command message with a stamp by the robot's clock."""
        header = messages.Header(self._clock.now(), "base_link")
        linear, angular = messages.Vector3(x=twist.v_mps), messages.Vector3(z=twist.omega_radps)
        return messages.TwistStamped(header, messages.Twist(linear, angular))

    def subscribe(self, topic: str, message: type[IdlStruct]) -> None:
        """Subscribes to a topic. Allowed before `start` and within `watch`."""
        self._read(topic, message, getattr(self, _HANDLERS[message]))
        if message in _OFFERED:
            self._sensors.offer(_OFFERED[message])

    def follow_localisation(self, topic: str, message: type[IdlStruct]) -> None:
        """Subscribes to the poses of the robot's own localisation. Allowed when `subscribe` is."""
        has_covariance = message is messages.PoseWithCovarianceStamped
        self._read(
            topic, message, self._on_localised_with if has_covariance else self._on_localised
        )

    def _read(self, topic: str, message: type[IdlStruct], handle: Handler) -> None:
        reader = self._session.reader(topic, message)
        condition = ReadCondition(reader, _NEW)
        self._waitset.attach(condition)
        self._handlers.append((reader, condition, handle))

    def withdraw(self, message: type[IdlStruct]) -> None:
        """Discards the last reading of a message type that the robot does not publish any more."""
        if message in _OFFERED:
            self._sensors.withdraw(_OFFERED[message])
        else:
            self._receiver.on_battery(math.nan)

    def _work(self) -> None:
        watched_s = -math.inf
        while not self._ending.is_set():
            started_s = time.monotonic()
            if started_s - watched_s >= _WATCH_INTERVAL_S:
                watched_s = started_s
                self._guarded(self._watch)
            self._waitset.wait(_MAX_WAIT)
            for reader, _, handle in tuple(self._handlers):
                self._guarded(partial(self._read_samples, reader, handle))
            self._ending.wait(max(0.0, _MIN_INTERVAL_S - (time.monotonic() - started_s)))

    def _guarded(self, act: Callable[[], None]) -> None:
        """Calls `act`. A PinelError stops the robot; any other error skips the message, and the first is logged."""
        try:
            act()
        except PinelError as problem:
            self._receiver.on_problem(problem)
        except Exception:
            if not self._has_failed:
                _log.exception("a message of the robot could not be read")
            self._has_failed = True

    def _read_samples(self, reader: "DataReader[Any]", handle: Handler) -> None:
        for sample in reader.take(_MAX_SAMPLES):
            if not isinstance(sample, InvalidSample):
                handle(sample)

    def _on_odometry(self, message: messages.Odometry) -> None:
        twist = message.twist.twist
        self._forward_pose(message.header, message.pose.pose, twist.linear.x, twist.angular.z)

    def _on_pose(self, message: messages.PoseStamped) -> None:
        self._forward_pose(message.header, message.pose, None, None)

    def _forward_pose(
        self, header: messages.Header, pose: messages.Pose, v: float | None, omega: float | None
    ) -> None:
        self.last_pose_s = time.monotonic()
        stamp_s = _stamp_s(header)
        self._clock.set(stamp_s)
        at, turned = pose.position, pose.orientation
        yaw = yaw_of(turned.x, turned.y, turned.z, turned.w)
        self._receiver.on_odometry(Odometry(at.x, at.y, yaw, v, omega, stamp_s, header.frame_id))

    def _on_localised(self, message: messages.PoseStamped) -> None:
        self._forward_localised(message.header, message.pose, None)

    def _on_localised_with(self, message: messages.PoseWithCovarianceStamped) -> None:
        covariance = message.pose.covariance
        variances = (covariance[0], covariance[7], covariance[35])
        self._forward_localised(message.header, message.pose.pose, variances)

    def _forward_localised(
        self,
        header: messages.Header,
        pose: messages.Pose,
        variances: tuple[float, float, float] | None,
    ) -> None:
        at, turned = pose.position, pose.orientation
        yaw = yaw_of(turned.x, turned.y, turned.z, turned.w)
        more = (*sigmas_of(variances), _stamp_s(header), header.frame_id)
        self._receiver.on_localised(Localised(at.x, at.y, yaw, *more))

    def _on_scan(self, message: messages.LaserScan) -> None:
        bounds = (message.range_min, message.range_max)
        scan = LidarScan(message.angle_min, message.angle_increment, *bounds, message.ranges)
        self._sensors.on_scan(scan)

    def _on_range(self, message: messages.Range) -> None:
        self._sensors.on_range(message.header.frame_id, message.range, message.max_range)

    def _on_points(self, message: messages.PointCloud) -> None:
        self._sensors.on_points([(point.x, point.y) for point in message.points])

    def _on_bumper(self, message: messages.Bool) -> None:
        self._sensors.on_bumper(message.data)

    def _on_battery(self, message: messages.BatteryState) -> None:
        level = message.percentage  # from 0 to 1; some robots count to 100
        self._receiver.on_battery(level / 100 if level > 1.0 else level)


def _stamp_s(header: messages.Header) -> float | None:
    return header.stamp.sec + header.stamp.nanosec * 1e-9 or None


_HANDLERS: dict[type[IdlStruct], str] = {
    messages.Odometry: "_on_odometry",
    messages.PoseStamped: "_on_pose",
    messages.LaserScan: "_on_scan",
    messages.Range: "_on_range",
    messages.RangeBeforeIron: "_on_range",
    messages.PointCloud: "_on_points",
    messages.Bool: "_on_bumper",
    messages.BatteryState: "_on_battery",
}
_OFFERED: dict[type[IdlStruct], str] = {
    messages.LaserScan: "lidar",
    messages.Range: "sonar",
    messages.RangeBeforeIron: "sonar",
    messages.PointCloud: "sonar",
    messages.Bool: "bumper",
}
