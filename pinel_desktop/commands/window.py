"""`pinel` without a subcommand: the app in its window; and `pinel --self-check`.

This process shows the window and owns the lock; the app runs in another (desktop/backstage.py) and loads while
the window is drawn. Nothing heavy may be imported at the top of this file.
"""

import gc
import json
import signal
import threading
from types import FrameType

from pinel_desktop.desktop.backstage import Backstage
from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.presenter import Presenter
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, language_of_system
from pinel_desktop.paths import database_path

# The toolkit and its libraries stay: looking for garbage among them all the while takes a tenth of their import.
_OBJECTS_BETWEEN_COLLECTIONS = 50_000


def open_app(db: str | None) -> int:
    """Shows the page until the person closes it; a second start brings the first window forward.

    Returns the exit status: 0, or 1 when the app cannot start.
    """
    gc.set_threshold(_OBJECTS_BETWEEN_COLLECTIONS)
    presenters: list[Presenter] = []
    backstage = Backstage(
        database_path(db),
        on_show=lambda: presenters[0].show() if presenters else None,
        on_lost=lambda: presenters[0].close() if presenters else None,
    )
    try:
        status = _open(backstage, db, presenters)
    except PinelError as error:
        _say(error.code, error.params, language_of_system())
        status = 1
    finally:
        backstage.close()
    end_process(status)
    return status


def _open(backstage: Backstage, db: str | None, presenters: list[Presenter]) -> int:
    # while the other process is loading
    from pinel_desktop.instance import AlreadyRunningError, Instance  # noqa: PLC0415

    instance = Instance(database_path(db))
    try:
        instance.acquire()
    except AlreadyRunningError as first:
        first.running.show()
        _say(first.code, first.params, language_of_system())
        _print(first.running.fresh_link())
        return 0
    try:
        backstage.start()
        presenter = Presenter(backstage.address, backstage.language, say=_say_line, give=_print)
        presenters.append(presenter)
        _end_at_signal(presenter)
        presenter.run()
        if backstage.failure is not None:
            raise backstage.failure
    finally:
        backstage.close()
        instance.release()
    return 0


def self_check(db: str | None) -> int:
    """Tries window, simulator and store once and prints one JSON object; the exit status is 0 when all is well."""
    from pinel_desktop.desktop.self_check import check  # noqa: PLC0415 - only the package's test needs it

    result = check(database_path(db) if db else None)
    _print(json.dumps(result, ensure_ascii=False, indent=2))
    status = 0 if result["ok"] else 1
    end_process(status)
    return status


def _end_at_signal(presenter: Presenter) -> None:
    """For the ways without a toolkit of their own; a native window hears the signals itself."""

    def end(number: int, frame: FrameType | None) -> None:
        presenter.close()

    if threading.current_thread() is threading.main_thread():
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, end)


def _say(code: str, params: dict[str, object], language: str) -> None:
    words = describe(code, params, language)
    _say_line(f"{words.message} {words.remedy}".strip())


def _say_line(line: str) -> None:
    _print(line, err=True)


def _print(text: str, *, err: bool = False) -> None:
    import click  # noqa: PLC0415 - a window that opens has nothing to say

    click.echo(text, err=err)
