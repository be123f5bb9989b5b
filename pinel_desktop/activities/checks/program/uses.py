from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import (
    NO_LIMIT,
    CheckBase,
    CheckFault,
    CheckResult,
    Name,
    counted,
    limits_faults,
    text,
)
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.program.model import action_names
from sim.world import World


class Uses(CheckBase):
    """The program has from `at_least` (1) to `at_most` commands with the `action`."""

    requires = None
    check: Literal["uses"]
    action: Name
    at_least: Annotated[int, Field(ge=0, le=20_000)] = 1
    at_most: Annotated[int, Field(ge=0, le=20_000)] = 20_000

    def evaluate(self, evidence: Evidence) -> CheckResult:
        found = [one for one in evidence.commands if one.action == self.action]
        n, passed = len(found), self.at_least <= len(found) <= self.at_most
        target, pointer, ending = self.at_least, None, "" if n else "_none"
        if n > self.at_most:
            target, pointer, ending = self.at_most, found[-1].pointer, "_too_many"
        values: dict[str, Any] = {"name": self.action, "measured": n, "target": target}
        code = f"check_uses{ending}"
        return CheckResult(passed, n, target, pointer, code, values, is_irrecoverable=not passed)

    def criterion(self, language: str) -> str:
        min_n, max_n, name = self.at_least, self.at_most, self.action
        if max_n >= NO_LIMIT:
            return counted("criterion_uses", min_n, language, name=name)
        if min_n in (0, 1) or max_n == 0:
            return counted("criterion_uses_most", max_n, language, name=name)
        return text("criterion_uses_range", language, name=name, least=min_n, most=max_n)

    def faults(self, world: World | None) -> Iterator[CheckFault]:
        if self.action not in action_names():
            params: dict[str, object] = {"value": self.action, "allowed": action_names()}
            yield CheckFault(("action",), "unknown_action", params)
        yield from limits_faults("at_least", self.at_least, self.at_most)
