"""Shows the page in a browser in app mode: without tabs and address bar, with a profile of its own."""

import contextlib
import os
import shutil
import subprocess
import tempfile
import threading
from collections.abc import Callable

from pinel_desktop.desktop.backends import NoWindowError, Pc, find_browser
from pinel_desktop.errors import PinelError

# a browser that fails sooner has not shown a window
_SHORT_LIFE_S = 5.0


def app_command(program: str, address: str, profile: str, *, as_root: bool) -> list[str]:
    """Returns the command line that shows `address` in app mode, without network use of the browser itself."""
    command = [
        program,
        f"--app={address}",
        f"--user-data-dir={profile}",
        "--no-first-run",
        "--no-default-browser-check",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--disable-translate",
        "--start-maximized",
    ]
    return [*command, "--no-sandbox"] if as_root else command


class BrowserWindow:
    """A browser window in app mode."""

    def __init__(self, fresh_address: Callable[[], str], pc: Pc | None = None) -> None:
        self._fresh_address = fresh_address
        self._pc = pc or Pc()
        self._process: subprocess.Popen[bytes] | None = None
        self._closed = threading.Event()
        self._command: Callable[[], list[str]] | None = None

    def run(self) -> None:
        """Shows the window until it is closed. Raises NoWindowError `window_browser_missing` or `window_failed`."""
        program = find_browser(self._pc)
        if program is None:
            raise NoWindowError("window_browser_missing")
        profile = tempfile.mkdtemp(prefix="pinel-browser-")
        self._command = lambda: app_command(
            program, self._fresh_address(), profile, as_root=_is_root()
        )
        try:
            self._run(self._command())
        finally:
            shutil.rmtree(profile, ignore_errors=True)

    def close(self) -> None:
        """Ends the browser, so that `run` returns."""
        self._closed.set()
        if self._process is not None:
            self._process.terminate()

    def present(self, address: str | None) -> bool:
        """Returns False: a browser cannot be told on which screen to open a window."""
        return False

    def show(self) -> None:
        """Opens another window, because the browser's existing one cannot be brought forward from outside.

        Returns at once: a new address comes on the thread that calls this.
        """
        threading.Thread(target=self._open_another, name="browser-window", daemon=True).start()

    def _open_another(self) -> None:
        with contextlib.suppress(PinelError, OSError, subprocess.TimeoutExpired):
            if self._command is not None:
                subprocess.run(
                    self._command(),
                    stdin=subprocess.DEVNULL,
                    capture_output=True,
                    check=False,
                    timeout=10,
                )

    def _run(self, command: list[str]) -> None:
        with subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        ) as self._process:
            if self._closed.is_set():  # `close` was called before there was a process to end
                self._process.terminate()
            try:
                status = self._process.wait(_SHORT_LIFE_S)
            except subprocess.TimeoutExpired:
                self._process.wait()
                return
        if status != 0 and not self._closed.is_set():
            raise NoWindowError("window_failed", backend=command[0], reason=f"status {status}")


def _is_root() -> bool:
    return hasattr(os, "geteuid") and os.geteuid() == 0
