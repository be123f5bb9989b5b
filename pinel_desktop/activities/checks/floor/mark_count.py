from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, FormField, counted
from pinel_desktop.activities.evidence import Evidence


class MarkCount(CheckBase):
    """The run leaves `n` marks."""

    requires = None
    form = (FormField("n", "number", "n", 1, 1000),)
    check: Literal["mark_count"]
    n: Annotated[int, Field(ge=0, le=10_000)]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        n, target = len(evidence.marks), self.n
        pointer, values = evidence.last_pointer_of("mark"), {"measured": n, "target": target}
        return CheckResult(
            n == target,
            n,
            target,
            pointer,
            "check_mark_count",
            values,
            "measured_number",
            n > target,
        )

    def criterion(self, language: str) -> str:
        return counted("criterion_mark_count", self.n, language)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        return {"n": len(solution.marks)} if solution.marks else None
