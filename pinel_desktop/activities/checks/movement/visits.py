from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import (
    MAX_ITEMS,
    CheckBase,
    CheckResult,
    FormField,
    Name,
    Path,
    text,
)
from pinel_desktop.activities.evidence import Evidence


class Visits(CheckBase):
    """The robot's centre passes through the `zones`, in this order unless `ordered` is false."""

    requires = "zones"
    form = (FormField("zones", "shown"),)
    check: Literal["visits"]
    zones: Annotated[list[Name], Field(min_length=1, max_length=MAX_ITEMS)]
    ordered: bool = True

    def evaluate(self, evidence: Evidence) -> CheckResult:
        zones = list(evidence.zones)
        missing = [zone for zone in self.zones if zone not in zones]
        if self.ordered:
            rest = iter(zones)
            missing = [zone for zone in self.zones if zone not in rest]
        visited = [zone for zone in zones if zone in self.zones]
        return CheckResult(
            passed=not missing,
            measured=", ".join(zones),
            target=", ".join(self.zones),
            pointer=evidence.motion_towards(missing[0]) if missing else evidence.last_motion,
            code="check_visits" if visited else "check_visits_none",
            values={"visited": visited, "zone": missing[0] if missing else ""},
            progress="measured_visits" if visited else "",
        )

    def criterion(self, language: str) -> str:
        in_order = self.ordered and len(self.zones) > 1
        code = "criterion_visits" if in_order else "criterion_visits_any"
        return text(code, language, zones=list(self.zones))

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        return {"zones": list(solution.zones)} if solution.zones else None

    def zones_named(self) -> dict[Path, str]:
        return {("zones", i): zone for i, zone in enumerate(self.zones)}
