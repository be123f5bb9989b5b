"""`pinel engine`: the process for live runs, started by the app."""

import signal
import sys

import click

from pinel_desktop.commands.owned.pipe import pipes
from pinel_desktop.engine.server import Engine


@click.command(hidden=True)
def command() -> None:
    """Execute live runs for the app: messages on standard input, events on standard output."""
    with pipes("engine") as (messages, events):
        # a log-out sends SIGTERM; exit in order, so that the robot is stopped first
        signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(0))
        Engine(messages, events).serve()
