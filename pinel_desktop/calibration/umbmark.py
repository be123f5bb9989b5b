"""UMBmark: wheel difference and track from the ends of squares in both directions.

J. Borenstein and L. Feng, "Measurement and correction of systematic odometry errors in mobile robots" (1996). The
robot drives squares by its odometry, in each direction several times; the centres of the two clusters of ends tell
both errors. PINEL uses it to check a calibration, which needs no squares: the centres of the same clusters, from where
the calibrated robot is predicted to end, are what a calibration leaves.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from pinel_desktop.calibration.drive import Drive
from pinel_desktop.calibration.held_out import HeldOut

MIN_SQUARES, SQUARES = 3, 5  # in each direction: what tells enough, and what the paper drives
_TOLERANCE = 0.1  # of the shape of a square, relative to its side, and of one turn in rad times two


class SquareErrors(NamedTuple):
    """Systematic errors of a robot.

    Attributes:
        difference: relative difference of the two wheels, right minus left.
        track_ratio: true track divided by the one that the robot believes.
        worst_m: distance of the farther cluster's centre from where the odometry ends, UMBmark's measure of accuracy
            (E_max,syst).
        left_over_m: the same from where the calibrated robot is predicted to end, each run by the others; None if that
            cannot be told in both directions.
        n_left, n_right: number of squares in each direction.
    """

    difference: float
    track_ratio: float
    worst_m: float
    left_over_m: float | None = None
    n_left: int = 0
    n_right: int = 0


End = tuple[float, float]


def umbmark(
    left: Sequence[End], right: Sequence[End], side_m: float, track_m: float
) -> SquareErrors:
    """Returns the errors to first order, as the paper does.

    Args:
        left, right: true ends (x, y in m, start frame) of squares that turn to the left and to the right, from where
            the odometry ends.
        side_m: length of a side.
        track_m: the track that the robot believes.
    """
    (left_x, left_y), (right_x, right_y) = np.mean(left, axis=0), np.mean(right, axis=0)
    # alpha: excess of each turn; beta: turn on each side, to the left. To first order, in units of
    # 2 * side_m, a left square ends at (alpha + beta, -alpha - beta), a right one at (alpha - beta, alpha - beta).
    unit_m = 8.0 * side_m
    alpha = (left_x + right_x + right_y - left_y) / unit_m
    beta = (left_x - right_x - left_y - right_y) / unit_m
    return SquareErrors(
        difference=beta * track_m / side_m,
        track_ratio=(math.pi / 2.0) / (math.pi / 2.0 + alpha),
        worst_m=max(math.hypot(left_x, left_y), math.hypot(right_x, right_y)),
    )


def umbmark_of(
    drives: Sequence[Drive], track_m: float, predictions: Sequence[HeldOut] = ()
) -> SquareErrors | None:
    """Returns the errors by the runs that are squares; None without squares of one size in both directions.

    Args:
        predictions: of runs by the others; `place` counts in `drives`.
    """
    sides = {
        place: side
        for place, drive in enumerate(drives)
        if drive.end and (side := _square_side(drive, track_m))
    }
    lengths = [abs(side) for side in sides.values()]
    if not sides or max(lengths) - min(lengths) > _TOLERANCE * max(lengths):
        return None
    turns = [[place for place, side in sides.items() if side * sign > 0] for sign in (1, -1)]
    if not all(turns):
        return None
    left, right = ([_end_off(drives[place]) for place in places] for places in turns)
    found = umbmark(left, right, float(np.mean(lengths)), track_m)
    off = {one.place: one.off_m for one in predictions}
    rests = [[off[place] for place in places if place in off] for places in turns]
    left_over_m = max(map(_centre_m, rests)) if all(rests) else None
    return found._replace(left_over_m=left_over_m, n_left=len(left), n_right=len(right))


def _end_off(drive: Drive) -> End:
    assert drive.end is not None
    x, y = (np.array(drive.end.pose[:2]) - drive.odometry[-1, :2]).tolist()
    return x, y


def _centre_m(ends: Sequence[End]) -> float:
    x, y = np.mean(ends, axis=0).tolist()
    return math.hypot(x, y)


def _square_side(drive: Drive, track_m: float) -> float:
    """Returns the side of a run that is a square by its odometry, negative to the right; 0 for another run."""
    left, right = drive.wheel_distances(track_m).T
    turned, side = float(np.sum(right - left)) / track_m, float(np.abs(left + right).sum()) / 8.0
    away = np.hypot(drive.odometry[:, 0], drive.odometry[:, 1])
    is_square = (
        abs(abs(turned) - math.tau) < 2.0 * _TOLERANCE
        and away[-1] < _TOLERANCE * side
        and abs(away.max() - math.sqrt(2.0) * side) < _TOLERANCE * side
    )
    return math.copysign(side, turned) if is_square else 0.0
