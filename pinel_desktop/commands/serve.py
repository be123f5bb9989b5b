"""`pinel serve`: serves the page without a window."""

import signal
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

from pinel_desktop.app import App
from pinel_desktop.camera.address import check_address, check_recognizer
from pinel_desktop.commands.options import chosen_database, database_option, recognizer_option
from pinel_desktop.commands.pc.first_start import locked
from pinel_desktop.commands.printing import Failure, print_problem
from pinel_desktop.commands.robots.real_robot import chosen_robot
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import AlreadyRunningError
from pinel_desktop.links import LINK_NAMES
from pinel_desktop.messages import describe
from pinel_desktop.processes.log_file import start_log
from pinel_desktop.robot.robot_profile import BridgeProfile

if TYPE_CHECKING:
    from pinel_desktop.web.legacy.api import BridgeChoice


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
@recognizer_option
@click.option(
    "--bridge",
    metavar="HOST:PORT",
    help="Serve the HTTP interface of the original PINEL there: /execute, /bridge/ and others (docs/bridge.md).",
)
@click.option(
    "--bridge-key",
    metavar="KEY",
    help="What each request to it must bring, in the header X-PINEL-Key or as ?key=KEY.",
)
@click.option(
    "--bridge-file-pages",
    is_flag=True,
    help="Let block pages that were opened as a file drive the robot, too; pages of this PC over http may anyway. "
    "A page of any web site that hides in a frame without an origin looks alike and could then drive it: "
    "close other sites meanwhile. --bridge-key lets in nobody without the key.",
)
@click.option(
    "--robot",
    type=click.Choice(LINK_NAMES),
    default="sim",
    show_default=True,
    help="Which robot its calls drive; bridge is the program that asks it for velocities.",
)
@database_option
@click.pass_context
def command(
    ctx: click.Context,
    port: int,
    camera: str | None,
    recognizer: str | None,
    bridge: str | None,
    bridge_key: str | None,
    bridge_file_pages: bool,
    robot: str,
) -> None:
    """Serve the page without a window and print its address.

    The address works once and on this PC only; start the command again for a new one. Ctrl+C ends it.
    Exit status: 0, or 1 if the page or the bridge cannot be served, or what --camera or --recognizer names is missing.
    """
    try:
        choice = _bridge(bridge, bridge_key, robot, file_pages=bridge_file_pages)
        if camera is not None:
            check_address(camera)
        if recognizer is not None:
            check_recognizer(recognizer)
        database = chosen_database(ctx)
        start_log("app", database)
        app = App(
            database,
            port=port,
            instance=locked(database),
            camera=camera,
            recognizer=recognizer,
            bridge=choice,
        )
        _serve(app, choice)
    except AlreadyRunningError as first:
        print_problem(first)
        click.echo(first.running.fresh_link())
    except PinelError as error:
        raise Failure(error) from error


def _bridge(
    bridge: str | None, key: str | None, robot: str, *, file_pages: bool
) -> "BridgeChoice | None":
    """Returns the bridge to serve besides the page, if any. Raises PinelError for invalid combinations of options."""
    if bridge is None:
        if key is not None or robot != "sim" or file_pages:
            raise PinelError("bridge_option_missing")
        return None
    from pinel_desktop.web.legacy.api import BridgeChoice  # noqa: PLC0415 - only with --bridge

    profile = chosen_robot("bridge", (), bridge, key)
    assert isinstance(profile, BridgeProfile)
    return BridgeChoice(profile, robot, file_pages)


def _serve(app: App, choice: "BridgeChoice | None") -> None:
    with _signals() as signals, app:
        if app.notice is not None:
            print_problem(app.notice, app.language)
        click.echo(describe("serving", {}, app.language).line, err=True)
        click.echo(app.address)
        if choice is not None:
            values = {"address": app.wait_for_bridge(), "robot": choice.robot}
            click.echo(describe("bridge_serving", values, app.language).line, err=True)
            if choice.file_pages:
                click.echo(describe("bridge_file_pages", {}, app.language).line, err=True)
        signals.recv(1)


@contextmanager
def _signals() -> Iterator[socket.socket]:
    """Yields a socket that becomes readable at SIGINT or SIGTERM.

    Python runs signal handlers on the main thread only, and not while it waits for a lock. The wakeup descriptor works
    whichever thread receives the signal.
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
