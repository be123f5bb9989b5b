"""Landmark sequences: recorded output of the landmark network for each frame, without any picture.

They replace a camera in tests and in the package's self-check.
"""

import io
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.errors import PinelError
from pinel_desktop.gestures.features import N_FEATURES

SEQUENCE_ENDING = ".npz"
_MAX_FRAMES = 10_000


@dataclass(frozen=True, slots=True)
class RecordedHand:
    """A hand of one recorded frame.

    Attributes:
        points: 21 landmarks (x, y) in px of a frame of 640 x 480.
        features: feature vector of `gestures.features`, (1748,).
        is_left: whether it is the person's left hand.
    """

    points: NDArray[np.float32]
    features: NDArray[np.float32]
    is_left: bool


def read_landmark_sequence(path: Path) -> list[tuple[RecordedHand, ...]]:
    """Returns the hands of each frame, one or none. Raises PinelError `camera_source_unreadable`."""
    try:
        with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as archive:
            is_there, is_left = archive["is_there"], archive["is_left"]
            points, features = (
                archive["points"].astype(np.float32),
                archive["features"].astype(np.float32),
            )
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        raise PinelError("camera_source_unreadable", path=str(path)) from error
    n = len(is_there)
    shapes = (points.shape, features.shape, is_left.shape)
    if not 0 < n <= _MAX_FRAMES or shapes != ((n, 21, 2), (n, N_FEATURES), (n,)):
        raise PinelError("camera_source_unreadable", path=str(path))
    if not (np.isfinite(points).all() and np.isfinite(features).all()):
        raise PinelError("camera_source_unreadable", path=str(path))
    return [
        (RecordedHand(points[i], features[i], bool(is_left[i])),) if is_there[i] else ()
        for i in range(n)
    ]


def write_landmark_sequence(path: Path, frames: Sequence[RecordedHand | None]) -> None:
    """Writes frames with one hand or none, in half precision."""
    nobody = RecordedHand(np.zeros((21, 2), np.float32), np.zeros(N_FEATURES, np.float32), False)
    hands = [hand or nobody for hand in frames]
    np.savez_compressed(
        path,
        is_there=np.array([hand is not None for hand in frames]),
        is_left=np.array([hand.is_left for hand in hands]),
        points=np.array([hand.points for hand in hands], np.float16),
        features=np.array([hand.features for hand in hands], np.float16),
    )
