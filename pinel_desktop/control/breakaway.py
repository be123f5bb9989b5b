"""Compensation of static friction (stiction): wheels of a real robot do not start to turn at low speeds.

Near the goal the controller commands only such low speeds. Without an addition the robot would stop short of the goal.
"""

from pinel_desktop.control.goal import GoalCheck, at_rest
from pinel_desktop.robot.geometry import Twist2D

_GROWS_S = 1.0  # time in which the addition grows from 0 to its maximum
# Wheels that break away overshoot, and more so with a longer delay of the link. Each overshoot
# therefore widens the goal tolerance by `_WIDENS` times `coarse`, up to `_WIDEST` times `coarse`.
_WIDENS, _WIDEST = 0.5, 4.0
_TRIES = 10  # overshoots after which the motion is given up


class Breakaway:
    """Speed that is added while the robot is at rest beside its goal; it grows until the robot moves.

    Args:
        goal: goal checker of the motion.
        max_added: maximum of the added speed, in m/s or rad/s; 0 for wheels without static friction.
        tick_s: control period, in s.
    """

    def __init__(self, goal: GoalCheck, max_added: float, tick_s: float) -> None:
        self._goal, self._max_added = goal, max_added
        self._step = max_added * tick_s / _GROWS_S
        self._added = 0.0
        self._towards = 0.0
        self._n_passed = 0

    def is_reached(self, error: float, twist: Twist2D, ticks_past_end: int) -> bool:
        """Returns whether the motion has reached its goal; `error` is the remaining path (m or rad)."""
        if self._goal.is_reached(error, twist, ticks_past_end):
            return True
        return self._n_passed > 0 and at_rest(twist) and abs(error) <= self._tolerance

    def more(self, error: float, twist: Twist2D, ticks_past_end: int) -> float:
        """Returns the speed to add towards the goal (m/s or rad/s); must be called at every tick."""
        if not self._max_added or ticks_past_end <= 0:
            return 0.0
        if not at_rest(twist) or abs(error) <= self._tolerance:
            self._added = 0.0
            return 0.0
        if error * self._towards < 0.0:
            self._n_passed += 1
            self._added = 0.0
        self._towards = error
        self._added = min(self._added + self._step, self._max_added)
        return self._added if error > 0.0 else -self._added

    @property
    def is_hopeless(self) -> bool:
        """True once the robot has overshot its goal too often to stop at it."""
        return self._n_passed > _TRIES

    @property
    def _tolerance(self) -> float:
        return self._goal.coarse * min(1.0 + _WIDENS * self._n_passed, _WIDEST)
