"""Detects hands and signs in the frames of a camera, frame by frame."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.frames import RawFrame
from pinel_desktop.camera.landmark_sequence import RecordedHand
from pinel_desktop.gestures.classifier import SignClassifier, SignPrediction
from pinel_desktop.gestures.recognition import RecognisedHand, Recogniser


@dataclass(frozen=True, slots=True)
class DetectedSign:
    """A detected hand and its predicted sign.

    Attributes:
        points: 21 landmarks (x, y) in px of the frame.
        handedness: which hand of the person it is.
        features: feature vector of the hand, (1748,).
        prediction: prediction of the classifier.
        is_taught: whether the class taught the likeliest sign.
    """

    points: NDArray[np.float32]
    handedness: Literal["left", "right"]
    features: NDArray[np.float32]
    prediction: SignPrediction
    is_taught: bool


class FrameAnalyzer:
    """Analyses the frames of one camera."""

    def __init__(self, recogniser: Recogniser) -> None:
        self._recogniser = recogniser
        self._taught: frozenset[str] = frozenset()

    @property
    def classifier(self) -> SignClassifier:
        """The classifier in use."""
        return self._recogniser.classifier

    def set_classifier(self, classifier: SignClassifier, taught: frozenset[str]) -> None:
        """Replaces the classifier.

        Args:
            taught: names of the signs in it that a class taught.
        """
        self._recogniser.classifier, self._taught = classifier, taught

    def analyze(self, frame: RawFrame, *, both: bool = False) -> list[DetectedSign]:
        """Returns the hands of the next frame, at most two.

        Args:
            both: looks for a second hand, too, while one is tracked.
        """
        if frame.hands is not None:
            return [self._recorded(hand) for hand in frame.hands]
        return [
            self._detected_sign(hand) for hand in self._recogniser.track(frame.picture, both=both)
        ]

    def reset(self) -> None:
        """Resets hand tracking, because the next frame comes from another source."""
        self._recogniser.reset_tracking()

    def _recorded(self, hand: RecordedHand) -> DetectedSign:
        prediction = self.classifier.predict(hand.features, self._recogniser.thresholds)
        side: Literal["left", "right"] = "left" if hand.is_left else "right"
        return DetectedSign(
            hand.points, side, hand.features, prediction, prediction.best in self._taught
        )

    def _detected_sign(self, recognised: RecognisedHand) -> DetectedSign:
        hand, prediction = recognised.hand, recognised.prediction
        points, is_taught = hand.points[:, :2].astype(np.float32), prediction.best in self._taught
        return DetectedSign(points, hand.handedness, recognised.features, prediction, is_taught)
