"""UMBmark: wheel difference and track from the ends of squares in both directions.

J. Borenstein and L. Feng, "Measurement and correction of systematic odometry errors in mobile robots" (1996). The
robot drives squares by its odometry, in each direction several times; the centres of the two clusters of ends tell
both errors. PINEL uses it to check a calibration, which needs no squares.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from pinel_desktop.calibration.drive import Drive

_TOLERANCE = 0.1  # of the shape of a square, relative to its side, and of one turn in rad times two


class SquareErrors(NamedTuple):
    """Systematic errors of a robot.

    Attributes:
        difference: relative difference of the two wheels, right minus left.
        track_ratio: true track divided by the one that the robot believes.
        worst_m: distance of the farther cluster's centre from the start, UMBmark's measure of accuracy.
    """

    difference: float
    track_ratio: float
    worst_m: float


End = tuple[float, float]


def umbmark(
    left: Sequence[End], right: Sequence[End], side_m: float, track_m: float
) -> SquareErrors:
    """Returns the errors to first order, as the paper does.

    Args:
        left, right: ends (x, y in m, start frame) of squares that turn to the left and to the right.
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


def umbmark_of(drives: Sequence[Drive], track_m: float) -> SquareErrors | None:
    """Returns the errors by the runs that are squares; None without squares of one size in both directions."""
    squares = [(_square_side(drive, track_m), drive.end) for drive in drives]
    sides = [abs(side) for side, end in squares if side and end]
    if not sides or max(sides) - min(sides) > _TOLERANCE * max(sides):
        return None
    left = [end.pose[:2] for side, end in squares if side > 0 and end]
    right = [end.pose[:2] for side, end in squares if side < 0 and end]
    return umbmark(left, right, float(np.mean(sides)), track_m) if left and right else None


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
