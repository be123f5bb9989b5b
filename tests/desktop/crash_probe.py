"""Opens the app in its real window, kills the page's process, and prints the page's place before and after.

python crash_probe.py DATABASE
"""

import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import psutil

from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.window import NativeWindow

_WITHIN_S = 60.0
_HEADING = "document.querySelector('h1')?.textContent ?? ''"


class Probe:
    """The app, its window, and what was found."""

    def __init__(self, database: Path) -> None:
        self.found: dict[str, Any] = {}
        self.app = AppProcess(database, lambda request: None, self._close)
        self.app.start()
        self.window = NativeWindow(
            self.app.address, "PINEL Desktop", self.app.language, on_open=self._try_everything
        )

    def _close(self) -> None:
        self.window.close()

    def _try_everything(self) -> None:
        try:
            self._until(lambda: self._script(_HEADING) != "")
            self._script("location.hash = '#/teacher'")
            self._until(lambda: self._script("!!document.querySelector('[data-testid=pin]')"))
            self.found["before"] = [self._script("location.hash"), self._script(_HEADING)]
            (killed,) = self._page_processes()
            psutil.Process(killed).kill()
            # a script would wait for ever for the dead process
            self._until(lambda: bool(self._page_processes() - {killed}))
            self._until(lambda: self._script("!!document.querySelector('[data-testid=pin]')"))
            self.found["after"] = [self._script("location.hash"), self._script(_HEADING)]
        except Exception as error:
            self.found["error"] = repr(error)
        self.window.close()

    def _script(self, script: str) -> Any:
        return self.window.run_script(script)

    def _page_processes(self) -> set[int]:
        found = psutil.Process().children(recursive=True)
        return {process.pid for process in found if process.name() == "WebKitWebProcess"}

    def _until(self, is_done: Callable[[], bool]) -> None:
        deadline = time.monotonic() + _WITHIN_S
        while not is_done():
            if time.monotonic() > deadline:
                raise TimeoutError(self.found)
            time.sleep(0.1)

    def run(self) -> None:
        self.window.run("gtk")
        self.app.close()
        print(json.dumps(self.found), flush=True)


if __name__ == "__main__":
    Probe(Path(sys.argv[1])).run()
    end_process(0)
