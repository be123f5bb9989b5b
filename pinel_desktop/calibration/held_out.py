"""Checks a calibration: predicts the end of each run by what the other runs tell."""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from pinel_desktop.calibration.drive import Drive, Floats
from pinel_desktop.calibration.wheels import calibrate_wheels, predicted_end

MIN_RUNS = 3


class HeldOut(NamedTuple):
    """The prediction of one run that the calibration did not use.

    Attributes:
        place: of the run among all runs, from 0.
        error_m: distance between predicted and true position at the end.
        expected_m: the root mean square of that distance by slip and the measurement's uncertainty alone, its noise
            floor.
        nominal_m: the distance without a calibration.
    """

    place: int
    error_m: float
    expected_m: float
    nominal_m: float


def held_out(drives: Sequence[Drive], track_m: float) -> list[HeldOut]:
    """Returns a prediction for each run with a true pose at its end whose wheels the other runs tell.

    Fewer than `MIN_RUNS` runs give none.

    Args:
        track_m: the track with which the robot computes its odometry.
    """
    return list(_predictions(drives, track_m)) if len(drives) >= MIN_RUNS else []


def _predictions(drives: Sequence[Drive], track_m: float) -> Iterator[HeldOut]:
    nominal = calibrate_wheels([], track_m)
    for place, drive in enumerate(drives):
        end = drive.end
        if end is None:
            continue
        others = [*drives[:place], *drives[place + 1 :]]
        wheels = calibrate_wheels(others, track_m)
        if not (wheels.scale.is_known and wheels.difference.is_known and wheels.track_m.is_known):
            continue
        predicted, covariance = predicted_end(drive, wheels, track_m)
        believed, _ = predicted_end(drive, nominal, track_m)
        spread = float(np.trace(covariance[:2, :2])) + 2.0 * end.sigma_m**2
        yield HeldOut(
            place, _distance(predicted, end.pose), math.sqrt(spread), _distance(believed, end.pose)
        )


def _distance(pose: Floats, true: Sequence[float]) -> float:
    return math.dist(pose[:2].tolist(), true[:2])
