"""Recordings of hands that move: the hand of a committed recording, on the computed way of a moving letter."""

from pathlib import Path

import numpy as np

from pinel_desktop.camera.landmark_sequence import RecordedHand, write_landmark_sequence
from pinel_desktop.gestures.moving.movements import HandObservation, Movement, MovementSegmenter
from pinel_desktop.gestures.training import moving_hands as hands
from pinel_desktop.gestures.training.moving_hands import Model
from pinel_desktop.gestures.training.moving_hands import Path as MotionPath
from tests.camera.taught_hands import shown

N_EMPTY = 8  # frames without a hand, so that the recording's end is not a movement to its beginning


def observations(letter: str, motion: tuple[MotionPath, float], seed: int) -> list[HandObservation]:
    """A video of the hand that shows a letter at rest, on a way."""
    model = Model.of(np.stack([hand.features for hand in shown(letter)]))
    return hands.signed(model, *motion, np.random.default_rng(seed))


def movements(letter: str, motion: tuple[MotionPath, float], seeds: range) -> list[Movement]:
    """What is cut out of such videos."""
    found = []
    for seed in seeds:
        segmenter = MovementSegmenter()
        results = (segmenter.update(one) for one in observations(letter, motion, seed))
        found += [movement for movement in results if movement is not None]
    return found


def packed(movements: list[Movement]) -> bytes:
    """As the store keeps them."""
    return np.stack(movements).astype("<f2").tobytes()


def write_moving_hand(
    path: Path, letter: str, motion: tuple[MotionPath, float], seeds: range
) -> Path:
    """A recording of such videos, one after the other."""
    frames: list[RecordedHand | None] = []
    features = [hand.features for hand in shown(letter)]
    for seed in seeds:
        for i, one in enumerate(observations(letter, motion, seed)):
            frames.append(RecordedHand(one.points, features[i % len(features)], one.is_left))
        frames += [None] * N_EMPTY
    write_landmark_sequence(path, frames)
    return path
