"""`pinel` without a subcommand: the app in its window; and `pinel --self-check`.

This process shows the window and holds the lock. The app runs in another process (desktop/app_process.py), which loads
while the window opens. Imports at the top of this file delay the start of that process. In kiosk mode, this process is
the watchdog (desktop/kiosk/watchdog.py), and the window is in another one (commands/owned/kiosk.py).
"""

import gc
import json
import os
import signal
import sys
import threading
from types import FrameType
from typing import TYPE_CHECKING

from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.desktop.ending import become, end_process
from pinel_desktop.errors import PinelError
from pinel_desktop.paths import database_path
from pinel_desktop.processes import own_command
from pinel_desktop.settings import Settings

if TYPE_CHECKING:
    from pinel_desktop.desktop.kiosk.mode import KioskMode, KioskReason
    from pinel_desktop.desktop.presenter import Presenter

# With the default threshold, garbage collection is a tenth of the toolkit's import, and useless.
_GC_THRESHOLD = 50_000
# exit status of a window that the teacher's switch has closed to open in the other mode
RESTARTS = 75
_ICON_ERROR = 0x10  # MB_ICONERROR


def open_app(db: str | None, *, kiosk: bool, place: str = "", file: str | None = None) -> int:
    """Shows the page until the person closes it; a second start brings the first window forward.

    Args:
        kiosk: opens in kiosk mode, also if the teacher has not chosen it on this PC.
        place: where the page opens in kiosk mode.
        file: a bundle, such as one that was double-clicked: the page opens where the teacher merges it.

    Returns the exit status: 0, or 1 if the app cannot start.
    """
    if file:
        # bytes that are no text would not pass the pipes and requests; the page names the file all the same
        file = os.fsencode(os.path.abspath(file)).decode("utf-8", "replace")
    if kiosk or Settings.beside(database_path(db)).opens_kiosk:
        status = _run_kiosk(db, "command" if kiosk else "setting", place, file)
    else:
        status = WindowProcess(db, file=file).run()
    if status == RESTARTS:
        become(pinel_command(db, kiosk=kiosk, file=file))
    end_process(status)
    return status


def _run_kiosk(db: str | None, reason: "KioskReason", place: str, file: str | None) -> int:
    from pinel_desktop.desktop.kiosk.watchdog import Watchdog  # noqa: PLC0415 - only in kiosk mode

    chosen = ["--db", db] if db else []
    opened = [f"--file={file}"] if file else []

    def command(place: str) -> list[str]:
        # only at first: after a crash, the page is where it was
        first, opened[:] = opened[:], []
        return own_command(*chosen, "kiosk", "--reason", reason, "--place", place, *first)

    watchdog = Watchdog(command, final=(0, RESTARTS), place=place)
    watchdog.end_at_signals()
    return watchdog.run()


def pinel_command(
    db: str | None, *, kiosk: bool, place: str = "", file: str | None = None
) -> list[str]:
    """Returns the command line that opens the window (see `open_app`)."""
    chosen = [*(["--db", db] if db else []), *(["--kiosk"] if kiosk else [])]
    opened = [f"--file={file}"] if file else []
    return own_command(*chosen, *(["--place", place] if place else []), *opened)


class WindowProcess:
    """The window with its app; `close` may be called on any thread."""

    def __init__(
        self, db: str | None, kiosk: "KioskMode | None" = None, file: str | None = None
    ) -> None:
        gc.set_threshold(_GC_THRESHOLD)
        self._database = database_path(db)
        self._kiosk = kiosk
        self._file = file
        self._presenter: Presenter | None = None
        self._is_closing = False
        self._restarts = False
        self._app = AppProcess(
            self._database,
            on_request=self._handle,
            on_lost=self.close,
            on_present=self._present,
            kiosk=kiosk.reason if kiosk else None,
            opened=file,
        )

    def run(self) -> int:
        """Shows the window until it is closed. Returns the exit status: 0, 1 if the app cannot start, or `RESTARTS`."""
        try:
            self._run()
        except PinelError as error:
            _report_failure(error)
            return 1
        finally:
            self._app.close()
        return RESTARTS if self._restarts else 0

    def close(self) -> None:
        """Closes the window, so that `run` returns."""
        self._is_closing = True
        if self._presenter is not None:
            self._presenter.close()

    def _handle(self, request: str) -> None:
        """Handles a request of the app."""
        match request:
            case "show" if self._presenter is not None:
                self._presenter.show()
            case "allow_print" if self._kiosk is not None:
                self._kiosk.print_permission.grant()
            case "close":
                self.close()
            case "restart":
                self._restarts = True
                self.close()

    def _present(self, address: str | None) -> bool:
        return self._presenter is not None and self._presenter.present(address)

    def _run(self) -> None:
        # while the other process is loading
        from pinel_desktop.commands.pc.first_start import locked  # noqa: PLC0415
        from pinel_desktop.desktop.presenter import Presenter  # noqa: PLC0415
        from pinel_desktop.instance import AlreadyRunningError  # noqa: PLC0415
        from pinel_desktop.processes.log_file import start_log  # noqa: PLC0415

        try:
            instance = locked(self._database)
        except AlreadyRunningError as first:
            if self._file:
                first.running.open(self._file)
            else:
                first.running.show()
            _print_message(first)
            _print(first.running.fresh_link())
            return
        try:
            if self._kiosk is None and Settings.beside(self._database).opens_kiosk:
                self._restarts = True  # the set-up file has just chosen it
                return
            self._app.start()
            start_log("window", self._database)
            self._presenter = Presenter(
                self._app.address,
                self._app.language,
                print_text=_print_error,
                give=_print,
                kiosk=self._kiosk,
            )
            self._end_at_signal()
            if not self._is_closing:
                self._presenter.run()
            if self._app.failure is not None:
                raise self._app.failure
        finally:
            self._app.close()
            instance.release()

    def _end_at_signal(self) -> None:
        """Closes the window at SIGINT or SIGTERM; native windows have their own handlers."""

        def end(number: int, frame: FrameType | None) -> None:
            self.close()

        if threading.current_thread() is threading.main_thread():
            for number in (signal.SIGINT, signal.SIGTERM):
                signal.signal(number, end)


def self_check(db: str | None) -> int:
    """Tests window, simulator and store, and prints one JSON object. Returns the exit status: 0 if all work."""
    from pinel_desktop.desktop.self_check import check  # noqa: PLC0415 - only the package's test needs it

    result = check(database_path(db) if db else None)
    _print(json.dumps(result, ensure_ascii=False, indent=2))
    status = 0 if result["ok"] else 1
    end_process(status)
    return status


def _report_failure(error: PinelError) -> None:
    """Prints why the app cannot start. The windowed program on Windows cannot print, and opens a message box."""
    if sys.platform == "win32" and sys.stderr is None:
        import ctypes  # noqa: PLC0415 - not needed if the window opens

        from pinel_desktop.desktop.presenter import TITLE  # noqa: PLC0415
        from pinel_desktop.messages import explain  # noqa: PLC0415

        ctypes.windll.user32.MessageBoxW(None, explain(error).line, TITLE, _ICON_ERROR)
    else:
        _print_message(error)


def _print_message(error: PinelError) -> None:
    from pinel_desktop.messages import explain  # noqa: PLC0415 - see _print

    _print_error(explain(error).line)


def _print_error(line: str) -> None:
    _print(line, err=True)


def _print(text: str, *, err: bool = False) -> None:
    import click  # noqa: PLC0415 - not needed if the window opens

    click.echo(text, err=err)
