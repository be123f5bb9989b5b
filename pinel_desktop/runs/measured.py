"""The poses of a real robot's run from the best source that there is: a source of truth, else its odometry."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from pinel_desktop.robot import Pose2D
from pinel_desktop.runs.prediction import Path, unwrapped

Source = Literal["odometry", "tape", "camera", "localisation"]

# by its odometry, a robot that has moved less is still at its start
_AT_REST_M, _AT_REST_RAD = 0.002, 0.005


@dataclass(frozen=True, slots=True)
class Measured:
    """Poses of the real run.

    Attributes:
        source: of the poses along the way.
        path: as `Prediction.path`, from the pose at the start; NaN where the source saw nothing.
        end: the pose after the run, its heading without jumps, if `end_source` knows it and `path` does not.
    """

    source: Source
    path: Path
    end: Path | None = None
    end_source: Source = "odometry"


def by_odometry(rows: Path) -> Measured:
    """Returns what the robot itself measured.

    Args:
        rows: its poses from tick 1 on, in the start frame, shape (n, 3).
    """
    return Measured("odometry", unwrapped(np.vstack([np.zeros(3), rows])))
