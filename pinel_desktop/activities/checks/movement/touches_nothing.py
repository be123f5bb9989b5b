from typing import Any, Literal

from pinel_desktop.activities.checks.base import CheckBase, CheckResult
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.execution.clock import TICK_HZ


class TouchesNothing(CheckBase):
    """The robot never touches a wall or a box."""

    requires = "contact"
    form = ()
    check: Literal["touches_nothing"]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        tick, code = evidence.touch_tick, "check_touches_nothing"
        if tick is None:
            return CheckResult(True, None, None, None, code)
        motion, at_s = evidence.motion_at(tick), tick / TICK_HZ
        pointer, values = motion.pointer if motion else None, {"at_s": at_s}
        return CheckResult(False, at_s, None, pointer, code, values, "measured_touch", True)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        return {} if solution.touch_tick is None else None
