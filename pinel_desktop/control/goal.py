"""Goal checker and progress checker: whether a motion has arrived, and whether it is stuck."""

import math
from dataclasses import dataclass, replace

from pinel_desktop.robot.geometry import Twist2D

_AT_REST_MPS, _AT_REST_RADPS = 1e-3, 2e-3
# A controller with a noisy pose never stops correcting. After the settle time, a robot below these
# speeds counts as being at rest.
_TREMBLES_MPS, _TREMBLES_RADPS = 0.02, 0.04


def at_rest(twist: Twist2D) -> bool:
    """Returns whether a robot with this measured twist is at rest."""
    return abs(twist.v_mps) < _AT_REST_MPS and abs(twist.omega_radps) < _AT_REST_RADPS


@dataclass(frozen=True, slots=True)
class GoalCheck:
    """Decides whether a motion has reached its goal. Tolerances in the unit of the motion (m or rad).

    For the first `settle_ticks` ticks after the last set-point, the error must be within `fine`, and the robot at rest.
    A robot with exact poses reaches that. After `settle_ticks` ticks the tolerance is `near`, and after
    `2 * settle_ticks` ticks it is `coarse`. Slight motion is then accepted, because noisy poses cause it.
    """

    fine: float
    near: float
    coarse: float
    settle_ticks: int = 15

    def is_reached(self, error: float, twist: Twist2D, ticks_past_end: int) -> bool:
        """Returns whether the motion has arrived.

        Args:
            error: remaining path, in the unit of the motion.
            ticks_past_end: number of ticks since the last set-point.
        """
        if ticks_past_end <= self.settle_ticks:
            return abs(error) <= self.fine and at_rest(twist)
        tolerance = self.near if ticks_past_end <= 2 * self.settle_ticks else self.coarse
        trembles = abs(twist.v_mps) < _TREMBLES_MPS and abs(twist.omega_radps) < _TREMBLES_RADPS
        return abs(error) <= tolerance and trembles


MOVE_GOAL = GoalCheck(fine=2e-5, near=0.002, coarse=0.01)
TURN_GOAL = GoalCheck(fine=math.radians(0.003), near=math.radians(0.15), coarse=0.01)


@dataclass(frozen=True, slots=True)
class Goals:
    """Goal checkers of all motions.

    Attributes:
        move: goal checker of lines and arcs, in m.
        turn: goal checker of turns, in rad.
        sticks: whether static friction may stop the robot's wheels before the goal.
    """

    move: GoalCheck = MOVE_GOAL
    turn: GoalCheck = TURN_GOAL
    sticks: bool = False

    def widened(self, move_m: float, turn_rad: float) -> "Goals":
        """Returns goal checkers with these `coarse` tolerances.

        Static friction keeps the wheels of a real robot from moving by less.
        """
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
        """Returns whether the motion is stuck.

        Args:
            done: progress of the motion in m or rad, of either sign.
            tick: number of the current tick.
        """
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
        """Returns whether the motion is stuck.

        Args:
            distance_m: distance from the robot to the goal.
            tick: number of the current tick.
        """
        self.nearest_m = min(self.nearest_m, distance_m)
        return self._progress.stuck(self.nearest_m, tick)
