"""The program as `pinel` starts it, opened at a program; prints when its workspace is drawn, and an address of its app.

python window_app.py PROGRAM_ID, with the folder of the database as PINEL_HOME. It closes at the end of its input. Its
camera shows recorded signs.
"""

import sys
import time
from pathlib import Path
from typing import Any

import pinel_desktop
from pinel_desktop.__main__ import main
from pinel_desktop.commands import window as command
from pinel_desktop.desktop.app_process import AppProcess

RECORDED_SIGNS = Path(pinel_desktop.__file__).parent / "camera" / "recordings" / "b_a.npz"
PROGRAM = sys.argv.pop()  # what is left is how the icon starts it


def started(*args: Any, **options: Any) -> AppProcess:
    """Starts the app's process; the imports of the measurement follow its start, as in the program itself."""
    process = AppProcess(*args, **options | {"camera": str(RECORDED_SIGNS)})
    from pinel_desktop.desktop import presenter  # noqa: PLC0415

    class WatchedPresenter(presenter.Presenter):
        """Opens the program instead of the start screen, and watches the page."""

        def __init__(self, fresh_address: Any, language: Any, **options: Any) -> None:
            super().__init__(
                lambda: f"{fresh_address()}#/program/{PROGRAM}",
                language,
                on_open=self._watch,
                **options,
            )

        def _watch(self) -> None:
            window: Any = self._window
            while window.run_script(presenter.USABLE) is not True:
                time.sleep(0.01)
            print(time.monotonic(), flush=True)
            print(process.address(), flush=True)
            sys.stdin.read()
            self.close()

    # assigned directly: importing mock would take a tenth of the start
    presenter.Presenter = WatchedPresenter  # type: ignore[misc]
    return process


command.AppProcess = started  # type: ignore[assignment, attr-defined]
main()
