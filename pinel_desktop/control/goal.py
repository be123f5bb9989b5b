"""When a motion has arrived, and when it is stuck: kept apart from the controller, which knows neither."""

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class GoalCheck:
    """Whether the set-point's end has been reached, in the unit of the motion (m or rad).

    A simulated robot gets within `fine`. A real one, whose pose is noisy, is given `patience` ticks and then has
    arrived within `coarse`.
    """

    fine: float
    coarse: float
    patience: int = 15

    def arrived(self, error: float, ticks_past_end: int) -> bool:
        tolerance = self.fine if ticks_past_end <= self.patience else self.coarse
        return abs(error) <= tolerance


MOVE_GOAL = GoalCheck(fine=2e-5, coarse=0.01)
TURN_GOAL = GoalCheck(fine=math.radians(0.003), coarse=0.01)


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
