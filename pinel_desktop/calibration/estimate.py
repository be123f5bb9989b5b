"""A parameter with its interval."""

from typing import NamedTuple

_Z_95 = 1.96


class Estimate(NamedTuple):
    """A parameter and its 95 % interval.

    Attributes:
        is_known: False if the runs cannot tell the parameter; `value` is then the nominal one.
    """

    value: float
    low: float
    high: float
    is_known: bool


def unknown(nominal: float) -> Estimate:
    """Returns the estimate of a parameter that the runs cannot tell."""
    return Estimate(nominal, nominal, nominal, is_known=False)


def estimate(value: float, sd: float, n_free: int) -> Estimate:
    """Returns the estimate of a value with its standard deviation and degrees of freedom.

    The quantile of Student's distribution is computed by its expansion around the normal one (M. Abramowitz and
    I. Stegun, "Handbook of Mathematical Functions", 26.7.5).
    """
    reach = sd * (_Z_95 + (_Z_95**3 + _Z_95) / (4.0 * max(n_free, 1)))
    return Estimate(float(value), float(value - reach), float(value + reach), is_known=True)
