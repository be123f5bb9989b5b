"""`pinel camera`: the process that sees signs, started by the app."""

import click

from pinel_desktop.camera.server import CameraServer
from pinel_desktop.camera.sight import Sight
from pinel_desktop.commands.owned.pipe import pipes
from pinel_desktop.gestures.recognition import Recogniser


@click.command(hidden=True)
def command() -> None:
    """Recognise signs for the app: messages on standard input, what is seen on standard output."""
    with pipes() as (messages, seen):
        CameraServer(messages, seen, lambda: Sight(Recogniser())).serve()
