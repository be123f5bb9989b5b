"""Evaluation of checks after a run: one function for each kind of check."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from pinel_desktop.activities import check_kinds as kinds
from pinel_desktop.events.model import Event, Telemetry, Things
from pinel_desktop.execution.executor import RunResult
from pinel_desktop.robot import Pose2D
from sim.floor import zone_at
from sim.world import World


@dataclass(slots=True)
class RunObserver:
    """Collects from the events of a run what checks need; `observe` must receive all of them.

    Attributes:
        pose: latest true pose of the robot, in the world's frame.
        zones: names of the zones that the robot entered, in order, one for each entry.
        touched: True once the robot has touched something.
        boxes: centres of pushed boxes in the world's frame, in m, by index in the world's list.
    """

    world: World
    pose: Pose2D = field(init=False)
    zones: list[str] = field(default_factory=list)
    touched: bool = False
    boxes: dict[int, tuple[float, float]] = field(default_factory=dict)
    _start: Pose2D = field(init=False)

    def __post_init__(self) -> None:
        self.pose = self._start = Pose2D(*self.world.start)
        self._note_zone()

    def observe(self, event: Event) -> None:
        if type(event) is Telemetry:
            self.pose = self._start.compose(_true_pose(event))
            self.touched = self.touched or event.bumper
            self._note_zone()
        elif type(event) is Things:
            self.boxes |= {int(i): (place[0], place[1]) for i, place in event.boxes.items()}

    def zone_of(self, x_m: float, y_m: float) -> str:
        """Name of the zone at a point in the world's frame; "" outside of all zones."""
        return zone_at(self.world.zones, x_m, y_m)

    def to_world(self, x_m: float, y_m: float) -> tuple[float, float]:
        """Transforms a point from the start frame to the world's frame."""
        pose = self._start.compose(Pose2D(x_m, y_m))
        return pose.x_m, pose.y_m

    @property
    def local_pose(self) -> Pose2D:
        """`pose` in the start frame."""
        return self.pose.relative_to(self._start)

    def _note_zone(self) -> None:
        zone = self.zone_of(self.pose.x_m, self.pose.y_m)
        if zone and (not self.zones or self.zones[-1] != zone):
            self.zones.append(zone)


@dataclass(frozen=True, slots=True)
class Evidence:
    """The input of all checks."""

    document: dict[str, Any]
    result: RunResult
    observed: RunObserver


def holds(check: Any, evidence: Evidence) -> bool:
    """True if a check of an activity holds."""
    return _CHECKS[type(check)](check, evidence)


def _finished(_check: kinds.Finished, evidence: Evidence) -> bool:
    return evidence.result.ended.state == "finished"


def _ends_at(check: kinds.EndsAt, evidence: Evidence) -> bool:
    pose = evidence.observed.local_pose
    return math.hypot(pose.x_m - check.x_m, pose.y_m - check.y_m) <= check.within_m


def _ends_heading(check: kinds.EndsHeading, evidence: Evidence) -> bool:
    heading = math.degrees(evidence.observed.local_pose.yaw_rad)
    return abs(math.remainder(heading - check.heading_deg, 360.0)) <= check.within_deg


def _ends_in(check: kinds.EndsIn, evidence: Evidence) -> bool:
    observed = evidence.observed
    return observed.zone_of(observed.pose.x_m, observed.pose.y_m) == check.zone


def _visits(check: kinds.Visits, evidence: Evidence) -> bool:
    zones = evidence.observed.zones
    if not check.ordered:
        return set(check.zones) <= set(zones)
    rest = iter(zones)
    return all(zone in rest for zone in check.zones)


def _touches_nothing(_check: kinds.TouchesNothing, evidence: Evidence) -> bool:
    return not evidence.observed.touched


def _pushed(check: kinds.Pushed, evidence: Evidence) -> bool:
    observed = evidence.observed
    if check.box >= len(observed.world.boxes):
        return False
    x, y = observed.boxes.get(check.box, observed.world.boxes[check.box].center)
    return observed.zone_of(x, y) == check.zone


def _uses(check: kinds.Uses, evidence: Evidence) -> bool:
    n = sum(action == check.action for action in _actions(evidence.document))
    return check.at_least <= n <= check.at_most


def _marks(check: kinds.Marks, evidence: Evidence) -> bool:
    observed = evidence.observed
    places = (
        observed.to_world(mark.x_m, mark.y_m)
        for mark in evidence.result.marks
        if mark.symbol == check.symbol
    )
    return any(observed.zone_of(*place) == check.zone for place in places)


def _says(check: kinds.Says, evidence: Evidence) -> bool:
    wanted = check.text.casefold()
    return any(wanted in text.casefold() for text in evidence.result.said)


def _path_length(check: kinds.PathLength, evidence: Evidence) -> bool:
    return check.at_least_m <= evidence.result.ended.path_length_m <= check.at_most_m


_CHECKS: dict[type, Callable[[Any, Evidence], bool]] = {
    kinds.Finished: _finished,
    kinds.EndsAt: _ends_at,
    kinds.EndsHeading: _ends_heading,
    kinds.EndsIn: _ends_in,
    kinds.Visits: _visits,
    kinds.TouchesNothing: _touches_nothing,
    kinds.Pushed: _pushed,
    kinds.Uses: _uses,
    kinds.Marks: _marks,
    kinds.Says: _says,
    kinds.PathLength: _path_length,
}


def _actions(value: Any) -> Iterator[str]:
    """The actions of all commands in a document."""
    if isinstance(value, dict):
        if isinstance(value.get("action"), str):
            yield value["action"]
        for part in value.values():
            yield from _actions(part)
    elif isinstance(value, list):
        for part in value:
            yield from _actions(part)


def _true_pose(event: Telemetry) -> Pose2D:
    if event.true_x_m is None or event.true_y_m is None or event.true_yaw_rad is None:
        return Pose2D(event.x_m, event.y_m, event.yaw_rad)
    return Pose2D(event.true_x_m, event.true_y_m, event.true_yaw_rad)
