from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, FormField, counted
from pinel_desktop.activities.evidence import Evidence


class BlockCount(CheckBase):
    """The program has at most `at_most` commands."""

    requires = None
    form = (FormField("at_most", "number", "most", 1, 1000),)
    check: Literal["block_count"]
    at_most: Annotated[int, Field(ge=1, le=20_000)]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        n, target = len(evidence.commands), self.at_most
        values, code = {"measured": n, "target": target}, "check_block_count"
        is_over = n > target
        return CheckResult(not is_over, n, target, None, code, values, "measured_number", is_over)

    def criterion(self, language: str) -> str:
        return counted("criterion_block_count", self.at_most, language)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any]:
        return {"at_most": max(1, len(solution.commands))}
