"""The signs in the frames of a camera, in their order."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.frames import Shot
from pinel_desktop.camera.recording import RecordedHand
from pinel_desktop.gestures.classifier import Reading, SignClassifier
from pinel_desktop.gestures.recognition import Recogniser, SeenHand


@dataclass(frozen=True, slots=True)
class SeenSign:
    """A hand in a frame and what it shows.

    Attributes:
        points: 21 landmarks (x, y) in px of the frame.
        handedness: which hand of the person it is.
        features: the hand as numbers, (1748,).
        reading: the sign that it shows.
        is_taught: whether the likeliest sign is one that the class taught.
    """

    points: NDArray[np.float32]
    handedness: Literal["left", "right"]
    features: NDArray[np.float32]
    reading: Reading
    is_taught: bool


class Sight:
    """Looks at the frames of one camera."""

    def __init__(self, recogniser: Recogniser) -> None:
        self._recogniser = recogniser
        self._taught: frozenset[str] = frozenset()

    @property
    def classifier(self) -> SignClassifier:
        """Which signs it knows."""
        return self._recogniser.classifier

    def know(self, classifier: SignClassifier, taught: frozenset[str]) -> None:
        """Knows other signs from now on, some of which a class taught."""
        self._recogniser.classifier, self._taught = classifier, taught

    def look(self, shot: Shot) -> list[SeenSign]:
        """The hands of the next frame, at most two."""
        if shot.hands is not None:
            return [self._recorded(hand) for hand in shot.hands]
        return [self._found(seen) for seen in self._recogniser.follow(shot.picture)]

    def begin_anew(self) -> None:
        """Forgets the hands that it follows: the next frame comes from elsewhere."""
        self._recogniser.forget()

    def _recorded(self, hand: RecordedHand) -> SeenSign:
        reading = self.classifier.read(hand.features, self._recogniser.doubt)
        side: Literal["left", "right"] = "left" if hand.is_left else "right"
        return SeenSign(hand.points, side, hand.features, reading, reading.best in self._taught)

    def _found(self, seen: SeenHand) -> SeenSign:
        hand, reading = seen.hand, seen.reading
        points, is_taught = hand.points[:, :2].astype(np.float32), reading.best in self._taught
        return SeenSign(points, hand.handedness, seen.features, reading, is_taught)
