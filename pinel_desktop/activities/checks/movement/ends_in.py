from typing import Any, Literal

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, FormField, Name, Path
from pinel_desktop.activities.evidence import Evidence


class EndsIn(CheckBase):
    """The robot's centre ends in the `zone` of the world."""

    requires = "zones"
    is_about_end = True
    form = (FormField("zone", "zone"),)
    check: Literal["ends_in"]
    zone: Name

    def evaluate(self, evidence: Evidence) -> CheckResult:
        x, y = (float(value) for value in evidence.in_world[-1])
        values = {"off_m": evidence.off_zone_m(self.zone, x, y), "zone": self.zone}
        pointer, end_zone = evidence.last_motion, evidence.end_zone
        passed, code = end_zone == self.zone, "check_ends_in"
        return CheckResult(passed, end_zone, self.zone, pointer, code, values, "measured_off")

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        return {"zone": solution.end_zone} if solution.end_zone else None

    def zones_named(self) -> dict[Path, str]:
        return {("zone",): self.zone}
