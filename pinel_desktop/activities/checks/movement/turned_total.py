import math
from typing import Annotated, Any, Literal, Self

from pydantic import Field

from pinel_desktop.activities.checks.base import (
    NO_LIMIT,
    CheckBase,
    CheckResult,
    FormField,
    RealRobotTolerance,
    rounded,
    side,
    text,
)
from pinel_desktop.activities.commands import TURNING
from pinel_desktop.activities.evidence import Evidence

_MAX_DEG = 1_000_000


class TurnedTotal(CheckBase):
    """The sum of all turning is from `at_least_deg` to `at_most_deg`; the sum with sign (left is positive) is
    `net_deg` within `net_within` (10).
    """

    requires = None
    form = (
        FormField("at_least_deg", "number", "least", 0, 100_000, 5),
        FormField("at_most_deg", "number", "most", 1, 100_000, 5),
    )
    check: Literal["turned_total"]
    at_least_deg: Annotated[float, Field(ge=0, le=_MAX_DEG)] = 0.0
    at_most_deg: Annotated[float, Field(gt=0, le=_MAX_DEG)] = 1_000_000.0
    net_deg: Annotated[float, Field(ge=-_MAX_DEG, le=_MAX_DEG)] | None = None
    net_within: Annotated[float, Field(gt=0, le=_MAX_DEG)] = 10.0

    def evaluate(self, evidence: Evidence) -> CheckResult:
        total, net = (math.degrees(one) for one in evidence.turned_rad)
        pointer, is_much = evidence.last_pointer_of(*TURNING), total > self.at_most_deg
        is_within = self.at_least_deg <= total <= self.at_most_deg
        if is_within and self.net_deg is not None and abs(net - self.net_deg) > self.net_within:
            values, code = (
                {"measured_deg": net, "target_deg": self.net_deg},
                "check_turned_total_net",
            )
            return CheckResult(False, net, self.net_deg, pointer, code, values, "measured_net")
        target = self.at_most_deg if is_much else self.at_least_deg
        return CheckResult(
            passed=is_within,
            measured=total,
            target=target,
            pointer=None if is_within else pointer,
            code="check_turned_total_much" if is_much else "check_turned_total",
            values={"measured_deg": total, "target_deg": target},
            progress="measured_turned",
            is_irrecoverable=is_much,
        )

    def criterion(self, language: str) -> str:
        min_deg, max_deg = self.at_least_deg, self.at_most_deg
        code = "criterion_turned_range"
        if max_deg >= NO_LIMIT or min_deg <= 0:
            code = "criterion_turned_least" if max_deg >= NO_LIMIT else "criterion_turned_most"
        turned = text(code, language, least_deg=min_deg, most_deg=max_deg)
        if self.net_deg is None:
            return turned
        if self.net_deg == 0:
            return text("criterion_turned_balanced", language, turned=turned)
        net = {"net_deg": abs(self.net_deg), "side": side(self.net_deg, language)}
        return text("criterion_turned_net", language, turned=turned, **net)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        turned = rounded(math.degrees(solution.turned_rad[0]), 0)
        limits = {"at_least_deg": max(0.0, turned - 10), "at_most_deg": turned + 10}
        return limits if turned else None

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        min_deg = max(0.0, self.at_least_deg - tolerance.turn_deg)
        max_deg = self.at_most_deg * (1 + tolerance.path) + tolerance.turn_deg
        within = max(self.net_within, tolerance.turn_deg)
        changes = {"at_least_deg": min_deg, "at_most_deg": max_deg, "net_within": within}
        return self.model_copy(update=changes)
