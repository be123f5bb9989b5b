"""When a motion has arrived, and when it is stuck: kept apart from the controller, which knows neither."""

import math
from dataclasses import dataclass

from pinel_desktop.robot.geometry import Twist2D

# A robot that measures its pose with noise goes on correcting it: it trembles at this speed and never stands.
_AT_REST_MPS, _AT_REST_RADPS = 1e-3, 2e-3
_TREMBLES_MPS, _TREMBLES_RADPS = 0.02, 0.04


def at_rest(twist: Twist2D) -> bool:
    """Whether a measured twist is standstill."""
    return abs(twist.v_mps) < _AT_REST_MPS and abs(twist.omega_radps) < _AT_REST_RADPS


@dataclass(frozen=True, slots=True)
class GoalCheck:
    """Whether the set-point's end has been reached, in the unit of the motion (m or rad), and the robot stands there.

    A simulated robot gets within `fine`. A real one, whose pose is noisy, is given `patience` ticks to come within
    `near`, and twice as many to come within `coarse`; it may tremble.
    """

    fine: float
    near: float
    coarse: float
    patience: int = 15

    def arrived(self, error: float, twist: Twist2D, ticks_past_end: int) -> bool:
        if ticks_past_end <= self.patience:
            return abs(error) <= self.fine and at_rest(twist)
        tolerance = self.near if ticks_past_end <= 2 * self.patience else self.coarse
        trembles = abs(twist.v_mps) < _TREMBLES_MPS and abs(twist.omega_radps) < _TREMBLES_RADPS
        return abs(error) <= tolerance and trembles


MOVE_GOAL = GoalCheck(fine=2e-5, near=0.002, coarse=0.01)
TURN_GOAL = GoalCheck(fine=math.radians(0.003), near=math.radians(0.15), coarse=0.01)


class ProgressCheck:
    """Notices a motion that has not come `step` further (m or rad) within `patience` ticks."""

    def __init__(self, step: float, patience: int) -> None:
        self._step, self._patience = step, patience
        self._mark: float | None = None
        self._due = 0

    def stuck(self, done: float, tick: int) -> bool:
        """`done` is how far the motion has come, its sign ignored; `tick` the number of the tick."""
        if self._mark is None or abs(done - self._mark) >= self._step:
            self._mark, self._due = done, tick + self._patience
        return tick >= self._due
