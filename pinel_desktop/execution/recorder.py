"""Telemetry of a run: rows, their hash, and the distances that follow from them."""

import hashlib
import math
import sys
from array import array
from collections.abc import Callable, Sequence
from operator import sub
from typing import NamedTuple

from pinel_desktop.execution.semantics import TRUE_CLOSING_ERROR_SINCE
from pinel_desktop.robot import Pose2D

PATH_STEP_M = 0.002  # between true poses; a shorter motion is the wheels' slip in a turn
MEASURED_STEP_M = 0.02  # between poses that a real robot measures; a shorter motion is noise


class Distances(NamedTuple):
    """The distances that a run reports at its end, in m, as in the event `run_ended`."""

    path_length_m: float
    closing_error_m: float | None
    estimated_closing_error_m: float | None


class TelemetryRecorder:
    """Collects one row of float64 per tick: tick, x, y, yaw, v, w, commanded v, commanded w (start frame, SI).

    Attributes:
        add: appends a row given as a tuple; the array's bound method, for speed.
        add_true: appends the true position, x and y, if the robot's pose is an estimate; in any frame.
        true_start: the true position before the first row, in the same frame; None if unknown.
    """

    COLUMNS = 8

    def __init__(self) -> None:
        self.rows = array("d")
        self.add: Callable[[tuple[float, ...]], None] = self.rows.extend
        self._true = array("d")
        self.add_true: Callable[[tuple[float, float]], None] = self._true.extend
        self.true_start: tuple[float, float] | None = None

    def distances(self, *, simulated: bool, semantics: int) -> Distances:
        """Returns the distances that a run reports at its end, as a semantics version defines them (`semantics.py`)."""
        estimated_m = self.estimated_closing_error_m()
        length_m = self.true_path_length_m() if simulated else self.measured_path_length_m()
        if semantics < TRUE_CLOSING_ERROR_SINCE:
            return Distances(length_m, estimated_m, None)
        return Distances(length_m, self.true_closing_error_m(), estimated_m)

    def estimated_closing_error_m(self) -> float:
        """Distance of the last pose from the start, as the robot estimates it."""
        pose = self.last_pose()
        return math.hypot(pose.x_m, pose.y_m)

    def true_closing_error_m(self) -> float | None:
        """Distance of the last true position from the start; None if unknown."""
        if self.true_start is None:
            return None
        return (
            math.dist(self._true[-2:], self.true_start)
            if self._true
            else self.estimated_closing_error_m()
        )

    def true_path_length_m(self) -> float:
        """Returns the length of the true path if it was recorded, else of the robot's own path."""
        if not self._true:
            return self.path_length_m()
        return _path_length_m(self._true[::2], self._true[1::2], PATH_STEP_M)

    def measured_path_length_m(self) -> float:
        """Returns the length of a real robot's path by its own poses, without their noise."""
        return _path_length_m(*self._positions(), MEASURED_STEP_M)

    def path_length_m(self) -> float:
        """Length of the path through the start and all recorded positions."""
        xs, ys = self._positions()
        return sum(map(math.hypot, map(sub, xs[1:], xs), map(sub, ys[1:], ys)))

    def _positions(self) -> "tuple[array[float], array[float]]":
        """The start and all recorded positions."""
        xs, ys = (array("d", [0.0]) + self.rows[column :: self.COLUMNS] for column in (1, 2))
        return xs, ys

    def last_pose(self) -> Pose2D:
        """Pose of the newest row; the start without rows."""
        return Pose2D(*self.rows[-7:-4]) if self.rows else Pose2D()

    def sha256(self) -> str:
        """SHA-256 of the rows as little-endian float64 (docs/program-document.md, telemetry_sha256)."""
        rows = self.rows
        if sys.byteorder == "big":
            rows = array("d", rows)
            rows.byteswap()
        return hashlib.sha256(rows).hexdigest()


def _path_length_m(xs: Sequence[float], ys: Sequence[float], min_step_m: float) -> float:
    """Returns the length of a path in steps of at least `min_step_m`, and to the last position."""
    length_m, x, y = 0.0, xs[0], ys[0]
    for new_x, new_y in zip(xs, ys, strict=True):
        step = math.hypot(new_x - x, new_y - y)
        if step >= min_step_m:
            length_m, x, y = length_m + step, new_x, new_y
    return length_m + math.hypot(xs[-1] - x, ys[-1] - y)
