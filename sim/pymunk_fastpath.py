"""Fast paths to the Chipmunk calls for which pymunk's Python wrapper costs more than the call itself.

They use pymunk's cffi binding with preallocated structs. A step takes two thirds of the time of `Space.step`, a ray one
sixth of the time of `Space.segment_query_first`. The results are bit-identical. The rest of `sim` uses pymunk's public
interface. The version of pymunk is pinned, and a test compares both paths.
"""

import math
from collections.abc import Sequence

import pymunk
from pymunk._chipmunk_cffi import ffi, lib

_SIZE_AND_ALPHA = (
    ffi.sizeof("cpSegmentQueryInfo"),
    ffi.offsetof("cpSegmentQueryInfo", "alpha"),
)


class Stepper:
    """Advances a space in steps of `seconds`. No callback may add or remove a shape."""

    def __init__(self, space: pymunk.Space, seconds: float) -> None:
        self._space, self._handle = space, space._space
        self._seconds = seconds
        self._step = lib.cpSpaceStep

    def steps(self, number: int) -> None:
        """Advances the space by `number` steps."""
        step, handle, seconds = self._step, self._handle, self._seconds
        for _ in range(number):
            step(handle, seconds)


class BodyAccess:
    """Reads the state of one body and sets its velocity."""

    def __init__(self, body: pymunk.Body) -> None:
        self._body, self._handle = body, body._body
        self._velocity = ffi.new("cpVect *")

    def position(self) -> tuple[float, float]:
        """Returns the position in m, in the world's frame."""
        point = lib.cpBodyGetPosition(self._handle)
        return point.x, point.y

    def angle(self) -> float:
        """Returns the yaw in rad, not wrapped."""
        return float(lib.cpBodyGetAngle(self._handle))

    def velocity(self) -> tuple[float, float, float]:
        """Returns the velocity along x and y in m/s, and the angular velocity in rad/s."""
        handle = self._handle
        moves = lib.cpBodyGetVelocity(handle)
        return moves.x, moves.y, lib.cpBodyGetAngularVelocity(handle)

    def set_velocity(self, vx_mps: float, vy_mps: float) -> None:
        """Sets the velocity of a kinematic body."""
        velocity = self._velocity
        velocity.x, velocity.y = vx_mps, vy_mps
        lib.cpBodySetVelocity(self._handle, velocity[0])

    def set_omega(self, omega_radps: float) -> None:
        """Sets the angular velocity of a kinematic body."""
        lib.cpBodySetAngularVelocity(self._handle, omega_radps)


class Rays:
    """Casts rays in a space against the shapes that `shape_filter` accepts."""

    def __init__(self, space: pymunk.Space, shape_filter: pymunk.ShapeFilter) -> None:
        self._space, self._handle = space, space._space
        self._query = lib.cpSpaceSegmentQueryFirst
        self._hit = ffi.new("cpSegmentQueryInfo *")
        self._start, self._end = ffi.new("cpVect *"), ffi.new("cpVect *")
        self._filter = ffi.new("cpShapeFilter *", tuple(shape_filter))

    def fraction(self, x: float, y: float, end_x: float, end_y: float) -> float:
        """Returns the fraction of the segment from (x, y) to (end_x, end_y), in m, before the first shape.

        The fraction is 1 without a hit.
        """
        start, end = self._start, self._end
        start.x, start.y, end.x, end.y = x, y, end_x, end_y
        self._query(self._handle, start[0], end[0], 0.0, self._filter[0], self._hit)
        return float(self._hit.alpha)


class Fan:
    """Casts a few fixed rays; `beams` are the start (x, y) and end (x, y) of each ray in a body's frame, in m."""

    def __init__(
        self,
        space: pymunk.Space,
        shape_filter: pymunk.ShapeFilter,
        beams: Sequence[tuple[float, float, float, float]],
    ) -> None:
        self._space, self._handle = space, space._space
        self._query = lib.cpSpaceSegmentQueryFirst
        self._filter = ffi.new("cpShapeFilter *")
        self._filter[0] = tuple(shape_filter)
        self._starts, self._ends = (ffi.new("cpVect[]", len(beams)) for _ in range(2))
        self._hits = ffi.new("cpSegmentQueryInfo[]", len(beams))
        # each beam with the structs that Chipmunk reads (start, end) and writes (hit)
        self._beams = [
            (*beam, self._starts[i], self._ends[i], self._hits + i) for i, beam in enumerate(beams)
        ]
        numbers = memoryview(ffi.buffer(self._hits)).cast("d")
        whole, alpha = (n // numbers.itemsize for n in _SIZE_AND_ALPHA)
        self._fractions = numbers[alpha::whole]

    def fractions(self, x: float, y: float, yaw: float) -> "memoryview[float]":
        """Returns `Rays.fraction` of each beam for a body at (x, y) in m with yaw in rad.

        The next call overwrites the returned buffer.
        """
        cos, sin = math.cos(yaw), math.sin(yaw)
        query, handle, mask = self._query, self._handle, self._filter[0]
        for from_ahead, from_left, ahead, left, start, end, hit in self._beams:
            start.x = x + cos * from_ahead - sin * from_left
            start.y = y + sin * from_ahead + cos * from_left
            end.x, end.y = x + cos * ahead - sin * left, y + sin * ahead + cos * left
            query(handle, start, end, 0.0, mask, hit)
        return self._fractions
