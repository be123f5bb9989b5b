"""Tick clocks: real time, or as fast as possible."""

import time
from collections.abc import Callable
from typing import NamedTuple, Protocol

TICK_HZ = 30
TICK_S = 1.0 / 30.0
# After a freeze of the PC the schedule restarts from now: missed ticks are not caught up.
_MAX_LATENESS_S = 5 * TICK_S


class WallTime(NamedTuple):
    """The PC's time in s, and its sleep function; injected by tests."""

    now: Callable[[], float] = time.monotonic
    sleep: Callable[[float], None] = time.sleep


WALL_TIME = WallTime()


class Clock(Protocol):
    """Paces the ticks."""

    def wait_for_tick(self) -> None:
        """Returns when the next tick is due."""


class UnpacedClock:
    """Never waits: headless runs and tests."""

    def wait_for_tick(self) -> None:
        return


class LiveClock:
    """30 ticks a second on absolute deadlines, so that delays do not accumulate.

    `speed` returns the factor by which ticks come faster. `speed` is polled during a wait, so that a
    new speed takes effect at once in slow motion.
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
