"""Goal and progress checks: whether a motion has arrived, and whether it is stuck. Independent of the controller."""

import math
from dataclasses import dataclass, replace

from pinel_desktop.robot.geometry import Twist2D

# A controller with a noisy pose never stops correcting; up to these speeds the robot counts as standing.
_AT_REST_MPS, _AT_REST_RADPS = 1e-3, 2e-3
_TREMBLES_MPS, _TREMBLES_RADPS = 0.02, 0.04


def at_rest(twist: Twist2D) -> bool:
    """True if the measured twist is that of a robot at standstill."""
    return abs(twist.v_mps) < _AT_REST_MPS and abs(twist.omega_radps) < _AT_REST_RADPS


@dataclass(frozen=True, slots=True)
class GoalCheck:
    """Decides whether the robot stands at the end of the motion. Tolerances in the unit of the motion (m or rad).

    During the first `patience` ticks after the end of the set-points the error must be within `fine`, which a robot
    with exact poses reaches. After that `near` suffices, after `2 * patience` ticks `coarse`; slight motion is then
    accepted, for robots with noisy poses.
    """

    fine: float
    near: float
    coarse: float
    settle_ticks: int = 15

    def arrived(self, error: float, twist: Twist2D, ticks_past_end: int) -> bool:
        """`error` in the unit of the motion; `ticks_past_end` counts ticks since the last set-point."""
        if ticks_past_end <= self.settle_ticks:
            return abs(error) <= self.fine and at_rest(twist)
        tolerance = self.near if ticks_past_end <= 2 * self.settle_ticks else self.coarse
        trembles = abs(twist.v_mps) < _TREMBLES_MPS and abs(twist.omega_radps) < _TREMBLES_RADPS
        return abs(error) <= tolerance and trembles


MOVE_GOAL = GoalCheck(fine=2e-5, near=0.002, coarse=0.01)
TURN_GOAL = GoalCheck(fine=math.radians(0.003), near=math.radians(0.15), coarse=0.01)


@dataclass(frozen=True, slots=True)
class Goals:
    """When motions have arrived.

    Attributes:
        move: of lines and arcs, in m.
        turn: of turns, in rad.
        sticks: the robot's wheels may stick before the goal.
    """

    move: GoalCheck = MOVE_GOAL
    turn: GoalCheck = TURN_GOAL
    sticks: bool = False

    def widened(self, move_m: float, turn_rad: float) -> "Goals":
        """With these errors accepted in the end: wheels of a real robot stick before they move by less."""
        return Goals(
            replace(self.move, coarse=move_m), replace(self.turn, coarse=turn_rad), sticks=True
        )


GOALS = Goals()


class ProgressCheck:
    """Detects a motion that progresses by less than `step` (m or rad) in `timeout_ticks` ticks."""

    def __init__(self, step: float, timeout_ticks: int) -> None:
        self._step, self._timeout_ticks = step, timeout_ticks
        self._reference: float | None = None
        self._due = 0

    def stuck(self, done: float, tick: int) -> bool:
        """`done` is the progress of the motion in m or rad, of either sign; `tick` is the current tick's number."""
        if self._reference is None or abs(done - self._reference) >= self._step:
            self._reference, self._due = done, tick + self._timeout_ticks
        return tick >= self._due


class ApproachCheck:
    """Detects a motion whose distance to its goal shrinks by less than `step` (m) in `timeout_ticks` ticks.

    Attributes:
        nearest_m: the smallest distance so far.
    """

    def __init__(self, step: float, timeout_ticks: int) -> None:
        self._progress = ProgressCheck(step, timeout_ticks)
        self.nearest_m = math.inf

    def stuck(self, distance_m: float, tick: int) -> bool:
        """`distance_m` is the robot's distance to the goal; `tick` is the current tick's number."""
        self.nearest_m = min(self.nearest_m, distance_m)
        return self._progress.stuck(self.nearest_m, tick)
