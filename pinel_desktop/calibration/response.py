"""Delay and lag between a commanded and a measured velocity of a robot."""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from pinel_desktop.calibration.drive import Drive, Floats
from pinel_desktop.calibration.estimate import Estimate, estimate
from pinel_desktop.calibration.least_squares import levenberg_marquardt

_TICK_S = 1.0 / 30.0
_MAX_S = 0.5
# the search begins at each of these (latency, lag) in s, because the sum of squares has several minima
_STARTS_S = ((0.02, 0.05), (0.1, 0.1), (0.25, 0.2))
_STEP_S = 1e-4
_MIN_LAG_S = 1e-3
_MIN_CHANGE = 0.05  # m/s or rad/s; runs whose commands change by less cannot tell


class Response(NamedTuple):
    """The response of the wheels.

    Attributes:
        latency_s: time from a command to the first motion.
        lag_s: time constant of the first-order response after it.
    """

    latency_s: Estimate
    lag_s: Estimate


def calibrate_response(drives: Sequence[Drive]) -> Response | None:
    """Returns the response that explains the measured velocities best; None if the commands hardly change.

    A measured velocity is taken as the mean of the tick before it. For a robot that reports the newest velocity, the
    latency is half a tick too small.
    """
    channels = [
        (drive.command[:, i], drive.velocity[:, i])
        for drive in drives
        for i in (0, 1)
        if np.ptp(drive.command[:, i]) >= _MIN_CHANGE
    ]
    if not channels:
        return None

    def residuals(times: Floats) -> Floats:
        return np.concatenate(
            [_responded(commands, *times)[:-1] - measured[1:] for commands, measured in channels]
        )

    steps = np.array([_STEP_S, _STEP_S])
    found = [levenberg_marquardt(residuals, np.array(start), steps) for start in _STARTS_S]
    best, slopes = min(found, key=lambda one: float(np.square(residuals(one[0])).sum()))
    sds, n_free = _standard_deviations(residuals(best), slopes)
    latency_s, lag_s = _inside(*best)
    return Response(estimate(latency_s, sds[0], n_free), estimate(lag_s, sds[1], n_free))


def _inside(latency_s: float, lag_s: float) -> tuple[float, float]:
    return min(max(latency_s, 0.0), _MAX_S), min(max(lag_s, _MIN_LAG_S), _MAX_S)


def _standard_deviations(values: Floats, slopes: Floats) -> tuple[list[float], int]:
    """Returns standard deviations from the residuals' spread, and the degrees of freedom."""
    n_free = max(len(values) - 2, 1)
    information = slopes.T @ slopes + np.eye(2) * np.finfo(float).tiny
    variances = float(values @ values) / n_free * np.diag(np.linalg.inv(information))
    return np.sqrt(variances).tolist(), n_free


def _responded(commands: Floats, latency_s: float, lag_s: float) -> Floats:
    """Returns the mean velocity in each tick of a first-order response to delayed commands."""
    latency_s, lag_s = _inside(latency_s, lag_s)
    ticks, part = divmod(latency_s / _TICK_S, 1.0)
    # in each tick, the command of one tick earlier still applies for `part` of it
    widths = [part * _TICK_S, (1.0 - part) * _TICK_S]
    decays = [math.exp(-width / lag_s) for width in widths]
    padded = np.concatenate((np.zeros(int(ticks) + 1), commands))
    delayed = padded[: len(commands)], padded[1 : len(commands) + 1]
    return np.fromiter(_means(*delayed, widths, decays, lag_s), np.float64, len(commands))


def _means(
    older: Floats, newer: Floats, widths: list[float], decays: list[float], lag_s: float
) -> Iterator[float]:
    velocity = 0.0
    for first, second in zip(older.tolist(), newer.tolist(), strict=True):
        moved = 0.0
        for command, width, decay in zip((first, second), widths, decays, strict=True):
            moved += command * width + (velocity - command) * lag_s * (1.0 - decay)
            velocity = command + (velocity - command) * decay
        yield moved / _TICK_S
