"""What a calibration knows of one run: odometry, commands and true poses, in the run's start frame."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


class TruePose(NamedTuple):
    """A measured true pose of the robot at a tick.

    Attributes:
        tick: the tick of the run; 0 is the start.
        x_m, y_m, heading_rad: the pose in the start frame.
        sd_m, sd_rad: standard deviations of each coordinate and of the heading.
    """

    tick: int
    x_m: float
    y_m: float
    heading_rad: float
    sd_m: float
    sd_rad: float


@dataclass(frozen=True, slots=True)
class Drive:
    """One run of a robot.

    Attributes:
        odometry: (n + 1, 3) x, y in m and heading in rad by wheel odometry at ticks 0 to n; the first row is the start.
        velocity: (n + 1, 2) measured v in m/s and omega in rad/s.
        command: (n + 1, 2) commanded v and omega from each tick on.
        truth: true poses by tick, without the start.
    """

    odometry: Floats
    velocity: Floats
    command: Floats
    truth: tuple[TruePose, ...]

    def wheel_distances(self, track_m: float) -> Floats:
        """Returns the distances in m that the left and the right wheel counted in each tick, (n, 2).

        Args:
            track_m: the track with which the robot computes its odometry.
        """
        steps = np.diff(self.odometry, axis=0)
        turned = np.mod(steps[:, 2] + math.pi, 2.0 * math.pi) - math.pi
        middle = self.odometry[:-1, 2] + turned / 2.0
        ahead = steps[:, 0] * np.cos(middle) + steps[:, 1] * np.sin(middle)
        half = turned * track_m / 2.0
        return np.column_stack((ahead - half, ahead + half))
