"""Evaluates letter recognition on people outside the training data, by letter and by source, with 95 % intervals."""

import time
from collections.abc import Callable, Iterator, Sequence
from statistics import median
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.classifier import (
    DEFAULT_THRESHOLDS,
    ClassScores,
    RejectThresholds,
    SignClassifier,
)
from pinel_desktop.gestures.recognition import LandmarkRecognizer
from pinel_desktop.gestures.training.accuracy_metrics import (
    Proportion,
    calibration_error,
    proportions_by,
)
from pinel_desktop.gestures.training.folds import CROPS, Fold, leave_one_source_out, strict
from pinel_desktop.gestures.training.letter_training import (
    SEED,
    WRONG_LABELS,
    CrossValidation,
    calibrate,
    cross_validate,
    fit_letters,
)
from pinel_desktop.gestures.training.photo_features import PhotoFeatures
from pinel_desktop.gestures.training.photos import Photo

N_TAUGHT = 4  # frames a letter
# people with enough photographs of each letter both to teach and to test it
TAUGHT_PEOPLE = ("p1_webcam", "p2_webcam", "p3_webcam")

Report = dict[str, Any]
Folds = Callable[[NDArray[np.str_]], Iterator[Fold]]


def evaluate_unseen(
    dataset: PhotoFeatures,
    seed: int = SEED,
    thresholds: RejectThresholds = DEFAULT_THRESHOLDS,
    *,
    unknown: bool = True,
) -> Report:
    """Cross-validates twice: without each source in turn, and strictly without each person at a webcam.

    Args:
        unknown: False skips the test of letters outside the training data, which takes two minutes.
    """
    report: Report = {
        "photos": len(dataset),
        "hands_found": hands_found(dataset),
        "leave_one_source_out": _unseen(dataset, leave_one_source_out, seed, thresholds),
        "strict": _unseen(dataset, strict, seed, thresholds),
    }
    report["strict"]["taught"] = _taught(dataset, seed)
    if unknown:
        report["strict"]["unknown_letter_refused"] = unknown_refused(dataset, seed, thresholds)
    return report


def evaluate_known(
    dataset: PhotoFeatures,
    classifier: SignClassifier,
    thresholds: RejectThresholds = DEFAULT_THRESHOLDS,
) -> Report:
    """Evaluates a classifier as it is. If it was trained on the same people, the result does not apply to others."""
    judged = classifier.score(dataset.features)
    right = np.array(classifier.signs)[judged.best] == dataset.letters
    confidence = classifier.calibration.probabilities(judged.scores)[:, :-1].max(1)
    return {
        "photos": len(dataset),
        "hands_found": hands_found(dataset),
        **_answers(dataset, judged, right, thresholds),
        "calibration_error": round(calibration_error(confidence, right), 4),
        "painted_over_answered": _painted_answered(
            dataset, classifier.score(dataset.painted.features), thresholds
        ),
    }


def hands_found(dataset: PhotoFeatures) -> Report:
    """Returns the share of photographs in which the labelled hand is detected, with the crops separate."""
    crops = dataset.sources == CROPS
    return {
        "all_but_crops": Proportion.among(dataset.is_hand[~crops]).as_object(),
        "by_source": _objects(proportions_by(dataset.sources, dataset.is_hand)),
    }


def _unseen(
    dataset: PhotoFeatures, folds: Folds, seed: int, thresholds: RejectThresholds
) -> Report:
    validation = cross_validate(dataset, folds(dataset.sources), seed)
    return {
        **_answers(validation.tested, validation.hands, validation.is_right, thresholds),
        "calibration_error": round(
            calibration_error(_confidence(validation), validation.is_right), 4
        ),
        "painted_over_answered": _painted_answered(
            validation.tested, validation.painted, thresholds
        ),
        "between_letters_answered": Proportion.among(
            validation.between.is_clear(thresholds)
        ).as_object(),
        "confused": _confusions(validation),
    }


def _answers(
    tested: PhotoFeatures,
    judged: ClassScores,
    right: NDArray[np.bool_],
    thresholds: RejectThresholds,
) -> Report:
    """Returns the accuracy of the best letter, and of the predictions that are not rejected.

    A hand that was not detected counts as wrong and as not answered.
    """
    right = right & tested.is_hand
    answered = judged.is_clear(thresholds) & tested.is_hand
    return {
        "accuracy": Proportion.among(right).as_object(),
        "by_source": _objects(proportions_by(tested.sources, right)),
        "by_letter": _objects(proportions_by(tested.letters, right)),
        "answered": Proportion.among(answered).as_object(),
        "right_of_answered": Proportion.among(right[answered]).as_object(),
        "answered_by_letter": _objects(proportions_by(tested.letters, answered)),
    }


def _painted_answered(
    tested: PhotoFeatures, judged: ClassScores, thresholds: RejectThresholds
) -> Report:
    """Returns the share of photographs that got an answer although their hand was painted over."""
    return Proportion(int(judged.is_clear(thresholds).sum()), len(tested)).as_object()


def _confidence(validation: CrossValidation) -> NDArray[np.float64]:
    """Returns the confidence in each photograph's best letter, (n,), calibrated on the other sources only."""
    confidence = np.zeros(len(validation.tested))
    for source in np.unique(validation.tested.sources):
        own = validation.tested.sources == source
        calibration = calibrate(validation, ~own)
        confidence[own] = calibration.probabilities(validation.hands.scores[own])[:, :-1].max(1)
    return confidence


def unknown_refused(
    dataset: PhotoFeatures, seed: int = SEED, thresholds: RejectThresholds = DEFAULT_THRESHOLDS
) -> Report:
    """Returns the share of rejected hands among letters, and people, that were left out of training."""
    letters, refused = [], []
    for fold in strict(dataset.sources):
        known, tested = dataset.where(fold.train), dataset.where(fold.test)
        for letter in np.unique(tested.letters):
            classifier = fit_letters(known.where(known.letters != letter), seed)
            own = tested.where(tested.letters == letter)
            refused.append(~classifier.score(own.features).is_clear(thresholds))
            letters += [str(letter)] * len(own)
    held = np.concatenate(refused)
    return {
        "all": Proportion.among(held).as_object(),
        "by_letter": _objects(proportions_by(letters, held)),
    }


def _taught(dataset: PhotoFeatures, seed: int) -> Report:
    """Returns the accuracy on a person's other photographs, after four photographs of each letter were taught."""
    sources, right = [], []
    for fold in strict(dataset.sources):
        if fold.source not in TAUGHT_PEOPLE:
            continue
        own = dataset.where(fold.test)
        taught = first_of_each_letter(own)
        classifier = fit_letters(dataset.where(fold.train), seed)
        classifier = classifier.with_samples(own.where(taught).samples())
        rest = own.where(~taught)
        best = np.array(classifier.signs)[classifier.score(rest.features).best]
        right.append(best == rest.letters)
        sources += [fold.source] * len(rest)
    held = np.concatenate(right) if right else np.zeros(0, bool)
    return {
        "accuracy": Proportion.among(held).as_object(),
        "by_source": _objects(proportions_by(sources, held)),
    }


def first_of_each_letter(dataset: PhotoFeatures) -> NDArray[np.bool_]:
    """Returns which photographs are taught, (n,): the first four of each letter, sorted by name."""
    taught = np.zeros(len(dataset), bool)
    by_name = np.argsort(dataset.files, kind="stable")
    for letter in np.unique(dataset.letters):
        own = by_name[dataset.letters[by_name] == letter]
        taught[own[:N_TAUGHT]] = True
    return taught & ~np.isin(dataset.files, WRONG_LABELS)


def _confusions(validation: CrossValidation) -> list[Report]:
    """Returns the confusions, true letter and predicted letter, the most frequent first."""
    wrong = np.flatnonzero(~validation.is_right)
    pairs = [
        (str(validation.tested.letters[i]), validation.signs[validation.hands.best[i]])
        for i in wrong
    ]
    counted = sorted(set(pairs), key=lambda pair: (-pairs.count(pair), pair))
    return [{"letter": a, "taken_for": b, "n": pairs.count((a, b))} for a, b in counted]


def _objects(shares: dict[str, Proportion]) -> Report:
    return {name: share.as_object() for name, share in shares.items()}


def speed_ms(photos: Sequence[Photo], n: int = 25) -> Report:
    """Returns the median time for a picture, in ms: `cold` with palm detection, `tracking` with the last frame's hand.

    Measures on one thread, with the first n photographs that are not crops.
    """
    recogniser = LandmarkRecognizer()
    cold: list[float] = []
    tracking: list[float] = []
    for photo in [photo for photo in photos if photo.source != CROPS][:n]:
        picture = photo.picture()
        for times, read in (
            (cold, recogniser.read),
            (None, recogniser.track),
            (tracking, recogniser.track),
        ):
            started = time.perf_counter()
            read(picture)
            if times is not None:
                times.append(1000 * (time.perf_counter() - started))
    return {
        name: round(median(times), 1) for name, times in (("cold", cold), ("tracking", tracking))
    }
