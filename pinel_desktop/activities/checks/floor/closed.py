import math
from typing import Any, Literal, Self

from pinel_desktop.activities.checks.base import (
    CheckBase,
    CheckResult,
    Length,
    RealRobotTolerance,
    centimetres,
)
from pinel_desktop.activities.checks.floor.draws import nothing_drawn
from pinel_desktop.activities.evidence import Evidence


class Closed(CheckBase):
    """The last point drawn is within `within_m` (0.05) of the first."""

    requires = None
    is_about_end = True
    form = (centimetres("within_m"),)
    check: Literal["closed"]
    within_m: Length = 0.05

    def evaluate(self, evidence: Evidence) -> CheckResult:
        gap = gap_of(evidence)
        if gap is None:
            return nothing_drawn(evidence, self.within_m)
        passed, values, pointer = gap <= self.within_m, {"gap_m": gap}, evidence.last_motion
        return CheckResult(passed, gap, 0.0, pointer, "check_closed", values, "measured_gap")

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        return {"within_m": 0.05} if solution.trails else None

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        return self.model_copy(update={"within_m": max(self.within_m, tolerance.move_m)})


def gap_of(evidence: Evidence) -> float | None:
    """Returns the distance between the first and the last point that the pen drew, in m; None without a drawing."""
    if not evidence.trails:
        return None
    return math.dist(evidence.trails[0].line[0], evidence.trails[-1].line[-1])
