from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, FormField, counted
from pinel_desktop.activities.commands import nesting_of
from pinel_desktop.activities.evidence import Evidence


class Nesting(CheckBase):
    """Loops are nested at least `at_least` deep."""

    requires = None
    form = (FormField("at_least", "fixed", value=1),)
    check: Literal["nesting"]
    at_least: Annotated[int, Field(ge=1, le=100)]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        depth, target = nesting_of(evidence.commands), self.at_least
        values, code = {"measured": depth, "target": target}, "check_nesting"
        lacks = depth < target
        return CheckResult(not lacks, depth, target, None, code, values, "measured_number", lacks)

    def criterion(self, language: str) -> str:
        return counted("criterion_nesting", self.at_least, language)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        return {"at_least": 1} if nesting_of(solution.commands) else None
