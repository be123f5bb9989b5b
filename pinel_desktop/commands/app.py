"""`pinel app`: web server, store and engine behind a window. Started by the window's process, not by people.

JSON lines over pipes. The window says `{"do": "start"}` once it has the lock on the database; it gets one address at
once, and more for `{"do": "address"}`. The app says `{"type": "address", "address": ...}`,
`{"type": "ready", "language": ...}` when everything works, `{"type": "show"}` when a second start wants the window
forward, or `{"type": "failed", "code": ..., "params": ...}`. It ends when its input does.
"""

import contextlib
import gc
import json
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

import click

from pinel_desktop.commands.printing import print_problem
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import Instance
from pinel_desktop.paths import database_path
from pinel_desktop.web.early_server import EarlyServer

if TYPE_CHECKING:
    from pinel_desktop.app import App

Message = dict[str, Any]

_ENGINE_AFTER_S = 1.0


@click.command(hidden=True)
@click.option("--db", type=click.Path(dir_okay=False), required=True)
def command(db: str) -> None:
    """Run the app for a window: messages on standard input and output."""
    # Ctrl+C in a terminal reaches the whole group; the window decides when the app goes, by ending its pipe.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The end of a person's session reaches everybody at once: put everything in order, as at the end of the pipe.
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit())
    # What a library prints by accident must not land among the messages.
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    with answers:
        _serve(db, _messages(sys.stdin), _sender(answers))


def _serve(db: str, messages: Iterator[Message], send: Callable[..., None]) -> None:
    if next(messages, None) != {"do": "start"}:
        return
    # the page first: the window loads it while the rest is being imported
    with _loading():
        server = EarlyServer()
        send(type="address", address=server.guard.fresh_link())
        app = _started(database_path(db), server, send)
    if app is not None:
        _answer(app, messages, send)


@contextlib.contextmanager
def _loading() -> Iterator[None]:
    """Importing gives up the interpreter ten times as often, for the server's threads, and collects no garbage.

    What is imported stays: collecting among it takes a tenth of the start and finds nothing, then or later.
    """
    usual_s = sys.getswitchinterval()
    sys.setswitchinterval(usual_s / 10)
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
        sys.setswitchinterval(usual_s)


def _started(database: Path, server: EarlyServer, send: Callable[..., None]) -> "App | None":
    from pinel_desktop.app import App  # noqa: PLC0415 - see above

    app = App(
        database,
        early_server=server,
        instance=Instance.of_parent(database),
        engine_after_s=_ENGINE_AFTER_S,
        on_show=lambda: send(type="show"),
    )
    try:
        app.start()
    except PinelError as error:
        server.close()
        send(type="failed", code=error.code, params=error.params)
        return None
    return app


def _answer(app: "App", messages: Iterator[Message], send: Callable[..., None]) -> None:
    with contextlib.closing(app):
        _tell_notice(app)
        send(type="ready", language=app.language)
        for message in messages:
            if message == {"do": "address"}:
                send(type="address", address=app.address)


def _tell_notice(app: "App") -> None:
    if app.notice is not None:
        print_problem(app.notice, app.language)


def _messages(lines: TextIO) -> Iterator[Message]:
    for line in lines:
        yield json.loads(line)


def _sender(answers: TextIO) -> Callable[..., None]:
    lock = threading.Lock()  # `show` comes on a thread of the server

    def send(**message: Any) -> None:
        with lock:
            try:
                answers.write(json.dumps(message, ensure_ascii=False, default=str) + "\n")
                answers.flush()
            except OSError:
                pass  # the window's process is gone; the end of the input says so

    return send
