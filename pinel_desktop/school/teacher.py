"""The teacher's door: a PIN opens review and settings for a while.

The PIN is kept as a salted scrypt hash. It is short, so guessing is made slow: after a few wrong ones each next try has
to wait, longer every time, also after the app was started again. Who has forgotten it chooses another with `pinel pin`,
which needs the account of this PC that owns the data: whoever can read that file needs no PIN.
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
IDLE_S = 30 * 60.0  # a teacher who walks off leaves the door open no longer than this
_FREE_TRIES = 5
_FIRST_WAIT_S, _LONGEST_WAIT_S = 30.0, 15 * 60.0
_PIN, _TRIES = "teacher_pin", "teacher_pin_tries"
_COST = {"n": 2**14, "r": 8, "p": 1}  # 16 MiB and some 50 ms for each guess


class Kept(Protocol):
    """Where values outlive the app: the store's settings."""

    def get(self, key: str) -> Any: ...

    def set(self, key: str, value: object) -> None: ...


class TeacherDoor:
    """Thread-safe. Those for whom the door is open hold a token.

    Args:
        clock: seconds of a clock that goes on while the app does not run; anybody may set it.
        steady: seconds of a clock that nobody can set.
    """

    def __init__(
        self,
        kept: Kept,
        clock: Callable[[], float] = time.time,
        steady: Callable[[], float] = time.monotonic,
    ) -> None:
        self._kept, self._clock, self._steady = kept, clock, steady
        self._tried = False  # since the start
        self._since = steady()  # the last try, before the first one the start
        self._open: dict[str, tuple[float, str]] = {}  # when last used, under which PIN
        self._lock = threading.Lock()

    @property
    def has_pin(self) -> bool:
        """False until a PIN was chosen."""
        return self._kept.get(_PIN) is not None

    def choose(self, pin: str) -> None:
        """Sets the PIN, and closes the door for everybody. Raises PinelError `pin_format`."""
        check_format(pin)
        salt = secrets.token_bytes(16)
        self._kept.set(_PIN, {**_COST, "salt": salt.hex(), "hash": _hash(pin, salt, _COST).hex()})
        self._kept.set(_TRIES, None)
        with self._lock:
            self._open.clear()

    def forget(self) -> None:
        """Takes the PIN away; the next start asks for another."""
        self._kept.set(_PIN, None)
        self._kept.set(_TRIES, None)

    def enter(self, pin: str) -> str:
        """Opens the door; returns the token that says so.

        Raises:
            PinelError: `pin_missing`; `pin_wrong`; `pin_wait` with the seconds that must pass before the next try.
            StoreError: the try cannot be counted, and so was none.
        """
        with self._lock:  # one guess at a time
            self._check_wait()
            self._check(pin)
            token = secrets.token_urlsafe(32)
            self._open[token] = (self._steady(), self._salt())
        return token

    def is_open(self, token: str | None) -> bool:
        """Whether the token still opens; using it keeps it good. Another PIN, by `pinel pin` too, shuts the door."""
        if token is None:
            return False
        salt = self._salt()
        with self._lock:
            now = (
                self._steady()
            )  # in here: of two who ask at once, neither may come before the other
            used, under = self._open.get(token, (-math.inf, ""))
            if under != salt or now - used > IDLE_S:
                self._open.pop(token, None)
                return False
            self._open[token] = (now, salt)
        return True

    def leave(self, token: str | None) -> None:
        """Closes the door behind a token."""
        with self._lock:
            self._open.pop(token or "", None)

    def _check(self, pin: str) -> None:
        kept = self._kept.get(_PIN)
        if kept is None:
            raise PinelError("pin_missing")
        # before the answer: on a full disk guesses would not be counted
        self._kept.set(_TRIES, {"failed": self._failed() + 1, "at": self._clock()})
        self._tried, self._since = True, self._steady()
        given = _hash(pin, bytes.fromhex(kept["salt"]), kept)
        if not hmac.compare_digest(given, bytes.fromhex(kept["hash"])):
            raise PinelError("pin_wrong")
        self._kept.set(_TRIES, None)

    def _check_wait(self) -> None:
        tries = self._kept.get(_TRIES)
        failed = self._failed()
        if not tries or failed < _FREE_TRIES:
            return
        wait_s = min(_FIRST_WAIT_S * 2 ** (failed - _FREE_TRIES), _LONGEST_WAIT_S)
        left_s = wait_s - self._passed_s(tries["at"])
        if left_s > 0:
            raise PinelError("pin_wait", failed=failed, seconds=int(left_s) + 1)

    def _passed_s(self, tried_at: float) -> float:
        """Since the last try. A clock that was set back keeps no teacher out for years, and spares nobody the wait:
        then it counts from the start of the app."""
        by_clock_s = self._clock() - tried_at
        return self._steady() - self._since if self._tried or by_clock_s < 0 else by_clock_s

    def _salt(self) -> str:
        """What tells one PIN from another, also from the same one chosen again."""
        return str((self._kept.get(_PIN) or {}).get("salt", ""))

    def _failed(self) -> int:
        return int((self._kept.get(_TRIES) or {}).get("failed", 0))


def check_format(pin: str) -> None:
    """Raises PinelError `pin_format`."""
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
