"""From a picture to a letter: hands, features and classifier together."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.classifier import (
    DEFAULT_THRESHOLDS,
    RejectThresholds,
    SignClassifier,
    SignPrediction,
)
from pinel_desktop.gestures.features import N_FEATURES, features
from pinel_desktop.gestures.hands import MIN_PRESENCE, HandDetector, HandTracker, Picture
from pinel_desktop.gestures.landmarks import SIZE, Hand
from pinel_desktop.gestures.networks import FOLDER
from pinel_desktop.gestures.regions import Region


@dataclass(frozen=True)
class RecognisedHand:
    """A hand in a picture, its features (1748,), and what it shows."""

    hand: Hand
    features: NDArray[np.float32]
    prediction: SignPrediction


class Recogniser:
    """Reads the signs of single pictures, or of a video frame by frame. It belongs to one thread."""

    def __init__(
        self,
        classifier: SignClassifier | None = None,
        thresholds: RejectThresholds = DEFAULT_THRESHOLDS,
        folder: Path = FOLDER,
    ) -> None:
        """The letters that ship, or another classifier. Raises PinelError where a file is missing or damaged."""
        self.classifier = classifier or weights_file.load(folder / weights_file.LETTERS.name)
        self.thresholds = thresholds
        self._detector = HandDetector(folder)
        self._tracker = HandTracker(self._detector)
        self._warm_up()

    def read(self, picture: Picture) -> list[RecognisedHand]:
        """The hands of one RGB picture (height, width, 3), unstretched, the best first; at most two."""
        return [
            self._recognised(hand)
            for hand in self._detector.detect(picture)
            if hand.presence > MIN_PRESENCE
        ]

    def track(self, picture: Picture) -> list[RecognisedHand]:
        """The hands of the next frame of a video; a hand that was seen in the last frame is not looked for."""
        return [self._recognised(hand) for hand in self._tracker.update(picture)]

    def reset_tracking(self) -> None:
        """Looks for hands anew in the next frame, which comes from elsewhere."""
        self._tracker = HandTracker(self._detector)

    def _warm_up(self) -> None:
        """The first picture takes no longer than the others: memory is laid out, what is derived once is derived."""
        self._detector.detect(np.zeros((SIZE, SIZE, 3), np.uint8), exhaustive=False)
        self._detector.landmarks(np.zeros((SIZE, SIZE, 3), np.uint8), Region(0, 0, SIZE, 0))
        self.classifier.predict(np.zeros(N_FEATURES, np.float32))

    def _recognised(self, hand: Hand) -> RecognisedHand:
        numbers = features(hand)
        return RecognisedHand(hand, numbers, self.classifier.predict(numbers, self.thresholds))


def clearest(hands: list[RecognisedHand]) -> RecognisedHand | None:
    """Of two hands the one that signs: one that is answered rather than not, then the surer one."""
    return max(
        hands,
        key=lambda one: (one.prediction.sign is not None, one.prediction.confidence),
        default=None,
    )
