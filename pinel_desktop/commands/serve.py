"""`pinel serve`: the page without a window."""

import signal
import socket
from collections.abc import Iterator
from contextlib import contextmanager

import click

from pinel_desktop.app import App
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
    help="Port; 0 takes a free one.",
)
@database_option
@click.pass_context
def command(ctx: click.Context, port: int) -> None:
    """Serve the page without a window and print its address.

    The address works once and on this PC only; start the command again for a fresh one. Ends with Ctrl+C.
    Exit status: 0, or 1 when the page cannot be served.
    """
    app = App(chosen_database(ctx), port=port)
    try:
        _serve(app)
    except AlreadyRunningError as first:
        print_problem(first)
        click.echo(first.running.fresh_link())
    except PinelError as error:
        raise Failure(error) from error


def _serve(app: App) -> None:
    with _signals() as told, app:
        if app.notice is not None:
            print_problem(app.notice, app.language)
        click.echo(describe("serving", {}, app.language).line, err=True)
        click.echo(app.address)
        told.recv(1)


@contextmanager
def _signals() -> Iterator[socket.socket]:
    """Hears of Ctrl+C and of being told to end, whichever thread the system hands them to: a lock that the main
    thread waits for would not."""
    told, telling = socket.socketpair()
    with told, telling:
        telling.setblocking(False)
        signal.set_wakeup_fd(telling.fileno())
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda number, frame: None)
        try:
            yield told
        finally:
            signal.set_wakeup_fd(-1)
