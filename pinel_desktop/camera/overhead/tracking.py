"""Follows the robot's marker picture by picture, and notices a lost, covered and moved camera."""

import math
from collections import deque
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from pinel_desktop.camera.overhead.detection import Corners, find_markers
from pinel_desktop.camera.overhead.lens import SQUARE, Lens, estimate_lens, heading_of
from pinel_desktop.camera.overhead.markers import (
    FLOOR_MARKERS,
    MARKER_M,
    ROBOT_MARKER,
    OverheadSetup,
)
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.robot import Pose2D, wrap_angle

_N_CALIBRATION = 8  # pictures whose floor markers are averaged
_STILL_PX = 1.5  # a floor marker of a camera at rest stays within
_MOVED_PX = (
    3.0  # floor markers farther from where they were mean that the camera moved, or a marker
)
_MOVED_TIMES = 3  # in so many pictures in a row
_LOST_S = 0.5  # without the robot's marker
_EDGE = 1.5  # sides of the marker: a robot last seen so near the edge of the picture has left it
_CORNER_PX = 0.25  # one sigma of a corner in a blurred, noisy picture
_PLACING_M = 0.003  # one sigma of a printed sheet laid by hand, on the floor and on the robot
_PLACING_RAD = math.radians(0.3)

Problem = Literal[
    "overhead_floor_missing",
    "overhead_setup_wrong",
    "overhead_moved",
    "overhead_marker_moved",
    "overhead_covered",
    "overhead_left",
]


@dataclass(frozen=True, slots=True)
class MarkerPose:
    """Where the robot is, in the frame of the floor, with one sigma of each coordinate and of the heading."""

    pose: Pose2D
    sigma_m: float
    sigma_rad: float


@dataclass(frozen=True, slots=True)
class Sighting:
    """What a picture shows.

    Attributes:
        seen: None while the robot's marker or the camera's place is unknown.
        problem: what a person can mend, None for nothing; a robot that is missed for less than half a second is none.
        missing: numbers of the floor markers that are missed, from 1, for `overhead_floor_missing` and
            `overhead_marker_moved`.
        markers: numbers of the markers in the picture, from 1; the robot's is 5.
    """

    seen: MarkerPose | None
    problem: Problem | None = None
    missing: tuple[int, ...] = ()
    markers: tuple[int, ...] = ()

    @property
    def pose_and_sigma(self) -> list[float] | None:
        """x, y (m) and heading (rad) of the robot, and one sigma of place and heading; None if it is not seen."""
        seen = self.seen
        return [*seen.pose, seen.sigma_m, seen.sigma_rad] if seen else None


class OverheadTracker:
    """Tracks one robot in the pictures of one camera.

    The floor's markers are its calibration. When the camera has moved, the tracker says so and calibrates anew as soon
    as it rests and sees all four: the frame of the floor stays the same, as the markers stay.
    """

    def __init__(self, setup: OverheadSetup) -> None:
        self._setup = setup
        self._lens: Lens | None = None
        self._reference: dict[int, Corners] = {}
        self._collected: deque[dict[int, Corners]] = deque(maxlen=_N_CALIBRATION)
        self._n_moved = 0
        self._has_moved = False
        self._last_s: float | None = None
        self._left_picture = False

    @property
    def lens(self) -> Lens | None:
        """The calibrated camera; None before, and after it was moved."""
        return self._lens

    def update(self, time_s: float, picture: Picture) -> Sighting:
        """Returns what the next picture shows."""
        if self._last_s is None:
            self._last_s = time_s
        markers = find_markers(picture)
        numbers = tuple(number + 1 for number in sorted(markers))
        return replace(self._sighting(time_s, picture, markers), markers=numbers)

    def _sighting(self, time_s: float, picture: Picture, markers: dict[int, Corners]) -> Sighting:
        height, width = picture.shape[:2]
        floor = {number: markers[number] for number in FLOOR_MARKERS if number in markers}
        if self._lens is None:
            self._calibrate(floor, (width, height))
        elif off := self._displaced(floor):
            return self._moved(off, floor)
        if self._lens is None:
            return self._uncalibrated(floor)
        robot = markers.get(ROBOT_MARKER)
        if robot is None:
            return self._missed(time_s)
        self._last_s, self._left_picture = time_s, _is_at_edge(robot, width, height)
        return Sighting(self._seen(self._lens, robot))

    def _calibrate(self, floor: dict[int, Corners], size_px: tuple[int, int]) -> None:
        if len(floor) < len(FLOOR_MARKERS):
            self._collected.clear()
            return
        if self._collected and _shift(self._collected[-1], floor) > _STILL_PX:
            self._collected.clear()
        self._collected.append(floor)
        if len(self._collected) == _N_CALIBRATION:
            mean = {
                number: np.mean([one[number] for one in self._collected], axis=0)
                for number in FLOOR_MARKERS
            }
            self._lens = estimate_lens(mean, self._setup, size_px)
            if self._lens:
                self._reference, self._has_moved, self._n_moved = mean, False, 0

    def _displaced(self, floor: dict[int, Corners]) -> list[int]:
        """Returns the floor markers that have been displaced in the last pictures."""
        off = [
            number for number, corners in floor.items()
            if np.linalg.norm(corners.mean(axis=0) - self._reference[number].mean(axis=0)) > _MOVED_PX
        ]  # fmt: skip
        self._n_moved = self._n_moved + 1 if off else 0
        return off

    def _moved(self, off: list[int], floor: dict[int, Corners]) -> Sighting:
        """Handles displaced markers: poses of these pictures would be wrong."""
        if self._n_moved < _MOVED_TIMES:
            return Sighting(None)
        if len(off) == 1 and len(floor) > 2:  # the others are where they were
            return Sighting(None, "overhead_marker_moved", (off[0] + 1,))
        self._lens, self._has_moved = None, True
        self._collected.clear()
        return Sighting(None, "overhead_moved")

    def _uncalibrated(self, floor: dict[int, Corners]) -> Sighting:
        missing = tuple(number + 1 for number in FLOOR_MARKERS if number not in floor)
        if self._has_moved:
            return Sighting(None, "overhead_moved", missing)
        if missing:
            return Sighting(None, "overhead_floor_missing", missing)
        is_wrong = len(self._collected) == _N_CALIBRATION
        return Sighting(None, "overhead_setup_wrong" if is_wrong else None)

    def _missed(self, time_s: float) -> Sighting:
        assert self._last_s is not None
        if time_s - self._last_s < _LOST_S:
            return Sighting(None)
        return Sighting(None, "overhead_left" if self._left_picture else "overhead_covered")

    def _seen(self, lens: Lens, robot: Corners) -> MarkerPose:
        level = self._setup.robot_m
        corners = lens.on_plane(robot, level)
        x, y = (float(value) for value in corners.mean(axis=0))
        # the top of the sheet points ahead
        pose = Pose2D(x, y, wrap_angle(heading_of(corners) + math.pi / 2))
        metres_per_px = MARKER_M / float(
            np.linalg.norm(robot - np.roll(robot, 1, axis=0), axis=1).mean()
        )
        corner_m = _CORNER_PX * metres_per_px
        radius_m = float(np.linalg.norm(SQUARE[0]))
        return MarkerPose(
            pose,
            math.hypot(corner_m / 2, _PLACING_M, lens.error_m),
            math.hypot(corner_m / 2 / radius_m, _PLACING_RAD),
        )


def _shift(before: dict[int, Corners], now: dict[int, Corners]) -> float:
    """Returns by how many px a marker has moved at most."""
    return max(
        float(np.linalg.norm(now[number].mean(axis=0) - corners.mean(axis=0)))
        for number, corners in before.items()
    )


def _is_at_edge(robot: Corners, width: int, height: int) -> bool:
    margin = _EDGE * float(np.linalg.norm(robot[0] - robot[1]))
    x, y = robot.mean(axis=0)
    return bool(min(x, y, width - x, height - y) < margin)
