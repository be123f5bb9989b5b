import math
from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, FormField, rounded, text
from pinel_desktop.activities.evidence import Evidence


class Time(CheckBase):
    """The run takes at most `at_most_s` of robot time."""

    requires = "pace"
    form = (FormField("at_most_s", "number", "most", 1, 1000),)
    check: Literal["time"]
    at_most_s: Annotated[float, Field(gt=0, le=3600)]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        duration_s, target = evidence.duration_s, self.at_most_s
        values, is_over = {"measured_s": duration_s, "target_s": target}, duration_s > target
        return CheckResult(
            not is_over, duration_s, target, None, "check_time", values, "measured_time", is_over
        )

    def criterion(self, language: str) -> str:
        return text("criterion_time", language, most_s=self.at_most_s)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any]:
        return {"at_most_s": max(1, math.ceil(rounded(solution.duration_s, 1) * 1.5))}
