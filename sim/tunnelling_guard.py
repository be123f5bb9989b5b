"""No box is ever pushed through a wall, however it is squeezed, whipped or thrown.

The physics resolves contacts step by step, and a light box between strong wheels and a thin wall may be pressed deeper
at each step until its middle is past the wall, from where it is pushed out on the other side. So after every call the
way of each box's centre is looked at: where it leads through something fixed, all that can move is put back to where it
was and stands, as it would if nothing gave way.
"""

from collections.abc import Callable, Sequence

import pymunk

from sim.pymunk_fastpath import BodyAccess, Rays

FIXED, MOVABLE = 0b0100, 0b1000  # categories of what never moves, and of boxes
_FIXED_ONLY = pymunk.ShapeFilter(mask=FIXED)
_STANDSTILL = (0.0, 0.0)


class TunnellingGuard:
    """Watches over the movable boxes of a space, and over the robot that pushes them."""

    def __init__(
        self, space: pymunk.Space, boxes: Sequence[pymunk.Body], robot: pymunk.Body
    ) -> None:
        self._space = space
        self._boxes = [BodyAccess(box) for box in boxes]
        self._all = (*boxes, robot)
        self._rays = Rays(space, _FIXED_ONLY)

    def around(self, steps: Callable[[int], None]) -> Callable[[int], None]:
        """The same steps, after which no box is where it cannot have come to."""

        def guarded(number: int) -> None:
            places = [box.position() for box in self._boxes]
            before = [(body, body.position, body.angle) for body in self._all]
            steps(number)
            if any(map(self._came_through, self._boxes, places)):
                for body, place, angle in before:
                    self._put_back(body, place, angle)

        return guarded

    def _came_through(self, box: BodyAccess, before: tuple[float, float]) -> bool:
        now = box.position()
        # what is no number came from nowhere
        return now != before and not self._rays.fraction(*before, *now) >= 1.0

    def _put_back(self, body: pymunk.Body, place: pymunk.Vec2d, angle: float) -> None:
        body.position, body.angle = place, angle
        body.velocity, body.angular_velocity = _STANDSTILL, 0.0
        self._space.reindex_shapes_for_body(body)
