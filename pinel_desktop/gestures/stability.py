"""Stability filter: a sign counts as shown if a hand at rest has the same letter over several frames."""

from collections import deque
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

N_FRAMES = 5
MIN_HOLD_S = 0.3  # with a fast camera, N_FRAMES alone could end within a transition between letters
MIN_CONFIDENCE = 0.97  # mean of the frames; below it false signs are three times as frequent
_MAX_FRAMES = 60
STILL_HZ = 1.5  # hand sizes/s, RMS over the landmarks; a transition between letters is faster


@dataclass(frozen=True, slots=True)
class FramePrediction:
    """Prediction for one frame.

    Attributes:
        time_s: time of the frame, on any clock.
        label: the letter; None if the classifier rejects the hand, or there is no hand.
        confidence: of the label, 0 to 1.
        second: the second best letter; "" if there is none.
        points: points that move with the hand (n, 2) in px, such as its landmarks; None without a hand.
    """

    time_s: float
    label: str | None
    confidence: float = 0.0
    second: str = ""
    points: NDArray[np.float32] | None = None


@dataclass(frozen=True, slots=True)
class Decision:
    """The steady sign, the mean confidence of its frames, and the second best sign of the last frame.

    is_moving: whether the sign is a movement that a class taught.
    """

    label: str
    confidence: float
    second: str
    is_moving: bool = False


def is_still(before: NDArray[np.float32], now: NDArray[np.float32], elapsed_s: float) -> bool:
    """Returns whether a hand was at rest from one frame to the next: points (n, 2) in px."""
    size = float(np.ptp(now, axis=0).max()) + 1e-6
    motion = float(np.sqrt(((now - before) ** 2).sum(axis=1).mean()))
    return motion / size <= STILL_HZ * elapsed_s


class StabilityFilter:
    """Counts frames until a sign is steady. A frame with another label, or a moving hand, restarts the count.

    Args:
        min_confidence: mean confidence of the frames from which the sign counts.
    """

    def __init__(self, min_confidence: float = MIN_CONFIDENCE) -> None:
        self._min_confidence = min_confidence
        self._frames: deque[FramePrediction] = deque(maxlen=_MAX_FRAMES)
        self._last: FramePrediction | None = None
        self._min_hold_s = MIN_HOLD_S

    @property
    def progress(self) -> float:
        """Progress towards a decision, 0 to 1."""
        if not self._frames:
            return 0.0
        lasted_s = self._frames[-1].time_s - self._frames[0].time_s
        return min(1.0, len(self._frames) / N_FRAMES, lasted_s / self._min_hold_s)

    @property
    def label(self) -> str:
        """The candidate sign; "" if there is none."""
        return self._frames[-1].label or "" if self._frames else ""

    def update(self, frame: FramePrediction, min_hold_s: float = MIN_HOLD_S) -> Decision | None:
        """Adds the next frame; once a sign is steady for `min_hold_s`, returns the decision and restarts the count."""
        moved = self._moved(frame)
        self._min_hold_s = min_hold_s
        self._last = frame
        if frame.label is None or moved:
            self._frames.clear()
            return None
        if self._frames and self._frames[-1].label != frame.label:
            self._frames.clear()
        self._frames.append(frame)
        is_certain = self._mean_confidence() >= self._min_confidence
        return self._decision() if self.progress >= 1.0 and is_certain else None

    def reset(self) -> None:
        """Discards all frames."""
        self._frames.clear()
        self._last = None

    def _moved(self, frame: FramePrediction) -> bool:
        last = self._last
        if last is None or last.points is None or frame.points is None:
            return False
        return not is_still(last.points, frame.points, frame.time_s - last.time_s)

    def _decision(self) -> Decision:
        last, confidence = self._frames[-1], self._mean_confidence()
        self._frames.clear()
        return Decision(last.label or "", round(confidence, 3), last.second)

    def _mean_confidence(self) -> float:
        return float(np.mean([frame.confidence for frame in self._frames]))
