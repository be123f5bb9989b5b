"""The camera process above a rendered floor: `python -m tests.camera.overhead.rendered_camera POSE_FILE`.

The pictures show the robot where the file says; without the file it is covered.
"""

import json
import sys
from pathlib import Path

from pinel_desktop.camera.frame_analyzer import FrameAnalyzer
from pinel_desktop.camera.frames import RawFrame
from pinel_desktop.camera.server import CameraServer
from pinel_desktop.camera.source import CameraSource
from pinel_desktop.commands.owned.pipe import pipes
from pinel_desktop.gestures.recognition import LandmarkRecognizer
from pinel_desktop.robot import Pose2D
from tests.camera.overhead.rendering import Scene


class RenderedReader:
    is_live = False

    def __init__(self, pose_file: Path) -> None:
        self._pose_file, self._scene = pose_file, Scene()

    def read(self) -> RawFrame:
        pose = None
        if self._pose_file.exists():
            pose = Pose2D(*json.loads(self._pose_file.read_text()))
        return RawFrame(self._scene.picture(pose))

    def close(self) -> None:
        return


def open_source(address: str) -> CameraSource:
    return CameraSource(address, lambda _address: RenderedReader(Path(sys.argv[1])))


if __name__ == "__main__":
    with pipes("camera") as (messages, results):
        analyzer = FrameAnalyzer(LandmarkRecognizer())
        CameraServer(messages, results, lambda: analyzer, open_source).serve()
