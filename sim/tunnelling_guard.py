"""Prevents movable boxes from tunnelling through walls.

The solver allows some penetration at each step. Strong wheels can press a light box deeper into a thin wall step by
step. Once the box's centre is past the wall, the solver pushes the box out on the far side. Therefore the guard checks
the path of each box's centre after every call. If a path crosses a fixed shape, all movable bodies return to their
previous poses with zero velocity.
"""

from collections.abc import Callable, Sequence

import pymunk

from sim.pymunk_fastpath import BodyAccess, Rays

FIXED, MOVABLE = 0b0100, 0b1000  # shape categories: fixed obstacles, movable boxes
_FIXED_ONLY = pymunk.ShapeFilter(mask=FIXED)
_STANDSTILL = (0.0, 0.0)


class TunnellingGuard:
    """Checks the movable boxes of a space after each call of its stepping function."""

    def __init__(
        self, space: pymunk.Space, boxes: Sequence[pymunk.Body], robot: pymunk.Body
    ) -> None:
        self._space = space
        self._all = [(body, BodyAccess(body)) for body in (*boxes, robot)]
        self._boxes = [access for _, access in self._all[:-1]]
        self._rays = Rays(space, _FIXED_ONLY)

    def wrap(self, steps: Callable[[int], None]) -> Callable[[int], None]:
        """Returns `steps` with a check: if a box has tunnelled, its steps are undone."""

        def guarded(number: int) -> None:
            before = [(access.position(), access.angle()) for _, access in self._all]
            steps(number)
            for box, (place, _) in zip(self._boxes, before, strict=False):  # without the robot
                if self._has_tunnelled(box, place):
                    self._put_all_back(before)
                    return

        return guarded

    def _has_tunnelled(self, box: BodyAccess, before: tuple[float, float]) -> bool:
        now = box.position()
        # written as "not >=" so that NaN counts as tunnelled
        return now != before and not self._rays.fraction(*before, *now) >= 1.0

    def _put_all_back(self, before: list[tuple[tuple[float, float], float]]) -> None:
        for (body, _), (place, angle) in zip(self._all, before, strict=True):
            body.position, body.angle = place, angle
            body.velocity, body.angular_velocity = _STANDSTILL, 0.0
            self._space.reindex_shapes_for_body(body)
