"""The evidence that checks evaluate: document, world and log of a run, and nothing else."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.activities.commands import Command, commands_of
from pinel_desktop.activities.drawing import Points, Sampled, at_steps, length, sampled
from pinel_desktop.activities.run_log import RunLog, Wire
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.recorder import MEASURED_STEP_M, PATH_STEP_M
from pinel_desktop.program.model import MOTIONS
from sim.floor import Disc, Rectangle, Zone
from sim.world import World

_DOT_M = 0.01  # a shorter line is invisible
_COUNTED_RAD = np.radians(2.0)
_CAPTURES = {"classify_gestures": "sign", "read_number": "number"}


class StartedCommand(NamedTuple):
    """A command that started.

    Attributes:
        tick: the tick before the command's first tick.
        amount: its goal in m, degrees or s; None without one.
        ended: the tick at which the command ended; None if it did not end.
    """

    tick: int
    pointer: str
    action: str
    amount: float | None
    block: str | None
    ended: int | None


class Trail(NamedTuple):
    """A drawn line in the start frame, shape (n, 2), in m, and the tick of its first point."""

    line: Points
    tick: int


@dataclass(frozen=True)
class Evidence:
    """The input of all checks."""

    document: Mapping[str, Any]
    world: World
    log: RunLog
    commands: tuple[Command, ...] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "commands", commands_of(self.document))

    @cached_property
    def end(self) -> tuple[float, float, float]:
        """The last pose in the start frame, m and rad."""
        x, y, yaw = self.log.poses[-1]
        return float(x), float(y), float(yaw)

    @cached_property
    def path(self) -> Points:
        """The path in the start frame without noise, shape (n, 2), in m."""
        step_m = PATH_STEP_M if self.log.is_true else MEASURED_STEP_M
        return at_steps(self.log.poses[:, :2], step_m)

    @cached_property
    def path_m(self) -> float:
        """Length of the path without noise, in m."""
        return length(self.path)

    @cached_property
    def turned_rad(self) -> tuple[float, float]:
        """Sum of all turning without and with sign (positive: left), in rad, without noise."""
        yaw = np.unwrap(self.log.poses[:, 2])
        return _swing(yaw.tolist(), _COUNTED_RAD), float(yaw[-1] - yaw[0])

    @cached_property
    def duration_s(self) -> float:
        """Robot time, in s."""
        return (len(self.log.poses) - 1) / TICK_HZ

    @cached_property
    def in_world(self) -> Points:
        """The positions of all ticks in the world's frame, shape (n + 1, 2), in m."""
        return self.to_world(self.log.poses[:, :2])

    def to_world(self, points: Points) -> Points:
        """Transforms points, shape (n, 2), from the start frame to the world's frame."""
        x, y, yaw = self.world.start
        cos, sin = np.cos(yaw), np.sin(yaw)
        moved: Points = points @ np.array([[cos, sin], [-sin, cos]]) + (x, y)
        return moved

    def to_start(self, x_m: float, y_m: float) -> tuple[float, float]:
        """Transforms a point from the world's frame to the start frame."""
        x, y, yaw = self.world.start
        cos, sin = np.cos(yaw), np.sin(yaw)
        dx, dy = x_m - x, y_m - y
        return float(cos * dx + sin * dy), float(cos * dy - sin * dx)

    @cached_property
    def entries(self) -> tuple[tuple[str, int], ...]:
        """Names of the zones that the robot's centre entered, with ticks, in order; no zone twice in a row."""
        indices = _zone_indices(self.world.zones, self.in_world)
        entered: list[tuple[str, int]] = []
        for tick in np.flatnonzero(np.diff(indices, prepend=-2)).tolist():
            name = self.world.zones[indices[tick]].name if indices[tick] >= 0 else ""
            if name and (not entered or entered[-1][0] != name):
                entered.append((name, tick))
        return tuple(entered)

    @cached_property
    def zones(self) -> tuple[str, ...]:
        """Names of the zones that the robot's centre entered, in order."""
        return tuple(name for name, _ in self.entries)

    def zone_at(self, x_m: float, y_m: float) -> str:
        """Name of the zone at a point in the world's frame; "" outside of all zones."""
        index = int(_zone_indices(self.world.zones, np.array([[x_m, y_m]]))[0])
        return self.world.zones[index].name if index >= 0 else ""

    def zone_center(self, name: str) -> tuple[float, float] | None:
        """Returns the centre of a zone in the world's frame; None if the world has no such zone."""
        centers = (zone.shape.center for zone in self.world.zones if zone.name == name)
        return next(centers, None)

    def off_zone_m(self, name: str, x_m: float, y_m: float) -> float:
        """Returns the distance (m) of a point in the world's frame from the centre of a zone."""
        center = self.zone_center(name)
        return math.dist((x_m, y_m), center) if center else 0.0

    @cached_property
    def end_zone(self) -> str:
        x, y = self.in_world[-1]
        return self.zone_at(float(x), float(y))

    @cached_property
    def trails(self) -> tuple[Trail, ...]:
        """Lines that the pen drew, each from a lowering of the pen to its next change."""
        found: list[Trail] = []
        last = len(self.log.poses) - 1
        pens = [event for event in self.log.events if event["type"] == "pen"]
        for i, event in enumerate(pens):
            until = pens[i + 1]["tick"] if i + 1 < len(pens) else last
            if event["down"] and until > event["tick"]:
                line = self.log.poses[event["tick"] : until + 1, :2]
                if length(at_steps(line, _DOT_M)) > _DOT_M:
                    found.append(Trail(line, event["tick"]))
        return tuple(found)

    @cached_property
    def trail_points(self) -> Sampled:
        return sampled([one.line for one in self.trails], [one.tick for one in self.trails])

    @cached_property
    def path_points(self) -> Sampled:
        return sampled([self.log.poses[:, :2]])

    @cached_property
    def boxes(self) -> dict[int, tuple[float, float]]:
        """Centres of all boxes at the end, in the world's frame (m), by index in the world's list."""
        places = {
            i: (float(b.center[0]), float(b.center[1])) for i, b in enumerate(self.world.boxes)
        }
        for event in self.log.events:
            if event["type"] == "things":
                places |= {int(i): (place[0], place[1]) for i, place in event["boxes"].items()}
        return places

    @cached_property
    def marks(self) -> tuple[Wire, ...]:
        return self._of_type("marked")

    @cached_property
    def captured(self) -> tuple[Wire, ...]:
        """The results of captures, of which `result` is "" if no sign was shown."""
        results = self._of_type("gesture_result")
        return tuple(event for event in results if event["source"] == "capture")

    @cached_property
    def shown_texts(self) -> tuple[str, ...]:
        return tuple(str(event["text"]) for event in self._of_type("said"))

    def _of_type(self, kind: str) -> tuple[Wire, ...]:
        return tuple(event for event in self.log.events if event["type"] == kind)

    @cached_property
    def started_commands(self) -> tuple[StartedCommand, ...]:
        """The commands that started, in order.

        A command without duration is reported at most five times a second for each place in the program.
        """
        open_at: dict[str, int] = {}
        found: list[StartedCommand] = []
        for event in self.log.events:
            if event["type"] == "block_started":
                open_at[event["pointer"]] = len(found)
                one = (event["pointer"], event["action"], event.get("amount"), event.get("block"))
                found.append(StartedCommand(event["tick"], *one, None))
            elif event["type"] == "block_ended" and event["pointer"] in open_at:
                index = open_at.pop(event["pointer"])
                found[index] = found[index]._replace(ended=event["tick"])
        return tuple(found)

    def n_started(self, action: str) -> int:
        """Returns how often a command started; exact for commands that take time, texts, marks, questions, signs."""
        counted = {"mark": "marked", "say": "said", "ask": "asked", "beep": "beeped"}
        if action in counted:
            return len(self._of_type(counted[action]))
        if action in _CAPTURES:
            captures = self._of_type("capture_started")  # with or without a result
            return sum(one.get("what", "sign") == _CAPTURES[action] for one in captures)
        return sum(one.action == action for one in self.started_commands)

    def motion_at(self, tick: int) -> StartedCommand | None:
        """Returns the motion that moved the robot in a tick."""
        before = [
            one
            for one in self.started_commands
            if one.action in MOTIONS and one.tick < max(tick, 1)
        ]
        return before[-1] if before else None

    @cached_property
    def last_motion(self) -> str | None:
        """Pointer of the last motion."""
        motion = self.motion_at(len(self.log.poses))
        return motion.pointer if motion else None

    def motion_towards(self, zone: str) -> str | None:
        """Returns the pointer of the motion that came nearest to a zone that the robot did not enter where it should.

        Counts from the last zone that the robot entered; if it never came nearer, returns its last motion.
        """
        center = self.zone_center(zone)
        if center is None:
            return self.last_motion
        since = self.entries[-1][1] if self.entries else 0
        distances = np.hypot(*(self.in_world[since:] - center).T)
        nearest = int(distances.argmin())
        motion = self.motion_at(since + nearest) if nearest else None
        return motion.pointer if motion else self.last_motion

    def last_pointer_of(self, *actions: str) -> str | None:
        """Returns the pointer of the last started command of these kinds."""
        found = [one.pointer for one in self.started_commands if one.action in actions]
        return found[-1] if found else None

    @cached_property
    def touch_tick(self) -> int | None:
        """The first tick in which the robot touched something."""
        ticks = np.flatnonzero(self.log.bumper)
        return int(ticks[0]) if len(ticks) else None

    @cached_property
    def running(self) -> StartedCommand | None:
        """The command that was running when the run ended, preferably without a body; None if all commands ended."""
        flow = {"conditional_execution", "call", "repeat", "while", "until", "for", "forever"}
        never = [one for one in self.started_commands if one.ended is None]
        inner = [one for one in never if one.action not in flow]
        return (inner or never)[-1] if never else None

    def command_at(self, pointer: str) -> Command | None:
        return next((one for one in self.commands if one.pointer == pointer), None)


def _swing(values: Sequence[float], min_swing: float) -> float:
    """Returns the sum of all rises and falls of the values; ignores reversals of less than `min_swing`."""
    turning_point = extreme = values[0]
    total, direction = 0.0, 0.0
    for value in values:
        beyond = (value - extreme) * (direction or 1.0)
        if direction == 0.0 and abs(value - extreme) >= min_swing:
            direction, extreme = (1.0 if value > extreme else -1.0), value
        elif direction != 0.0 and beyond > 0.0:
            extreme = value
        elif direction != 0.0 and -beyond >= min_swing:
            total += abs(extreme - turning_point)
            turning_point, extreme, direction = extreme, value, -direction
    return total + abs(extreme - turning_point)


def _zone_indices(zones: Sequence[Zone], points: Points) -> NDArray[np.int64]:
    """Returns the index of the zone at each point, the last if several overlap; -1 outside all zones."""
    found = np.full(len(points), -1, dtype=np.int64)
    for i, zone in enumerate(zones):
        found[_inside(zone, points)] = i
    return found


def _inside(zone: Zone, points: Points) -> NDArray[np.bool_]:
    shape = zone.shape
    if isinstance(shape, Disc):
        away: Points = points - np.array(shape.center)
        return np.hypot(away[:, 0], away[:, 1]) <= shape.radius
    assert isinstance(shape, Rectangle)
    dx, dy = (points - np.array(shape.center)).T
    cos, sin = np.cos(shape.angle_rad), np.sin(shape.angle_rad)
    ahead, left = np.abs(cos * dx + sin * dy), np.abs(cos * dy - sin * dx)
    inside: NDArray[np.bool_] = (ahead <= shape.size[0] / 2) & (left <= shape.size[1] / 2)
    return inside
