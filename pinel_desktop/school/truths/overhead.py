"""Records where a real robot is seen by the camera above the floor, as a truth of its run."""

from collections.abc import Mapping
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import Pose2D
from pinel_desktop.runs.truth import TruePose
from pinel_desktop.school.truths.collector import Language, Publish, TruthCollector
from pinel_desktop.school.truths.floor_camera import FloorCamera
from storage import Store


class OverheadTruth:
    """Follows one run at a time; thread-safe. Without a camera above the floor it does nothing."""

    def __init__(
        self, store: Store, camera: FloorCamera, publish: Publish, language: Language
    ) -> None:
        self._camera = camera
        self._collector = TruthCollector("camera", store, publish, language)

    def begin(self, run_id: str) -> None:
        """Follows the robot of a run that starts, if a camera above the floor is set up."""
        if self._camera.begin_run():
            self._collector.begin(run_id)

    def observe(self, event: Mapping[str, Any]) -> None:
        """Handles every event of a run."""
        if event["run"] != self._collector.run:
            return
        if event["type"] == "telemetry":
            self._collector.observe(event)
        elif event["type"] == "run_ended":
            self._collector.end()
            self._camera.end_run()

    def close(self) -> None:
        """Waits until what was seen of the last run is recorded."""
        self._collector.close()

    def receive(self, message: Mapping[str, Any]) -> None:
        """Handles a message `overhead` of the camera process."""
        self._camera.receive(message)
        if self._collector.run is None:
            return
        if problem := message["problem"]:
            markers = ", ".join(map(str, message["missing"]))
            self._collector.report(PinelError(problem, markers=markers))
        place = self._collector.believed(message["age_s"])
        if place and message["pose"]:
            x, y, yaw, sigma_m, sigma_rad = message["pose"]
            self._collector.add(TruePose(place[0], Pose2D(x, y, yaw), sigma_m, sigma_rad))
