"""Keeps PINEL open in kiosk mode: starts the process of the window again, at its place, whenever it ends by itself.

The watchdog and the window (commands/owned/kiosk.py) watch each other: the window's input is a pipe that ends with the
watchdog. The window then closes in order, and its process becomes the watchdog.
"""

import contextlib
import json
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Collection
from types import FrameType

# a window that never opened may not open at the next try either
_MAX_FAILURES = 5
_LONG_S = 10.0


class Watchdog:
    """Runs the window's process again and again, until the teacher or a signal ends it.

    Args:
        command: returns the command line of the window's process for a place of the page.
        final: exit statuses after which the window stays closed.
        place: where the page opens first.
    """

    def __init__(
        self, command: Callable[[str], list[str]], final: Collection[int], place: str = ""
    ) -> None:
        self._command = command
        self._final = final
        self._place = place
        self._window: subprocess.Popen[str] | None = None
        self._ending = threading.Event()

    def run(self) -> int:
        """Returns a final exit status, or another one if no window could be opened."""
        failures = 0
        while True:
            started_s = time.monotonic()
            status, has_opened = self._run_window()
            if self._ending.is_set():
                return 0
            failures = 0 if has_opened else failures + 1
            if status in self._final or failures == _MAX_FAILURES:
                return status
            if time.monotonic() - started_s < _LONG_S:
                self._ending.wait(2.0**failures - 1)

    def end(self) -> None:
        """Ends the window in order, so that `run` returns; safe in a signal handler."""
        self._ending.set()
        if self._window is not None:
            with contextlib.suppress(OSError):
                self._window.terminate()

    def end_at_signals(self) -> None:
        """Calls `end` at the signals by which the desktop's session or a terminal ends a program."""

        def handle(number: int, frame: FrameType | None) -> None:
            self.end()

        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, handle)

    def _run_window(self) -> tuple[int, bool]:
        """Returns the window's exit status, and whether it opened."""
        has_opened = False
        with subprocess.Popen(
            self._command(self._place),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            encoding="utf-8",
        ) as self._window:
            if self._ending.is_set():
                self.end()
            assert self._window.stdout is not None
            for line in self._window.stdout:
                self._place = json.loads(line)["place"]
                has_opened = True
        return self._window.returncode, has_opened
