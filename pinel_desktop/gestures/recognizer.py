"""What every recognizer of signs offers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.gestures.classifier import SignPrediction
from pinel_desktop.gestures.landmarks import Hand
from pinel_desktop.gestures.pictures import Picture

MAX_SIGNS = 2  # in one picture
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class RecognizedSign:
    """A hand in a picture, and its predicted sign.

    Attributes:
        box: left, top, right, bottom of the hand, in px of the picture.
        prediction: the predicted sign; its confidence is comparable between pictures of one recognizer only.
        hand: landmarks of the hand; None if the recognizer has none.
        features: features of the hand, (1748,), from which signs are taught; None if the recognizer has none.
    """

    box: Box
    prediction: SignPrediction
    hand: Hand | None = None
    features: NDArray[np.float32] | None = None


class SignRecognizer(Protocol):
    """Recognizes signs in single pictures, or in a video frame by frame. Not thread-safe."""

    @property
    def signs(self) -> tuple[str, ...]:
        """Names of the signs that it can recognize."""

    @property
    def min_confidence(self) -> float:
        """Mean confidence of consecutive frames from which a steady sign counts as shown, 0 to 1."""

    def read(self, picture: Picture) -> Sequence[RecognizedSign]:
        """Returns the signs of one unstretched RGB picture (height, width, 3), at most `MAX_SIGNS`, the best first."""

    def track(self, picture: Picture, *, both: bool = False) -> Sequence[RecognizedSign]:
        """Returns the signs of the next frame of a video.

        Args:
            both: looks for a second hand, too, while one is tracked.
        """

    def reset_tracking(self) -> None:
        """Forgets the video, because the next frame comes from another source."""


def clearest(signs: Sequence[RecognizedSign]) -> RecognizedSign | None:
    """Returns the sign that is most probably meant: prefers accepted predictions, then the higher confidence."""
    return max(
        signs,
        key=lambda one: (one.prediction.sign is not None, one.prediction.confidence),
        default=None,
    )
