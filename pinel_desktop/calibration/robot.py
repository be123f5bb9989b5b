"""The calibration of one robot from several runs: a simulated robot with its errors."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pinel_desktop.calibration.drive import Drive
from pinel_desktop.calibration.estimate import Estimate
from pinel_desktop.calibration.response import Response, calibrate_response
from pinel_desktop.calibration.wheels import WheelCalibration, calibrate_wheels
from pinel_desktop.errors import PinelError
from pinel_desktop.robot import BOUNDS, RobotModel, RobotParameters, robot_parameters_from

_MIN_PATH_M, _MIN_TURN_RAD = 0.5, 0.5  # of all runs together


@dataclass(frozen=True, slots=True)
class Calibration:
    """What the runs tell about a robot.

    Attributes:
        wheels: wheels, track and slip, which only true poses tell.
        response: delay and lag; None if the commands hardly changed.
    """

    wheels: WheelCalibration
    response: Response | None

    @property
    def estimates(self) -> dict[str, Estimate]:
        """The estimates by the names of `RobotParameters`, in its units; without what no run could tell."""
        scale, difference = self.wheels.scale, self.wheels.difference
        found = {"track_m": self.wheels.track_m}
        if scale.is_known and difference.is_known:
            found["wheel_bias_left"] = _bias(scale, difference, -0.5)
            found["wheel_bias_right"] = _bias(scale, difference, 0.5)
        if self.response is not None:
            found |= self.response._asdict()
        return {name: one for name, one in found.items() if one.is_known}

    @property
    def parameters(self) -> RobotParameters:
        """The parameters of a simulated robot with these errors.

        Its wheels have exactly the estimated errors in each run (`wheel_bias_sd` is 0) if they are known.

        Raises:
            PinelError: `robot_parameter_range` if an estimate is absurd.
        """
        values = {name: one.value for name, one in self.estimates.items()}
        if "wheel_bias_left" in values:
            values["wheel_bias_sd"] = 0.0
        if self.wheels.noise_is_known:
            values["wheel_noise"] = min(self.wheels.wheel_noise, BOUNDS["wheel_noise"][1])
        return robot_parameters_from(values)


def calibrate(drives: Sequence[Drive], model: RobotModel) -> Calibration:
    """Returns what runs of one robot tell about it.

    Args:
        drives: the runs.
        model: what the robot believes to be, with the track of its odometry.

    Raises:
        PinelError: `calibration_without_motion`.
    """
    path_m, turned_rad = np.sum([_motion(drive, model.track_m) for drive in drives], axis=0)
    if path_m < _MIN_PATH_M and turned_rad < _MIN_TURN_RAD:
        raise PinelError("calibration_without_motion", path_m=float(path_m))
    return Calibration(calibrate_wheels(drives, model.track_m), calibrate_response(drives))


def _motion(drive: Drive, track_m: float) -> tuple[float, float]:
    """Returns the length of the path in m, and the sum of all turns in rad."""
    left, right = drive.wheel_distances(track_m).T
    return float(np.abs(left + right).sum() / 2.0), float(np.abs(right - left).sum() / track_m)


def _bias(scale: Estimate, difference: Estimate, side: float) -> Estimate:
    """Returns the relative error of a wheel; the two estimates are taken as independent."""
    value = scale.value * (1.0 + side * difference.value)
    reach = np.hypot(scale.high - scale.value, side * (difference.high - difference.value))
    return Estimate(value - 1.0, float(value - reach - 1.0), float(value + reach - 1.0), True)
