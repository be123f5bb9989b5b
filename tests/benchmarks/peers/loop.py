"""What the peers have in common: each runs in a process and an environment of its own and answers on a pipe.

The first line that comes in holds what is to be driven: `{"twists": [[v, omega], ...]}` in m/s and rad/s, one a tick of
1/30 s. For every line after it the peer drives that once and answers `{"seconds", "pose", "ranges"}`: the processor's
time that it took, where it ended, and what the 16 beams measured last.
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
# centre and side of boxes whose sides are along x and y: with the walls, a room of 20 edges
BOXES_M = [(2.5, 1.5, 0.8), (-2.0, 2.5, 1.0), (-2.5, -2.0, 0.6), (1.5, -2.5, 0.8)]
RADIUS_M, MASS_KG = 0.2225, 9.0
RANGE_M = 5.0
BEAMS_RAD = [math.tau * index / 16 for index in range(16)]
Twists = list[list[float]]
Drive = Callable[[], tuple[list[float], list[float]]]


def answer(prepare: Callable[[Twists], Drive]) -> None:
    """`prepare` makes ready for one drive and gives what does it: pose at the end, ranges at the end."""
    twists: Twists = json.loads(sys.stdin.readline())["twists"]
    for _ in sys.stdin:
        drive = prepare(twists)
        began = time.process_time()
        pose, ranges = drive()
        told: dict[str, Any] = {
            "seconds": time.process_time() - began,
            "pose": [float(value) for value in pose],
            "ranges": [float(value) for value in ranges],
        }
        print(json.dumps(told), flush=True)
