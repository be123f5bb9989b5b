"""Rate limit for attempts to enter the PIN: a wait for each browser session, and a common rate for all sessions.

If all sessions shared one wait, pupils could lock the teacher out. If each session had only its own wait, a new session
would reset it. Therefore the common rate bounds guessing: 10 attempts at once, then one every two minutes while the app
runs. Trying half of the 10,000 PINs of four digits takes 166 hours.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol

from pinel_desktop.errors import PinelError
from storage import StoreError

FREE_TRIES = 5  # of one session before its first wait
FIRST_WAIT_S, MAX_WAIT_S = 30.0, 15 * 60.0
TOGETHER, ONE_MORE_S = 10, 120.0  # attempts of all sessions; time until one more is allowed
_MAX_SESSIONS = 20
_NEARLY = 1e-6
_TRIES = "teacher_pin_tries"


class Settings(Protocol):
    """Persistent values by key: the settings of the store."""

    def get(self, key: str) -> Any: ...

    def set(self, key: str, value: object) -> None: ...


class PinRateLimiter:
    """Counts wrong PINs in the settings, so that a restart of the app does not reset the limits. Not thread-safe.

    If the settings cannot be written, counts in memory, so that the teacher can sign in on a full disk.

    Args:
        clock: wall clock in seconds; runs while the app does not, but anybody can set it.
        steady: monotonic clock in seconds.
    """

    def __init__(
        self,
        settings: Settings,
        clock: Callable[[], float] = time.time,
        steady: Callable[[], float] = time.monotonic,
    ) -> None:
        self._settings, self._clock, self._steady = settings, clock, steady
        self._stored: Any = None  # the last value read from the settings
        self._tries = _Tries()
        # session -> time of its last attempt since the app's start, by the monotonic clock
        self._tried_at: dict[str, float] = {}
        self._started_at = self._refilled_at = steady()

    def check(self, session: str) -> None:
        """Raises PinelError `pin_wait` with the seconds until the session's next attempt."""
        self._update()
        failed, at = self._tries.by.get(session, (0, 0.0))
        left_s = max(self._own_wait_s(session, failed, at), self._shared_wait_s())
        if left_s > 0:
            raise PinelError("pin_wait", failed=max(failed, 1), seconds=int(left_s) + 1)

    def count(self, session: str) -> None:
        """Counts an attempt; called before the PIN is checked."""
        self._update()
        failed, _ = self._tries.by.pop(session, (0, 0.0))
        self._tries.by[session] = (failed + 1, self._clock())
        self._tries.by = dict(list(self._tries.by.items())[-_MAX_SESSIONS:])
        self._tries.left = max(self._tries.left - 1, 0.0)
        self._tried_at[session] = self._steady()
        if not self._store({"left": self._tries.left, "by": self._tries.by}):
            # a restart would reset the limit of attempts: from now on only one every two minutes
            self._tries.left = 0.0

    def forget(self) -> None:
        """Resets all limits, after the right PIN or for a new PIN."""
        self._tries = _Tries()
        self._tried_at.clear()
        self._store(None)

    def _own_wait_s(self, session: str, failed: int, at: float) -> float:
        if failed < FREE_TRIES:
            return 0.0
        doubled = min(failed - FREE_TRIES, 10)
        wait_s: float = min(FIRST_WAIT_S * 2**doubled, MAX_WAIT_S)
        return wait_s - self._passed_s(session, at)

    def _shared_wait_s(self) -> float:
        return max(1 - _NEARLY - self._tries.left, 0.0) * ONE_MORE_S

    def _passed_s(self, session: str, tried_at: float) -> float:
        """Seconds since the session's last attempt.

        If the wall clock was set back, counts from the start of the app. So the wait is neither skipped nor endless.
        """
        if session in self._tried_at:
            return self._steady() - self._tried_at[session]
        by_clock_s = self._clock() - tried_at
        return self._steady() - self._started_at if by_clock_s < 0 else by_clock_s

    def _update(self) -> None:
        """Reads the changes that `pinel pin` made, and refills the common attempts for the time since the last call.

        Only time while the app runs counts, by the monotonic clock: anybody can set the wall clock.
        """
        stored, now = self._settings.get(_TRIES), self._steady()
        if stored != self._stored:
            self._stored, self._tries = stored, _tries_of(stored)
        more = (now - self._refilled_at) / ONE_MORE_S
        self._tries.left = min(self._tries.left + more, TOGETHER)
        self._refilled_at = now

    def _store(self, tries: object) -> bool:
        try:
            self._settings.set(_TRIES, tries)
            self._stored = self._settings.get(_TRIES)
        except StoreError:
            return False
        return True


@dataclass(slots=True)
class _Tries:
    """Attempts left to all sessions together; by session the number of wrong PINs and the time of the last one."""

    left: float = float(TOGETHER)
    by: dict[str, tuple[int, float]] = field(default_factory=dict)


def _tries_of(stored: Any) -> _Tries:
    if not stored:
        return _Tries()
    try:
        by = {session: (int(n), float(at)) for session, (n, at) in stored["by"].items()}
        return _Tries(float(stored["left"]), by)
    except (KeyError, TypeError, ValueError, AttributeError):  # damaged settings
        return _Tries()
