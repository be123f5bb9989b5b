"""Telemetry of a run: rows, their hash, path length."""

import hashlib
import math
import sys
from array import array
from collections.abc import Callable
from operator import sub

from pinel_desktop.robot import Pose2D


class Recorder:
    """Collects one row of float64 per tick: tick, x, y, yaw, v, w, commanded v, commanded w (start frame, SI).

    Attributes:
        add: appends a row given as a tuple; the array's bound method, for speed.
    """

    COLUMNS = 8

    def __init__(self) -> None:
        self.rows = array("d")
        self.add: Callable[[tuple[float, ...]], None] = self.rows.extend

    def path_length_m(self) -> float:
        """Length of the path through the start and all recorded positions."""
        xs, ys = (array("d", [0.0]) + self.rows[column :: self.COLUMNS] for column in (1, 2))
        return sum(map(math.hypot, map(sub, xs[1:], xs), map(sub, ys[1:], ys)))

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
