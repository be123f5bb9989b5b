"""`pinel app`: the process with web server, store and engine client, started by the window's process.

Both exchange JSON lines over pipes. The window sends `{"do": "start"}` once it has the lock on the database, and
`{"do": "address"}` for each further address; `--kiosk` says why it is in kiosk mode, `--opened` with which file a
person has opened PINEL. The app sends:

- `{"type": "address", "address": ...}`, the first one without a request;
- `{"type": "ready", "language": ...}` when it has started;
- `{"type": "window", "do": ...}`, a request to the window (`WindowRequest` in web/services.py, or "present" with an
  `address` or null), which replies with `{"do": "confirm", "done": ...}`;
- `{"type": "failed", "code": ..., "params": ...}` if it cannot start.

The app exits at the end of its input.
"""

import contextlib
import functools
import gc
import json
import logging
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, TextIO

import click

from pinel_desktop.commands.printing import print_problem
from pinel_desktop.desktop.kiosk.mode import KioskReason
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import InstanceLock
from pinel_desktop.processes.log_file import start_log
from pinel_desktop.processes.standard_streams import reserve_output
from pinel_desktop.settings import Settings
from pinel_desktop.web.early_server import EarlyServer
from pinel_desktop.web.services import WindowRequest

if TYPE_CHECKING:
    from pinel_desktop.app import App

Message = dict[str, Any]

_ENGINE_AFTER_S = 10.0
_CONFIRM_S = 2.0
_log = logging.getLogger(__name__)


@click.command(hidden=True)
@click.option("--db", type=click.Path(dir_okay=False), required=True)
@click.option("--camera")
@click.option("--kiosk", type=click.Choice(["setting", "command"]))
@click.option("--opened")
def command(db: str, camera: str | None, kiosk: KioskReason | None, opened: str | None) -> None:
    """Run the app for a window: messages on standard input and output."""
    # Ctrl+C in a terminal reaches the whole process group; the window ends the app by its pipe.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The end of the desktop session sends SIGTERM to all processes: exit as at the end of the pipe.
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit())
    with os.fdopen(reserve_output(), "w", encoding="utf-8") as answers:
        send = _sender(answers)
        start = functools.partial(_started, Path(db), camera=camera, opened=opened)
        _serve(Path(db), start, _Window(send, kiosk), _messages(sys.stdin.buffer), send)


class _Window:
    """The window at the other end of the pipes."""

    def __init__(self, send: Callable[..., None], kiosk: KioskReason | None) -> None:
        self._send = send
        self.kiosk: KioskReason | None = kiosk
        self._asking = threading.Lock()
        self._confirmed = threading.Event()
        self._done = False

    def ask(self, request: WindowRequest) -> None:
        """Sends a request, and waits until the window has handled it, or for a moment."""
        self._request(do=request)

    def present(self, address: str | None) -> bool:
        """Asks to show an address on a second screen, as `WindowLink.present`."""
        return self._request(do="present", address=address)

    def confirm(self, *, done: bool) -> None:
        """Called when the window has handled a request."""
        self._done = done
        self._confirmed.set()

    def _request(self, **message: str | None) -> bool:
        with self._asking:
            self._done = False
            self._confirmed.clear()
            self._send(type="window", **message)
            self._confirmed.wait(_CONFIRM_S)
            return self._done


def _serve(
    database: Path,
    start: Callable[..., "App | None"],
    window: _Window,
    messages: Iterator[Message],
    send: Callable[..., None],
) -> None:
    if next(messages, None) != {"do": "start"}:
        return
    # server first, so that the window loads the page during the other imports
    with _loading():
        start_log("app", database)
        server = EarlyServer(settings=Settings.beside(database), is_kiosk=window.kiosk is not None)
        send(type="address", address=server.guard.fresh_link())
        app = start(window, server, send)
    if app is not None:
        _serve_requests(app, window, messages, send)


@contextlib.contextmanager
def _loading() -> Iterator[None]:
    """Speeds up the imports: shorter switch interval for the server's threads, no garbage collection.

    Imported objects are permanent; collecting them takes a tenth of the start and frees nothing, so they are frozen.
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


def _started(
    database: Path,
    window: _Window,
    server: EarlyServer,
    send: Callable[..., None],
    *,
    camera: str | None,
    opened: str | None,
) -> "App | None":
    from pinel_desktop.app import App  # noqa: PLC0415 - see above

    app = App(
        database,
        early_server=server,
        instance=InstanceLock.of_parent(database),
        engine_after_s=_ENGINE_AFTER_S,
        window=window,
        camera=camera,
        opened=opened,
    )
    try:
        app.start()
    except PinelError as error:
        server.close()
        _log.error("the app cannot start: %s", error)
        send(type="failed", code=error.code, params=error.params)
        return None
    return app


def _serve_requests(
    app: "App", window: _Window, messages: Iterator[Message], send: Callable[..., None]
) -> None:
    with contextlib.closing(app):
        _print_notice(app)
        send(type="ready", language=app.language)
        for message in messages:
            if message == {"do": "address"}:
                send(type="address", address=app.address)
            elif message["do"] == "confirm":
                window.confirm(done=message["done"])


def _print_notice(app: "App") -> None:
    if app.notice is not None:
        print_problem(app.notice, app.language)


def _messages(lines: BinaryIO) -> Iterator[Message]:
    for line in lines:
        yield json.loads(line)


def _sender(answers: TextIO) -> Callable[..., None]:
    lock = threading.Lock()  # `show` is sent by a thread of the server

    def send(**message: Any) -> None:
        with lock:
            try:
                answers.write(json.dumps(message, ensure_ascii=False, default=str) + "\n")
                answers.flush()
            except OSError:
                pass  # the window's process has ended, so the input ends too

    return send
