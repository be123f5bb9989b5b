"""`pinel` without a subcommand: the app in its window; and `pinel --self-check`.

The window and the app start side by side: the toolkit needs as long to draw an empty window as Python does to
import the web server. Nothing heavy may be imported at the top of this file.
"""

import json
import signal
import threading
from concurrent.futures import Future
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

import click

from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.presenter import Presenter
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import AlreadyRunningError, Instance
from pinel_desktop.messages import describe, language_of_system
from pinel_desktop.paths import database_path

if TYPE_CHECKING:
    from pinel_desktop.app import App


def open_app(db: str | None) -> int:
    """Shows the page until the person closes it; a second start brings the first window forward.

    Returns the exit status: 0, or 1 when the app cannot start.
    """
    database = database_path(db)
    instance = Instance(database)
    try:
        # before anything else, so that a second start is quick and shows no window of its own
        instance.acquire()
        _present(database, instance)
    except AlreadyRunningError as first:
        return _bring_forward(first)
    except PinelError as error:
        _say(error.code, error.params, language_of_system())
        end_process(1)
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


def _present(database: Path, instance: Instance) -> None:
    """Shows the window at once, the page in it as soon as the app answers."""
    starting: Future[App] = Future()
    presenter = Presenter(
        lambda: starting.result().address,
        lambda: starting.result().language,
        say=_say_line,
        give=click.echo,
    )
    _end_at_signal(presenter)
    starter = threading.Thread(
        target=_start, args=(starting, database, instance, presenter), name="start"
    )
    starter.start()
    try:
        presenter.run()
    finally:
        starter.join()
        if starting.exception() is None:
            starting.result().close()


def _start(
    starting: "Future[App]", database: Path, instance: Instance, presenter: Presenter
) -> None:
    try:
        from pinel_desktop.app import App  # noqa: PLC0415 - see above

        app = App(database, instance=instance, on_show=presenter.show)
        app.start()
    except BaseException as failure:  # whatever it is, the main thread waits for it
        starting.set_exception(failure)
        return
    if app.notice is not None:
        _say(app.notice.code, app.notice.params, app.language)
    starting.set_result(app)


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
