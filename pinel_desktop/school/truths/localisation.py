"""Records what a real robot's own localisation says, as a truth of its run."""

import math
from collections.abc import Mapping
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import Pose2D
from pinel_desktop.robot.robot_profile import RobotProfile, RosProfile
from pinel_desktop.runs.truth import TruePose, moves_alike
from pinel_desktop.school.truths.collector import Language, Publish, TruthCollector
from storage import Store

# A localisation may report only after a movement, so silence is measured in movement.
_TIMEOUT_M, _TIMEOUT_RAD = 1.0, math.radians(120.0)


class LocalisationTruth:
    """Follows one run at a time; thread-safe. Of a robot whose profile names no topic it records nothing."""

    def __init__(self, store: Store, publish: Publish, language: Language) -> None:
        self._collector = TruthCollector("localisation", store, publish, language)
        self._accepted: tuple[Pose2D, Pose2D] | None = (
            None  # by the map, and by the robot's own estimate
        )
        self._reported_at = Pose2D()

    def begin(self, run_id: str, robot: RobotProfile | None) -> None:
        """Follows the robot of a run that starts, if its localisation is read."""
        if isinstance(robot, RosProfile) and robot.localisation_topic:
            self._accepted, self._reported_at = None, Pose2D()
            self._collector.begin(run_id)

    def observe(self, event: Mapping[str, Any]) -> None:
        """Handles every event of a run."""
        if event["run"] != self._collector.run:
            return
        if event["type"] == "telemetry":
            self._collector.observe(event)
            self._check_timeout(Pose2D(event["x_m"], event["y_m"], event["yaw_rad"]))
        elif event["type"] == "run_ended":
            self._collector.end()

    def close(self) -> None:
        """Waits until what was seen of the last run is recorded."""
        self._collector.close()

    def receive(self, message: Mapping[str, Any]) -> None:
        """Handles a message `robot_localised` of the engine."""
        if message["run"] != self._collector.run:
            return
        if message["code"]:
            self._collector.report(PinelError(message["code"], **message["params"]))
            return
        place = self._collector.believed(message["age_s"])
        if place is None:
            return
        tick, believed = place
        x, y, yaw, sigma_m, sigma_rad = message["pose"]
        pose, self._reported_at = Pose2D(x, y, yaw), believed
        if self._accepted and not moves_alike(self._accepted, (pose, believed)):
            self._collector.report(PinelError("localisation_jumped"))
            return
        self._accepted = (pose, believed)
        self._collector.add(TruePose(tick, pose, sigma_m, sigma_rad))

    def _check_timeout(self, believed: Pose2D) -> None:
        moved = believed.relative_to(self._reported_at)
        if math.hypot(moved.x_m, moved.y_m) > _TIMEOUT_M or abs(moved.yaw_rad) > _TIMEOUT_RAD:
            self._collector.report(PinelError("localisation_silent"))
