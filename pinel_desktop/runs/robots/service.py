"""Monitors and jogs the real robots of an engine, and reserves them for runs."""

import contextlib
import threading
from collections.abc import Callable, Iterator

from pinel_desktop.processes.messages import Message
from pinel_desktop.robot.robot_profile import RobotProfile, profile_from
from pinel_desktop.runs.robots import AT_START, HALT, JOG
from pinel_desktop.runs.robots.jog import Jog
from pinel_desktop.runs.robots.monitor import Follow, RobotMonitor


class RobotService:
    """One monitor and one jog for each kind of link. Called on the engine's reading thread and on the threads of runs.

    Args:
        send: writes a message to the app; safe from any thread.
    """

    def __init__(self, send: Callable[[Message], None]) -> None:
        self._send = send
        self._robots: dict[str, RobotMonitor] = {}
        self._jogs: dict[str, Jog] = {}
        self._lock = threading.Lock()

    def handle(self, message: Message) -> None:
        """Executes a message of one of the `ROBOT_MESSAGES`. Never waits."""
        profile = profile_from(message["robot"])
        if message["type"] == JOG:
            self._jog(message, profile)
        elif message["type"] == HALT:
            self._halt(profile)
        elif message["type"] == AT_START:
            self._robot(profile).set_start_here()
        else:
            self._robot(profile).renew_lease(profile)

    @contextlib.contextmanager
    def reserved(self, profile: RobotProfile) -> Iterator[Follow]:
        """Reserves the robot for a run or a connection test; ends a jog first.

        The monitor publishes the state of the link that the yielded function receives.
        """
        jog = self._jogs.get(profile.link)
        if jog is not None:
            jog.end()
        with self._robot(profile).reserved("run", profile) as follow:
            yield follow

    def close(self) -> None:
        """Stops jogged robots and closes all links."""
        for jog in tuple(self._jogs.values()):
            jog.end()
        for robot in tuple(self._robots.values()):
            robot.close()

    def _robot(self, profile: RobotProfile) -> RobotMonitor:
        with self._lock:
            return self._robots.setdefault(profile.link, RobotMonitor(profile, self._send))

    def _jog(self, message: Message, profile: RobotProfile) -> None:
        robot = self._robot(profile)
        jog = self._jogs.get(profile.link)
        if jog is None:
            jog = self._jogs[profile.link] = Jog(robot)
        jog.command(profile, message["drive"], message["turn"], message["sent_s"])

    def _halt(self, profile: RobotProfile) -> None:
        jog = self._jogs.get(profile.link)
        if jog is not None:
            jog.halt()
