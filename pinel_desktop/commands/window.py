"""`pinel` without a subcommand: the app in its window; and `pinel --self-check`."""

import json
import signal
import threading
from types import FrameType

import click

from pinel_desktop.app import App
from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.presenter import Presenter
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import AlreadyRunningError
from pinel_desktop.messages import describe, language_of_system
from pinel_desktop.paths import database_path


def open_app(db: str | None) -> int:
    """Shows the page until the person closes it; a second start brings the first window forward.

    Returns the exit status: 0, or 1 when the app cannot start.
    """
    try:
        _present(db)
    except AlreadyRunningError as first:
        return _bring_forward(first)
    except PinelError as error:
        _say(error.code, error.params, language_of_system())
        return 1
    end_process(0)
    return 0


def self_check(db: str | None) -> int:
    """Tries window, simulator and store once and prints one JSON object; the exit status is 0 when all is well."""
    from pinel_desktop.desktop.self_check import check  # noqa: PLC0415 - only the package's test needs it

    result = check(database_path(db) if db else None)
    click.echo(json.dumps(result, ensure_ascii=False, indent=2))
    status = 0 if result["ok"] else 1
    end_process(status)
    return status


def _present(db: str | None) -> None:
    presenters: list[Presenter] = []
    app = App(database_path(db), on_show=lambda: presenters[0].show() if presenters else None)
    with app:
        if app.notice is not None:
            _say(app.notice.code, app.notice.params, app.language)
        presenter = Presenter(lambda: app.address, app.language, say=_say_line, give=click.echo)
        presenters.append(presenter)
        _end_at_signal(presenter)
        presenter.run()


def _end_at_signal(presenter: Presenter) -> None:
    """For the ways without a toolkit of their own; a native window hears the signals itself."""

    def end(number: int, frame: FrameType | None) -> None:
        presenter.close()

    if threading.current_thread() is threading.main_thread():
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, end)


def _bring_forward(first: AlreadyRunningError) -> int:
    try:
        first.running.show()
        _say(first.code, first.params, language_of_system())
        click.echo(first.running.fresh_link())
    except PinelError as error:
        _say(error.code, error.params, language_of_system())
        return 1
    return 0


def _say(code: str, params: dict[str, object], language: str) -> None:
    words = describe(code, params, language)
    _say_line(f"{words.message} {words.remedy}".strip())


def _say_line(line: str) -> None:
    click.echo(line, err=True)
