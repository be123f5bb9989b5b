"""`pinel camera`: the process that sees signs. Started by the app, not by people."""

import logging
import os
import signal
import sys

import click

from pinel_desktop.camera.server import CameraServer
from pinel_desktop.camera.sight import Sight
from pinel_desktop.gestures.recognition import Recogniser


@click.command(hidden=True)
def command() -> None:
    """Recognise signs for the app: messages on standard input, what is seen on standard output."""
    logging.basicConfig(stream=sys.stderr, level=logging.INFO)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the app decides when this process ends
    # what a driver prints by accident must not land among the messages
    events = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with events:
        CameraServer(sys.stdin.buffer, events, lambda: Sight(Recogniser())).serve()
