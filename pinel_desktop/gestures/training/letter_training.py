"""From recordings to the classifier of letters that ships."""

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
# how far on the way from one letter to another a hand shows neither
_BETWEEN = (0.35, 0.65)
# labelled C, shows D: not learnt from, but counted as it is labelled where letters are tested
WRONG_LABELS = ("WIN_20230812_12_38_22_Pro_jpg.rf.fc31fe7e06b57c421580f44693b92aa3.jpg",)


@dataclass(frozen=True)
class CrossValidation:
    """What classifiers say about n photographs whose sources they never saw.

    signs: the k letters. tested: the photographs. hands: what is thought of them. between: of hands on the way between
    two letters. painted: of what was taken for a hand where it was painted over.
    """

    signs: tuple[str, ...]
    tested: PhotoFeatures
    hands: ClassScores
    between: ClassScores
    painted: ClassScores

    @property
    def is_right(self) -> NDArray[np.bool_]:
        """Whether the best letter is the one that was shown, (n,)."""
        right: NDArray[np.bool_] = np.array(self.signs)[self.hands.best] == self.tested.letters
        return right

    @property
    def numbers(self) -> NDArray[np.int64]:
        """The number of the letter that was shown, (n,)."""
        return np.searchsorted(self.signs, self.tested.letters).astype(np.int64)


def train(dataset: PhotoFeatures, seed: int = SEED) -> SignClassifier:
    """The classifier of all letters in the recordings, its confidence calibrated on sources that it had not seen."""
    validation = cross_validate(dataset, leave_one_source_out(dataset.sources), seed)
    calibration = calibrate(validation, np.ones(len(validation.tested), bool))
    return replace(fit_letters(dataset, seed), calibration=calibration)


def calibrate(validation: CrossValidation, chosen: NDArray[np.bool_]) -> Calibration:
    """The calibration that suits the chosen hands (n,), and what was taken for a hand and is none.

    Hands between two letters are left out: how often they come is not known, and a letter would get too little.
    """
    nothing = np.full(len(validation.painted.scores), len(validation.signs))
    scores = np.concatenate([validation.hands.scores[chosen], validation.painted.scores])
    return calibrated(scores, np.concatenate([validation.numbers[chosen], nothing]))


def fit_letters(
    dataset: PhotoFeatures, seed: int = SEED, projection: Projection | None = None
) -> SignClassifier:
    """A classifier of the letters in the recordings, not calibrated."""
    usable = dataset.is_hand & ~np.isin(dataset.files, WRONG_LABELS)
    hands = dataset.where(usable)
    between = transitions(hands, N_TRANSITIONS, np.random.default_rng(seed))
    return SignClassifier.fit(hands.samples() + dataset.painted + between, BLOCKS, projection)


def transitions(dataset: PhotoFeatures, n: int, random: np.random.Generator) -> Samples:
    """About n hands on the way between two letters of one source: features mixed, which show no sign."""
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
    """Each fold's photographs, judged by a classifier that learnt from the rest."""
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
    """The judgement with a score for each of `signs`; 0 for one that the classifier never met."""
    found = classifier.score(features)
    scores = np.zeros((len(features), len(signs)))
    scores[:, [signs.index(sign) for sign in classifier.signs]] = found.scores
    return ClassScores(scores, found.novelty)


def _joined(parts: Sequence[ClassScores]) -> ClassScores:
    return ClassScores(
        np.concatenate([part.scores for part in parts]),
        np.concatenate([part.novelty for part in parts]),
    )
