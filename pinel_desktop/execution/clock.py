"""How ticks follow each other: at the pace of the wall clock, or as fast as they can."""

import time
from collections.abc import Callable
from typing import NamedTuple, Protocol

TICK_HZ = 30
TICK_S = 1.0 / 30.0
# A PC that froze for a moment goes on from now: it does not rush through the ticks it missed.
_MAX_LATENESS_S = 5 * TICK_S


class WallTime(NamedTuple):
    """The PC's time in s, and how to let some of it pass; tests bring one of their own."""

    now: Callable[[], float] = time.monotonic
    sleep: Callable[[float], None] = time.sleep


WALL_TIME = WallTime()


class Clock(Protocol):
    """Decides when the next tick may begin."""

    def wait_for_tick(self) -> None:
        """Returns when the next tick is due."""


class MaxClock:
    """Never waits: headless runs and tests."""

    def wait_for_tick(self) -> None:
        return


class LiveClock:
    """30 ticks a second on absolute deadlines, so that lateness does not add up.

    `speed` tells how many times faster than that they are to come. In slow motion it is asked again while a tick is
    waited for, so that another speed takes effect at once.
    """

    def __init__(
        self, wall: WallTime = WALL_TIME, speed: Callable[[], float] = lambda: 1.0
    ) -> None:
        (self._now, self._sleep), self._speed = wall, speed
        self._due: float | None = None

    def wait_for_tick(self) -> None:
        before, now = self._due, self._now()
        if before is None:
            self._due = now
            return
        while (due := before + TICK_S / self._speed()) > now:
            self._sleep(min(due - now, TICK_S))
            now = self._now()
        self._due = now if now - due > _MAX_LATENESS_S else due
