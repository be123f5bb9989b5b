"""State messages about a real robot, between and during runs: sent on change, at most twice a second."""

import math
import time
from collections.abc import Callable
from typing import Literal, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.links.real import ODOMETRY_TIMEOUT_S, RealLink
from pinel_desktop.processes.messages import Message
from pinel_desktop.robot import Pose2D
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.runs.robots import ROBOT_STATE

UPDATE_INTERVAL_S = 0.5
_RATE_OVER_S = 2.0

Use = Literal["watch", "run", "jog"]


class RobotSnapshot(NamedTuple):
    """State of a robot at one time.

    Attributes:
        use: what the link is used for.
        link: None without a connection.
        start: pose of the robot at the room's start, in its odometry frame; None if unknown.
        problem: the current problem, or the problem that ended the last jog.
    """

    profile: RobotProfile
    use: Use
    link: RealLink | None
    start: Pose2D | None
    problem: PinelError | None


class StatePublisher:
    """Sends the state of one robot to the app."""

    def __init__(self, send: Callable[[Message], None]) -> None:
        self._send = send
        self._last: Message | None = None
        self._published_s = -math.inf
        self._counted: tuple[RealLink | None, float, int] = (None, 0.0, 0)
        self._rate_hz: float | None = None

    def publish(self, snapshot: RobotSnapshot) -> None:
        """Sends a changed state: a change of `use` at once, other changes at most every `UPDATE_INTERVAL_S`."""
        state, now_s = self._state(snapshot), time.monotonic()
        is_due = now_s - self._published_s >= UPDATE_INTERVAL_S
        is_other_use = self._last is None or self._last["use"] != state["use"]
        if state != self._last and (is_due or is_other_use):
            self._last, self._published_s = state, now_s
            self._send(state)

    def force_next(self) -> None:
        """Makes `publish` send the next state, changed or not."""
        self._last = None

    def _state(self, snapshot: RobotSnapshot) -> Message:
        link, problem = snapshot.link, snapshot.problem
        received = (
            _nothing(snapshot)
            if link is None or link.pose is None
            else self._received_fields(link, snapshot)
        )
        return {
            "type": ROBOT_STATE,
            "link": snapshot.profile.link,
            "address": snapshot.profile.address if snapshot.profile.comes_to_us else "",
            "use": snapshot.use,
            **received,
            "holder": link and link.holder,
            "code": problem and problem.code,
            "params": dict(problem.params) if problem else {},
        }

    def _received_fields(self, link: RealLink, snapshot: RobotSnapshot) -> Message:
        pose, age_s = link.pose, link.age_s
        assert pose is not None
        begin = link.start or snapshot.start or pose
        x, y, yaw = snapshot.profile.room.start.compose(pose.relative_to(begin))
        is_unresponsive = age_s > ODOMETRY_TIMEOUT_S
        rate_hz = self._rate(link)
        return {
            "state": "silent" if is_unresponsive else "connected",
            "age_s": math.floor(age_s) if is_unresponsive else None,
            "rate_hz": None if is_unresponsive else rate_hz,
            "battery": None if link.battery is None else round(link.battery, 2),
            "x_m": round(x, 2) + 0.0,  # no -0.0
            "y_m": round(y, 2) + 0.0,
            "heading_deg": round(math.degrees(yaw)),
        }

    def _rate(self, link: RealLink) -> float | None:
        """Returns the odometry messages per second; ignores changes of up to 1 Hz or a tenth."""
        now_s, n_received = time.monotonic(), link.n_odometry
        counted, since_s, before = self._counted
        if counted is not link:
            self._counted, self._rate_hz = (link, now_s, n_received), None
        elif now_s - since_s >= _RATE_OVER_S:
            rate_hz = (n_received - before) / (now_s - since_s)
            if self._rate_hz is None or abs(rate_hz - self._rate_hz) > max(1.0, rate_hz / 10):
                self._rate_hz = float(round(rate_hz))
            self._counted = (link, now_s, n_received)
        return self._rate_hz


def _nothing(snapshot: RobotSnapshot) -> Message:
    waits = snapshot.profile.comes_to_us and snapshot.problem is None
    fields = ("age_s", "rate_hz", "battery", "x_m", "y_m", "heading_deg")
    return {"state": "waiting" if waits else "searching", **dict.fromkeys(fields)}
