"""Detects hands and signs in the frames of a camera, frame by frame."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.camera.frames import RawFrame
from pinel_desktop.camera.landmark_sequence import RecordedHand
from pinel_desktop.gestures.classifier import SignClassifier, SignPrediction
from pinel_desktop.gestures.recognition import LandmarkRecognizer
from pinel_desktop.gestures.recognizer import Box, RecognizedSign, SignRecognizer


@dataclass(frozen=True, slots=True)
class DetectedSign:
    """A detected hand and its predicted sign.

    Attributes:
        box: left, top, right, bottom of the hand, in px of the frame.
        prediction: the predicted sign.
        points: 21 landmarks (x, y) in px of the frame; None from a recognizer without landmarks, as the next two.
        handedness: which hand of the person it is.
        features: feature vector of the hand, (1748,).
        is_taught: whether the class taught the likeliest sign.
    """

    box: Box
    prediction: SignPrediction
    points: NDArray[np.float32] | None = None
    handedness: Literal["left", "right"] | None = None
    features: NDArray[np.float32] | None = None
    is_taught: bool = False

    @property
    def outline(self) -> NDArray[np.float32]:
        """Points that move with the hand, (n, 2) in px: the landmarks, else the corners of the box."""
        if self.points is not None:
            return self.points
        left, top, right, bottom = self.box
        return np.array([[left, top], [right, top], [right, bottom], [left, bottom]], np.float32)


class FrameAnalyzer:
    """Analyses the frames of one camera.

    Args:
        landmarks: the recognizer by default; the only one that signs are taught to, and that reads recorded hands.
    """

    def __init__(self, landmarks: LandmarkRecognizer) -> None:
        self._landmarks = landmarks
        self._recognizer: SignRecognizer = landmarks
        self._taught: frozenset[str] = frozenset()

    @property
    def recognizer(self) -> SignRecognizer:
        """The recognizer of the frames."""
        return self._recognizer

    @property
    def has_landmarks(self) -> bool:
        """Whether the frames are read by landmarks, so that taught signs count."""
        return self._recognizer is self._landmarks

    def use(self, recognizer: SignRecognizer | None) -> None:
        """Reads the next frames with another recognizer; None is the default."""
        self._recognizer = recognizer or self._landmarks
        self.reset()

    @property
    def classifier(self) -> SignClassifier:
        """The classifier of the landmarks in use."""
        return self._landmarks.classifier

    def set_classifier(self, classifier: SignClassifier, taught: frozenset[str]) -> None:
        """Replaces the classifier.

        Args:
            taught: names of the signs in it that a class taught.
        """
        self._landmarks.classifier, self._taught = classifier, taught

    def analyze(self, frame: RawFrame, *, both: bool = False) -> list[DetectedSign]:
        """Returns the hands of the next frame, at most two.

        Args:
            both: looks for a second hand, too, while one is tracked.
        """
        if frame.hands is not None:
            return [self._recorded(hand) for hand in frame.hands]
        return [
            self._detected_sign(sign) for sign in self._recognizer.track(frame.picture, both=both)
        ]

    def reset(self) -> None:
        """Resets hand tracking, because the next frame comes from another source."""
        self._recognizer.reset_tracking()

    def _recorded(self, hand: RecordedHand) -> DetectedSign:
        prediction = self.classifier.predict(hand.features, self._landmarks.thresholds)
        low, high = hand.points.min(axis=0), hand.points.max(axis=0)
        return DetectedSign(
            (float(low[0]), float(low[1]), float(high[0]), float(high[1])),
            prediction,
            hand.points,
            "left" if hand.is_left else "right",
            hand.features,
            prediction.best in self._taught,
        )

    def _detected_sign(self, sign: RecognizedSign) -> DetectedSign:
        if sign.hand is None:
            return DetectedSign(sign.box, sign.prediction)
        return DetectedSign(
            sign.box,
            sign.prediction,
            sign.hand.points[:, :2].astype(np.float32),
            sign.hand.handedness,
            sign.features,
            sign.prediction.best in self._taught,
        )
