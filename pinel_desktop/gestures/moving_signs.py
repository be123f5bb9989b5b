"""Signs that move, recognised by the movements that a class has shown of them; null when in doubt.

A movement is compared with each example by dynamic time warping (warping.py) of the hand's shape, its way, the
direction in which it goes and its size. It is the sign whose two nearest examples are nearest, if they are near enough
and clearly nearer than those of any other sign. How near is enough follows from the examples: how far they lie apart,
and how near another sign comes to them. The constants were chosen on synthetic movements (training/moving_hands.py).
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures import movements, warping
from pinel_desktop.gestures.movements import GROWTH, N_FRAMES, PATH, SHAPE, TIME, Movement

Array = NDArray[np.float64]

N_NEAREST = 2
# distances: always near enough; never; and the median among a sign's examples counts so many times between
NEAR, FAR, _SPREAD = 0.55, 0.6, 1.4
_CLEAR = 0.85  # of the distance to the second sign
# the way alone must be near too: people's hands differ more than their movements, and one's own hand hides a wrong way
_MAX_PATH_DISTANCE = 0.27
_MIN_PATH_EXTENT = (
    1.5  # sizes of the hand: shorter ways are not stretched to the length of the others
)
_DIRECTION = 0.2  # weight, for the way of a whole movement in a unit of its time
_PACES = (0.35, 2.8)  # how long a movement takes, relative to the median of the examples
_N_SHAPE = 42
_BEGINS_AS = 0.48  # distance of shapes up to which a hand may be about to begin a sign
_SHARPNESS = 12.0


@dataclass(frozen=True, slots=True)
class MovingSignPrediction:
    """What a movement shows: `sign` is None in doubt; `best` and `second` are the likeliest signs, "" for none.

    confidence: from 0 to 1, higher for a nearer movement; not calibrated.
    """

    sign: str | None
    best: str
    confidence: float
    second: str


class MovingSignClassifier:
    """Knows signs by n movements of each, (n, 38, 46); without any, no movement is a sign."""

    def __init__(self, examples: Mapping[str, NDArray[np.float32]]) -> None:
        self.signs = tuple(examples)
        shown = [np.asarray(examples[sign], np.float64) for sign in self.signs]
        self._owners = np.repeat(np.arange(len(shown)), [len(one) for one in shown])
        self._sequences = _sequences(np.concatenate(shown)) if shown else None
        self._paces = np.array([np.median(one[:, -1, TIME]) for one in shown])
        self._beginnings = _beginnings(np.concatenate(shown)) if shown else np.empty((0, 42))
        self._thresholds = self._calibrated()

    def predict(self, movement: Movement) -> MovingSignPrediction:
        """What a movement (38, 46) shows."""
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
        """Whether a hand at rest, landmarks (21, 2) in px, looks like the beginning of one of the signs."""
        if not len(self._beginnings):
            return False
        offsets = self._beginnings - movements.shape(points, is_left=is_left)
        return bool((np.sqrt((offsets**2).sum(1) / 21) <= _BEGINS_AS).any())

    def _distances(self, sequence: Array, but: int | None = None) -> Array:
        """Of each sign the mean distance of its nearest examples, (k,); without example `but`."""
        assert self._sequences is not None
        distances = warping.dtw_distances(sequence, self._sequences)
        if but is not None:
            distances[but] = np.inf
        return np.array(
            [_mean_of_nearest(distances[self._owners == k]) for k in range(len(self.signs))]
        )

    def _path_distance(self, sequence: Array, k: int) -> float:
        """The same of one sign, without the hand's shape."""
        assert self._sequences is not None
        examples = self._sequences[self._owners == k]
        distances = warping.dtw_distances(sequence[:, _N_SHAPE:], examples[..., _N_SHAPE:])
        return _mean_of_nearest(distances)

    def _calibrated(self) -> Array:
        """Of each sign, from which distance on a movement is none of it any more, (k,)."""
        thresholds = np.full(len(self.signs), NEAR)
        if self._sequences is None:
            return thresholds
        distances = np.array([self._distances(one, i) for i, one in enumerate(self._sequences)])
        for k in range(len(self.signs)):
            own = distances[self._owners == k]
            spread = np.median(own[:, k])
            if np.isfinite(spread):  # there are two examples at least
                thresholds[k] = np.clip(_SPREAD * spread, NEAR, FAR)
            others = np.delete(own, k, axis=1)
            if others.size:
                thresholds[k] = min(thresholds[k], float(np.median(others.min(1))))
        return thresholds

    def _confidence(self, distances: Array, best: int) -> float:
        """The share of the best sign, beside the others and "none" at the threshold."""
        none = self._thresholds[best] + 0.1
        shares = np.exp(-_SHARPNESS * (np.append(distances, none) - distances[best]))
        return float(1.0 / shares.sum())


def _mean_of_nearest(distances: Array) -> float:
    finite = np.sort(distances[np.isfinite(distances)])
    return float(finite[:N_NEAREST].mean()) if len(finite) else float("inf")


def _sequences(shown: Array) -> Array:
    """Movements (n, 38, 46) as what is compared, (n, 38, d): shape, way, direction and growth, weighted."""
    path = shown[..., PATH] - shown[:, :1, PATH]
    reach = np.maximum(np.linalg.norm(path, axis=2).max(1), _MIN_PATH_EXTENT)[:, None, None]
    direction = np.gradient(path, axis=1) * N_FRAMES * _DIRECTION
    growth = shown[..., GROWTH] - shown[:, :3, GROWTH].mean(1, keepdims=True)
    parts = [shown[..., SHAPE] / np.sqrt(21), path / reach, direction / reach, growth[..., None]]
    return np.concatenate(parts, axis=2)


def _beginnings(shown: Array) -> Array:
    """The shapes of the hand with which movements begin, (n, 42)."""
    shapes: Array = shown[:, :3, SHAPE].mean(1)
    return shapes
