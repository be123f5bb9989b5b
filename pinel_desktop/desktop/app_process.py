"""The window's client of the app process; commands/app.py describes the messages.

In one process, the toolkit's main loop and the web server would compete for the interpreter lock, mostly at the start.
"""

import contextlib
import json
import logging
import queue
import subprocess
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from pinel_desktop.desktop.kiosk.mode import KioskReason
from pinel_desktop.errors import PinelError
from pinel_desktop.processes import own_command
from pinel_desktop.processes.standard_streams import error_output

_START_S = 60.0
# the app may wait four seconds for the end of the engine
_CLOSE_S = 8.0
_EXIT_TIMEOUT_S = 1.0
_log = logging.getLogger(__name__)


class AppProcess:
    """Starts, serves and ends the app process; thread-safe.

    The constructor starts the process, which imports its modules at once but opens nothing before `start`.
    """

    def __init__(
        self,
        database: Path,
        on_request: Callable[[str], None],
        on_lost: Callable[[], None],
        camera: str | None = None,
        kiosk: KioskReason | None = None,
        opened: str | None = None,
        on_present: Callable[[str | None], bool] = lambda address: False,
    ) -> None:
        """
        Args:
            on_request: called with each request of the app to the window (`WindowRequest` in web/services.py).
            on_present: called with an address for a second screen, as `WindowLink.present`.
            on_lost: called when the app has died or could not start.
            camera: address of a camera instead of the chosen webcam, as for `camera.frames.open_reader`.
            kiosk: why the window is in kiosk mode; None if it is not.
            opened: path of the file with which a person has opened the app.
        """
        self._on_request = on_request
        self._on_present = on_present
        self._on_lost = on_lost
        self._responses: queue.Queue[str] = queue.Queue()
        self._asking = threading.Lock()
        self._has_asked = False
        self._ready = threading.Event()
        self._failure: PinelError | None = None
        self._language = ""
        self._closing = False
        self._process = subprocess.Popen(
            own_command(
                "app",
                *("--db", str(database)),
                *(("--camera", camera) if camera else ()),
                *(("--kiosk", kiosk) if kiosk else ()),
                *((f"--opened={opened}",) if opened else ()),
            ),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=error_output(),
            text=True,
            encoding="utf-8",
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
        self._reader = threading.Thread(target=self._read, name="app-reader", daemon=True)
        self._reader.start()

    def start(self) -> None:
        """Lets the app open the database; returns at once."""
        self._send({"do": "start"})

    @property
    def pid(self) -> int:
        """Id of the app's process."""
        return self._process.pid

    @property
    def failure(self) -> PinelError | None:
        """The error if the app could not start; `app_lost` if it died; else None."""
        return self._failure

    def language(self) -> str:
        """Waits until the app has started; returns the chosen language. Raises PinelError if the app does not start."""
        if not self._ready.wait(_START_S):
            raise PinelError("app_lost")
        if self._failure is not None:
            raise self._failure
        return self._language

    def address(self) -> str:
        """Returns a new address that opens the page once. Raises PinelError if the app does not start."""
        with self._asking:
            # the app sends the first address without a request, before it is ready
            if self._has_asked:
                self._send({"do": "address"})
            self._has_asked = True
            try:
                answer = self._responses.get(timeout=_START_S)
            except queue.Empty:
                answer = ""
        if self._failure is not None or not answer:
            raise self._failure or PinelError("app_lost")
        return answer

    def close(self) -> None:
        """Ends the app, which stops the robot and writes pending data, and waits for its process."""
        self._closing = True
        assert self._process.stdin is not None
        with contextlib.suppress(OSError):  # the process may have ended already
            self._process.stdin.close()
        try:
            self._process.wait(_CLOSE_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join()

    def _send(self, message: dict[str, object]) -> None:
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(json.dumps(message) + "\n")
            self._process.stdin.flush()
        except (OSError, ValueError):
            pass  # the reader reports the end of the process

    def _read(self) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as lines:
            for line in lines:
                self._handle(json.loads(line))
        if not self._closing:
            self._log_end()
            self._failure = self._failure or PinelError("app_lost")
            self._ready.set()
            self._responses.put("")
            self._on_lost()

    def _log_end(self) -> None:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_EXIT_TIMEOUT_S)
        _log.error("the app died with status %s", self._process.returncode)

    def _handle(self, message: dict[str, Any]) -> None:
        match message["type"]:
            case "ready":
                self._language = message["language"]
                self._ready.set()
            case "address":
                self._responses.put(message["address"])
            case "window" if message["do"] == "present":
                self._send({"do": "confirm", "done": self._on_present(message["address"])})
            case "window":
                self._on_request(message["do"])
                self._send({"do": "confirm", "done": True})
            case "failed":
                self._failure = PinelError(message["code"], **message["params"])
