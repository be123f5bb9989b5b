"""Evaluates captures with short synthetic videos of people outside the classifier's training data.

Small motions of the picture, blur and changes of light make a video of a photograph; the networks analyse each frame. A
transition is a steady letter, a few frames that mix the hands of two letters, and the second letter.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from statistics import median
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.classifier import SignClassifier
from pinel_desktop.gestures.features import features
from pinel_desktop.gestures.hands import MIN_PRESENCE, HandDetector, HandTracker
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.gestures.stability import Decision, FramePrediction, StabilityFilter
from pinel_desktop.gestures.training.accuracy_metrics import Proportion
from pinel_desktop.gestures.training.folds import strict
from pinel_desktop.gestures.training.letter_training import SEED, fit_letters
from pinel_desktop.gestures.training.photo_features import PhotoFeatures
from pinel_desktop.gestures.training.photos import Photo

RATE_HZ = 15.0
N_FRAMES = 15  # of a steady letter: 1 s
_N_MIXED = (3, 9)  # frames of a transition between two letters: 0.2 s to 0.6 s
_TREMBLE, _TURN_DEG, _GROWTH = (
    0.004,
    1.0,
    0.01,
)  # standard deviations: shift (fraction of the width), rotation (degrees), size (fraction)
_LIGHT, _MAX_BLUR = 0.15, 2

Random = np.random.Generator


@dataclass(frozen=True)
class Video:
    """A video of a steady letter: features (n, 1748) and landmarks (n, 21, 2) in px of the n frames with a hand."""

    letter: str
    features: NDArray[np.float32]
    points: NDArray[np.float32]


@dataclass(frozen=True)
class Shown:
    """A hand in one frame: features (1748,), landmarks (21, 2) in px."""

    features: NDArray[np.float32]
    points: NDArray[np.float32]


def sequences_report(
    photos: Sequence[Photo], dataset: PhotoFeatures, n_photos: int = 200, seed: int = SEED
) -> dict[str, Any]:
    """Measures the time to the decision of a steady letter, and false decisions in transitions.

    Args:
        photos, dataset: the same photographs in the same order.
        n_photos: number of photographs that become videos, over all people.
    """
    random = np.random.default_rng(seed)
    detector = HandDetector()
    times_s: list[float | None] = []
    right, false, late = [], [], []
    for fold in strict(dataset.sources):
        uncalibrated = fit_letters(dataset.where(fold.train), seed)
        classifier = replace(uncalibrated, calibration=weights_file.load().calibration)
        own = np.flatnonzero(fold.test & dataset.is_hand)
        chosen = random.choice(own, min(n_photos // 4, len(own)), replace=False)
        videos = [video_of(detector, photos[i], random) for i in chosen]
        for video in videos:
            time_s, decision = _decided(classifier, _frames(video))
            times_s.append(time_s)
            if decision:
                right.append(decision.label == video.letter)
        for first, second in _pairs(videos, random):
            labels = [d.label for d in _decisions(classifier, _transition(first, second, random))]
            false.append(any(label not in (first.letter, second.letter) for label in labels))
            late.append(second.letter not in labels)
    decided = [time_s for time_s in times_s if time_s is not None]
    return {
        "steady": {
            "videos": len(times_s),
            "decided_within_1_s": Proportion(len(decided), len(times_s)).as_object(),
            "median_s": round(median(decided), 3) if decided else None,
            "right_of_decided": Proportion.among(np.array(right, bool)).as_object(),
        },
        "transitions": {
            "false": Proportion.among(np.array(false, bool)).as_object(),
            "second_letter_missed": Proportion.among(np.array(late, bool)).as_object(),
        },
    }


def video_of(detector: HandDetector, photo: Photo, random: Random) -> Video:
    """Makes one second of video of a photograph, and analyses each frame with the networks."""
    picture = photo.picture()
    tracker = HandTracker(detector)
    frames: list[Shown] = []
    for _ in range(N_FRAMES):
        hands = [
            h for h in tracker.update(_disturbed(picture, random)) if h.presence > MIN_PRESENCE
        ]
        if hands:
            frames.append(Shown(features(hands[0]), hands[0].points[:, :2].astype(np.float32)))
    return Video(
        photo.letter,
        np.array([one.features for one in frames]),
        np.array([one.points for one in frames]),
    )


def _disturbed(picture: Picture, random: Random) -> Picture:
    """Returns the picture with a small random shift, rotation, scale, blur and change of brightness."""
    height, width = picture.shape[:2]
    angle, growth = random.normal(0, _TURN_DEG), 1 + random.normal(0, _GROWTH)
    motion = cv2.getRotationMatrix2D((width / 2, height / 2), angle, growth)
    motion = motion + [[0, 0, x] for x in random.normal(0, _TREMBLE * width, 2)]
    moved = cv2.warpAffine(picture, motion, (width, height), borderMode=cv2.BORDER_REPLICATE)
    blur = 2 * int(random.integers(0, _MAX_BLUR + 1)) + 1
    soft = cv2.GaussianBlur(moved, (blur, blur), 0)
    light = soft.astype(np.float32) * (1 + random.normal(0, _LIGHT))
    return np.asarray(np.clip(light, 0, 255), np.uint8)


def _frames(video: Video) -> Iterator[Shown]:
    for row, points in zip(video.features, video.points, strict=True):
        yield Shown(row, points)


def _pairs(videos: Sequence[Video], random: Random) -> Iterator[tuple[Video, Video]]:
    """Yields each video with a random video of the same person that shows another letter."""
    usable = [video for video in videos if len(video.features)]
    for first in usable:
        others = [video for video in usable if video.letter != first.letter]
        if others:
            yield first, others[int(random.integers(len(others)))]


def _transition(first: Video, second: Video, random: Random) -> Iterator[Shown]:
    yield from _frames(first)
    n = int(random.integers(*_N_MIXED))
    offset = first.points[-1].mean(0) - second.points[0].mean(0)  # keeps the hand's position
    for i in range(1, n + 1):
        share = np.float32(i / (n + 1))
        yield Shown(
            first.features[-1] * (1 - share) + second.features[0] * share,
            first.points[-1] * (1 - share) + (second.points[0] + offset) * share,
        )
    for shown in _frames(second):
        yield Shown(shown.features, shown.points + offset)


def _decisions(classifier: SignClassifier, frames: Iterable[Shown]) -> Iterator[Decision]:
    stability_filter = StabilityFilter()
    for i, shown in enumerate(frames):
        if decision := stability_filter.update(_frame_prediction(classifier, shown, i)):
            yield decision


def _decided(
    classifier: SignClassifier, frames: Iterable[Shown]
) -> tuple[float | None, Decision | None]:
    """Returns the first decision and its time in s from the start of the video; None, None if there is none."""
    stability_filter = StabilityFilter()
    for i, shown in enumerate(frames):
        if decision := stability_filter.update(_frame_prediction(classifier, shown, i)):
            return (i + 1) / RATE_HZ, decision
    return None, None


def _frame_prediction(classifier: SignClassifier, shown: Shown, i: int) -> FramePrediction:
    prediction = classifier.predict(shown.features)
    return FramePrediction(
        i / RATE_HZ, prediction.sign, prediction.confidence, prediction.second, shown.points
    )
