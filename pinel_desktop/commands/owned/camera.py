"""`pinel camera`: the process that recognises signs, started by the app."""

import click

from pinel_desktop.camera.frame_analyzer import FrameAnalyzer
from pinel_desktop.camera.server import CameraServer
from pinel_desktop.commands.owned.pipe import pipes
from pinel_desktop.gestures.recognition import LandmarkRecognizer


@click.command(hidden=True)
def command() -> None:
    """Recognise signs for the app: messages on standard input, detection results on standard output."""
    with pipes("camera") as (messages, results):
        CameraServer(messages, results, lambda: FrameAnalyzer(LandmarkRecognizer())).serve()
