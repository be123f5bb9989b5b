"""From a picture to a letter: hands, features and classifier together."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.classifier import USUAL_DOUBT, Doubt, Reading, SignClassifier
from pinel_desktop.gestures.features import N_FEATURES, features
from pinel_desktop.gestures.hands import LEAST_PRESENCE, HandFinder, HandTracker, Picture
from pinel_desktop.gestures.landmarks import SIZE, Hand
from pinel_desktop.gestures.networks import FOLDER
from pinel_desktop.gestures.regions import Region


@dataclass(frozen=True)
class SeenHand:
    """A hand in a picture, its features (1748,), and what it shows."""

    hand: Hand
    features: NDArray[np.float32]
    reading: Reading


class Recogniser:
    """Reads the signs of single pictures, or of a video frame by frame. It belongs to one thread."""

    def __init__(
        self,
        classifier: SignClassifier | None = None,
        doubt: Doubt = USUAL_DOUBT,
        folder: Path = FOLDER,
    ) -> None:
        """The letters that ship, or another classifier. Raises PinelError where a file is missing or damaged."""
        self.classifier = classifier or weights_file.load(folder / weights_file.LETTERS.name)
        self.doubt = doubt
        self._finder = HandFinder(folder)
        self._tracker = HandTracker(self._finder)
        self._warm_up()

    def read(self, picture: Picture) -> list[SeenHand]:
        """The hands of one RGB picture (height, width, 3), unstretched, the best first; at most two."""
        return [
            self._seen(hand)
            for hand in self._finder.find(picture)
            if hand.presence > LEAST_PRESENCE
        ]

    def follow(self, picture: Picture) -> list[SeenHand]:
        """The hands of the next frame of a video; a hand that was seen in the last frame is not looked for."""
        return [self._seen(hand) for hand in self._tracker.update(picture)]

    def forget(self) -> None:
        """Looks for hands anew in the next frame, which comes from elsewhere."""
        self._tracker = HandTracker(self._finder)

    def _warm_up(self) -> None:
        """The first picture takes no longer than the others: memory is laid out, what is derived once is derived."""
        self._finder.find(np.zeros((SIZE, SIZE, 3), np.uint8), patient=False)
        self._finder.landmarks(np.zeros((SIZE, SIZE, 3), np.uint8), Region(0, 0, SIZE, 0))
        self.classifier.read(np.zeros(N_FEATURES, np.float32))

    def _seen(self, hand: Hand) -> SeenHand:
        numbers = features(hand)
        return SeenHand(hand, numbers, self.classifier.read(numbers, self.doubt))


def clearest(seen: list[SeenHand]) -> SeenHand | None:
    """Of two hands the one that signs: one that is answered rather than not, then the surer one."""
    return max(
        seen, key=lambda one: (one.reading.sign is not None, one.reading.confidence), default=None
    )
