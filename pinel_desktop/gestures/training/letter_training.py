"""Trains the shipped classifier of letters on photographs, and cross-validates it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.classifier import (
    NO_SIGN,
    Calibration,
    ClassScores,
    Projection,
    Samples,
    SignClassifier,
    calibrated,
)
from pinel_desktop.gestures.features import BLOCKS
from pinel_desktop.gestures.training.folds import Fold, leave_one_source_out
from pinel_desktop.gestures.training.photo_features import PhotoFeatures

SEED = 20230815
N_TRANSITIONS = 300
# range of the mixing ratio between two letters in which a hand shows neither
_BETWEEN = (0.35, 0.65)
# Labelled C, shows D: excluded from training, but counted with its label in tests.
WRONG_LABELS = ("WIN_20230812_12_38_22_Pro_jpg.rf.fc31fe7e06b57c421580f44693b92aa3.jpg",)


@dataclass(frozen=True)
class CrossValidation:
    """Scores of n photographs, each from a classifier that was trained without its source.

    signs: the k letters. tested: the photographs. hands: their scores.
    between: scores of hands in transition between two letters.
    painted: scores of false hands, detected after the hand was painted over.
    """

    signs: tuple[str, ...]
    tested: PhotoFeatures
    hands: ClassScores
    between: ClassScores
    painted: ClassScores

    @property
    def is_right(self) -> NDArray[np.bool_]:
        """Whether the best letter is the true letter, (n,)."""
        right: NDArray[np.bool_] = np.array(self.signs)[self.hands.best] == self.tested.letters
        return right

    @property
    def numbers(self) -> NDArray[np.int64]:
        """Index of the true letter, (n,)."""
        return np.searchsorted(self.signs, self.tested.letters).astype(np.int64)


def train(dataset: PhotoFeatures, seed: int = SEED) -> SignClassifier:
    """Trains the classifier of all letters in the photographs; calibrates its confidence on left-out sources."""
    validation = cross_validate(dataset, leave_one_source_out(dataset.sources), seed)
    calibration = calibrate(validation, np.ones(len(validation.tested), bool))
    return replace(fit_letters(dataset, seed), calibration=calibration)


def calibrate(validation: CrossValidation, chosen: NDArray[np.bool_]) -> Calibration:
    """Calibrates on the chosen hands (n,), and on false hands with the label "no sign".

    Leaves out hands in transition: their frequency is unknown, and the confidence in letters would become too low.
    """
    nothing = np.full(len(validation.painted.scores), len(validation.signs))
    scores = np.concatenate([validation.hands.scores[chosen], validation.painted.scores])
    return calibrated(scores, np.concatenate([validation.numbers[chosen], nothing]))


def fit_letters(
    dataset: PhotoFeatures, seed: int = SEED, projection: Projection | None = None
) -> SignClassifier:
    """Trains a classifier of the letters in the photographs, without calibration."""
    usable = dataset.is_hand & ~np.isin(dataset.files, WRONG_LABELS)
    hands = dataset.where(usable)
    between = transitions(hands, N_TRANSITIONS, np.random.default_rng(seed))
    return SignClassifier.fit(hands.samples() + dataset.painted + between, BLOCKS, projection)


def transitions(dataset: PhotoFeatures, n: int, random: np.random.Generator) -> Samples:
    """Returns about n synthetic hands without a sign: mixed features of two letters of one source."""
    mixed = []
    for source in np.unique(dataset.sources):
        own = dataset.where((dataset.sources == source) & dataset.is_hand)
        first, second = random.integers(0, len(own), (2, round(n * len(own) / len(dataset))))
        differ = own.letters[first] != own.letters[second]
        share = random.uniform(*_BETWEEN, (int(differ.sum()), 1)).astype(np.float32)
        a, b = own.features[first[differ]], own.features[second[differ]]
        mixed.append(a + share * (b - a))
    features = np.concatenate(mixed)
    return Samples(features, (NO_SIGN,) * len(features))


def cross_validate(
    dataset: PhotoFeatures, folds: Iterable[Fold], seed: int = SEED
) -> CrossValidation:
    """Scores each fold's photographs with a classifier trained on the rest."""
    signs = tuple(map(str, np.unique(dataset.letters)))
    tested, judged = [], []
    for fold in folds:
        classifier = fit_letters(dataset.where(fold.train), seed)
        own = dataset.where(fold.test)
        between = transitions(own, len(own), np.random.default_rng(seed + 1))
        probed = (own.features, between.features, own.painted.features)
        tested.append(own)
        judged.append([_aligned(classifier, features, signs) for features in probed])
    parts = (_joined(part) for part in zip(*judged, strict=True))
    return CrossValidation(signs, PhotoFeatures.joined(tested), *parts)


def _aligned(
    classifier: SignClassifier, features: NDArray[np.float32], signs: tuple[str, ...]
) -> ClassScores:
    """Returns scores with a column for each of `signs`; 0 for a sign outside the classifier's training data."""
    found = classifier.score(features)
    scores = np.zeros((len(features), len(signs)))
    scores[:, [signs.index(sign) for sign in classifier.signs]] = found.scores
    return ClassScores(scores, found.novelty)


def _joined(parts: Sequence[ClassScores]) -> ClassScores:
    return ClassScores(
        np.concatenate([part.scores for part in parts]),
        np.concatenate([part.novelty for part in parts]),
    )
