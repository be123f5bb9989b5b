"""Records where a real robot is seen by the camera above the floor, as a truth of its run."""

import logging
import threading
from collections.abc import Mapping
from typing import Any

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.camera.overhead.markers import setup_of
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.robot import Pose2D
from pinel_desktop.runs.truth import TruePose, Truth, in_start_frame
from pinel_desktop.settings import OVERHEAD, Settings
from storage import Store, StoreError

_log = logging.getLogger(__name__)


class OverheadTruth:
    """Follows one run at a time; thread-safe. Without a camera above the floor it does nothing."""

    def __init__(self, store: Store, settings: Settings) -> None:
        self._store, self._settings = store, settings
        self._lock = threading.Lock()
        self._run: str | None = None
        self._believed: dict[int, Pose2D] = {}
        self._seen: dict[int, TruePose] = {}
        self._tick = 0
        self._problems: list[str] = []
        self._camera: CameraClient | None = None

    def use(self, camera: CameraClient) -> None:
        """Sets the camera, whose client is created after this object."""
        self._camera = camera

    def begin(self, run_id: str) -> None:
        """Follows the robot of a run that starts, if a camera above the floor is set up."""
        setup = setup_of(self._settings[OVERHEAD])
        if setup is None or self._camera is None:
            return
        with self._lock:
            self._run, self._tick = run_id, 0
            self._believed, self._seen, self._problems = {}, {}, []
        self._camera.watch_floor(setup.model_dump())

    def observe(self, event: Mapping[str, Any]) -> None:
        """Handles every event of a run."""
        if event["run"] != self._run:
            return
        if event["type"] == "telemetry":
            with self._lock:
                self._tick = event["tick"]
                self._believed[self._tick] = Pose2D(event["x_m"], event["y_m"], event["yaw_rad"])
        elif event["type"] == "run_ended":
            self._end()

    def receive(self, message: Mapping[str, Any]) -> None:
        """Handles a message `overhead` of the camera process."""
        problem, pose = message["problem"], message["pose"]
        with self._lock:
            if self._run is None:
                return
            if problem and problem not in self._problems:
                self._problems.append(problem)
                _log.warning("the camera above the floor: %s", problem)
            tick = self._tick - round(message["age_s"] * TICK_HZ)
            if pose and tick >= 0 and self._tick:
                x, y, yaw, sigma_m, sigma_rad = pose
                self._seen[tick] = TruePose(tick, Pose2D(x, y, yaw), sigma_m, sigma_rad)

    def _end(self) -> None:
        """Records what was seen, on a thread of its own: the end of a run waits for nothing."""
        assert self._camera is not None
        with self._lock:
            run, self._run = self._run, None
            seen = [self._seen[tick] for tick in sorted(self._seen)]
            believed = self._believed
        self._camera.watch_floor(None)
        if run and seen:
            threading.Thread(
                target=self._record, args=(run, seen, believed), name="overhead-truth"
            ).start()

    def _record(self, run: str, seen: list[TruePose], believed: dict[int, Pose2D]) -> None:
        try:
            aligned = in_start_frame(seen, believed.get)
            if aligned:
                rows = Truth("camera", tuple(aligned)).as_rows()
                self._store.truths.record(run, "camera", rows)
        except StoreError:
            _log.exception("what the camera above the floor has seen is not recorded")
