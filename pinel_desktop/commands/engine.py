"""`pinel engine`: the process for live runs. Started by the app, not by people."""

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
    # Ctrl+C in a terminal reaches the whole group; the app decides when the engine goes, by ending its pipe.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # What a library prints by accident must not land among the events.
    events = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with events:
        Engine(sys.stdin.buffer, events).serve()
