"""Velocity publisher: the thread that repeats the newest command to a real robot and expires it."""

import logging
import threading
import time
from collections.abc import Callable

from pinel_desktop.robot import STANDSTILL, Twist2D

# Robots stop by themselves without commands, RosAria after 0.6 s. Repetition must be more frequent.
PERIOD_S = 1 / 30
# Without new commands the robot stops within 0.3 s: this time, one period and the network's delay.
COMMAND_TIMEOUT_S = 0.2
N_LAST_ZEROS = 5

_log = logging.getLogger(__name__)


class VelocityPublisher:
    """Sends the newest command at once, repeats it 30 times a second, and sends zeros once it has expired.

    Only `send` can block its thread. The thread acquires no lock that the run, the app or a pipe could hold.

    Args:
        send: passes a velocity to the transport, without waiting. The first error is logged; sending continues.
    """

    def __init__(self, send: Callable[[Twist2D], None]) -> None:
        self._send = send
        self._newest: tuple[Twist2D, float] = (STANDSTILL, -1.0)
        self._changed = threading.Event()
        self._ending = False
        self._has_failed = False
        self._thread = threading.Thread(target=self._work, name="robot-sender", daemon=True)

    def start(self) -> None:
        """Starts the thread, which first sends zeros."""
        self._thread.start()

    def command(self, twist: Twist2D) -> None:
        """Sets the velocity for the next `COMMAND_TIMEOUT_S`."""
        self._newest = (twist, time.monotonic())
        self._changed.set()

    def close(self) -> None:
        """Sends the last zeros and ends the thread; safe to call twice, and without a start."""
        self._newest = (STANDSTILL, -1.0)
        self._ending = True
        self._changed.set()
        if self._thread.is_alive():
            self._thread.join()

    def _work(self) -> None:
        while not self._ending:
            twist, at_s = self._newest
            left_s = at_s + COMMAND_TIMEOUT_S - time.monotonic()
            self._publish(twist if left_s > 0.0 else STANDSTILL)
            self._changed.wait(min(PERIOD_S, left_s) if left_s > 0.0 else PERIOD_S)
            self._changed.clear()
        for _ in range(N_LAST_ZEROS):  # several, because a network may lose packets
            self._publish(STANDSTILL)
            time.sleep(PERIOD_S / N_LAST_ZEROS)

    def _publish(self, twist: Twist2D) -> None:
        try:
            self._send(twist)
        except Exception:
            # The next attempt may succeed, and a robot without commands stops by itself.
            if not self._has_failed:
                _log.exception("a velocity could not be sent")
            self._has_failed = True
