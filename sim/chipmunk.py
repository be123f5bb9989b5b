"""The few calls of Chipmunk for which pymunk's Python around them takes longer than the work itself.

They go through pymunk's own cffi binding with structs that are kept: a step takes two thirds of the time of
`Space.step`, a ray a sixth of `Space.segment_query_first`; the numbers are the same to the bit. The rest of `sim` uses
pymunk as it is meant. pymunk's version is pinned, and a test compares both ways.
"""

from collections.abc import Callable

import pymunk
from pymunk._chipmunk_cffi import ffi, lib


def stepper(space: pymunk.Space) -> Callable[[float], None]:
    """What steps `space` by so many seconds. No shape may be added or removed in a callback."""
    step, handle = lib.cpSpaceStep, space._space

    def step_by(seconds: float) -> None:
        step(handle, seconds)

    # the closure keeps the space alive, and with it what `handle` points to
    step_by.__dict__["space"] = space
    return step_by


class Rays:
    """Rays in a space: how far along a segment the first shape is that `shape_filter` lets through."""

    def __init__(self, space: pymunk.Space, shape_filter: pymunk.ShapeFilter) -> None:
        self._space, self._handle = space, space._space
        self._query = lib.cpSpaceSegmentQueryFirst
        self._hit = ffi.new("cpSegmentQueryInfo *")
        self._start, self._end = ffi.new("cpVect *"), ffi.new("cpVect *")
        self._filter = ffi.new("cpShapeFilter *", tuple(shape_filter))

    def fraction(self, x: float, y: float, end_x: float, end_y: float) -> float:
        """Of the way from (x, y) to (end_x, end_y), in m: what lies before the first shape; 1 when nothing is there."""
        start, end = self._start, self._end
        start.x, start.y, end.x, end.y = x, y, end_x, end_y
        self._query(self._handle, start[0], end[0], 0.0, self._filter[0], self._hit)
        return float(self._hit.alpha)  # Chipmunk sets it to 1 where it has hit nothing
