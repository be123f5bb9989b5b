"""Jogs a real robot: drives it slowly while a key is held. A command expires after 0.2 s, then the robot stops."""

import logging
import math
import threading
import time

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.links.real import RealLink
from pinel_desktop.robot import STANDSTILL, Twist2D
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.runs.robots.monitor import RobotMonitor

MAX_JOG_MPS = 0.15
MAX_JOG_RADPS = math.radians(30.0)
# Drops a command whose transmission took longer: the key may have been released since.
TOO_LATE_S = 0.25
# The link stays open for so long after the last command: the next key press need not connect again.
_IDLE_TIMEOUT_S = 3.0
# After a stop or a problem, ignores held keys until no key was held for so long.
_RELEASED_S = 0.5
_POLL_S = 0.05

_log = logging.getLogger(__name__)


class Jog:
    """Connects to the robot at the first command, as a run does, and disconnects soon after the last one.

    `command` runs on the engine's reading thread and never waits; the link's velocity publisher expires commands.
    """

    def __init__(self, robot: RobotMonitor) -> None:
        self._robot = robot
        self._lock = threading.Lock()
        self._drive: _Drive | None = None
        self._held_s = -math.inf
        self._sent_s = 0.0
        self._is_halted = False

    def command(self, profile: RobotProfile, drive: float, turn: float, sent_s: float) -> None:
        """Commands the velocity for the held keys: ahead (1) or back (-1), left (1) or right (-1).

        Args:
            sent_s: the time at which the page sent the command, by the PC's clock (s since 1970).
        """
        now_s, is_held = time.monotonic(), drive != 0.0 or turn != 0.0
        with self._lock:
            is_overtaken = 0.0 < self._sent_s - sent_s < TOO_LATE_S
            if is_held and (is_overtaken or abs(time.time() - sent_s) > TOO_LATE_S):
                return
            self._sent_s = sent_s
            if is_held:
                self._is_halted = self._is_halted and now_s - self._held_s < _RELEASED_S
                self._held_s = now_s
            if self._drive is not None and self._drive.is_over:
                self._drive = None
            if self._is_halted:
                return
            if self._drive is None and is_held:
                self._drive = _Drive(self, self._robot, profile)
            if self._drive is not None:
                self._drive.command(_twist(profile, drive, turn))

    def halt(self) -> None:
        """Stops the robot at once and disconnects; ignores the held keys until they are released."""
        with self._lock:
            self._is_halted = True
            drive = self._drive
        if drive is not None:
            drive.stop()

    def end(self) -> None:
        """Does the same as `halt`, and waits until the robot is disconnected."""
        self.halt()
        drive = self._drive
        if drive is not None:
            drive.join()


class _Drive:
    """One connection to the robot, on a thread of its own."""

    def __init__(self, jog: Jog, robot: RobotMonitor, profile: RobotProfile) -> None:
        self._jog, self._robot, self._profile = jog, robot, profile
        self._link: RealLink | None = None
        self._used_s = time.monotonic()
        self._ending = threading.Event()
        self._commanding = threading.Lock()
        self._thread = threading.Thread(target=self._work, name="robot-jog", daemon=True)
        self._thread.start()

    @property
    def is_over(self) -> bool:
        return not self._thread.is_alive()

    def command(self, twist: Twist2D) -> None:
        if twist != STANDSTILL:
            self._used_s = time.monotonic()
        with self._commanding:
            if self._link is not None and not self._ending.is_set():
                self._link.command(twist)

    def stop(self) -> None:
        with self._commanding:
            self._ending.set()
            if self._link is not None:
                self._link.command(STANDSTILL)

    def join(self) -> None:
        self._thread.join()

    def _work(self) -> None:
        try:
            with self._robot.reserved("jog", self._profile) as follow:
                link = open_link(
                    self._profile.link, world=self._profile.room.as_world(), robot=self._profile
                )
                assert isinstance(link, RealLink)
                try:
                    self._connect(link)
                    follow(link)
                    self._stay(link)
                finally:
                    link.close()
        except PinelError as problem:
            self._robot.fail(problem)
            self._jog.halt()
        except Exception:
            _log.exception("a robot could not be moved by keys")

    def _connect(self, link: RealLink) -> None:
        start = self._robot.start
        if start is not None:
            link.begin_at(start)
        link.connect(self._ending.is_set)
        self._link = link

    def _stay(self, link: RealLink) -> None:
        """Returns when no key was held for `_IDLE_TIMEOUT_S`, or at `stop`. Raises the robot's problem."""
        while not self._ending.wait(_POLL_S):
            link.read()
            if time.monotonic() - self._used_s > _IDLE_TIMEOUT_S:
                return


def _twist(profile: RobotProfile, drive: float, turn: float) -> Twist2D:
    """Returns the velocity for the keys, at most half of the profile's limits."""
    slow = profile.slowed()
    v = min(MAX_JOG_MPS, slow.max_v_mps)
    omega = min(MAX_JOG_RADPS, math.radians(slow.max_omega_dps))
    return Twist2D(_share(drive) * v, _share(turn) * omega)


def _share(value: float) -> float:
    return min(max(float(value), -1.0), 1.0) if math.isfinite(value) else 0.0
