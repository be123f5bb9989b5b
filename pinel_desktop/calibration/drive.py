"""What a calibration knows of one run: odometry, commands and true poses, in the run's start frame."""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pinel_desktop.runs.truth import TruePose

Floats = npt.NDArray[np.float64]
_STANDSTILL = np.array([0.002, 0.002, 0.005])  # m, m, rad


@dataclass(frozen=True, slots=True)
class Drive:
    """One run of a robot.

    Attributes:
        odometry: (n + 1, 3) x, y in m and heading in rad by wheel odometry at ticks 0 to n; the first row is the start.
        velocity: (n + 1, 2) measured v in m/s and omega in rad/s.
        command: (n + 1, 2) commanded v and omega from each tick on.
        truth: true poses in the order of their ticks, without the start.
    """

    odometry: Floats
    velocity: Floats
    command: Floats
    truth: tuple[TruePose, ...]

    @property
    def end(self) -> TruePose | None:
        """The true pose after the run, or the last one along the way if the robot has stood still since; else None."""
        last = self.truth[-1] if self.truth else None
        if last is None or last.tick is None:
            return last
        moved = np.abs(self.odometry[-1] - self.odometry[last.tick])
        return last if np.all(moved < _STANDSTILL) else None

    def wheel_distances(self, track_m: float) -> Floats:
        """Returns the distances in m that the left and the right wheel counted in each tick, (n, 2).

        Args:
            track_m: the track with which the robot computes its odometry.
        """
        return rolled_distances(self.odometry, track_m)


def rolled_distances(odometry: Floats, track_m: float) -> Floats:
    """Returns the distances in m that the left and the right wheel counted between poses of an odometry, (n, 2).

    Args:
        odometry: (n + 1, 3) poses.
        track_m: the track with which the robot computes its odometry.
    """
    steps = np.diff(odometry, axis=0)
    turned = np.mod(steps[:, 2] + math.pi, 2.0 * math.pi) - math.pi
    middle = odometry[:-1, 2] + turned / 2.0
    ahead = steps[:, 0] * np.cos(middle) + steps[:, 1] * np.sin(middle)
    half = turned * track_m / 2.0
    return np.column_stack((ahead - half, ahead + half))
