"""What a run leaves behind in numbers: rows of telemetry, their hash, the length of the path."""

import hashlib
import math
import sys
from array import array

from pinel_desktop.robot import Pose2D


class Recorder:
    """Keeps one row of float64 a tick: tick, x, y, yaw, v, w, commanded v, commanded w (start frame, SI)."""

    COLUMNS = 8

    def __init__(self) -> None:
        self.rows = array("d")
        self.path_length_m = 0.0
        self._x, self._y = 0.0, 0.0

    def add(
        self,
        tick: int,
        x: float,
        y: float,
        yaw: float,
        v: float,
        w: float,
        command_v: float,
        command_w: float,
    ) -> None:
        self.rows.extend((tick, x, y, yaw, v, w, command_v, command_w))
        self.path_length_m += math.hypot(x - self._x, y - self._y)
        self._x, self._y = x, y

    def last_pose(self) -> Pose2D:
        """Pose of the newest row; the start without one."""
        return Pose2D(*self.rows[-7:-4]) if self.rows else Pose2D()

    def sha256(self) -> str:
        """SHA-256 of the rows as little-endian float64 (IR.md, telemetry_sha256)."""
        rows = self.rows
        if sys.byteorder == "big":
            rows = array("d", rows)
            rows.byteswap()
        return hashlib.sha256(rows).hexdigest()
