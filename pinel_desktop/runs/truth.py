"""Where a real robot truly was in a run, by a source of truth that is not its odometry.

Poses are in the frame of the start, as a person measures them: from the start mark, x ahead, y to the left, heading
counterclockwise, in metres and radians. Each has a standard uncertainty (one sigma) of position and heading.
"""

import math
from bisect import bisect_left
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import Pose2D
from pinel_desktop.robot.geometry import wrap_angle
from storage import TruePoseRow, TruthRow
from storage.limits import FARTHEST_M, MAX_TRUE_POSES

Source = Literal["tape", "camera", "localisation"]
# one sigma of a person's measurement with a tape and a protractor
TAPE_SIGMA_M = 0.01
TAPE_SIGMA_RAD = math.radians(2)
# a robot's centre may be so far outside of its room: the room is as the teacher typed it
_OUTSIDE_M = 1.0
# between poses that are farther apart nothing is known: half a second
_GAP_TICKS = 15
_N_FIRST = 10  # poses that tell where the start is
_DURING_RUN: tuple[Source, ...] = ("camera", "localisation")
# by so much, and by such a share of the way, the robot's own estimate of a movement may be wrong
_DRIFT_M, _DRIFT_RAD, _DRIFT_SHARE = 0.3, math.radians(20), 0.2
_SIGMA = (1e-5, FARTHEST_M)
_BOUNDS = {
    "x_m": (-FARTHEST_M, FARTHEST_M),
    "y_m": (-FARTHEST_M, FARTHEST_M),
    "heading_rad": (-math.tau, math.tau),
    "sigma_m": _SIGMA,
    "sigma_rad": (1e-5, math.pi),
}


class TruePose(NamedTuple):
    """A pose of the robot.

    Attributes:
        tick: robot time in steps of 1/30 s; None where the robot stood after the run.
        sigma_m, sigma_rad: standard uncertainty of each coordinate of the position, and of the heading.
    """

    tick: int | None
    pose: Pose2D
    sigma_m: float
    sigma_rad: float


@dataclass(frozen=True, slots=True)
class Truth:
    """What one source says about a run; the poses are in the order of their ticks, and there is at least one."""

    source: Source
    poses: tuple[TruePose, ...]

    @property
    def end(self) -> TruePose:
        """The pose after the run, or the last one that the source saw."""
        return self.poses[-1]

    @property
    def during_run(self) -> tuple[TruePose, ...]:
        """The poses during the run."""
        return self.poses[:-1] if self.poses[-1].tick is None else self.poses

    def at(self, tick: float) -> TruePose | None:
        """Returns the pose at a tick, interpolated; None where the source saw nothing for half a second around it."""
        poses = self.during_run
        after = bisect_left(poses, tick, key=_tick)
        if after < len(poses) and _tick(poses[after]) == tick:
            return poses[after]
        if not 0 < after < len(poses):
            return None
        return _between(poses[after - 1], poses[after], tick)

    @property
    def covered_ticks(self) -> int:
        """The part of the run of which the source knows the robot's place, in ticks."""
        ticks = [round(_tick(pose)) for pose in self.during_run]
        gaps = (after - before for before, after in pairwise(ticks))
        return sum(gap for gap in gaps if gap <= _GAP_TICKS)

    def as_rows(self) -> list[TruePoseRow]:
        """Returns the poses as the store records them."""
        return [(tick, *pose, sigma, sigma_rad) for tick, pose, sigma, sigma_rad in self.poses]


def truths_of(rows: Iterable[TruthRow]) -> list[Truth]:
    """Returns the truths of a run (`store.truths.of_run`)."""
    return [
        Truth(
            row.source,  # type: ignore[arg-type] # the store accepts these sources only
            tuple(
                TruePose(tick, Pose2D(x, y, yaw), *sigmas) for tick, x, y, yaw, *sigmas in row.poses
            ),
        )
        for row in rows
    ]


def read_truth(source: Source, poses: Iterable[TruePoseRow]) -> Truth | None:
    """Checks what a source says; None for no poses.

    Raises:
        PinelError: `truth_range` with field, value and bounds; `truth_order` if ticks do not grow; `truth_too_many`.
    """
    checked = tuple(map(_checked, poses))
    ticks = [_tick(pose) for pose in checked]
    if any(before >= after for before, after in pairwise(ticks)):
        raise PinelError("truth_order")
    if len(checked) > MAX_TRUE_POSES:
        raise PinelError("truth_too_many", n=len(checked), max=MAX_TRUE_POSES)
    return Truth(source, checked) if checked else None


def in_start_frame(
    seen: Sequence[TruePose], believed: Callable[[int], Pose2D | None]
) -> list[TruePose]:
    """Converts poses of another frame, such as a map's or a camera's, to the frame of the start.

    The robot's own estimate of the first poses tells where the start is in that frame: a robot that has hardly moved
    knows where it is. The uncertainty of that start turns all later poses, so it counts in theirs.

    Args:
        seen: poses with ticks, in their order.
        believed: returns the robot's own estimate at a tick, in the frame of the start; None if unknown.
    """
    known = [(pose, own) for pose in seen if pose.tick is not None and (own := believed(pose.tick))]
    starts = [
        pose.pose.compose(Pose2D().relative_to(own)) for pose, own in known[:_N_FIRST]
    ]  # fmt: skip
    if not starts:
        return []
    start = _mean(starts)
    sigma_rad = known[0][0].sigma_rad / math.sqrt(len(starts))
    aligned = []
    for pose in seen:
        place = pose.pose.relative_to(start)
        turned_m = sigma_rad * math.hypot(place.x_m, place.y_m)
        aligned.append(
            pose._replace(
                pose=place,
                sigma_m=math.hypot(pose.sigma_m, turned_m),
                sigma_rad=min(math.pi, math.hypot(pose.sigma_rad, sigma_rad)),
            )
        )
    return aligned


def moves_alike(before: tuple[Pose2D, Pose2D], after: tuple[Pose2D, Pose2D]) -> bool:
    """Returns whether a source saw the movement that the robot itself believes; if not, one of its poses is wrong.

    Args:
        before, after: the pose of the source and the robot's own estimate, each in a frame of its own.
    """
    seen, own = (after[n].relative_to(before[n]) for n in range(2))
    off_m = math.hypot(seen.x_m - own.x_m, seen.y_m - own.y_m)
    off_rad = abs(wrap_angle(seen.yaw_rad - own.yaw_rad))
    moved_m = math.hypot(own.x_m, own.y_m)
    return (
        off_m <= _DRIFT_M + _DRIFT_SHARE * moved_m
        and off_rad <= _DRIFT_RAD + _DRIFT_SHARE * abs(own.yaw_rad)
    )


def check_in_room(pose: Pose2D, start: Pose2D, width_m: float, depth_m: float) -> None:
    """Raises PinelError `truth_outside_room` if a measured pose is more than a metre outside of the robot's room.

    Args:
        start: the start in the room's frame, whose origin is the centre of the room.
    """
    place = start.compose(pose)
    over = max(abs(place.x_m) - width_m / 2, abs(place.y_m) - depth_m / 2)
    if over > _OUTSIDE_M:
        raise PinelError("truth_outside_room", width=width_m, depth=depth_m)


def best_at_end(truths: Iterable[Truth]) -> Truth | None:
    """Returns the truth that knows best where the robot stood after the run; None for no truths."""
    return min(truths, key=lambda truth: truth.end.sigma_m, default=None)


def best_during_run(truths: Iterable[Truth]) -> Truth | None:
    """Returns the truth to compare a path with: the camera's before the robot's own localisation; None for neither."""
    found = {truth.source: truth for truth in truths if len(truth.during_run) > 1}
    return next((found[source] for source in _DURING_RUN if source in found), None)


def _mean(poses: Sequence[Pose2D]) -> Pose2D:
    n = len(poses)
    sin = sum(math.sin(pose.yaw_rad) for pose in poses)
    cos = sum(math.cos(pose.yaw_rad) for pose in poses)
    return Pose2D(
        sum(pose.x_m for pose in poses) / n,
        sum(pose.y_m for pose in poses) / n,
        math.atan2(sin, cos),
    )


def _checked(row: TruePoseRow) -> TruePose:
    tick, *values = row
    for (field, (low, high)), value in zip(_BOUNDS.items(), values, strict=True):
        if not low <= value <= high:  # also refuses NaN
            raise PinelError("truth_range", field=field, value=value, low=low, high=high)
    if tick is not None and tick < 0:
        raise PinelError("truth_range", field="tick", value=tick, low=0, high=math.inf)
    x, y, heading, sigma_m, sigma_rad = values
    return TruePose(tick, Pose2D(x, y, wrap_angle(heading)), sigma_m, sigma_rad)


def _tick(pose: TruePose) -> float:
    return math.inf if pose.tick is None else pose.tick


def _between(before: TruePose, after: TruePose, tick: float) -> TruePose | None:
    first, last = _tick(before), _tick(after)
    if last - first > _GAP_TICKS:
        return None
    part = (tick - first) / (last - first)
    (x, y, yaw), (x1, y1, yaw1) = before.pose, after.pose
    pose = Pose2D(
        x + part * (x1 - x), y + part * (y1 - y), wrap_angle(yaw + part * wrap_angle(yaw1 - yaw))
    )
    return TruePose(
        round(tick),
        pose,
        max(before.sigma_m, after.sigma_m),
        max(before.sigma_rad, after.sigma_rad),
    )
