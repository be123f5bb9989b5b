"""Publishes the status of real robots to the pages that ask for it."""

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from pinel_desktop.events.app_events import RobotStateChanged
from pinel_desktop.messages import describe
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.runs.robots import LEASE_S

if TYPE_CHECKING:
    from pinel_desktop.engine.client import EngineClient


class RobotStatusFeed:
    """Keeps the engine listening to a robot while a page asks, and publishes its status in the chosen language.

    Args:
        publish: sends an event to all pages.
        language: returns the chosen language.
    """

    def __init__(
        self, publish: Callable[[dict[str, Any]], None], language: Callable[[], str]
    ) -> None:
        self._publish, self._language = publish, language
        self._asked_s: dict[str, float] = {}
        self._last: dict[str, dict[str, Any]] = {}

    def watch(self, engine: "EngineClient", robot: RobotProfile, *, is_first: bool) -> None:
        """Handles a page's request to watch a robot; publishes the last known status for the page's first request."""
        now_s = time.monotonic()
        if now_s - self._asked_s.get(robot.link, now_s) > LEASE_S:  # the last status is outdated
            self._last.pop(robot.link, None)
        self._asked_s[robot.link] = now_s
        known = self._last.get(robot.link)
        if is_first and known is not None:
            self._publish(known)
        engine.watch(robot)

    def publish_state(self, state: dict[str, Any]) -> None:
        """Publishes a status message of the engine."""
        values = dict(state)
        code, params = values["code"], values.pop("params")
        del values["type"]
        text = describe(code, params, self._language()) if code else None
        event = RobotStateChanged(
            **values,
            message=text.message if text else "",
            remedy=text.remedy if text else "",
        )
        self._last[event.link] = event.to_wire()
        self._publish(event.to_wire())
