"""The poses of a real robot's run from the best source that there is: a source of truth, else its odometry."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from pinel_desktop.robot import wrap_angle
from pinel_desktop.runs.prediction import Path, unwrapped
from pinel_desktop.runs.truth import Truth, best_at_end, best_during_run

Source = Literal["odometry", "tape", "camera", "localisation"]

# by its odometry, a robot that has moved less is still at its start
_AT_REST_M, _AT_REST_RAD = 0.002, 0.005


@dataclass(frozen=True, slots=True)
class Measured:
    """Poses of the real run.

    Attributes:
        source: of the poses along the way.
        path: as `Prediction.path`, from the pose at the start; NaN where the source saw nothing.
        odometry: the robot's own poses.
        end: the pose after the run as `end_source` knows it, the heading without jumps; None: the end of `path`.
        end_sigma_rad: standard uncertainty of the heading of `end`.
    """

    source: Source
    path: Path
    odometry: Path
    end: Path | None = None
    end_source: Source = "odometry"
    end_sigma_rad: float = 0.0


def measured_poses(rows: Path, truths: Sequence[Truth]) -> Measured:
    """Returns the poses of a run by the best source.

    Args:
        rows: the robot's own poses from tick 1 on, in the start frame, shape (n, 3).
        truths: what sources of truth say.
    """
    odometry = unwrapped(np.vstack([np.zeros(3), rows]))
    along, last = best_during_run(truths), best_at_end(truths)
    end = None if last is None else _beside(np.array(last.end.pose), odometry[-1])
    end_source: Source = "odometry" if last is None else last.source
    if along is None:
        sigma_rad = 0.0 if last is None else last.end.sigma_rad
        return Measured("odometry", odometry, odometry, end, end_source, sigma_rad)
    path = np.full_like(odometry, np.nan)
    for tick, own in enumerate(odometry):
        if (pose := along.at(tick)) is not None:
            path[tick] = _beside(np.array(pose.pose), own)
    start = _start(path[: _n_at_rest(odometry)])
    if last is along and end is not None:
        end = _from(start, end)
    return Measured(along.source, _from(start, path), odometry, end, end_source)


def _beside(pose: Path, odometry: Path) -> Path:
    """Returns a pose with the heading, of all that differ by full turns, that is nearest to the odometry's."""
    return np.array([*pose[:2], odometry[2] + wrap_angle(pose[2] - odometry[2])])


def _n_at_rest(odometry: Path) -> int:
    """The number of poses before the robot moves."""
    moved = np.hypot(odometry[:, 0], odometry[:, 1]) > _AT_REST_M
    moved |= np.abs(odometry[:, 2]) > _AT_REST_RAD
    return int(np.argmax(moved)) if moved.any() else len(odometry)


def _start(poses: Path) -> Path:
    """The mean of the known poses at the start; the start mark if none is known."""
    known = poses[~np.isnan(poses[:, 0])]
    mean: Path = known.mean(axis=0) if len(known) else np.zeros(3)
    return mean


def _from(start: Path, poses: Path) -> Path:
    """Returns poses in the frame of a start."""
    cos, sin = math.cos(start[2]), math.sin(start[2])
    off = poses - start
    x, y = off[..., 0], off[..., 1]
    return np.stack([cos * x + sin * y, cos * y - sin * x, off[..., 2]], axis=-1)
