"""`pinel engine`: the process for live runs, started by the app."""

import logging
import os
import signal
import sys

import click

from pinel_desktop.engine.server import Engine


@click.command(hidden=True)
def command() -> None:
    """Execute live runs for the app: messages on standard input, events on standard output."""
    logging.basicConfig(stream=sys.stderr, level=logging.INFO)
    # Ctrl+C in a terminal reaches the whole process group; the app ends the engine by closing its pipe.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # Standard output goes to standard error, so that prints of libraries do not corrupt the events.
    events = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with events:
        Engine(sys.stdin.buffer, events).serve()
