"""Hand detection in a picture, and hand tracking from frame to frame."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.landmarks import Hand, LandmarkNetwork
from pinel_desktop.gestures.networks import FOLDER, HAND, PALM, Network
from pinel_desktop.gestures.opencv import cv2
from pinel_desktop.gestures.palms import Palm, PalmDetector
from pinel_desktop.gestures.regions import around_hand

Picture = NDArray[np.uint8]

MAX_HANDS = 2
MIN_PRESENCE = 0.5
_LOST_PRESENCE = 0.3  # lower than MIN_PRESENCE: the presence of a tracked hand may drop for a while
_PADDINGS = (1, 1.5, 2, 3)
_PALM_SCORES = (0.5, 0.3)
_CERTAINLY_OTHER = 0.3
_SECOND_HAND_FRAMES = 3
_SAME_HAND = 0.5  # as a fraction of the smaller hand's size


class HandDetector:
    """Detects the hands in single pictures."""

    def __init__(self, folder: Path = FOLDER) -> None:
        """Raises PinelError if a network's file is missing or damaged."""
        cv2.setNumThreads(1)  # leave the other cores to a robot's control loop
        self._palms = PalmDetector(Network(PALM, folder))
        self.landmarks = LandmarkNetwork(Network(HAND, folder))

    def detect(
        self,
        picture: Picture,
        *,
        accepts: Callable[[Palm], bool] = lambda palm: True,
        exhaustive: bool = True,
    ) -> list[Hand]:
        """Returns the hands of an RGB picture, at most two, the best first.

        Close hands need a smaller picture, faint hands a lower score threshold. Tries both until it finds a hand. If
        no hand reaches `MIN_PRESENCE`, returns the best guess.

        Args:
            accepts: returns False for palms to ignore.
            exhaustive: False tries once only.
        """
        guess: Hand | None = None
        for min_score in _PALM_SCORES[: None if exhaustive else 1]:
            for padding in _PADDINGS[: None if exhaustive else 1]:
                palms = self._palms(picture, padding=padding, min_score=min_score)
                detected = [self.landmarks(picture, palm.region) for palm in palms if accepts(palm)]
                hands = without_duplicates(
                    [hand for hand in detected if hand.presence > MIN_PRESENCE]
                )
                if hands:
                    return [self._refined(picture, hand) for hand in hands]
                guess = max([*detected, *([guess] if guess else [])], key=_presence, default=None)
        return [self._refined(picture, guess)] if guess else []

    def _refined(self, picture: Picture, hand: Hand) -> Hand:
        """Runs the landmark network twice more: on a crop fitted to the landmarks, then mirrored for a left hand."""
        fitted = self.landmarks(picture, around_hand(hand.points))
        mirrored = fitted.chirality < 0.5
        return self.landmarks(picture, around_hand(fitted.points), mirrored=mirrored)


class HandTracker:
    """Tracks the hands in a video: one pass of the landmark network for each hand and frame."""

    def __init__(self, detector: HandDetector) -> None:
        self._detector = detector
        self._hands: list[Hand] = []
        self._n_frames = 0

    def update(self, picture: Picture, *, both: bool = False) -> list[Hand]:
        """Returns the hands of the next frame. If all hands are lost, detects palms again.

        Args:
            both: whether to look for the second hand, too, while one is tracked: every `_SECOND_HAND_FRAMES` frames,
                because it takes four times as long as tracking.
        """
        followed = without_duplicates([self._follow(picture, hand) for hand in self._hands])
        self._hands = [hand for hand in followed if hand.presence > _LOST_PRESENCE]
        if not self._hands:
            found = self._detector.detect(picture)
            self._hands = [hand for hand in found if hand.presence > MIN_PRESENCE]
        elif both and len(self._hands) < MAX_HANDS:
            self._n_frames += 1
            if self._n_frames % _SECOND_HAND_FRAMES == 0:
                found = self._detector.detect(picture, exhaustive=False)
                new = [hand for hand in found if hand.presence > MIN_PRESENCE]
                self._hands = without_duplicates([*self._hands, *new])
        return self._hands

    def _follow(self, picture: Picture, hand: Hand) -> Hand:
        """Tracks one hand. If its chirality changed (it turned, or it is another hand), mirrors it from now on."""
        region = around_hand(hand.points)
        tracked = self._detector.landmarks(picture, region, mirrored=hand.mirrored)
        if tracked.chirality < _CERTAINLY_OTHER:
            return self._detector.landmarks(picture, region, mirrored=not hand.mirrored)
        return tracked


def without_duplicates(hands: list[Hand]) -> list[Hand]:
    """Returns the best hands, at most two, without detections of the same hand."""
    unique: list[Hand] = []
    for hand in sorted(hands, key=_presence, reverse=True):
        if not any(_is_same(hand, other) for other in unique):
            unique.append(hand)
    return unique[:MAX_HANDS]


def _presence(hand: Hand) -> float:
    return hand.presence


def _is_same(a: Hand, b: Hand) -> bool:
    """Returns whether the mean distance of two hands' landmarks is less than half the smaller hand's size."""
    distance = np.linalg.norm(a.points[:, :2] - b.points[:, :2], axis=1).mean()
    size = min(np.ptp(hand.points[:, :2], axis=0).max() for hand in (a, b))
    return bool(distance < _SAME_HAND * size)
