import math
from typing import Any, Literal, Self

from pinel_desktop.activities.checks.base import (
    CheckBase,
    CheckResult,
    Length,
    Metres,
    RealRobotTolerance,
    centimetres,
    place_text,
    rounded,
    text,
)
from pinel_desktop.activities.evidence import Evidence


class EndsAt(CheckBase):
    """The robot ends within `within_m` (0.1) of `x_m`, `y_m`, in the start frame."""

    requires = None
    is_about_end = True
    form = (centimetres("within_m"),)
    check: Literal["ends_at"]
    x_m: Metres
    y_m: Metres
    within_m: Length = 0.1

    def evaluate(self, evidence: Evidence) -> CheckResult:
        x, y, _ = evidence.end
        off = math.hypot(x - self.x_m, y - self.y_m)
        at_start = math.hypot(self.x_m, self.y_m) <= self.within_m
        code = "check_ends_at_start" if at_start else "check_ends_at"
        passed, values = off <= self.within_m, {"off_m": off}
        return CheckResult(passed, off, 0.0, evidence.last_motion, code, values, "measured_off")

    def criterion(self, language: str) -> str:
        place = place_text(self.x_m, self.y_m, self.within_m, language)
        if not place:
            return text("criterion_ends_at_start", language)
        return text("criterion_ends_at", language, place=place)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any]:
        x, y, _ = solution.end
        return {"x_m": rounded(x), "y_m": rounded(y), "within_m": 0.1}

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        return self.model_copy(update={"within_m": max(self.within_m, tolerance.move_m)})
