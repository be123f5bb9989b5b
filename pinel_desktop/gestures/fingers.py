"""Counts raised fingers from the geometry of the landmarks; no training.

Input is the hand in the palm's frame (`features.palm_landmarks`), so size, position, side and direction of the hand do
not matter. Each finger has one measure and one limit:

- index to little finger: distance of the tip from the wrist, divided by that of the middle joint. It exceeds 1 for a
  straight finger, and is below 1 for a finger that is folded into the palm.
- thumb: how far its tip stands out sideways beyond the base of the index finger, in widths of the palm. A thumb that
  lies along the fist (A) or across the palm (B) does not stand out.

A logistic function of measure and limit is the probability that the finger is raised. Fingers are taken as independent,
so the convolution of their probabilities is the probability of each count (Poisson binomial distribution), also over
two hands. A finger near its limit leaves two counts likely: that is the doubt.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MIN_CONFIDENCE = 0.97  # as the stability filter demands of letters
_TIPS, _MIDDLE_JOINTS = [8, 12, 16, 20], [6, 10, 14, 18]
_THUMB_TIP, _INDEX_BASE, _LITTLE_BASE = 4, 5, 17
# Limits: midway between folded and raised fingers (docs/gestures.md). The scale is the distance from the limit at which
# one of the two is e times as probable as the other.
_FINGER_LIMIT, _FINGER_SCALE = 1.15, 0.025
_THUMB_LIMIT, _THUMB_SCALE = 0.47, 0.04


@dataclass(frozen=True)
class NumberPrediction:
    """A number shown by hand, in digits, and the second likeliest number ("" without one).

    confidence: probability of `best`, 0 to 1. is_sure: whether it counts as shown.
    """

    best: str
    confidence: float
    second: str
    is_sure: bool

    def as_unsure(self) -> "NumberPrediction":
        """Returns the same prediction as one that does not count."""
        return replace(self, is_sure=False)


def count_fingers(hands: Sequence[Array]) -> NumberPrediction:
    """Returns the number of raised fingers of all hands together.

    Args:
        hands: landmarks (21, 3) of each hand in its palm's frame, at least one hand.
    """
    shares = np.ones(1)
    for landmarks in hands:
        for raised in raised_probabilities(landmarks):
            shares = np.convolve(shares, [1.0 - raised, raised])
    second, best = np.argsort(shares, kind="stable")[-2:]
    confidence = float(shares[best])
    return NumberPrediction(str(best), confidence, str(second), confidence >= MIN_CONFIDENCE)


def raised_probabilities(landmarks: Array) -> Array:
    """Returns the probability of each finger, thumb first, that it is raised, (5,)."""
    thumb = (_thumb_measure(landmarks) - _THUMB_LIMIT) / _THUMB_SCALE
    fingers = (_finger_measures(landmarks) - _FINGER_LIMIT) / _FINGER_SCALE
    odds = np.concatenate([[thumb], fingers])
    probabilities: Array = 1.0 / (1.0 + np.exp(-np.clip(odds, -30.0, 30.0)))
    return probabilities


def _finger_measures(landmarks: Array) -> Array:
    """Returns the distance of each tip from the wrist, divided by that of the middle joint, (4,)."""
    from_wrist = np.linalg.norm(landmarks, axis=1)
    measures: Array = from_wrist[_TIPS] / (from_wrist[_MIDDLE_JOINTS] + 1e-9)
    return measures


def _thumb_measure(landmarks: Array) -> float:
    """Returns how far the thumb's tip stands out beyond the index finger's base, in widths of the palm."""
    width = float(np.linalg.norm(landmarks[_INDEX_BASE] - landmarks[_LITTLE_BASE])) + 1e-9
    return float(landmarks[_THUMB_TIP, 0] - landmarks[_INDEX_BASE, 0]) / width
