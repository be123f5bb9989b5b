"""Runs of a real robot whose difference from the prediction is out of the ordinary for this robot."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from pinel_desktop.runs.difference import Difference, Kind, StepDifference

MIN_OTHER_RUNS = 5
# modified z-score of an outlier: Iglewicz and Hoaglin, How to Detect and Handle Outliers, ASQC 1993
_OUTLIER_Z = 3.5
_MAD_TO_SIGMA = 1.4826
_MIN_SIGMA = {"turn": 1.0, "move": 0.02, "path": 0.02}


@dataclass(frozen=True, slots=True)
class Unusual:
    """A difference that is out of the ordinary for a robot.

    Attributes:
        kind: of a turn (degrees), of a move (m), or of the whole path (the trajectory error, m).
        difference, usual: what this run has, and what the robot's other runs have, as a median.
        n_runs: number of the other runs.
        block, action, amount, tick: of the step; None for the path.
    """

    kind: Literal["turn", "move", "path"]
    difference: float
    usual: float
    n_runs: int
    block: str | None = None
    action: str | None = None
    amount: float | None = None
    tick: int | None = None


def unusual(own: Difference, others: Sequence[Difference]) -> Unusual | None:
    """Returns what is most out of the ordinary in a run; None for nothing, or with too few other runs.

    Median and median absolute deviation of the other runs decide, so that a few odd runs among them do not count. Only
    runs with the same source of poses are compared.
    """
    same = [one for one in others if one.source == own.source]
    if len(same) < MIN_OTHER_RUNS:
        return None
    steps = [_unusual_step("turn", own, same), _unusual_step("move", own, same)]
    best = max((one for one in steps if one is not None), key=lambda one: one[0], default=None)
    found = best or _unusual_path(own, same)  # a step says more than the path
    return found and found[1]


_Scored = tuple[float, Unusual] | None


def _unusual_step(kind: Kind, own: Difference, others: Sequence[Difference]) -> _Scored:
    """A robot's usual error grows with the amount: the median is of the error per degree, or per metre."""
    by_run = [_errors(kind, other.steps) for other in others]
    n_runs, errors = sum(map(bool, by_run)), [error for run in by_run for error in run]
    if n_runs < MIN_OTHER_RUNS:
        return None
    rate = float(np.median([more / size for _, size, more in errors]))
    sigma = _sigma(kind, [more - rate * size for _, size, more in errors])
    found: _Scored = None
    for step, size, more in _errors(kind, own.steps):
        score = abs(more - rate * size) / sigma
        if score > max(_OUTLIER_Z, found[0] if found else 0.0):
            place = (step.block, step.action, step.amount, step.tick)
            found = score, Unusual(kind, more, rate * size, n_runs, *place)
    return found


def _errors(
    kind: Kind, steps: Iterable[StepDifference]
) -> list[tuple[StepDifference, float, float]]:
    pairs = ((step, step.more(kind)) for step in steps)
    return [(step, step.predicted(kind), more) for step, more in pairs if more is not None]


def _unusual_path(own: Difference, others: Sequence[Difference]) -> _Scored:
    errors = [other.ate_m for other in others if other.ate_m is not None]
    if own.ate_m is None or len(errors) < MIN_OTHER_RUNS:
        return None
    usual = float(np.median(errors))
    score = (own.ate_m - usual) / _sigma("path", [error - usual for error in errors])
    return (score, Unusual("path", own.ate_m, usual, len(errors))) if score > _OUTLIER_Z else None


def _sigma(kind: Literal["turn", "move", "path"], residuals: Sequence[float]) -> float:
    mad = float(np.median(np.abs(residuals)))
    return max(_MAD_TO_SIGMA * mad, _MIN_SIGMA[kind])
