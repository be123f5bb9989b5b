"""Measures the counting of raised fingers on the letters whose fingers can be counted, with 95 % intervals."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.features import features, palm_landmarks
from pinel_desktop.gestures.fingers import NumberPrediction, count_fingers
from pinel_desktop.gestures.hands import MIN_PRESENCE, HandDetector
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.pictures import Picture
from pinel_desktop.gestures.training.accuracy_metrics import Proportion, proportions_by
from pinel_desktop.gestures.training.folds import CROPS, PEOPLE
from pinel_desktop.gestures.training.photos import Photo

# Raised fingers, as the page draws the letters. Not here are letters whose fingers are half bent (C, E, F, O, T),
# crossed (R), beside the thumb (G, K), or point downwards or at the camera (M, N, P, Q).
RAISED = {"A": 0, "S": 0, "D": 1, "I": 1, "L": 2, "U": 2, "V": 2, "W": 3, "B": 4}
# the people from whose hands the limit of the fingers in `fingers.py` comes
LIMITS_FROM = ("p1_webcam", "p2_webcam")
# fingers neither raised nor folded: there is no right answer, only doubt
CURVED = ("C", "O")
_TILT_DEG = 45.0

Report = dict[str, Any]


class _Counted(NamedTuple):
    """A photograph and the number counted in it; None without a hand."""

    photo: Photo
    number: NumberPrediction | None

    @property
    def is_answered(self) -> bool:
        return self.number is not None and self.number.is_sure

    @property
    def is_right(self) -> bool:
        return self.number is not None and int(self.number.best) == RAISED[self.photo.letter]


def number_report(photos: Sequence[Photo], tick: Callable[[], object] = lambda: None) -> Report:
    """Counts the fingers in each photograph: as it is, mirrored (the other hand), and tilted by 45 degrees.

    Calls `tick` after each photograph, `n_counted(photos)` times.
    """
    detector = HandDetector()
    countable, curved = _countable(photos), _curved(photos)
    views: dict[str, list[_Counted]] = {"as_it_is": [], "mirrored": [], "tilted": []}
    for photo in countable:
        for name, picture, seen in _views(photo):
            views[name].append(_Counted(photo, _number(detector, picture, seen)))
        tick()
    doubtful = []
    for photo in curved:
        number = _number(detector, photo.picture(), photo)
        doubtful.append(number is not None and number.is_sure)
        tick()
    report: Report = {name: _answers(counted) for name, counted in views.items()}
    report["other_sources_than_the_limits"] = _shares(
        [one for one in views["as_it_is"] if one.photo.source not in LIMITS_FROM]
    )
    report["curved_fingers_answered"] = Proportion.among(doubtful).as_object()
    return report


def n_counted(photos: Sequence[Photo]) -> int:
    """Returns how many of the photographs `number_report` reads."""
    return len(_countable(photos)) + len(_curved(photos))


def _countable(photos: Sequence[Photo]) -> list[Photo]:
    return [one for one in photos if one.letter in RAISED and one.source != CROPS]


def _curved(photos: Sequence[Photo]) -> list[Photo]:
    return [one for one in photos if one.letter in CURVED and one.source in PEOPLE]


def _views(photo: Photo) -> Iterator[tuple[str, Picture, Photo]]:
    """Yields each view with its name, and the photograph with the hand's box in this view."""
    picture = photo.picture()
    yield "as_it_is", picture, photo
    x, y, width, height = photo.box
    mirrored = Photo(photo.path, photo.letter, photo.source, (1.0 - x, y, width, height))
    yield "mirrored", np.ascontiguousarray(picture[:, ::-1]), mirrored
    for degrees in (_TILT_DEG, -_TILT_DEG):
        yield "tilted", _turned(picture, photo, degrees), photo


def _turned(picture: Picture, photo: Photo, degrees: float) -> Picture:
    """Returns the picture turned about the middle of the hand's box."""
    height, width = picture.shape[:2]
    middle = (photo.box[0] * width, photo.box[1] * height)
    turn = cv2.getRotationMatrix2D(middle, degrees, 1.0)
    turned = cv2.warpAffine(picture, turn, (width, height), borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(turned, np.uint8)


def _number(detector: HandDetector, picture: Picture, photo: Photo) -> NumberPrediction | None:
    hands = detector.detect(picture, accepts=photo.accepts(picture))
    hands = [hand for hand in hands if hand.presence > MIN_PRESENCE]
    if not hands:
        return None
    hand = max(hands, key=lambda hand: hand.presence)
    return count_fingers([palm_landmarks(features(hand))])


def _answers(counted: Sequence[_Counted]) -> Report:
    """Returns the shares of all, of people at a webcam, by letter and by source; without a hand there is no answer."""
    letters = np.array([one.photo.letter for one in counted])
    sources = np.array([one.photo.source for one in counted])
    answered = np.array([one.is_answered for one in counted], bool)
    right = np.array([one.is_right for one in counted], bool)
    return {
        **_shares(counted),
        "people": _shares([one for one in counted if one.photo.source in PEOPLE]),
        "answered_by_letter": _objects(letters, answered),
        "right_of_answered_by_letter": _objects(letters[answered], right[answered]),
        "answered_by_source": _objects(sources, answered),
        "right_of_answered_by_source": _objects(sources[answered], right[answered]),
    }


def _shares(counted: Sequence[_Counted]) -> Report:
    answered = [one for one in counted if one.is_answered]
    return {
        "answered": Proportion.among(one.is_answered for one in counted).as_object(),
        "right_of_answered": Proportion.among(one.is_right for one in answered).as_object(),
        "right": Proportion.among(one.is_right for one in counted).as_object(),
    }


def _objects(groups: NDArray[np.str_], holds: NDArray[np.bool_]) -> Report:
    return {name: share.as_object() for name, share in proportions_by(groups, holds).items()}
