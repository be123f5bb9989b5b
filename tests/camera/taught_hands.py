"""Recorded hands, and hands between two of them: one that shows no letter, one that shows no clear number."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.landmark_sequence import (
    RecordedHand,
    read_landmark_sequence,
    write_landmark_sequence,
)

RECORDINGS = Path(__file__).parent / "recordings"
N_FRAMES = 60
_NOISE = 0.01
_HALF_RAISED = 0.55  # from the little finger of W towards that of B


def shown(letter: str) -> list[RecordedHand]:
    """The frames of a recording in which there is a hand."""
    frames = read_landmark_sequence(RECORDINGS / f"{letter.lower()}.npz")
    return [hand for hands in frames for hand in hands]


def packed(hands: list[RecordedHand]) -> bytes:
    """Features as the store keeps them."""
    return np.stack([hand.features for hand in hands]).astype("<f2").tobytes()


def write_unknown_hand(path: Path) -> Path:
    """Between A and B, at rest, with a little noise in each frame."""
    return _write_between(path, "A", "B", 0.5)


def write_doubtful_number(path: Path) -> Path:
    """Between W and B: three raised fingers, or four."""
    return _write_between(path, "W", "B", _HALF_RAISED)


def _write_between(path: Path, one: str, other: str, part: float) -> Path:
    first, second = shown(one)[0], shown(other)[0]
    chance = np.random.default_rng(5)
    middle = (1.0 - part) * first.features + part * second.features

    def frame() -> RecordedHand:
        noise = chance.normal(0, _NOISE, middle.shape)
        features: NDArray[np.float32] = (middle + noise).astype(np.float32)
        return RecordedHand(first.points, features, is_left=False)

    write_landmark_sequence(path, [frame() for _ in range(N_FRAMES)])
    return path
