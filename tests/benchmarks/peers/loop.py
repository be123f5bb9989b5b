"""Protocol of the compared simulators, each in its own process and environment, on stdin and stdout.

The first line is `{"twists": [[v, omega], ...]}` in m/s and rad/s, one twist per tick of 1/30 s. For each further line
the peer drives all of them once and answers `{"seconds", "pose", "ranges"}`: processor time, final pose, and the last
measurements of the 16 beams.
"""

import json
import math
import sys
import time
from collections.abc import Callable
from typing import Any

TICK_S = 1.0 / 30.0
SUBSTEPS = 8
HALF_M, WALL_RADIUS_M = 4.0, 0.01
# centre and side of axis-aligned boxes; with the walls a room of 20 edges
BOXES_M = [(2.5, 1.5, 0.8), (-2.0, 2.5, 1.0), (-2.5, -2.0, 0.6), (1.5, -2.5, 0.8)]
RADIUS_M, MASS_KG = 0.2225, 9.0
RANGE_M = 5.0
BEAMS_RAD = [math.tau * index / 16 for index in range(16)]
Twists = list[list[float]]
Drive = Callable[[], tuple[list[float], list[float]]]


def answer(prepare: Callable[[Twists], Drive]) -> None:
    """`prepare` sets up one drive and returns the function that performs it and returns final pose and ranges."""
    twists: Twists = json.loads(sys.stdin.readline())["twists"]
    for _ in sys.stdin:
        drive = prepare(twists)
        start_s = time.process_time()
        pose, ranges = drive()
        result: dict[str, Any] = {
            "seconds": time.process_time() - start_s,
            "pose": [float(value) for value in pose],
            "ranges": [float(value) for value in ranges],
        }
        print(json.dumps(result), flush=True)
