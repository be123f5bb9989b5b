import math
from typing import Annotated, Literal, Self

from pydantic import Field

from pinel_desktop.activities.checks.base import (
    CheckBase,
    CheckResult,
    RealRobotTolerance,
    side,
    text,
)
from pinel_desktop.activities.commands import TURNING
from pinel_desktop.activities.evidence import Evidence


class EndsHeading(CheckBase):
    """The robot ends within `within_deg` (5) of `heading_deg`, in the start frame."""

    requires = None
    is_about_end = True
    check: Literal["ends_heading"]
    heading_deg: Annotated[float, Field(ge=-360, le=360)]
    within_deg: Annotated[float, Field(gt=0, le=180)] = 5.0

    def evaluate(self, evidence: Evidence) -> CheckResult:
        heading, target = math.degrees(math.remainder(evidence.end[2], math.tau)), self.heading_deg
        passed = abs(math.remainder(heading - target, 360.0)) <= self.within_deg
        values = {"measured_deg": heading, "target_deg": target}
        pointer, code = evidence.last_pointer_of(*TURNING), "check_ends_heading"
        return CheckResult(passed, heading, target, pointer, code, values, "measured_heading")

    def criterion(self, language: str) -> str:
        heading = self.heading_deg
        if abs(heading) % 360 <= self.within_deg:
            return text("criterion_ends_heading_start", language)
        values = {"target_deg": abs(heading), "side": side(heading, language)}
        return text("criterion_ends_heading", language, **values)

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        return self.model_copy(update={"within_deg": max(self.within_deg, tolerance.turn_deg)})
