"""`pinel serve`: serves the page without a window."""

import signal
import socket
from collections.abc import Iterator
from contextlib import contextmanager

import click

from pinel_desktop.app import App
from pinel_desktop.camera.address import check_address
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.printing import Failure, print_problem
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import AlreadyRunningError
from pinel_desktop.messages import describe


@click.command()
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    show_default=True,
    help="Port; 0 chooses a free one.",
)
@click.option(
    "--camera",
    metavar="SOURCE",
    help="Look through this in place of the chosen webcam: its number, a video file, a folder of pictures.",
)
@database_option
@click.pass_context
def command(ctx: click.Context, port: int, camera: str | None) -> None:
    """Serve the page without a window and print its address.

    The address works once and on this PC only; start the command again for a new one. Ctrl+C ends it.
    Exit status: 0, or 1 if the page cannot be served, or there is no video and no folder of that path.
    """
    app = App(chosen_database(ctx), port=port, camera=camera)
    try:
        if camera is not None:
            check_address(camera)
        _serve(app)
    except AlreadyRunningError as first:
        print_problem(first)
        click.echo(first.running.fresh_link())
    except PinelError as error:
        raise Failure(error) from error


def _serve(app: App) -> None:
    with _signals() as signals, app:
        if app.notice is not None:
            print_problem(app.notice, app.language)
        click.echo(describe("serving", {}, app.language).line, err=True)
        click.echo(app.address)
        signals.recv(1)


@contextmanager
def _signals() -> Iterator[socket.socket]:
    """A socket that becomes readable at SIGINT or SIGTERM.

    The wakeup descriptor works for whichever thread receives the signal; a main thread that waits for a lock would not
    run Python signal handlers.
    """
    receiving, sending = socket.socketpair()
    with receiving, sending:
        sending.setblocking(False)
        signal.set_wakeup_fd(sending.fileno())
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda number, frame: None)
        try:
            yield receiving
        finally:
            signal.set_wakeup_fd(-1)
