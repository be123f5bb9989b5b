"""Monitors one real robot while a page requests it; a run or a jog reserves the robot before driving it."""

import contextlib
import logging
import math
import threading
import time
from collections.abc import Callable, Iterator

from pinel_desktop.errors import PinelError
from pinel_desktop.links import open_link
from pinel_desktop.links.real import RealLink
from pinel_desktop.processes.messages import Message
from pinel_desktop.robot import Pose2D, RobotLink
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.runs.robots import LEASE_S
from pinel_desktop.runs.robots.state import UPDATE_INTERVAL_S, RobotSnapshot, StatePublisher, Use

# Reconnects after such a pause of the odometry: the robot may have restarted with other message
# types or another address.
_RECONNECT_AFTER_S = 10.0
_AGAIN_S = 2.0
_RELEASED_WITHIN_S = 5.0

_log = logging.getLogger(__name__)
Follow = Callable[[RobotLink], None]


class RobotMonitor:
    """Listens to a robot on a thread of its own, which ends some seconds after the last `renew_lease`.

    A run or a jog reserves the robot. Listening then ends, and the published state comes from the link that drives.
    """

    def __init__(self, profile: RobotProfile, send: Callable[[Message], None]) -> None:
        self._profile = profile
        self._changed = threading.Condition()
        self._thread: threading.Thread | None = None
        self._lease_ends_s = -math.inf
        self._use: Use = "watch"
        self._n_users = 0
        self._is_listening = False
        self._link: RealLink | None = None
        self._start: Pose2D | None = None
        self._missing: PinelError | None = None  # problem of listening
        self._trouble: PinelError | None = None  # problem of the last jog
        self._publisher = StatePublisher(send)

    @property
    def start(self) -> Pose2D | None:
        """Pose of the robot at the room's start, in its odometry frame; None if unknown."""
        return self._start

    def renew_lease(self, profile: RobotProfile) -> None:
        """Extends monitoring by `LEASE_S`; connects again if the profile has changed."""
        with self._changed:
            self._lease_ends_s = time.monotonic() + LEASE_S
            if not self._n_users:
                self._use_profile(profile)
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, name="robot-watch", daemon=True)
                self._thread.start()

    def set_start_here(self) -> None:
        """Declares that the robot is at the room's start: its later poses in the room refer to this pose."""
        with self._changed:
            self._start = self._link.pose if self._link else None
            self._trouble = None

    @contextlib.contextmanager
    def reserved(self, use: Use, profile: RobotProfile) -> Iterator[Follow]:
        """Reserves the robot: ends listening, and publishes the state of the link that the yielded function receives.

        Raises PinelError `robot_in_use` for a jog while a run or a connection test has reserved the robot.
        """
        with self._changed:
            if use == "jog" and self._n_users:
                raise PinelError("robot_in_use")
            self._n_users += 1
            self._use, self._trouble = use, None
            self._changed.notify_all()
            self._changed.wait_for(lambda: not self._is_listening, _RELEASED_WITHIN_S)
            self._missing = None
        try:
            yield self._follow
        finally:
            with self._changed:
                self._update_start()
                self._n_users -= 1
                self._use, self._link = "watch", None
                self._changed.notify_all()

    def fail(self, problem: PinelError) -> None:
        """Publishes the problem that ended a jog, until the robot is reserved again."""
        self._trouble = problem

    def close(self) -> None:
        """Ends monitoring."""
        with self._changed:
            self._lease_ends_s = -math.inf
            thread = self._thread
            self._changed.notify_all()
        if thread is not None:
            thread.join(_RELEASED_WITHIN_S)

    def _use_profile(self, profile: RobotProfile) -> None:
        if profile != self._profile:
            self._profile, self._start = profile, None
            self._missing = self._trouble = None
            self._changed.notify_all()

    def _follow(self, link: RobotLink) -> None:
        if isinstance(link, RealLink):
            with self._changed:
                self._link = link
                self._changed.notify_all()

    def _update_start(self) -> None:
        """Takes over the start of the link that drove; after a lost reference the start is unknown."""
        if self._link is None:
            return
        problem = self._link.problem
        is_lost = problem is not None and problem.code in _LOST
        self._start = None if is_lost else self._link.start or self._start

    def _work(self) -> None:
        self._publisher.force_next()
        while True:
            with self._changed:
                if time.monotonic() >= self._lease_ends_s:
                    self._thread = self._start = self._missing = self._trouble = None
                    return
                self._is_listening = is_free = self._n_users == 0
                profile = self._profile
            if is_free:
                self._listen(profile)
            else:
                self._publish_state()
                self._wait(lambda: not self._n_users, UPDATE_INTERVAL_S)

    def _listen(self, profile: RobotProfile) -> None:
        link = open_link(profile.link, world=profile.room.as_world(), robot=profile)
        assert isinstance(link, RealLink)
        self._publish_state()
        try:
            link.listen(lambda: self._is_over(profile))
            self._follow(link)
            self._missing = None
            self._receive(link, profile)
        except PinelError as problem:
            self._missing = problem
        except Exception:
            _log.exception("a robot could not be listened to")
        finally:
            link.close()
            with self._changed:
                self._link, self._is_listening = None, False
                self._changed.notify_all()
        if not self._is_over(profile):
            self._publish_state()
            self._wait(lambda: self._is_over(profile), _AGAIN_S)

    def _receive(self, link: RealLink, profile: RobotProfile) -> None:
        """Publishes the robot's state until the robot is reserved or must be connected again."""
        while not self._is_over(profile):
            if link.problem is not None:
                self._start = None
                raise link.problem
            self._start = self._start or link.pose
            self._publish_state()
            if link.n_odometry and link.age_s > _RECONNECT_AFTER_S:
                return
            self._wait(lambda: self._is_over(profile), UPDATE_INTERVAL_S / 2)

    def _is_over(self, profile: RobotProfile) -> bool:
        is_due = time.monotonic() >= self._lease_ends_s
        return is_due or self._n_users > 0 or profile != self._profile

    def _wait(self, condition: Callable[[], bool], seconds: float) -> None:
        with self._changed:
            self._changed.wait_for(condition, seconds)

    def _publish_state(self) -> None:
        with self._changed:
            problem = self._trouble or self._missing
            snapshot = RobotSnapshot(self._profile, self._use, self._link, self._start, problem)
        self._publisher.publish(snapshot)


# Problems after which the robot's pose in the room is unknown.
_LOST = frozenset({"reference_lost", "odometry_frame_changed"})
