"""Motion profile, tracking controller, goal checker, path planner. PURE: no IO, thread or clock."""

from pinel_desktop.control.breakaway import Breakaway
from pinel_desktop.control.goal import ApproachCheck, GoalCheck, ProgressCheck
from pinel_desktop.control.profile import s_curve
from pinel_desktop.control.tracking import (
    DEFAULT_GAINS,
    SLIPPING_GAINS,
    ArcTracker,
    Gains,
    LineTracker,
    hold_position,
)
from pinel_desktop.control.trim import Trim

__all__ = [
    "DEFAULT_GAINS",
    "SLIPPING_GAINS",
    "ApproachCheck",
    "ArcTracker",
    "Breakaway",
    "Gains",
    "GoalCheck",
    "LineTracker",
    "ProgressCheck",
    "Trim",
    "hold_position",
    "s_curve",
]
