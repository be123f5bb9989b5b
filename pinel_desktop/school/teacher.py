"""The teacher's PIN and sessions: a PIN gives access to review and settings for a limited time.

The PIN is stored as a salted scrypt hash. Because a PIN is short, `pin_rate_limiter.py` limits the attempts. `pinel
pin` replaces a forgotten PIN. It needs write access to the database file; anybody with that access needs no PIN.
"""

import hashlib
import hmac
import math
import secrets
import threading
import time
from collections.abc import Callable, Mapping
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.school.pin_rate_limiter import PinRateLimiter, Settings

MIN_DIGITS, MAX_DIGITS = 4, 12
IDLE_S = 30 * 60.0  # an unused session ends after this time
_PIN = "teacher_pin"
_COST = {"n": 2**14, "r": 8, "p": 1}  # 16 MiB and some 50 ms for each attempt
_HASH_PARTS = (*_COST, "salt", "hash")


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
        self._settings, self._steady = settings, steady
        self._tries = PinRateLimiter(settings, clock, steady)
        self._sessions: dict[str, tuple[float, str]] = {}  # token -> (last use, salt of the PIN)
        self._lock = threading.Lock()

    @property
    def has_pin(self) -> bool:
        """False until a PIN is set."""
        return self._stored_pin() is not None

    def set_pin(self, pin: str) -> None:
        """Sets the PIN and ends all sessions. Raises PinelError `pin_format`."""
        self.set_stored_pin(_stored(pin))

    def set_stored_pin(self, stored: Mapping[str, Any]) -> None:
        """Sets the PIN by its stored form (`stored_pin`), which does not tell the PIN, and ends all sessions."""
        self._settings.set(_PIN, dict(stored))
        with self._lock:
            self._tries.forget()
            self._sessions.clear()

    def remove_pin(self) -> None:
        """Removes the PIN; the page then asks for a new one."""
        self._settings.set(_PIN, None)
        with self._lock:
            self._tries.forget()

    def sign_in(self, pin: str, browser: str = "") -> str:
        """Opens a session and returns its token.

        Args:
            browser: identifies the browser session in which the PIN is tried.

        Raises:
            PinelError: `pin_missing`, `pin_wrong`, or `pin_wait` with the seconds until the next attempt.
        """
        with self._lock:  # one attempt at a time
            self._tries.check(browser)
            self._check(pin, browser)
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

    def _check(self, pin: str, browser: str) -> None:
        stored = self._stored_pin()
        if stored is None:
            raise PinelError("pin_missing")
        self._tries.count(browser)
        given = _hash(pin, bytes.fromhex(stored["salt"]), stored)
        if not hmac.compare_digest(given, bytes.fromhex(stored["hash"])):
            raise PinelError("pin_wrong")
        self._tries.forget()

    def _salt(self) -> str:
        """Identifies the current PIN; differs even if the same digits are set again."""
        return str((self._stored_pin() or {}).get("salt", ""))

    def _stored_pin(self) -> dict[str, Any] | None:
        """Returns the stored hash of the PIN; None without a PIN, or if the stored value is damaged."""
        stored = self._settings.get(_PIN)
        return stored if _is_whole(stored) else None


def pin_hash(pin: str) -> str:
    """Returns a text for a set-up file (`pc_setup.py`) that does not tell the PIN. Raises PinelError `pin_format`."""
    stored = _stored(pin)
    return ":".join(["scrypt", *(str(stored[part]) for part in _HASH_PARTS)])


def stored_pin(text: object) -> Mapping[str, Any] | None:
    """Returns the stored form of a PIN from the text of `pin_hash`; None for another text."""
    kind, *parts = str(text).split(":")
    if kind != "scrypt" or len(parts) != len(_HASH_PARTS):
        return None
    stored: dict[str, Any] = dict(zip(_HASH_PARTS, parts, strict=True))
    for part, cost in _COST.items():
        if stored[part] != str(
            cost
        ):  # another cost could block the sign-in, or make guessing cheap
            return None
        stored[part] = cost
    return stored if _is_whole(stored) else None


def _stored(pin: str) -> dict[str, Any]:
    check_format(pin)
    salt = secrets.token_bytes(16)
    return {**_COST, "salt": salt.hex(), "hash": _hash(pin, salt, _COST).hex()}


def check_format(pin: str) -> None:
    """Raises PinelError `pin_format` unless the PIN has 4 to 12 ASCII digits."""
    if not (pin.isascii() and pin.isdecimal() and MIN_DIGITS <= len(pin) <= MAX_DIGITS):
        raise PinelError("pin_format", min=MIN_DIGITS, max=MAX_DIGITS)


def _is_whole(stored: Any) -> bool:
    try:
        return all(bytes.fromhex(stored[part]) for part in ("salt", "hash")) and all(
            isinstance(stored[part], int) for part in _COST
        )
    except (TypeError, KeyError, ValueError):
        return False


def _hash(pin: str, salt: bytes, cost: Any) -> bytes:
    return hashlib.scrypt(
        pin.encode("utf-8", "ignore")[:100],
        salt=salt,
        n=cost["n"],
        r=cost["r"],
        p=cost["p"],
        maxmem=2**26,
    )
