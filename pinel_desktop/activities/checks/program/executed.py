from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, Name, counted
from pinel_desktop.activities.evidence import Evidence


class Executed(CheckBase):
    """Commands with the `action` start `n` times in the run."""

    requires = None
    check: Literal["executed"]
    action: Name
    n: Annotated[int, Field(ge=0, le=1_000_000)]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        n, target = evidence.n_started(self.action), self.n
        values: dict[str, Any] = {"name": self.action, "measured": n, "target": target}
        there = next((one for one in evidence.commands if one.action == self.action), None)
        pointer, code = there.pointer if there else None, "check_executed"
        return CheckResult(
            n == target, n, target, pointer, code, values, "measured_number", n > target
        )

    def criterion(self, language: str) -> str:
        return counted("criterion_executed", self.n, language, name=self.action)
