"""Somebody who tries PINs, on a simulated clock."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.school.pin_rate_limiter import Settings
from pinel_desktop.school.teacher import TeacherSessions
from storage import StoreError

PIN, WRONG = "3141", "0000"


class Pins:
    """A PC with a PIN; `clock` is both the wall clock and the monotonic one."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.now_s = 1_800_000_000.0
        self.sessions = TeacherSessions(settings, self.clock, self.clock)

    def clock(self) -> float:
        return self.now_s

    def guess(self, browser: str, after_s: float = 0.0) -> bool:
        """True when the wrong PIN was compared, False when it had to wait."""
        self.now_s += after_s
        try:
            self.sessions.sign_in(WRONG, browser)
        except PinelError as refused:
            return refused.code == "pin_wrong"
        raise AssertionError("a wrong PIN opened")


@contextmanager
def open_pins_again(pins: Pins) -> Iterator[Pins]:
    """The same PC after a restart of the app."""
    pins.sessions = TeacherSessions(pins.settings, pins.clock, pins.clock)
    yield pins


class FullDisk:
    """Settings on a full disk: readable, not writable."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings

    def get(self, key: str) -> Any:
        return self._settings.get(key)

    def set(self, key: str, value: object) -> None:
        raise StoreError("disk_full")
