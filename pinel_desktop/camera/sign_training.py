"""Trains the classifiers on the signs that a class taught, and collects the samples for this training."""

import base64
import logging
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.frame_analyzer import DetectedSign
from pinel_desktop.camera.latest_job import LatestJob
from pinel_desktop.gestures.classifier import Samples, SignClassifier
from pinel_desktop.gestures.features import N_FEATURES
from pinel_desktop.gestures.moving.movements import (
    N_FRAMES,
    N_NUMBERS,
    HandObservation,
    MovementSegmenter,
)
from pinel_desktop.gestures.moving.moving_signs import MovingSignClassifier
from pinel_desktop.gestures.stability import is_still

_log = logging.getLogger(__name__)
_SAMPLE_S = 0.12  # minimum interval, because consecutive frames are nearly the same
_SAMPLE_DTYPE = np.dtype("<f2")
_MAX_FLOAT16 = float(np.finfo(np.float16).max)


@dataclass(frozen=True, slots=True)
class TrainedSigns:
    """The trained classifiers of signs at rest and moving signs, and the names of the taught signs at rest."""

    classifier: SignClassifier
    taught: frozenset[str] = frozenset()
    moving: MovingSignClassifier = field(default_factory=lambda: MovingSignClassifier({}))


class SignTrainer:
    """Trains the classifiers on a thread of its own, so that frame analysis continues meanwhile."""

    def __init__(self, classifier: SignClassifier) -> None:
        self._letters = classifier
        self._job = LatestJob[TrainedSigns]("camera-learner")

    @property
    def is_busy(self) -> bool:
        """Whether training is in progress; predictions of the old classifier must not answer captures meanwhile."""
        return self._job.is_busy

    def train(self, signs: Sequence[dict[str, Any]]) -> None:
        """Starts training on the shipped letters and these signs.

        Args:
            signs: for each sign its name as `sign`; `samples` and `movements` as base64 of float16 (n, 1748).
        """
        self._job.start(partial(self._trained, signs))

    def pop_result(self) -> TrainedSigns | None:
        """Returns the result of a training that ended since the last call, else None."""
        return self._job.pop_result()

    def _trained(self, signs: Sequence[dict[str, Any]]) -> TrainedSigns:
        try:
            return self._taught(signs)
        except (KeyError, TypeError, ValueError, np.linalg.LinAlgError):
            _log.exception("signs cannot be learnt")
            return TrainedSigns(self._letters)

    def _taught(self, signs: Sequence[dict[str, Any]]) -> TrainedSigns:
        moves = {sign["sign"]: _unpacked(sign["movements"]) for sign in signs}
        moving = {name: rows.reshape(-1, N_FRAMES, N_NUMBERS) for name, rows in moves.items()}
        known = MovingSignClassifier({name: rows for name, rows in moving.items() if len(rows)})
        samples = [_unpacked(sign["samples"]) for sign in signs]
        names = [sign["sign"] for sign, found in zip(signs, samples, strict=True) for _ in found]
        if not names:
            return TrainedSigns(self._letters, moving=known)
        classifier = self._letters.with_samples(Samples(np.concatenate(samples), tuple(names)))
        classifier.predict(np.zeros(N_FEATURES, np.float32))  # fills caches on this thread
        return TrainedSigns(classifier, frozenset(names), known)


class SampleCollector:
    """Selects frames as training samples: exactly one hand, at rest, `_SAMPLE_S` or more after the last sample."""

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Forgets the frames so far."""
        self._points: NDArray[np.float32] | None = None
        self._last_frame_s = self._last_sample_s = float("-inf")

    def update(self, time_s: float, hands: Sequence[DetectedSign]) -> str | None:
        """Returns the hand of a suitable frame, packed for messages; None for an unsuitable frame."""
        before, elapsed_s = self._points, time_s - self._last_frame_s
        self._points, self._last_frame_s = (hands[0].points if len(hands) == 1 else None), time_s
        if self._points is None or before is None or not is_still(before, self._points, elapsed_s):
            return None
        if time_s - self._last_sample_s < _SAMPLE_S:
            return None
        features = hands[0].features
        packed = pack(features) if features is not None else None
        self._last_sample_s = time_s if packed else self._last_sample_s
        return packed


class MovementCollector:
    """Segments movements as training samples: exactly one hand, from rest to rest."""

    def __init__(self) -> None:
        self._segmenter = MovementSegmenter()

    def reset(self) -> None:
        """Forgets the frames so far."""
        self._segmenter.reset()

    def update(self, time_s: float, hands: Sequence[DetectedSign]) -> str | None:
        """Returns the movement that ends with this frame, packed for messages; None if none ends."""
        hand = hands[0] if len(hands) == 1 else None
        if hand is None or hand.points is None:
            self._segmenter.reset() if hands else None
            return None
        movement = self._segmenter.update(
            HandObservation(time_s, hand.points, hand.handedness == "left")
        )
        return None if movement is None else pack(movement)


def pack(numbers: NDArray[np.float32]) -> str | None:
    """Packs the numbers of a sample for messages; None if a number exceeds half precision."""
    if not (np.abs(numbers) <= _MAX_FLOAT16).all():
        return None
    return base64.b64encode(numbers.astype(_SAMPLE_DTYPE).tobytes()).decode("ascii")


def _unpacked(packed: str) -> NDArray[np.float32]:
    octets = base64.b64decode(packed, validate=True)
    return np.frombuffer(octets, _SAMPLE_DTYPE).reshape(-1, N_FEATURES).astype(np.float32)
