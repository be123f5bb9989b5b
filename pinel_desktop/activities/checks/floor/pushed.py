from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import (
    CheckBase,
    CheckFault,
    CheckResult,
    Name,
    Path,
)
from pinel_desktop.activities.evidence import Evidence
from sim.world import World


class Pushed(CheckBase):
    """The centre of box number `box` of the world, from 0, ends in the `zone`."""

    requires = "boxes"
    check: Literal["pushed"]
    box: Annotated[int, Field(ge=0, lt=1000)]
    zone: Name

    def evaluate(self, evidence: Evidence) -> CheckResult:
        place = evidence.boxes.get(self.box)
        zone = evidence.zone_at(*place) if place else ""
        off_m = evidence.off_zone_m(self.zone, *place) if place else 0.0
        values, pointer = {"off_m": off_m, "zone": self.zone}, evidence.last_motion
        passed, code = zone == self.zone, "check_pushed"
        return CheckResult(passed, zone, self.zone, pointer, code, values, "measured_off")

    def zones_named(self) -> dict[Path, str]:
        return {("zone",): self.zone}

    def faults(self, world: World | None) -> Iterator[CheckFault]:
        yield from super().faults(world)
        if world is None or (self.box < len(world.boxes) and world.boxes[self.box].movable):
            return
        movable = [i for i, one in enumerate(world.boxes) if one.movable]
        params: dict[str, object] = {"value": self.box, "allowed": movable}
        yield CheckFault(("box",), "activity_unknown_box", params)
