"""Accuracy metrics: proportions with confidence intervals, and the calibration error."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_Z = 1.959964  # standard deviations about the mean with 95 % of a normal distribution


@dataclass(frozen=True)
class Proportion:
    """A proportion, `n` of `of` cases, with the 95 % confidence interval of Wilson (1927)."""

    n: int
    of: int

    @classmethod
    def among(cls, holds: Iterable[bool] | NDArray[np.bool_]) -> "Proportion":
        found = list(holds)
        return cls(sum(map(bool, found)), len(found))

    @property
    def value(self) -> float:
        return self.n / self.of if self.of else math.nan

    @property
    def interval(self) -> tuple[float, float]:
        if not self.of:
            return (0.0, 1.0)
        spread = _Z**2 / self.of
        middle = (self.value + spread / 2) / (1 + spread)
        half = math.sqrt(self.value * (1 - self.value) * spread + spread**2 / 4) / (1 + spread)
        return (max(middle - half, 0.0), min(middle + half, 1.0))

    def as_object(self) -> dict[str, float | int | None]:
        """Returns the proportion for JSON; `share` is null if there are no cases."""
        low, high = (round(bound, 4) for bound in self.interval)
        value = round(self.value, 4) if self.of else None
        return {"share": value, "low": low, "high": high, "n": self.n, "of": self.of}


def proportions_by(
    groups: Sequence[str] | NDArray[np.str_], holds: NDArray[np.bool_]
) -> dict[str, Proportion]:
    """Returns the proportion for each group, sorted by the group's name."""
    named = np.asarray(groups)
    return {str(group): Proportion.among(holds[named == group]) for group in np.unique(named)}


def calibration_error(confidence: Array, right: NDArray[np.bool_], n_bins: int = 10) -> float:
    """Returns the expected calibration error: mean |confidence - accuracy| over equal bins, weighted by their sizes."""
    bins = np.minimum((confidence * n_bins).astype(int), n_bins - 1)
    gaps = [abs(float(confidence[bins == i].sum() - right[bins == i].sum())) for i in range(n_bins)]
    return sum(gaps) / len(confidence) if len(confidence) else 0.0
