from typing import Literal

import numpy as np

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, Name, Path
from pinel_desktop.activities.evidence import Evidence


class Marks(CheckBase):
    """The run leaves the `symbol` in the `zone`."""

    requires = "zones"
    check: Literal["marks"]
    symbol: Literal["X", "O"]
    zone: Name

    def evaluate(self, evidence: Evidence) -> CheckResult:
        marks = [one for one in evidence.marks if one["symbol"] == self.symbol]
        places = np.array([(one["x_m"], one["y_m"]) for one in marks], dtype=float).reshape(-1, 2)
        zones = [evidence.zone_at(float(x), float(y)) for x, y in evidence.to_world(places)]
        values = {"symbol": self.symbol, "zone": self.zone}
        passed, measured = self.zone in zones, ", ".join(zones)
        pointer = evidence.last_pointer_of("mark")
        return CheckResult(passed, measured, self.zone, pointer, "check_marks", values)

    def zones_named(self) -> dict[Path, str]:
        return {("zone",): self.zone}
