from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, counted
from pinel_desktop.activities.checks.floor.draws import nothing_drawn
from pinel_desktop.activities.drawing import axes_of_symmetry, fine_step_m, sampled
from pinel_desktop.activities.evidence import Evidence


class Symmetric(CheckBase):
    """The drawing has at least `axes` mirror axes through its centroid; `tolerance` (0.06) is in r.m.s. radii."""

    requires = None
    check: Literal["symmetric"]
    axes: Annotated[int, Field(ge=1, le=180)]
    tolerance: Annotated[float, Field(gt=0, le=1)] = 0.06

    def evaluate(self, evidence: Evidence) -> CheckResult:
        if not evidence.trails:
            return nothing_drawn(evidence, self.axes)
        axes, target = axes_of(evidence, self.tolerance), self.axes
        values, code = {"measured": axes, "target": target}, "check_symmetric"
        return CheckResult(axes >= target, axes, target, None, code, values, "measured_number")

    def criterion(self, language: str) -> str:
        return counted("criterion_symmetric", self.axes, language)


def axes_of(evidence: Evidence, tolerance: float) -> int:
    """Returns the number of mirror axes of the pen's drawing."""
    step_m = fine_step_m(evidence.trail_points.points)
    fine = sampled([one.line for one in evidence.trails], step_m=step_m)
    return axes_of_symmetry(fine.points, tolerance)
