"""Nearest-neighbour classifier of moving signs, with a reject option.

Dynamic time warping (warping.py) compares a movement with each example that a class has shown. It compares the hand's
shape, path, direction and growth. The best sign is the sign with the smallest mean distance to its two nearest
examples. The movement is rejected if this distance exceeds a threshold, or is not clearly less than the second sign's.

Each sign's threshold follows from the distances among its examples, and from their distances to other signs. The
constants were chosen on synthetic movements (training/moving_hands.py).
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.moving import movements, warping
from pinel_desktop.gestures.moving.movements import GROWTH, N_FRAMES, PATH, SHAPE, TIME, Movement

Array = NDArray[np.float64]

N_NEAREST = 2
# A sign's threshold: _SPREAD times the median distance among its examples, clipped to [NEAR, FAR]
NEAR, FAR, _SPREAD = 0.55, 0.6, 1.4
_CLEAR = 0.85  # greatest ratio of the distances to the best and to the second sign
# The path has a limit of its own. Hands differ between people more than paths do. If the person
# taught the sign, the matching hand shape would otherwise compensate for a wrong path.
_MAX_PATH_DISTANCE = 0.27
_MIN_PATH_EXTENT = 1.5  # hand sizes; paths are divided by their extent, but not by less than this
_DIRECTION = 0.2  # weight of the path's derivative; unit of time: the movement's duration
_PACES = (0.35, 2.8)  # allowed duration relative to the median of the examples
_N_SHAPE = 42
_BEGINS_AS = 0.48  # greatest distance of a hand's shape to the start of a sign
_SHARPNESS = 12.0


@dataclass(frozen=True, slots=True)
class MovingSignPrediction:
    """Prediction for a movement: `sign` is None if rejected; `best` and `second` are the likeliest signs, "" for none.

    confidence: 0 to 1, higher for a nearer movement; not calibrated.
    """

    sign: str | None
    best: str
    confidence: float
    second: str


class MovingSignClassifier:
    """Classifier with n example movements for each sign, (n, 38, 46). Without examples it rejects every movement."""

    def __init__(self, examples: Mapping[str, NDArray[np.float32]]) -> None:
        self.signs = tuple(examples)
        shown = [np.asarray(examples[sign], np.float64) for sign in self.signs]
        self._owners = np.repeat(np.arange(len(shown)), [len(one) for one in shown])
        self._sequences = _sequences(np.concatenate(shown)) if shown else None
        self._paces = np.array([np.median(one[:, -1, TIME]) for one in shown])
        self._beginnings = _beginnings(np.concatenate(shown)) if shown else np.empty((0, 42))
        self._thresholds = self._calibrated()

    def predict(self, movement: Movement) -> MovingSignPrediction:
        """Returns the prediction for a movement (38, 46)."""
        if self._sequences is None:
            return MovingSignPrediction(None, "", 0.0, "")
        sequence = _sequences(movement[None].astype(np.float64))[0]
        distances = self._distances(sequence)
        order = np.argsort(distances, kind="stable")
        best, second = int(order[0]), int(order[1]) if len(order) > 1 else None
        pace = float(movement[-1, TIME]) / (self._paces[best] + 1e-6)
        is_sign = (
            distances[best] <= self._thresholds[best]
            and self._path_distance(sequence, best) <= _MAX_PATH_DISTANCE
            and (second is None or distances[best] <= _CLEAR * distances[second])
            and _PACES[0] <= pace <= _PACES[1]
        )
        return MovingSignPrediction(
            self.signs[best] if is_sign else None,
            self.signs[best],
            self._confidence(distances, best),
            "" if second is None else self.signs[second],
        )

    def may_begin(self, points: NDArray[np.float32], *, is_left: bool) -> bool:
        """Returns whether a hand at rest, landmarks (21, 2) in px, has the shape with which a sign starts."""
        if not len(self._beginnings):
            return False
        offsets = self._beginnings - movements.shape(points, is_left=is_left)
        return bool((np.sqrt((offsets**2).sum(1) / 21) <= _BEGINS_AS).any())

    def _distances(self, sequence: Array, but: int | None = None) -> Array:
        """Returns the mean distance to each sign's nearest examples, (k,), without the example number `but`."""
        assert self._sequences is not None
        distances = warping.dtw_distances(sequence, self._sequences)
        if but is not None:
            distances[but] = np.inf
        return np.array(
            [_mean_of_nearest(distances[self._owners == k]) for k in range(len(self.signs))]
        )

    def _path_distance(self, sequence: Array, k: int) -> float:
        """Returns the mean distance to the nearest examples of sign number `k`, without the hand's shape."""
        assert self._sequences is not None
        examples = self._sequences[self._owners == k]
        distances = warping.dtw_distances(sequence[:, _N_SHAPE:], examples[..., _N_SHAPE:])
        return _mean_of_nearest(distances)

    def _calibrated(self) -> Array:
        """Returns each sign's threshold, (k,): the greatest distance of a movement that is this sign."""
        thresholds = np.full(len(self.signs), NEAR)
        if self._sequences is None:
            return thresholds
        distances = np.array([self._distances(one, i) for i, one in enumerate(self._sequences)])
        for k in range(len(self.signs)):
            own = distances[self._owners == k]
            spread = np.median(own[:, k])
            if np.isfinite(spread):  # the sign has at least two examples
                thresholds[k] = np.clip(_SPREAD * spread, NEAR, FAR)
            others = np.delete(own, k, axis=1)
            if others.size:
                thresholds[k] = min(thresholds[k], float(np.median(others.min(1))))
        return thresholds

    def _confidence(self, distances: Array, best: int) -> float:
        """Returns the softmax share of the best sign among all signs and "none", which lies 0.1 above the threshold."""
        none = self._thresholds[best] + 0.1
        shares = np.exp(-_SHARPNESS * (np.append(distances, none) - distances[best]))
        return float(1.0 / shares.sum())


def _mean_of_nearest(distances: Array) -> float:
    finite = np.sort(distances[np.isfinite(distances)])
    return float(finite[:N_NEAREST].mean()) if len(finite) else float("inf")


def _sequences(shown: Array) -> Array:
    """Converts movements (n, 38, 46) to weighted sequences (n, 38, d) for warping: shape, path, direction, growth."""
    path = shown[..., PATH] - shown[:, :1, PATH]
    reach = np.maximum(np.linalg.norm(path, axis=2).max(1), _MIN_PATH_EXTENT)[:, None, None]
    direction = np.gradient(path, axis=1) * N_FRAMES * _DIRECTION
    growth = shown[..., GROWTH] - shown[:, :3, GROWTH].mean(1, keepdims=True)
    parts = [shown[..., SHAPE] / np.sqrt(21), path / reach, direction / reach, growth[..., None]]
    return np.concatenate(parts, axis=2)


def _beginnings(shown: Array) -> Array:
    """Returns the hand's shape at the start of each movement, (n, 42)."""
    shapes: Array = shown[:, :3, SHAPE].mean(1)
    return shapes
