"""Nonlinear least squares for a handful of parameters."""

from collections.abc import Callable

import numpy as np

from pinel_desktop.calibration.drive import Floats

_MAX_STEPS = 50
_FIRST_DAMPING, _MAX_DAMPING = 1e-3, 1e9
_ENOUGH = 1e-10  # relative decrease of the sum of squares below which the search ends

Residuals = Callable[[Floats], Floats]


def levenberg_marquardt(
    residuals: Residuals, start: Floats, steps: Floats
) -> tuple[Floats, Floats]:
    """Returns the parameters with the smallest sum of squares, and the Jacobian there.

    Levenberg-Marquardt with central differences. scipy would be the library for it, but is as large as a third of the
    package.

    Args:
        residuals: from the parameters to the residuals, each divided by its standard deviation.
        steps: difference of each parameter for the derivative.
    """
    parameters, damping = start.astype(np.float64), _FIRST_DAMPING
    values = residuals(parameters)
    for _ in range(_MAX_STEPS):
        slopes = jacobian(residuals, parameters, steps)
        normal, gradient = slopes.T @ slopes, slopes.T @ values
        before = float(values @ values)
        while damping < _MAX_DAMPING:
            scaled = normal + damping * np.diag(np.diag(normal) + np.finfo(float).tiny)
            tried = parameters - np.linalg.lstsq(scaled, gradient, rcond=None)[0]
            new_values = residuals(tried)
            if float(new_values @ new_values) <= before:
                break
            damping *= 10.0
        else:
            break
        parameters, values, damping = tried, new_values, damping / 10.0
        if before - float(values @ values) <= _ENOUGH * before:
            break
    return parameters, jacobian(residuals, parameters, steps)


def jacobian(residuals: Residuals, parameters: Floats, steps: Floats) -> Floats:
    """Returns the derivatives of the residuals by central differences, (n residuals, n parameters)."""
    columns = []
    for i, step in enumerate(steps):
        change = np.zeros_like(parameters)
        change[i] = step
        columns.append(
            (residuals(parameters + change) - residuals(parameters - change)) / (2 * step)
        )
    return np.column_stack(columns)
