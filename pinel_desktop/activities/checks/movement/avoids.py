from typing import Any, Literal

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, FormField, Name, Path
from pinel_desktop.activities.evidence import Evidence


class Avoids(CheckBase):
    """The robot's centre never enters the `zone`."""

    requires = "zones"
    form = (FormField("zone", "zone"),)
    check: Literal["avoids"]
    zone: Name

    def evaluate(self, evidence: Evidence) -> CheckResult:
        tick = next((tick for name, tick in evidence.entries if name == self.zone), None)
        motion = None if tick is None else evidence.motion_at(tick)
        return CheckResult(
            passed=tick is None,
            measured=", ".join(evidence.zones),
            target=None,
            pointer=motion.pointer if motion else None,
            code="check_avoids",
            values={"zone": self.zone},
            is_irrecoverable=tick is not None,
        )

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        away = [zone.name for zone in solution.world.zones if zone.name not in solution.zones]
        return {"zone": away[0]} if away else None

    def zones_named(self) -> dict[Path, str]:
        return {("zone",): self.zone}

    def goal_zones(self) -> list[str]:
        return []
