from collections.abc import Iterator
from typing import Annotated, Any, Literal, Self

from pydantic import Field

from pinel_desktop.activities.checks.base import (
    NO_LIMIT,
    CheckBase,
    CheckFault,
    CheckResult,
    FormField,
    Length,
    RealRobotTolerance,
    limits_faults,
    rounded,
    text,
)
from pinel_desktop.activities.commands import DRIVING
from pinel_desktop.activities.evidence import Evidence
from sim.world import World

# limits whose difference is at most this share of the upper one are shown as one length
_NEAR = 0.1
_STILL_M = 0.1


class PathLength(CheckBase):
    """The path is from `at_least_m` to `at_most_m` long."""

    requires = None
    form = (
        FormField("at_least_m", "number", "least", 0, 10_000, 0.1),
        FormField("at_most_m", "number", "most", 0.1, 10_000, 0.1),
    )
    check: Literal["path_length"]
    at_least_m: Annotated[float, Field(ge=0, le=10_000)] = 0.0
    at_most_m: Length = 10_000.0

    def evaluate(self, evidence: Evidence) -> CheckResult:
        length = evidence.path_m
        is_long = length > self.at_most_m
        target = self.at_most_m if is_long else self.at_least_m
        ending = ("_still" if target < _STILL_M else "_long") if is_long else ""
        return CheckResult(
            passed=self.at_least_m <= length <= self.at_most_m,
            measured=length,
            target=target,
            pointer=evidence.last_pointer_of(*DRIVING) or evidence.last_motion,
            code=f"check_path_length{ending}",
            values={"measured_m": length, "target_m": target},
            progress="measured_way",
            is_irrecoverable=is_long,
        )

    def criterion(self, language: str) -> str:
        min_m, max_m = self.at_least_m, self.at_most_m
        if max_m <= _STILL_M:
            return text("criterion_path_still", language)
        if max_m >= NO_LIMIT:
            return text("criterion_path_least", language, least_m=min_m)
        if min_m <= 0:
            return text("criterion_path_most", language, most_m=max_m)
        if max_m - min_m <= _NEAR * max_m:
            return text("criterion_path", language, about_m=(min_m + max_m) / 2)
        return text("criterion_path_range", language, least_m=min_m, most_m=max_m)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any]:
        min_m, max_m = (rounded(solution.path_m + by, 1) for by in (-0.2, 0.2))
        return {"at_least_m": max(0.0, min_m), "at_most_m": max_m}

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        min_m = self.at_least_m * (1 - tolerance.path)
        max_m = max(self.at_most_m * (1 + tolerance.path), tolerance.move_m)
        return self.model_copy(update={"at_least_m": min_m, "at_most_m": max_m})

    def faults(self, world: World | None) -> Iterator[CheckFault]:
        return limits_faults("at_least_m", self.at_least_m, self.at_most_m)
