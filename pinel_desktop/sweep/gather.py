"""What rows have in common: one summary, of rows in any order."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.sweep.rows import Cause, Row

TOGETHER_M = 0.1
_PERCENTILES = (5, 50, 95)


class Reason(NamedTuple):
    """Why some runs did not go well.

    Attributes:
        detail: kind of the check, or code of the failure; None for a collision.
        block: id of the block to look at; None without one.
    """

    cause: Cause
    detail: str | None
    block: str | None


@dataclass(frozen=True, slots=True)
class Summary:
    """What rows have in common.

    Attributes:
        n_runs, n_well, n_collided: all runs, those that went well, and those that touched something.
        n_together: those that went well and end within `TOGETHER_M` of where most of these end.
        closing_error_m: the 5th, 50th and 95th percentile; None if no run started.
        duration_s: the same percentiles of the robot time.
        end_spread_m: distance of the ends from their centre below which 95 % of them lie; None if no run started.
        reasons: why runs did not go well, and how many, the most frequent first.
    """

    n_runs: int
    n_well: int
    n_collided: int
    n_together: int
    closing_error_m: tuple[float, float, float] | None
    duration_s: tuple[float, float, float] | None
    end_spread_m: float | None
    reasons: tuple[tuple[Reason, int], ...]

    @property
    def success(self) -> float:
        """Share of the runs that went well; 0 without any run."""
        return self.n_well / self.n_runs if self.n_runs else 0.0


def summary_of(rows: Iterable[Row]) -> Summary:
    """Returns the summary of rows; their order does not matter."""
    rows = sorted(rows, key=lambda row: row.index)
    started = [row for row in rows if row.end is not None]
    return Summary(
        n_runs=len(rows),
        n_well=sum(row.is_well for row in rows),
        n_collided=sum(row.n_collisions > 0 for row in rows),
        n_together=len(together(rows)),
        closing_error_m=_percentiles([row.closing_error_m or 0.0 for row in started]),
        duration_s=_percentiles([row.duration_s for row in started]),
        end_spread_m=_end_spread_m(started),
        reasons=_reasons(rows),
    )


def together(rows: Iterable[Row]) -> list[Row]:
    """Returns those that went well and end within `TOGETHER_M` of where most of these end."""
    well = [row for row in rows if row.is_well and row.end is not None]
    return [row for row, away in zip(well, _distances(well), strict=True) if away <= TOGETHER_M]


def _percentiles(values: list[float]) -> tuple[float, float, float] | None:
    if not values:
        return None
    low, middle, high = (round(float(one), 6) for one in np.percentile(values, _PERCENTILES))
    return low, middle, high


def _end_spread_m(rows: list[Row]) -> float | None:
    distances = _distances(rows)
    return round(float(np.percentile(distances, _PERCENTILES[-1])), 6) if rows else None


def _distances(rows: list[Row]) -> NDArray[np.float64]:
    """Returns the distance (m) of each end from the median of the ends."""
    ends = np.array([row.end[:2] for row in rows if row.end is not None]).reshape(-1, 2)
    middle = np.median(ends, axis=0) if len(ends) else 0.0
    return np.asarray(np.hypot(*(ends - middle).T), dtype=np.float64)


def _reasons(rows: list[Row]) -> tuple[tuple[Reason, int], ...]:
    """Counts the reasons; of equally frequent ones the first to occur comes first."""
    found = Counter(
        Reason(row.cause, row.check if row.cause == "check" else _code(row), row.block)
        for row in rows
        if row.cause is not None
    )
    return tuple(found.most_common())


def _code(row: Row) -> str | None:
    return row.reason if row.cause == "failure" else None
