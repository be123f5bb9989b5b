"""The camera above the floor: runs and the teacher's trial use it, and it is off without both."""

import threading
import time
from collections.abc import Mapping
from typing import Any

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.camera.overhead.markers import OverheadSetup, setting_of, setup_of
from pinel_desktop.errors import PinelError
from pinel_desktop.settings import OVERHEAD, Settings

TRIAL_S = 4.0  # a trial ends so long after the page has asked last
_STALE_S = 1.5  # a sighting so old is none: the camera has stopped


class FloorCamera:
    """Thread-safe. The setup is a setting of this PC."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._camera: CameraClient | None = None
        self._lock = threading.Lock()
        self._is_in_run = False
        self._trial_end: threading.Timer | None = None
        self._sighting: tuple[float, Mapping[str, Any]] | None = None

    def use(self, camera: CameraClient) -> None:
        """Sets the camera, whose client is created after this object."""
        self._camera = camera

    @property
    def setup(self) -> OverheadSetup | None:
        """What the teacher has measured; None without a camera above the floor."""
        return setup_of(self._settings[OVERHEAD])

    def set_up(self, setup: OverheadSetup | None) -> None:
        """Stores what was measured, from the next run on; None switches the camera above the floor off."""
        self._settings.choose(OVERHEAD, setting_of(setup) if setup else "")
        with self._lock:
            is_tried = self._trial_end is not None
        if is_tried:
            self._watch()

    def begin_run(self) -> bool:
        """Follows the robot of a run; returns False without a camera above the floor."""
        if self.setup is None:
            return False
        self._is_in_run = True
        self._watch()
        return True

    def end_run(self) -> None:
        """Ends following; a trial goes on."""
        self._is_in_run = False
        self._watch()

    def try_out(self) -> Mapping[str, Any] | None:
        """Follows the robot for some seconds more; returns the last message of `camera/floor_watch.py`, None before.

        Raises PinelError `overhead_not_set_up`.
        """
        if self.setup is None:
            raise PinelError("overhead_not_set_up")
        with self._lock:
            is_new = self._trial_end is None
            if self._trial_end is not None:
                self._trial_end.cancel()
            self._trial_end = threading.Timer(TRIAL_S, self.end_trial)
            self._trial_end.daemon = True
            self._trial_end.start()
            sighting = self._sighting
        if is_new:
            self._watch()
        if sighting is None or time.monotonic() - sighting[0] > _STALE_S:
            return None
        return sighting[1]

    def end_trial(self) -> None:
        """Ends a trial."""
        with self._lock:
            if self._trial_end is not None:
                self._trial_end.cancel()
            self._trial_end = None
        self._watch()

    def receive(self, message: Mapping[str, Any]) -> None:
        """Handles a message `overhead` of the camera process."""
        with self._lock:
            self._sighting = (time.monotonic(), message)

    def _watch(self) -> None:
        with self._lock:
            is_used = self._is_in_run or self._trial_end is not None
            setup = self.setup if is_used else None
            assert self._camera is not None
            self._camera.watch_floor(setup.model_dump() if setup else None)
