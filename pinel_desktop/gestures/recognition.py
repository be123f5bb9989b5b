"""Recognizes signs from the landmarks of hands: combines hand detection, features and classifier."""

from pathlib import Path

import numpy as np

from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.classifier import (
    DEFAULT_THRESHOLDS,
    RejectThresholds,
    SignClassifier,
)
from pinel_desktop.gestures.features import N_FEATURES, features
from pinel_desktop.gestures.hands import MIN_PRESENCE, HandDetector, HandTracker, Picture
from pinel_desktop.gestures.landmarks import SIZE, Hand
from pinel_desktop.gestures.networks import FOLDER
from pinel_desktop.gestures.recognizer import RecognizedSign
from pinel_desktop.gestures.regions import Region
from pinel_desktop.gestures.stability import MIN_CONFIDENCE


class LandmarkRecognizer:
    """The recognizer of the shipped letters and of the signs that a class teaches."""

    min_confidence = MIN_CONFIDENCE

    def __init__(
        self,
        classifier: SignClassifier | None = None,
        thresholds: RejectThresholds = DEFAULT_THRESHOLDS,
        folder: Path = FOLDER,
    ) -> None:
        """Loads the networks and, by default, the shipped letters.

        Raises:
            PinelError: a file is missing or damaged.
        """
        self.classifier = classifier or weights_file.load(folder / weights_file.LETTERS.name)
        self.thresholds = thresholds
        self._detector = HandDetector(folder)
        self._tracker = HandTracker(self._detector)
        self._warm_up()

    @property
    def signs(self) -> tuple[str, ...]:
        """Names of the signs that the classifier knows."""
        return self.classifier.signs

    def read(self, picture: Picture) -> list[RecognizedSign]:
        """Returns the hands of one unstretched RGB picture (height, width, 3), at most two, the best first."""
        return [
            self._recognised(hand)
            for hand in self._detector.detect(picture)
            if hand.presence > MIN_PRESENCE
        ]

    def track(self, picture: Picture, *, both: bool = False) -> list[RecognizedSign]:
        """Returns the hands of the next frame of a video; detects new hands only if none is tracked.

        Args:
            both: detects a second hand, too, while one is tracked.
        """
        return [self._recognised(hand) for hand in self._tracker.update(picture, both=both)]

    def reset_tracking(self) -> None:
        """Detects hands again in the next frame, because it comes from another source."""
        self._tracker = HandTracker(self._detector)

    def _warm_up(self) -> None:
        """Allocates memory and fills caches, so that the first picture takes no longer than the others."""
        self._detector.detect(np.zeros((SIZE, SIZE, 3), np.uint8), exhaustive=False)
        self._detector.landmarks(np.zeros((SIZE, SIZE, 3), np.uint8), Region(0, 0, SIZE, 0))
        self.classifier.predict(np.zeros(N_FEATURES, np.float32))

    def _recognised(self, hand: Hand) -> RecognizedSign:
        numbers = features(hand)
        prediction = self.classifier.predict(numbers, self.thresholds)
        return RecognizedSign(hand.box, prediction, hand, numbers)
