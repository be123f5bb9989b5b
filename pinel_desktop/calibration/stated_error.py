"""The error that a calibrated robot states for a prediction: how far from the predicted place a run may end."""

import math
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from pinel_desktop.calibration.drive import Floats, rolled_distances
from pinel_desktop.calibration.estimate import estimate
from pinel_desktop.calibration.wheels import WheelCalibration, end_uncertainty, predicted_end
from pinel_desktop.runs.truth import TAPE_SIGMA_M

# 95 % quantiles of the chi-squared distribution with one and with two degrees of freedom
_ONE_AXIS, _TWO_AXES = 3.841, 5.991


@dataclass(frozen=True, slots=True)
class CalibratedWheels:
    """Calibrated wheels with the track with which the robot computes its odometry."""

    wheels: WheelCalibration
    believed_track_m: float

    def as_record(self) -> dict[str, Any] | None:
        """Returns plain JSON data for the store; None if the runs do not tell the wheels."""
        found = self.wheels
        if not found.is_known:
            return None
        return {
            "believed_track_m": self.believed_track_m,
            "parameters": found.parameters.tolist(),
            "covariance": found.covariance.tolist(),
            "wheel_noise": found.wheel_noise,
            "n_poses": found.n_poses,
        }

    @classmethod
    def from_record(cls, record: Mapping[str, Any]) -> "CalibratedWheels | None":
        """Reads the data of `as_record`, which may come from a file; None if it is unusable."""
        with suppress(KeyError, TypeError, ValueError):
            parameters = np.array(record["parameters"], dtype=np.float64).reshape(3)
            covariance = np.array(record["covariance"], dtype=np.float64).reshape(3, 3)
            noise, believed_m = float(record["wheel_noise"]), float(record["believed_track_m"])
            numbers = np.array([*parameters, *covariance.ravel(), noise, believed_m])
            if np.isfinite(numbers).all() and parameters[2] > 0.0:
                scale, difference, track_m = (
                    estimate(value, 0.0, 1) for value in parameters.tolist()
                )
                n_poses = int(record["n_poses"])
                wheels = WheelCalibration(
                    scale, difference, track_m, noise, True, n_poses, covariance
                )
                return cls(wheels, believed_m)
        return None


def end_radius_m(odometry: Floats, robot: CalibratedWheels) -> float:
    """Returns the distance in m from the predicted end within which 95 of 100 runs end, as a tape measures it.

    Slip, the uncertainty of the calibration and that of the tape make it. Along the two axes of their distribution the
    bound is between that of one and of two dimensions, on the safe side.

    Args:
        odometry: (n + 1, 3) the predicted odometry at ticks 0 to n, the heading without jumps.
    """
    distances = rolled_distances(odometry, robot.believed_track_m)
    _, slip = predicted_end(distances, robot.wheels)
    spread = slip + end_uncertainty(distances, robot.wheels) + np.eye(3) * TAPE_SIGMA_M**2
    smaller, larger = np.linalg.eigvalsh(spread[:2, :2])
    widened = estimate(0.0, 1.0, robot.wheels.n_free).high / math.sqrt(_ONE_AXIS)
    return float(widened * math.sqrt(_ONE_AXIS * larger + (_TWO_AXES - _ONE_AXIS) * smaller))
