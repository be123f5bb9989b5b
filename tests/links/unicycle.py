"""A robot in memory: a unicycle that follows velocities at once and reports its pose, for tests of links."""

import math
import threading
import time
from dataclasses import dataclass, field

from pinel_desktop.links.transport import Cancelled, Odometry, Receiver
from pinel_desktop.robot import STANDSTILL, Sensors, Twist2D


@dataclass
class Unicycle:
    """Integrates velocities over wall time.

    Attributes:
        received: all velocities that reached it, with the time (s, monotonic).
        is_mute: reports nothing more; it still drives.
    """

    x_m: float = 0.0
    y_m: float = 0.0
    yaw_rad: float = 0.0
    twist: Twist2D = STANDSTILL
    received: list[tuple[float, Twist2D]] = field(default_factory=list)
    is_mute: bool = False
    _at_s: float = field(default_factory=time.monotonic)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def receive(self, twist: Twist2D) -> None:
        """Follows a velocity from now on."""
        self.received.append((time.monotonic(), twist))
        with self._lock:
            self._advance()
            self.twist = twist

    def report(self) -> Odometry:
        """Pose and velocity now."""
        with self._lock:
            self._advance()
            return Odometry(self.x_m, self.y_m, self.yaw_rad, *self.twist, time.time(), "odom")

    def _advance(self) -> None:
        dt_s, self._at_s = time.monotonic() - self._at_s, time.monotonic()
        (v, omega), middle = self.twist, self.yaw_rad + self.twist.omega_radps * dt_s / 2
        self.x_m += v * dt_s * math.cos(middle)
        self.y_m += v * dt_s * math.sin(middle)
        self.yaw_rad += omega * dt_s

    def standstill_since_s(self) -> float | None:
        """Since when only zeros have come (monotonic); None if the last velocity was another one."""
        return standstill_since_s(self.received)


def standstill_since_s(received: list[tuple[float, Twist2D]]) -> float | None:
    """The time of the first of the zeros at the end of `received`; None if the last velocity was another one."""
    since: float | None = None
    for at_s, twist in received:
        if twist != STANDSTILL:
            since = None
        elif since is None:
            since = at_s
    return since


class MemoryTransport:
    """Carries velocities to a unicycle and its reports back, one every `period_s`."""

    def __init__(self, robot: Unicycle, period_s: float = 0.01) -> None:
        self._period_s = period_s
        self.sensors = Sensors()
        self._robot = robot
        self._ending = threading.Event()
        self._thread: threading.Thread | None = None

    def open(self, receiver: Receiver, cancelled: Cancelled) -> None:
        self._thread = threading.Thread(target=self._report, args=(receiver,), daemon=True)
        self._thread.start()

    def listen(self, receiver: Receiver, cancelled: Cancelled) -> None:
        self.open(receiver, cancelled)

    def _report(self, receiver: Receiver) -> None:
        while not self._ending.wait(self._period_s):
            if not self._robot.is_mute:
                receiver.on_odometry(self._robot.report())

    def send(self, twist: Twist2D) -> None:
        self._robot.receive(twist)

    def bumper(self) -> bool:
        return False

    def close(self) -> None:
        self._ending.set()
        if self._thread is not None:
            self._thread.join()
