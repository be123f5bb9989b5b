"""Wheels that stick: near its goal a real robot stands, because what is left to correct is too slow for its wheels."""

from pinel_desktop.control.goal import GoalCheck, at_rest
from pinel_desktop.robot.geometry import Twist2D

_GROWS_S = 1.0  # from standstill to the greatest addition
# Wheels that break away go too far, the farther the later the robot answers: each time more is taken for the goal.
_WIDENS, _WIDEST = 0.5, 4.0
_TRIES = 10


class Breakaway:
    """What is added to the speed of a robot that stands beside its goal; it grows until the robot moves.

    Args:
        goal: when the motion has arrived.
        max_added: the greatest addition, in m/s or rad/s; 0 for wheels that never stick.
        tick_s: control period.
    """

    def __init__(self, goal: GoalCheck, max_added: float, tick_s: float) -> None:
        self._goal, self._max_added = goal, max_added
        self._step = max_added * tick_s / _GROWS_S
        self._added = 0.0
        self._towards = 0.0
        self._n_passed = 0

    def arrived(self, error: float, twist: Twist2D, ticks_past_end: int) -> bool:
        """Whether the robot stands at its goal; `error` is the rest of the way (m or rad)."""
        if self._goal.arrived(error, twist, ticks_past_end):
            return True
        return self._n_passed > 0 and at_rest(twist) and abs(error) <= self._tolerance

    def more(self, error: float, twist: Twist2D, ticks_past_end: int) -> float:
        """The addition towards the goal; asked at every tick."""
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
        """The robot has gone past its goal to and fro, and will not stop at it."""
        return self._n_passed > _TRIES

    @property
    def _tolerance(self) -> float:
        return self._goal.coarse * min(1.0 + _WIDENS * self._n_passed, _WIDEST)
