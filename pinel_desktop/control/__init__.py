"""Motion profile, tracking controller, goal check. PURE: no IO, thread or clock."""

from pinel_desktop.control.goal import GoalCheck, ProgressCheck
from pinel_desktop.control.profile import s_curve
from pinel_desktop.control.tracking import DEFAULT_GAINS, Arc, Gains, Line

__all__ = ["DEFAULT_GAINS", "Arc", "Gains", "GoalCheck", "Line", "ProgressCheck", "s_curve"]
