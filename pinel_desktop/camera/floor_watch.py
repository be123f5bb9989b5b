"""Follows a robot on the floor in the frames of the camera process, and sends where it is."""

import time
from collections.abc import Callable
from typing import Any

from pinel_desktop.camera.overhead.markers import OverheadSetup
from pinel_desktop.camera.overhead.tracking import OverheadTracker
from pinel_desktop.camera.source import StampedFrame
from pinel_desktop.processes.messages import Message


class FloorWatch:
    """Sends a message `overhead` for each frame.

    Args:
        setup: fields of `OverheadSetup`.
        send: sends a message to the app.
    """

    def __init__(self, setup: dict[str, Any], send: Callable[[Message], None]) -> None:
        self._tracker, self._send = OverheadTracker(OverheadSetup(**setup)), send

    def watch(self, frame: StampedFrame) -> None:
        """Handles the next frame; its age is that of the picture when the message is sent."""
        sighting = self._tracker.update(frame.time_s, frame.raw.picture)
        self._send(
            {
                "type": "overhead",
                "age_s": time.monotonic() - frame.time_s,
                "pose": sighting.pose_and_sigma,
                "problem": sighting.problem,
                "missing": list(sighting.missing),
                "markers": list(sighting.markers),
            }
        )
