"""Sends what a real robot's own localisation says during a run to the app."""

import time
from collections.abc import Callable

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.links.real import RealLink
from pinel_desktop.processes.messages import Message
from pinel_desktop.robot import RobotLink
from pinel_desktop.robot.robot_profile import RobotProfile, RosProfile
from pinel_desktop.runs.robots import LOCALISED


class LocalisationSender:
    """Sends the newest pose after each sample of a run, on the thread of the run.

    Args:
        send: writes a message to the app.

    Attributes:
        is_read: whether the robot's profile names a topic.
    """

    def __init__(self, run_id: str, robot: RobotProfile, send: Callable[[Message], None]) -> None:
        self._run, self._send = run_id, send
        self.is_read = isinstance(robot, RosProfile) and bool(robot.localisation_topic)
        self._link: RealLink | None = None

    def follow(self, link: RobotLink) -> None:
        """Sets the link of the run."""
        self._link = link if isinstance(link, RealLink) else None

    def observe(self, _tick: int, event: Event) -> None:
        """Handles an event of the run, which was sent before."""
        if self._link is None or type(event) is not Telemetry:
            return
        found = self._link.pop_localised()
        if isinstance(found, PinelError):
            self._send({**self._empty(), "code": found.code, "params": dict(found.params)})
        elif found is not None:
            pose = [*found.pose, found.sigma_m, found.sigma_rad]
            age_s = time.monotonic() - found.at_s
            self._send({**self._empty(), "pose": pose, "age_s": age_s})

    def _empty(self) -> Message:
        return {
            "type": LOCALISED,
            "run": self._run,
            "age_s": 0.0,
            "pose": None,
            "code": None,
            "params": {},
        }
