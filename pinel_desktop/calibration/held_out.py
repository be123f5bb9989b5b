"""Checks a calibration: predicts the end of each run by what the other runs tell.

A run counts only if the other runs tell its prediction nearly as well as chance allows: the uncertainty of their
calibration may make the expected error at most `MAX_RATIO` times the noise floor. So a square whose direction no other
run has driven is not held out: its error would say something of the missing run, not of the robot. Whether a run counts
depends on what was driven and measured how well, not on how far off its prediction is.
"""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from pinel_desktop.calibration.drive import Drive
from pinel_desktop.calibration.wheels import (
    WheelCalibration,
    calibrate_wheels,
    end_uncertainty,
    predicted_end,
)

MIN_RUNS = 3
MAX_RATIO = 1.3


class HeldOut(NamedTuple):
    """The prediction of one run that the calibration did not use.

    Attributes:
        place: of the run among all runs, from 0.
        error_m: distance between predicted and true position at the end.
        expected_m: the root mean square of that distance by slip and the measurement's uncertainty alone, its noise
            floor.
        nominal_m: the distance without a calibration.
        off_m: x and y of the true position from the predicted one.
    """

    place: int
    error_m: float
    expected_m: float
    nominal_m: float
    off_m: tuple[float, float]


def held_out(drives: Sequence[Drive], by_all: WheelCalibration, track_m: float) -> list[HeldOut]:
    """Returns a prediction for each run with a true pose at its end that the other runs tell well enough.

    Fewer than `MIN_RUNS` runs give none.

    Args:
        by_all: the calibration by all runs, of which the noise of the wheels is taken over.
        track_m: the track with which the robot computes its odometry.
    """
    return (
        list(_predictions(drives, by_all.wheel_noise, track_m)) if len(drives) >= MIN_RUNS else []
    )


def _predictions(drives: Sequence[Drive], noise: float, track_m: float) -> Iterator[HeldOut]:
    for place, drive in enumerate(drives):
        end = drive.end
        if end is None:
            continue
        others = [*drives[:place], *drives[place + 1 :]]
        wheels = calibrate_wheels(others, track_m, noise)
        if not wheels.is_known:
            continue
        distances = drive.wheel_distances(track_m)
        predicted, slip = predicted_end(distances, wheels)
        floor = float(np.trace(slip[:2, :2])) + 2.0 * end.sigma_m**2
        unsure = float(np.trace(end_uncertainty(distances, wheels)[:2, :2]))
        if floor + unsure > MAX_RATIO**2 * floor:
            continue
        off_x, off_y = (np.array(end.pose[:2]) - predicted[:2]).tolist()
        nominal_m = math.dist(drive.odometry[-1, :2].tolist(), end.pose[:2])
        yield HeldOut(place, math.hypot(off_x, off_y), math.sqrt(floor), nominal_m, (off_x, off_y))
