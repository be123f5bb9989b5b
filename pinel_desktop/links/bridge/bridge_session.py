"""State of a run over the bridge: the commanded velocity, the robot's pose, and whether PINEL drives."""

import math
import threading
import time
from collections.abc import Mapping
from typing import Any, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.links.transport import Odometry, Receiver
from pinel_desktop.links.velocity_publisher import COMMAND_TIMEOUT_S
from pinel_desktop.robot import STANDSTILL, Twist2D

# A client that sent a request within this time is still connected, and must receive the run's end.
_THERE_S = 0.5
# Requests after which the client has received a zero: the first response may have been lost.
_N_ZEROS = 2
_FARTHEST = 1e5  # limit of a valid pose, in m and rad
POSE_EXAMPLE = '{"x": 1.5, "y": 0.0, "yaw": 0.1}'


class _Velocity(NamedTuple):
    """A velocity and its time, by the PC's clock (s since 1970) and by its monotonic clock (s)."""

    twist: Twist2D
    wall_s: float
    at_s: float


class BridgeSession:
    """Handles the requests of the bridge's client during a run, on the server's thread.

    The first address that posts a pose is the robot. Other addresses may only request the status.

    Attributes:
        asked: set once a client has requested a velocity.
        active: whether PINEL drives the robot: from the opening of the link until its end.
    """

    def __init__(self, receiver: Receiver) -> None:
        self.asked = threading.Event()
        self.active = True
        self._receiver = receiver
        self._velocity = _Velocity(STANDSTILL, time.time(), -math.inf)
        self._last_request_s = -math.inf
        self._robot: str | None = None
        self._ending = False
        self._n_zeros = 0
        self._zeros_delivered, self._end_delivered = threading.Event(), threading.Event()

    def set_velocity(self, twist: Twist2D) -> None:
        """Sets the velocity for the next `COMMAND_TIMEOUT_S`."""
        self._velocity = _Velocity(twist, time.time(), time.monotonic())

    def velocity(self, client: str) -> dict[str, Any]:
        """Returns the newest velocity; zero once it has expired. Raises PinelError `bridge_other_client`."""
        self._record_request(client)
        twist, wall_s, at_s = self._velocity
        if time.monotonic() - at_s > COMMAND_TIMEOUT_S or not self.active:
            twist = STANDSTILL
        self.asked.set()
        if self._ending and twist == STANDSTILL:
            self._n_zeros += 1
            if self._n_zeros >= _N_ZEROS:
                self._zeros_delivered.set()
        return {"linear_x": twist.v_mps, "angular_z": twist.omega_radps, "ts": wall_s}

    def handle_pose(self, client: str, document: object) -> dict[str, Any]:
        """Passes a pose to the link. Raises PinelError `bridge_pose_invalid`, `bridge_other_client`."""
        self._record_request(client)
        try:
            x_m, y_m, yaw_rad = (_number(document, name) for name in ("x", "y", "yaw"))
        except PinelError:
            # The link counts invalid poses, for its error about a robot that posts no valid pose.
            self._receiver.on_odometry(Odometry(math.nan, math.nan, math.nan, None, None))
            raise
        self._robot = client
        self._receiver.on_odometry(Odometry(x_m, y_m, yaw_rad, None, None))
        return {"ok": True}

    def status(self) -> dict[str, Any]:
        """Returns whether PINEL drives."""
        if not self.active:
            self._end_delivered.set()
        return {"active": self.active}

    def finish(self, timeout_s: float) -> None:
        """Ends the session: sends the client zeros first, then `active` false. Waits only for a connected client."""
        self._ending = True
        if time.monotonic() - self._last_request_s > _THERE_S:
            self.active = False
            return
        due_s = time.monotonic() + timeout_s
        self._zeros_delivered.wait(timeout_s)
        self.active = False
        self._end_delivered.wait(max(due_s - time.monotonic(), 0.0))

    def _record_request(self, client: str) -> None:
        if self._robot is not None and client != self._robot:
            raise PinelError("bridge_other_client", robot=self._robot)
        self._last_request_s = time.monotonic()


def _number(document: object, name: str) -> float:
    value = document.get(name) if isinstance(document, Mapping) else None
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if not is_number or not abs(value) < _FARTHEST:  # type: ignore[arg-type] # a number here
        raise PinelError("bridge_pose_invalid", field=name, value=value, example=POSE_EXAMPLE)
    return float(value)  # type: ignore[arg-type] # a number here
