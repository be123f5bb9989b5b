"""From recordings to the classifier of letters that ships."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.classifier import (
    NO_SIGN,
    Calibration,
    Judgement,
    Projection,
    Samples,
    SignClassifier,
    calibrated,
)
from pinel_desktop.gestures.features import BLOCKS
from pinel_desktop.gestures.training.folds import Fold, leave_one_source_out
from pinel_desktop.gestures.training.recordings import Recordings

SEED = 20230815
N_TRANSITIONS = 300
# how far on the way from one letter to another a hand shows neither
_BETWEEN = (0.35, 0.65)
# labelled C, shows D: not learnt from, but counted as it is labelled where letters are tested
WRONG_LABELS = ("WIN_20230812_12_38_22_Pro_jpg.rf.fc31fe7e06b57c421580f44693b92aa3.jpg",)


@dataclass(frozen=True)
class OutOfSource:
    """What classifiers say about n photographs whose sources they never saw.

    signs: the k letters. tested: the photographs. hands: what is thought of them. between: of hands on the way between
    two letters. painted: of what was taken for a hand where it was painted over.
    """

    signs: tuple[str, ...]
    tested: Recordings
    hands: Judgement
    between: Judgement
    painted: Judgement

    @property
    def is_right(self) -> NDArray[np.bool_]:
        """Whether the best letter is the one that was shown, (n,)."""
        right: NDArray[np.bool_] = np.array(self.signs)[self.hands.best] == self.tested.letters
        return right

    @property
    def numbers(self) -> NDArray[np.int64]:
        """The number of the letter that was shown, (n,)."""
        return np.searchsorted(self.signs, self.tested.letters).astype(np.int64)


def train(recordings: Recordings, seed: int = SEED) -> SignClassifier:
    """The classifier of all letters in the recordings, its confidence calibrated on sources that it had not seen."""
    seen = out_of_source(recordings, leave_one_source_out(recordings.sources), seed)
    calibration = calibrate(seen, np.ones(len(seen.tested), bool))
    return replace(learn(recordings, seed), calibration=calibration)


def calibrate(seen: OutOfSource, chosen: NDArray[np.bool_]) -> Calibration:
    """The calibration that suits the chosen hands (n,), and what was taken for a hand and is none.

    Hands between two letters are left out: how often they come is not known, and a letter would get too little.
    """
    nothing = np.full(len(seen.painted.scores), len(seen.signs))
    scores = np.concatenate([seen.hands.scores[chosen], seen.painted.scores])
    return calibrated(scores, np.concatenate([seen.numbers[chosen], nothing]))


def learn(
    recordings: Recordings, seed: int = SEED, projection: Projection | None = None
) -> SignClassifier:
    """A classifier of the letters in the recordings, not calibrated."""
    usable = recordings.is_hand & ~np.isin(recordings.files, WRONG_LABELS)
    hands = recordings.where(usable)
    between = transitions(hands, N_TRANSITIONS, np.random.default_rng(seed))
    return SignClassifier.fit(hands.samples() + recordings.painted + between, BLOCKS, projection)


def transitions(recordings: Recordings, n: int, random: np.random.Generator) -> Samples:
    """About n hands on the way between two letters of one source: features mixed, which show no sign."""
    mixed = []
    for source in np.unique(recordings.sources):
        own = recordings.where((recordings.sources == source) & recordings.is_hand)
        first, second = random.integers(0, len(own), (2, round(n * len(own) / len(recordings))))
        differ = own.letters[first] != own.letters[second]
        share = random.uniform(*_BETWEEN, (int(differ.sum()), 1)).astype(np.float32)
        a, b = own.features[first[differ]], own.features[second[differ]]
        mixed.append(a + share * (b - a))
    features = np.concatenate(mixed)
    return Samples(features, (NO_SIGN,) * len(features))


def out_of_source(recordings: Recordings, folds: Iterable[Fold], seed: int = SEED) -> OutOfSource:
    """Each fold's photographs, judged by a classifier that learnt from the rest."""
    signs = tuple(map(str, np.unique(recordings.letters)))
    tested, judged = [], []
    for fold in folds:
        classifier = learn(recordings.where(fold.train), seed)
        own = recordings.where(fold.test)
        between = transitions(own, len(own), np.random.default_rng(seed + 1))
        probed = (own.features, between.features, own.painted.features)
        tested.append(own)
        judged.append([_aligned(classifier, features, signs) for features in probed])
    parts = (_joined(part) for part in zip(*judged, strict=True))
    return OutOfSource(signs, Recordings.joined(tested), *parts)


def _aligned(
    classifier: SignClassifier, features: NDArray[np.float32], signs: tuple[str, ...]
) -> Judgement:
    """The judgement with a score for each of `signs`; 0 for one that the classifier never met."""
    found = classifier.judge(features)
    scores = np.zeros((len(features), len(signs)))
    scores[:, [signs.index(sign) for sign in classifier.signs]] = found.scores
    return Judgement(scores, found.strangeness)


def _joined(parts: Sequence[Judgement]) -> Judgement:
    return Judgement(
        np.concatenate([part.scores for part in parts]),
        np.concatenate([part.strangeness for part in parts]),
    )
