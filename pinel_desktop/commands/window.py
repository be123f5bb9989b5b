"""`pinel` without a subcommand: the app in its window; and `pinel --self-check`.

This process shows the window and holds the lock. The app runs in another process (desktop/app_process.py), which loads
while the window opens. Imports at the top of this file delay the start of that process.
"""

import gc
import json
import signal
import sys
import threading
from types import FrameType
from typing import TYPE_CHECKING

from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.errors import PinelError
from pinel_desktop.paths import database_path

if TYPE_CHECKING:
    from pinel_desktop.desktop.presenter import Presenter

# With the default threshold, garbage collection is a tenth of the toolkit's import, and useless.
_GC_THRESHOLD = 50_000
_ICON_ERROR = 0x10  # MB_ICONERROR


def open_app(db: str | None) -> int:
    """Shows the page until the person closes it; a second start brings the first window forward.

    Returns the exit status: 0, or 1 if the app cannot start.
    """
    gc.set_threshold(_GC_THRESHOLD)
    presenters: list[Presenter] = []
    app = AppProcess(
        database_path(db),
        on_show=lambda: presenters[0].show() if presenters else None,
        on_lost=lambda: presenters[0].close() if presenters else None,
    )
    # while the other process is loading
    from pinel_desktop.desktop.ending import end_process  # noqa: PLC0415

    try:
        status = _open(app, db, presenters)
    except PinelError as error:
        _report_failure(error)
        status = 1
    finally:
        app.close()
    end_process(status)
    return status


def _open(app: AppProcess, db: str | None, presenters: "list[Presenter]") -> int:
    # while the other process is loading
    from pinel_desktop.commands.pc.first_start import set_up_if_new  # noqa: PLC0415
    from pinel_desktop.desktop.presenter import Presenter  # noqa: PLC0415
    from pinel_desktop.instance import AlreadyRunningError, InstanceLock  # noqa: PLC0415

    instance = InstanceLock(database_path(db))
    try:
        instance.acquire()
    except AlreadyRunningError as first:
        first.running.show()
        _print_message(first)
        _print(first.running.fresh_link())
        return 0
    try:
        set_up_if_new(database_path(db))
        app.start()
        presenter = Presenter(app.address, app.language, print_text=_print_error, give=_print)
        presenters.append(presenter)
        _end_at_signal(presenter)
        presenter.run()
        if app.failure is not None:
            raise app.failure
    finally:
        app.close()
        instance.release()
    return 0


def self_check(db: str | None) -> int:
    """Tests window, simulator and store, and prints one JSON object. Returns the exit status: 0 if all work."""
    from pinel_desktop.desktop.ending import end_process  # noqa: PLC0415
    from pinel_desktop.desktop.self_check import check  # noqa: PLC0415 - only the package's test needs it

    result = check(database_path(db) if db else None)
    _print(json.dumps(result, ensure_ascii=False, indent=2))
    status = 0 if result["ok"] else 1
    end_process(status)
    return status


def _end_at_signal(presenter: "Presenter") -> None:
    """Closes the presenter at SIGINT or SIGTERM; native windows have their own handlers."""

    def end(number: int, frame: FrameType | None) -> None:
        presenter.close()

    if threading.current_thread() is threading.main_thread():
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, end)


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
