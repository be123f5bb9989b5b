from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Literal, Self

from pydantic import Field

from pinel_desktop.activities.checks.base import (
    MAX_ITEMS,
    CheckBase,
    CheckResult,
    RealRobotTolerance,
    SimulatorRequirement,
    text,
)
from pinel_desktop.activities.checks.floor.draws import PROGRESS as DRAWING
from pinel_desktop.activities.evidence import Evidence

if TYPE_CHECKING:
    # `checks/__init__.py` declares the union of all kinds, which includes this one
    Check = CheckBase


class AnyOf(CheckBase):
    """One of the `checks` holds."""

    requires = None
    check: Literal["any_of"]
    checks: Annotated[list["Check"], Field(min_length=1, max_length=MAX_ITEMS)]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        """Returns the first result that passes, else the nearest drawing, else the first result."""
        results: list[CheckResult] = []
        for check in self.checks:
            results.append(check.evaluate(evidence))
            if results[-1].passed:
                return results[-1]
        best = results[0]
        for result in results[1:]:
            if _is_nearer(result, best):
                best = result
        return replace(best, is_irrecoverable=all(one.is_irrecoverable for one in results))

    def criterion(self, language: str) -> str:
        lines = dict.fromkeys(one.line(language) for one in self.checks)
        return text("criteria_or", language).join(lines)

    def requirements(self) -> frozenset[SimulatorRequirement]:
        """Returns the requirements of all its checks: without data for one, a failure of the others proves nothing."""
        return frozenset().union(*(one.requirements() for one in self.checks))

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        return self.model_copy(
            update={"checks": [one.with_tolerance(tolerance) for one in self.checks]}
        )


def _is_nearer(found: CheckResult, other: CheckResult) -> bool:
    if not found.progress == other.progress == DRAWING:
        return False
    assert isinstance(found.measured, float)
    assert isinstance(other.measured, float)
    return found.measured < other.measured
