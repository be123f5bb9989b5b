"""Scales of both wheels, track and slip of a robot, from odometry and true poses.

The odometry of a robot with a differential drive counts what its wheels rolled; a wheel of another size or another
track moves the body differently (J. Borenstein and L. Feng, "Measurement and correction of systematic odometry errors
in mobile robots", 1996). The parameters maximize the likelihood of the true poses, each predicted from the one before
by a Kalman filter whose process noise is the slip of the wheels (A. Martinelli et al., "Simultaneous localization and
odometry self calibration for mobile robot", 2007).
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from pinel_desktop.calibration.drive import Drive, Floats
from pinel_desktop.calibration.estimate import Estimate, estimate, unknown
from pinel_desktop.calibration.least_squares import jacobian, levenberg_marquardt
from pinel_desktop.runs.truth import TruePose

# relative noise of a wheel's distance in a tick: the range that is searched, and the value if the poses cannot tell it
_NOISE_RANGE = (1e-3, 0.2)
_TYPICAL_NOISE = 0.02
_N_NOISE_STEPS = 12
_NEARBY = np.array([0.67, 1.0, 1.5])  # values around the likeliest one, for a closer look
_MIN_DEGREES_OF_FREEDOM = 3
_NOISE_PRIOR = 0.7  # standard deviation of the noise's logarithm around the typical value
# a parameter with a larger standard deviation is not told by the runs
_MAX_SD = (
    0.02  # of the scale, of the wheels' difference, and of the track relative to its nominal value
)
_PRIOR_SD = 0.1
_N_PARAMETERS = 3
_STEPS = np.array([1e-5, 1e-5, 1e-5])  # for derivatives


@dataclass(frozen=True, slots=True)
class WheelCalibration:
    """The result.

    Attributes:
        scale: metres that the body moves per metre that its odometry counts.
        difference: relative difference of the two wheels, right minus left; positive turns the robot to the left.
        track_m: distance between the wheels' points of contact.
        wheel_noise: relative error of a wheel's distance in a tick, one standard deviation.
        noise_is_known: whether the true poses were enough to tell the noise.
        n_poses: number of true poses.
        covariance: of scale, difference and track, (3, 3).
    """

    scale: Estimate
    difference: Estimate
    track_m: Estimate
    wheel_noise: float
    noise_is_known: bool
    n_poses: int
    covariance: Floats

    @property
    def is_known(self) -> bool:
        """Whether the runs tell all three parameters."""
        return self.scale.is_known and self.difference.is_known and self.track_m.is_known

    @property
    def parameters(self) -> Floats:
        """Scale, difference and track, (3,)."""
        return np.array([self.scale.value, self.difference.value, self.track_m.value])

    @property
    def n_free(self) -> int:
        """Degrees of freedom."""
        return 3 * self.n_poses - _N_PARAMETERS


def calibrate_wheels(
    drives: Sequence[Drive], track_m: float, noise: float | None = None
) -> WheelCalibration:
    """Returns the parameters that explain the true poses best.

    Args:
        drives: runs of one robot; without true poses nothing is known.
        track_m: the track with which the robot computes its odometry.
        noise: `wheel_noise` if it is known already.
    """
    counted = [(drive.wheel_distances(track_m), drive.truth) for drive in drives]
    n_poses = sum(len(truth) for _, truth in counted)
    nominal = np.array([1.0, 0.0, track_m])
    if n_poses == 0:
        scale, difference, track = (unknown(float(value)) for value in nominal)
        return WheelCalibration(
            scale, difference, track, _TYPICAL_NOISE, False, 0, np.zeros((3, 3))
        )
    n_free = 3 * n_poses - _N_PARAMETERS
    noise_is_known = n_free >= _MIN_DEGREES_OF_FREEDOM
    tried = np.geomspace(*_NOISE_RANGE, _N_NOISE_STEPS)
    n_searches = 3 if noise_is_known and noise is None else 0
    noise = noise or _TYPICAL_NOISE
    best, slopes = _fit(counted, nominal, nominal, noise)
    for _ in range(n_searches):
        noise = _likeliest_noise(counted, best, tried)
        best, slopes = _fit(counted, nominal, best, noise)
        tried = noise * _NEARBY
    covariance = np.asarray(np.linalg.inv(slopes.T @ slopes), dtype=np.float64)
    scale, difference, track = _estimates(best, covariance, nominal, n_free)
    return WheelCalibration(scale, difference, track, noise, noise_is_known, n_poses, covariance)


_Counted = tuple[Floats, tuple[TruePose, ...]]


def _fit(
    counted: Sequence[_Counted], nominal: Floats, start: Floats, noise: float
) -> tuple[Floats, Floats]:
    def residuals(parameters: Floats) -> Floats:
        off = (parameters - nominal) / (_PRIOR_SD * _units(nominal))
        return np.concatenate((_innovations(counted, parameters, noise)[0], off))

    return levenberg_marquardt(residuals, start, _STEPS)


def _likeliest_noise(counted: Sequence[_Counted], parameters: Floats, tried: Floats) -> float:
    """Returns the likeliest noise, by restricted maximum likelihood: fitted parameters make residuals too small."""
    costs = [_noise_cost(counted, parameters, float(noise)) for noise in tried]
    place = int(np.argmin(costs))
    if place in (0, len(tried) - 1):
        return float(np.clip(tried[place], *_NOISE_RANGE))
    around = np.log(tried[place - 1 : place + 2])
    a, b, _ = np.polyfit(around, costs[place - 1 : place + 2], 2)
    return float(np.clip(math.exp(-b / (2.0 * a)), *_NOISE_RANGE))


def _noise_cost(counted: Sequence[_Counted], parameters: Floats, noise: float) -> float:
    """Returns -2 times the logarithm of the restricted likelihood, up to a constant."""

    def residuals(one: Floats) -> Floats:
        return _innovations(counted, one, noise)[0]

    values, log_determinant = _innovations(counted, parameters, noise)
    slopes = jacobian(residuals, parameters, _STEPS)
    lost = float(np.linalg.slogdet(slopes.T @ slopes + np.eye(3))[1])
    prior = (math.log(noise / _TYPICAL_NOISE) / _NOISE_PRIOR) ** 2
    return float(values @ values) + log_determinant + lost + prior


def _estimates(
    best: Floats, covariance: Floats, nominal: Floats, n_free: int
) -> Iterator[Estimate]:
    sds = np.sqrt(np.diag(covariance))
    for value, sd, default, unit in zip(best, sds, nominal, _units(nominal), strict=True):
        too_wide = sd > _MAX_SD * unit
        yield unknown(float(default)) if too_wide else estimate(value, sd, n_free)


def _units(nominal: Floats) -> Floats:
    """Returns what a relative error of 1 is for each parameter."""
    return np.array([1.0, 1.0, nominal[2]])


def _innovations(
    counted: Sequence[_Counted], parameters: Floats, noise: float
) -> tuple[Floats, float]:
    """Returns the whitened differences between true and predicted poses, and the sum of log determinants."""
    values, log_determinant = [], 0.0
    for distances, truth in counted:
        for whitened, logarithm in _filtered(distances, truth, parameters, noise):
            values.append(whitened)
            log_determinant += logarithm
    return np.concatenate(values), log_determinant


def _filtered(
    distances: Floats, truth: Sequence[TruePose], parameters: Floats, noise: float
) -> Iterator[tuple[Floats, float]]:
    """Filters one run; yields for each true pose its whitened innovation and the log determinant of its covariance."""
    pose, covariance, last_tick = np.zeros(3), np.zeros((3, 3)), 0
    for measured in truth:
        pose, covariance = _predicted(
            pose, covariance, distances[last_tick : measured.tick], parameters, noise
        )
        last_tick = len(distances) if measured.tick is None else measured.tick
        error = np.array(measured.pose) - pose
        error[2] = (error[2] + math.pi) % (2.0 * math.pi) - math.pi
        sigmas: Floats = np.array([measured.sigma_m, measured.sigma_m, measured.sigma_rad])
        spread: Floats = covariance + np.diag(sigmas**2)
        lower = np.linalg.cholesky(spread)
        yield np.linalg.solve(lower, error), 2.0 * float(np.log(np.diag(lower)).sum())
        gain = covariance @ np.linalg.inv(spread)
        pose, covariance = pose + gain @ error, covariance - gain @ covariance
        covariance = (covariance + covariance.T) / 2.0


def predicted_end(distances: Floats, wheels: WheelCalibration) -> tuple[Floats, Floats]:
    """Returns the pose at the end of a run by its odometry and calibrated wheels, and its covariance by slip.

    Args:
        distances: (n, 2) what the wheels counted in each tick, in m.
    """
    return _end(distances, wheels.parameters, wheels.wheel_noise)


def end_uncertainty(distances: Floats, wheels: WheelCalibration) -> Floats:
    """Returns the covariance of the predicted end by the uncertainty of the calibration, (3, 3)."""

    def end(parameters: Floats) -> Floats:
        return _end(distances, parameters, wheels.wheel_noise)[0]

    slopes = jacobian(end, wheels.parameters, _STEPS)
    return slopes @ wheels.covariance @ slopes.T


def _end(distances: Floats, parameters: Floats, noise: float) -> tuple[Floats, Floats]:
    return _predicted(np.zeros(3), np.zeros((3, 3)), distances, parameters, noise)


def _predicted(
    pose: Floats, covariance: Floats, distances: Floats, parameters: Floats, noise: float
) -> tuple[Floats, Floats]:
    """Returns pose and covariance after the given wheel distances, (n, 2) in m."""
    scale, difference, track_m = parameters
    left = distances[:, 0] * scale * (1.0 - difference / 2.0)
    right = distances[:, 1] * scale * (1.0 + difference / 2.0)
    ahead, turned = (left + right) / 2.0, (right - left) / track_m
    heading = pose[2] + np.cumsum(turned)
    middle = heading - turned / 2.0
    cos, sin = np.cos(middle), np.sin(middle)
    xs, ys = pose[0] + np.cumsum(ahead * cos), pose[1] + np.cumsum(ahead * sin)
    if len(xs) == 0:
        return pose, covariance
    end = np.array([xs[-1], ys[-1], heading[-1]])
    across_x, across_y = -(end[1] - ys), end[0] - xs  # how the end moves with a turn in each tick
    shift = np.array([[1.0, 0.0, pose[1] - end[1]], [0.0, 1.0, end[0] - pose[0]], [0.0, 0.0, 1.0]])
    slips = [
        np.array([cos * rolled / 2.0 + across_x * turn, sin * rolled / 2.0 + across_y * turn, turn])
        for rolled, turn in ((left, -left / track_m), (right, right / track_m))
    ]
    process = noise**2 * sum(slip @ slip.T for slip in slips)
    return end, shift @ covariance @ shift.T + process
