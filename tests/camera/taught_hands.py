"""A hand that shows no letter, as a recording: what the features of A and B have in common."""

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


def shown(letter: str) -> list[RecordedHand]:
    """The frames of a recording in which there is a hand."""
    frames = read_landmark_sequence(RECORDINGS / f"{letter.lower()}.npz")
    return [hand for hands in frames for hand in hands]


def packed(hands: list[RecordedHand]) -> bytes:
    """Features as the store keeps them."""
    return np.stack([hand.features for hand in hands]).astype("<f2").tobytes()


def write_unknown_hand(path: Path) -> Path:
    """Between A and B, at rest, with a little noise in each frame."""
    first, second = shown("A")[0], shown("B")[0]
    chance = np.random.default_rng(5)
    middle = (first.features + second.features) / 2

    def frame() -> RecordedHand:
        noise = chance.normal(0, _NOISE, middle.shape)
        features: NDArray[np.float32] = (middle + noise).astype(np.float32)
        return RecordedHand(first.points, features, is_left=False)

    write_landmark_sequence(path, [frame() for _ in range(N_FRAMES)])
    return path
