"""Sign classifier: kernel ridge regression on hand features, with a reject option.

The classifier stores each training sample as a point on the 200 principal axes. A hand's score for a sign is a
weighted sum of kernel values over these points (Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006,
2.2). The weights solve one linear system, so samples of a class are added in less than a second.

A hand without a sign may still score high. Its novelty reveals it: the Mahalanobis distance to its best sign, relative
to the distance to all hands (Ren et al., A Simple Fix to Mahalanobis Distance, 2021).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

Features = NDArray[np.float32]
Array = NDArray[np.float64]

NO_SIGN = ""
N_AXES = 200
_KERNEL_GAMMA = 0.6  # kernel exp(-0.6 d²); the mean of d² over random pairs of samples is 2
_RIDGE = 0.01
# Samples without a sign lie between the signs, so the classifier must fit them less exactly.
_RIDGE_OF_NO_SIGN = 0.1
# Share of the covariance that a multiple of the identity replaces: 200 axes, only 1,500 samples.
_SHRINKAGE = 0.05


@dataclass(frozen=True)
class Samples:
    """Labelled hands: features (n, d), and n names of signs. A hand without a sign has the label NO_SIGN."""

    features: Features
    signs: tuple[str, ...]

    def __add__(self, other: "Samples") -> "Samples":
        return Samples(np.concatenate([self.features, other.features]), self.signs + other.signs)

    def where(self, chosen: NDArray[np.bool_]) -> "Samples":
        """Returns the samples for which `chosen` (n,) is True."""
        signs = tuple(sign for sign, is_chosen in zip(self.signs, chosen, strict=True) if is_chosen)
        return Samples(self.features[chosen], signs)


@dataclass(frozen=True)
class RejectThresholds:
    """Reject thresholds: minimum score, minimum margin to the second sign's score, maximum novelty."""

    min_score: float = 0.5
    min_margin: float = 0.2
    max_novelty: float = 1.15


DEFAULT_THRESHOLDS = RejectThresholds()


@dataclass(frozen=True)
class ClassScores:
    """Scores of n hands for k signs.

    scores (n, k): about 1 for the sign that the hand shows, about 0 for the others.
    novelty (n,): relative Mahalanobis distance to the best sign; below 0 for a hand like the training samples.
    """

    scores: Array
    novelty: Array

    @property
    def best(self) -> NDArray[np.int64]:
        """The index of each hand's best sign, (n,)."""
        numbers: NDArray[np.int64] = self.scores.argmax(1)
        return numbers

    def is_clear(self, thresholds: RejectThresholds = DEFAULT_THRESHOLDS) -> NDArray[np.bool_]:
        """Returns whether each hand passes the reject thresholds, (n,)."""
        second, best = np.sort(self.scores, axis=1)[:, -2:].T
        is_sure = (best >= thresholds.min_score) & (best - second >= thresholds.min_margin)
        clear: NDArray[np.bool_] = is_sure & (self.novelty <= thresholds.max_novelty)
        return clear


@dataclass(frozen=True)
class Calibration:
    """Converts scores to probabilities: softmax(sharpness * scores), with a constant logit `no_sign` for "no sign"."""

    sharpness: float = 10.0
    no_sign: float = 0.0

    def probabilities(self, scores: Array) -> Array:
        """Returns the probability of each sign; the last column is "no sign": (n, k) -> (n, k + 1)."""
        share = np.full((len(scores), 1), self.no_sign)
        logits = np.hstack([self.sharpness * scores, share])
        raised = np.exp(logits - logits.max(1, keepdims=True))
        shares: Array = raised / raised.sum(1, keepdims=True)
        return shares


@dataclass(frozen=True)
class SignPrediction:
    """Prediction for one hand: `sign` is None if rejected; `best` and `second` are the likeliest signs.

    confidence, second_confidence: probabilities of `best` and `second`.
    """

    sign: str | None
    best: str
    confidence: float
    second: str
    second_confidence: float


@dataclass(frozen=True)
class Projection:
    """Projects features to points: mean and scale of each feature (d,), and the principal axes (d, m)."""

    mean: Array
    scale: Array
    axes: Array

    @classmethod
    def of(cls, features: Features, blocks: Sequence[slice]) -> "Projection":
        """Computes the principal axes of standardised features; features of a block weigh equally, and so do blocks."""
        mean = features.mean(0, dtype=np.float64)
        scale = 1 / (features.std(0, dtype=np.float64) + 1e-4)
        for block in blocks:
            scale[block] /= np.sqrt(len(blocks) * (block.stop - block.start))
        spread = (features - mean) * scale
        _, axes = np.linalg.eigh(spread.T @ spread)
        return cls(*(stored(part) for part in (mean, scale, _signed(axes[:, ::-1][:, :N_AXES]))))

    def __call__(self, features: Features) -> Array:
        """Returns the points (n, m) of features (n, d)."""
        points: Array = ((features - self.mean) * self.scale) @ self.axes
        return points


@dataclass(frozen=True)
class SignClassifier:
    """Classifier of k signs, trained on n points (n, m).

    members (n,): index of each point's sign, -1 for NO_SIGN.
    weights (n, k): weight of each point in the score of each sign.
    """

    signs: tuple[str, ...]
    projection: Projection
    points: Array
    members: NDArray[np.int64]
    weights: Array
    calibration: Calibration = Calibration()

    @classmethod
    def fit(
        cls, samples: Samples, blocks: Sequence[slice], projection: Projection | None = None
    ) -> "SignClassifier":
        """Trains a classifier on the samples, with the axes of `projection`, or by default with axes of the samples."""
        if projection is None:
            known = np.array([sign != NO_SIGN for sign in samples.signs])
            projection = Projection.of(samples.features[known], blocks)
        signs = tuple(sorted({sign for sign in samples.signs if sign != NO_SIGN}))
        points = stored(projection(samples.features))
        members = _numbers(samples.signs, signs)
        return cls(signs, projection, points, members, _ridge_weights(points, members, len(signs)))

    def with_samples(self, samples: Samples) -> "SignClassifier":
        """Returns a classifier with additional samples, of existing or new signs; takes about 0.3 s."""
        new = sorted({*samples.signs} - {*self.signs, NO_SIGN})
        signs = (*self.signs, *new)
        points = np.concatenate([self.points, stored(self.projection(samples.features))])
        members = np.concatenate([self.members, _numbers(samples.signs, signs)])
        weights = _ridge_weights(points, members, len(signs))
        return replace(self, signs=signs, points=points, members=members, weights=weights)

    def score(self, features: Features) -> ClassScores:
        """Returns the scores of n hands with features (n, d)."""
        points = self.projection(features)
        scores: Array = _kernel(points, self.points) @ self.weights
        return ClassScores(scores, self._novelty(points, scores.argmax(1)))

    def predict(
        self, features: Features, thresholds: RejectThresholds = DEFAULT_THRESHOLDS
    ) -> SignPrediction:
        """Returns the prediction for one hand with features (d,)."""
        class_scores = self.score(features[None])
        shares = self.calibration.probabilities(class_scores.scores)[0]
        second, best = np.argsort(class_scores.scores[0], kind="stable")[-2:]
        return SignPrediction(
            sign=self.signs[best] if class_scores.is_clear(thresholds)[0] else None,
            best=self.signs[best],
            confidence=float(shares[best]),
            second=self.signs[second],
            second_confidence=float(shares[second]),
        )

    def _novelty(self, points: Array, best: NDArray[np.int64]) -> Array:
        """Returns the squared Mahalanobis distance to the best sign minus the distance to all signs, per axis, (n,)."""
        from_sign = (points - self._means[best]) @ self._within
        from_all = (points - self._shown.mean(0)) @ self._overall
        farther: Array = ((from_sign**2).sum(1) - (from_all**2).sum(1)) / points.shape[1]
        return farther

    @cached_property
    def _shown(self) -> Array:
        """The points with a sign."""
        return self.points[self.members >= 0]

    @cached_property
    def _means(self) -> Array:
        """Mean point of each sign, (k, m)."""
        members = self.members[self.members >= 0]
        totals = np.zeros((len(self.signs), self.points.shape[1]))
        np.add.at(totals, members, self._shown)
        means: Array = totals / np.bincount(members, minlength=len(self.signs))[:, None]
        return means

    @cached_property
    def _within(self) -> Array:
        """Whitening matrix of the deviations from the mean of the own sign, (m, m)."""
        return _whitening(self._shown - self._means[self.members[self.members >= 0]])

    @cached_property
    def _overall(self) -> Array:
        """Whitening matrix of the deviations from the mean of all hands with a sign, (m, m)."""
        return _whitening(self._shown - self._shown.mean(0))


def _whitening(deviations: Array) -> Array:
    """Returns the matrix (m, m) that scales deviations (n, m) to unit covariance."""
    covariance = deviations.T @ deviations / len(deviations)
    ball = np.eye(len(covariance)) * np.trace(covariance) / len(covariance)
    mixed = (1 - _SHRINKAGE) * covariance + _SHRINKAGE * ball
    whitening: Array = np.linalg.inv(np.linalg.cholesky(mixed)).T
    return whitening


def calibrated(scores: Array, numbers: NDArray[np.int64]) -> Calibration:
    """Returns the calibration with the greatest likelihood of the labels.

    Args:
        numbers: the label of each row of scores, (n,): the index of the sign, k for no sign.
    """
    rows = np.arange(len(numbers))

    def surprise(calibration: Calibration) -> float:
        shares = calibration.probabilities(scores)[rows, numbers]
        return float(-np.log(shares + 1e-12).mean())

    tried = [Calibration(s, n) for s in np.arange(4, 20, 0.5) for n in np.arange(-2, 8, 0.25)]
    return min(tried, key=surprise)


def stored(values: Any) -> Array:
    """Rounds values to half precision, as in the file: so predictions are equal before saving and after loading."""
    return np.asarray(values, np.float16).astype(np.float64)


def _numbers(names: Sequence[str], signs: tuple[str, ...]) -> NDArray[np.int64]:
    return np.array([signs.index(name) if name != NO_SIGN else -1 for name in names], np.int64)


def _ridge_weights(points: Array, members: NDArray[np.int64], n_signs: int) -> Array:
    """Returns weights that fit the score 1 for each point's sign and 0 for the others, regularised by the ridge."""
    targets = (members[:, None] == np.arange(n_signs)).astype(np.float64)
    system = _kernel(points, points)
    system[np.diag_indices_from(system)] += np.where(members < 0, _RIDGE_OF_NO_SIGN, _RIDGE)
    weights: Array = np.linalg.solve(system, targets)
    return weights.astype(np.float32).astype(np.float64)


def _kernel(a: Array, b: Array) -> Array:
    """Returns the kernel exp(-0.6 d²) for all pairs of points: (n, m), (p, m) -> (n, p)."""
    near: Array = np.exp(-_KERNEL_GAMMA * _squared_distances(a, b))
    return near


def _squared_distances(a: Array, b: Array) -> Array:
    squared = (a * a).sum(1)[:, None] + (b * b).sum(1) - 2 * a @ b.T
    distances: Array = np.maximum(squared, 0)
    return distances


def _signed(axes: Array) -> Array:
    """Makes the largest component of each axis (d, m) positive, because the sign of an eigenvector is arbitrary."""
    max_rows = np.abs(axes).argmax(0)
    turned: Array = axes * np.sign(axes[max_rows, np.arange(axes.shape[1])])
    return turned
