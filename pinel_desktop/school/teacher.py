"""The teacher's PIN and sessions: a PIN gives access to review and settings for a limited time.

The PIN is stored as a salted scrypt hash. Because it is short, guessing is slowed down: after a few wrong PINs every
further attempt must wait, longer each time, also after a restart of the app. `pinel pin` replaces a forgotten PIN; it
needs write access to the database file, and anybody with that access needs no PIN.
"""

import hashlib
import hmac
import math
import secrets
import threading
import time
from collections.abc import Callable
from typing import Any, Protocol

from pinel_desktop.errors import PinelError

MIN_DIGITS, MAX_DIGITS = 4, 12
IDLE_S = 30 * 60.0  # an unused session ends after this time
_FREE_TRIES = 5
_FIRST_WAIT_S, _LONGEST_WAIT_S = 30.0, 15 * 60.0
_PIN, _TRIES = "teacher_pin", "teacher_pin_tries"
_COST = {"n": 2**14, "r": 8, "p": 1}  # 16 MiB and some 50 ms for each attempt


class Settings(Protocol):
    """Persistent values by key: the settings of the store."""

    def get(self, key: str) -> Any: ...

    def set(self, key: str, value: object) -> None: ...


class TeacherSessions:
    """Checks the PIN and holds the tokens of open sessions; thread-safe.

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
        self._tried = False  # whether there was an attempt since the start
        self._since = steady()  # time of the last attempt, initially of the start
        self._sessions: dict[str, tuple[float, str]] = {}  # token -> (last use, salt of the PIN)
        self._lock = threading.Lock()

    @property
    def has_pin(self) -> bool:
        """False until a PIN is set."""
        return self._settings.get(_PIN) is not None

    def set_pin(self, pin: str) -> None:
        """Sets the PIN and ends all sessions. Raises PinelError `pin_format`."""
        check_format(pin)
        salt = secrets.token_bytes(16)
        self._settings.set(
            _PIN, {**_COST, "salt": salt.hex(), "hash": _hash(pin, salt, _COST).hex()}
        )
        self._settings.set(_TRIES, None)
        with self._lock:
            self._sessions.clear()

    def remove_pin(self) -> None:
        """Removes the PIN; the page then asks for a new one."""
        self._settings.set(_PIN, None)
        self._settings.set(_TRIES, None)

    def sign_in(self, pin: str) -> str:
        """Begins a session and returns its token.

        Raises:
            PinelError: `pin_missing`, `pin_wrong`, or `pin_wait` with the seconds until the next attempt.
            StoreError: the attempt could not be counted and was therefore refused.
        """
        with self._lock:  # one attempt at a time
            self._check_wait()
            self._check(pin)
            token = secrets.token_urlsafe(32)
            self._sessions[token] = (self._steady(), self._salt())
        return token

    def is_signed_in(self, token: str | None) -> bool:
        """True if the token's session is open; prolongs it. A change of the PIN, also by `pinel pin`, ends sessions."""
        if token is None:
            return False
        salt = self._salt()
        with self._lock:
            now = self._steady()  # under the lock, so that times of use never decrease
            used, pin_salt = self._sessions.get(token, (-math.inf, ""))
            if pin_salt != salt or now - used > IDLE_S:
                self._sessions.pop(token, None)
                return False
            self._sessions[token] = (now, salt)
        return True

    def sign_out(self, token: str | None) -> None:
        """Ends the session of a token."""
        with self._lock:
            self._sessions.pop(token or "", None)

    def _check(self, pin: str) -> None:
        kept = self._settings.get(_PIN)
        if kept is None:
            raise PinelError("pin_missing")
        # counted before the check: if the disk is full, the attempt fails instead of going uncounted
        self._settings.set(_TRIES, {"failed": self._failed() + 1, "at": self._clock()})
        self._tried, self._since = True, self._steady()
        given = _hash(pin, bytes.fromhex(kept["salt"]), kept)
        if not hmac.compare_digest(given, bytes.fromhex(kept["hash"])):
            raise PinelError("pin_wrong")
        self._settings.set(_TRIES, None)

    def _check_wait(self) -> None:
        tries = self._settings.get(_TRIES)
        failed = self._failed()
        if not tries or failed < _FREE_TRIES:
            return
        wait_s = min(_FIRST_WAIT_S * 2 ** (failed - _FREE_TRIES), _LONGEST_WAIT_S)
        left_s = wait_s - self._passed_s(tries["at"])
        if left_s > 0:
            raise PinelError("pin_wait", failed=failed, seconds=int(left_s) + 1)

    def _passed_s(self, tried_at: float) -> float:
        """Seconds since the last attempt.

        If the wall clock was set back, they count from the start of the app: the wait is neither skipped nor endless.
        """
        by_clock_s = self._clock() - tried_at
        return self._steady() - self._since if self._tried or by_clock_s < 0 else by_clock_s

    def _salt(self) -> str:
        """Identifies the current PIN; differs even if the same digits are set again."""
        return str((self._settings.get(_PIN) or {}).get("salt", ""))

    def _failed(self) -> int:
        return int((self._settings.get(_TRIES) or {}).get("failed", 0))


def check_format(pin: str) -> None:
    """Raises PinelError `pin_format` unless the PIN has 4 to 12 ASCII digits."""
    if not (pin.isascii() and pin.isdecimal() and MIN_DIGITS <= len(pin) <= MAX_DIGITS):
        raise PinelError("pin_format", min=MIN_DIGITS, max=MAX_DIGITS)


def _hash(pin: str, salt: bytes, cost: Any) -> bytes:
    return hashlib.scrypt(
        pin.encode("utf-8", "ignore")[:100],
        salt=salt,
        n=cost["n"],
        r=cost["r"],
        p=cost["p"],
        maxmem=2**26,
    )
