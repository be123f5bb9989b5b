"""What a camera above the floor sees, told when it changes: for the one who sets it up."""

import math
import time
from collections.abc import Iterator

from pinel_desktop.camera.frames import OVERHEAD_SIZE, open_reader
from pinel_desktop.camera.overhead.markers import OverheadSetup
from pinel_desktop.camera.overhead.tracking import OverheadTracker, Sighting
from pinel_desktop.camera.overhead.wording import CodeAndParams, wording

_EVERY_S = 1.0  # at most so often a place is told


def sightings(source: str, setup: OverheadSetup, seconds: float) -> Iterator[CodeAndParams]:
    """Yields code and parameters of messages about what the camera sees, for so many seconds.

    Raises PinelError if the camera cannot be opened (`frames.open_reader`).
    """
    reader, tracker = open_reader(source, OVERHEAD_SIZE), OverheadTracker(setup)
    try:
        start_s, printed, printed_s = time.monotonic(), "", -math.inf
        while (now_s := time.monotonic()) - start_s < seconds:
            raw = reader.read()
            found = _message(tracker.update(now_s, raw.picture)) if raw else None
            if found and (found[0] != printed or now_s - printed_s >= _EVERY_S):
                printed, printed_s = found[0], now_s
                yield found
    finally:
        reader.close()


def _message(sighting: Sighting) -> CodeAndParams | None:
    return wording(sighting.pose_and_sigma, sighting.problem, sighting.missing)
