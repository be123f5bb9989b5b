"""How well letters are recognised: of people who were never seen, by letter and by source, with 95 % intervals."""

import time
from collections.abc import Callable, Iterator, Sequence
from statistics import median
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.classifier import (
    USUAL_DOUBT,
    Doubt,
    Judgement,
    SignClassifier,
)
from pinel_desktop.gestures.recognition import Recogniser
from pinel_desktop.gestures.training.figures import Share, calibration_error, shares_by
from pinel_desktop.gestures.training.folds import CROPS, Fold, leave_one_source_out, strict
from pinel_desktop.gestures.training.learning import (
    SEED,
    WRONG_LABELS,
    OutOfSource,
    calibrate,
    learn,
    out_of_source,
)
from pinel_desktop.gestures.training.photos import Photo
from pinel_desktop.gestures.training.recordings import Recordings

N_TAUGHT = 4  # frames a letter
# who has enough photographs of each letter to be taught and tested
TAUGHT_PEOPLE = ("p1_webcam", "p2_webcam", "p3_webcam")

Report = dict[str, Any]
Folds = Callable[[NDArray[np.str_]], Iterator[Fold]]


def evaluate_unseen(
    recordings: Recordings,
    seed: int = SEED,
    doubt: Doubt = USUAL_DOUBT,
    *,
    unknown: bool = True,
) -> Report:
    """The report of training without each source in turn, and strictly without each person at a webcam.

    `unknown=False` leaves out the letters that are left out of training, which take two minutes.
    """
    report: Report = {
        "photos": len(recordings),
        "hands_found": hands_found(recordings),
        "leave_one_source_out": _unseen(recordings, leave_one_source_out, seed, doubt),
        "strict": _unseen(recordings, strict, seed, doubt),
    }
    report["strict"]["taught"] = _taught(recordings, seed)
    if unknown:
        report["strict"]["unknown_letter_refused"] = unknown_refused(recordings, seed, doubt)
    return report


def evaluate_known(
    recordings: Recordings, classifier: SignClassifier, doubt: Doubt = USUAL_DOUBT
) -> Report:
    """The report of the classifier as it is. Where it learnt from the same people, this says nothing about others."""
    judged = classifier.judge(recordings.features)
    right = np.array(classifier.signs)[judged.best] == recordings.letters
    confidence = classifier.calibration.probabilities(judged.scores)[:, :-1].max(1)
    return {
        "photos": len(recordings),
        "hands_found": hands_found(recordings),
        **_answers(recordings, judged, right, doubt),
        "calibration_error": round(calibration_error(confidence, right), 4),
        "painted_over_answered": _painted_answered(
            recordings, classifier.judge(recordings.painted.features), doubt
        ),
    }


def hands_found(recordings: Recordings) -> Report:
    """In which share of the photographs the labelled hand is found; the crops count apart."""
    crops = recordings.sources == CROPS
    return {
        "all_but_crops": Share.among(recordings.is_hand[~crops]).as_object(),
        "by_source": _objects(shares_by(recordings.sources, recordings.is_hand)),
    }


def _unseen(recordings: Recordings, folds: Folds, seed: int, doubt: Doubt) -> Report:
    seen = out_of_source(recordings, folds(recordings.sources), seed)
    return {
        **_answers(seen.tested, seen.hands, seen.is_right, doubt),
        "calibration_error": round(calibration_error(_confidence(seen), seen.is_right), 4),
        "painted_over_answered": _painted_answered(seen.tested, seen.painted, doubt),
        "between_letters_answered": Share.among(seen.between.is_clear(doubt)).as_object(),
        "confused": _confusions(seen),
    }


def _answers(
    tested: Recordings, judged: Judgement, right: NDArray[np.bool_], doubt: Doubt
) -> Report:
    """Accuracy of the best letter, and of the answers that the doubt leaves; a hand that is not found has neither."""
    right = right & tested.is_hand
    answered = judged.is_clear(doubt) & tested.is_hand
    return {
        "accuracy": Share.among(right).as_object(),
        "by_source": _objects(shares_by(tested.sources, right)),
        "by_letter": _objects(shares_by(tested.letters, right)),
        "answered": Share.among(answered).as_object(),
        "right_of_answered": Share.among(right[answered]).as_object(),
        "answered_by_letter": _objects(shares_by(tested.letters, answered)),
    }


def _painted_answered(tested: Recordings, judged: Judgement, doubt: Doubt) -> Report:
    """Of all photographs whose hand was painted over, those that got an answer all the same."""
    return Share(int(judged.is_clear(doubt).sum()), len(tested)).as_object()


def _confidence(seen: OutOfSource) -> NDArray[np.float64]:
    """Of each photograph's best letter, (n,): calibrated on the other sources, so that none judges itself."""
    confidence = np.zeros(len(seen.tested))
    for source in np.unique(seen.tested.sources):
        own = seen.tested.sources == source
        calibration = calibrate(seen, ~own)
        confidence[own] = calibration.probabilities(seen.hands.scores[own])[:, :-1].max(1)
    return confidence


def unknown_refused(recordings: Recordings, seed: int = SEED, doubt: Doubt = USUAL_DOUBT) -> Report:
    """How often a letter is refused that was left out of training, shown by people who were left out as well."""
    letters, refused = [], []
    for fold in strict(recordings.sources):
        known, tested = recordings.where(fold.train), recordings.where(fold.test)
        for letter in np.unique(tested.letters):
            classifier = learn(known.where(known.letters != letter), seed)
            own = tested.where(tested.letters == letter)
            refused.append(~classifier.judge(own.features).is_clear(doubt))
            letters += [str(letter)] * len(own)
    held = np.concatenate(refused)
    return {"all": Share.among(held).as_object(), "by_letter": _objects(shares_by(letters, held))}


def _taught(recordings: Recordings, seed: int) -> Report:
    """Accuracy on a person's other photographs after four of each letter were taught, the first by name."""
    sources, right = [], []
    for fold in strict(recordings.sources):
        if fold.source not in TAUGHT_PEOPLE:
            continue
        own = recordings.where(fold.test)
        taught = first_of_each_letter(own)
        classifier = learn(recordings.where(fold.train), seed)
        classifier = classifier.teach(own.where(taught).samples())
        rest = own.where(~taught)
        best = np.array(classifier.signs)[classifier.judge(rest.features).best]
        right.append(best == rest.letters)
        sources += [fold.source] * len(rest)
    held = np.concatenate(right) if right else np.zeros(0, bool)
    return {
        "accuracy": Share.among(held).as_object(),
        "by_source": _objects(shares_by(sources, held)),
    }


def first_of_each_letter(recordings: Recordings) -> NDArray[np.bool_]:
    """Which photographs are taught: four of each letter, the first by name, (n,)."""
    taught = np.zeros(len(recordings), bool)
    by_name = np.argsort(recordings.files, kind="stable")
    for letter in np.unique(recordings.letters):
        own = by_name[recordings.letters[by_name] == letter]
        taught[own[:N_TAUGHT]] = True
    return taught & ~np.isin(recordings.files, WRONG_LABELS)


def _confusions(seen: OutOfSource) -> list[Report]:
    """Which letters were taken for which others, the most frequent first."""
    wrong = np.flatnonzero(~seen.is_right)
    pairs = [(str(seen.tested.letters[i]), seen.signs[seen.hands.best[i]]) for i in wrong]
    counted = sorted(set(pairs), key=lambda pair: (-pairs.count(pair), pair))
    return [{"letter": a, "taken_for": b, "n": pairs.count((a, b))} for a, b in counted]


def _objects(shares: dict[str, Share]) -> Report:
    return {name: share.as_object() for name, share in shares.items()}


def speed_ms(photos: Sequence[Photo], n: int = 25) -> Report:
    """Median time of a picture: `cold`, where the hand is looked for, and `tracking`, where the last frame had it.

    On one thread, of the first n photographs of people at a webcam, or of any.
    """
    recogniser = Recogniser()
    cold: list[float] = []
    tracking: list[float] = []
    for photo in [photo for photo in photos if photo.source != CROPS][:n]:
        picture = photo.picture()
        for times, read in (
            (cold, recogniser.read),
            (None, recogniser.follow),
            (tracking, recogniser.follow),
        ):
            started = time.perf_counter()
            read(picture)
            if times is not None:
                times.append(1000 * (time.perf_counter() - started))
    return {
        name: round(median(times), 1) for name, times in (("cold", cold), ("tracking", tracking))
    }
