"""Decides when a number counts as shown: raised fingers of one or two hands, or a sign of the class named 0 to 10."""

import numpy as np

from pinel_desktop.camera.frame_analyzer import DetectedSign
from pinel_desktop.gestures.features import palm_landmarks
from pinel_desktop.gestures.fingers import NumberPrediction, count_fingers
from pinel_desktop.gestures.stability import (
    MIN_CONFIDENCE,
    Decision,
    FramePrediction,
    StabilityFilter,
    is_still,
)

NUMBERS = tuple(map(str, range(11)))
NO_NUMBER_SHOWN = NumberPrediction("", 0.0, "", is_sure=False)
# Longer than for letters: whoever shows seven raises one hand after the other, finger after finger.
MIN_HOLD_S = 0.8


def shown_number(hands: list[DetectedSign]) -> NumberPrediction | None:
    """Returns the number that the hands show together; None without a hand that can be counted.

    A taught number on the only hand takes precedence, because numerals of Libras differ from raised fingers from 5 on.
    A detector finds no fingers: its classes named 0 to 10 count like taught numbers.
    Of two hands the fingers count; a taught number that is not its own count of fingers then makes it doubtful.
    """
    taught = [hand.prediction for hand in hands if _is_number(hand)]
    if len(hands) == 1 and taught:
        one = taught[0]
        return NumberPrediction(one.best, one.confidence, one.second, is_sure=True)
    fingers = [palm_landmarks(hand.features) for hand in hands if hand.features is not None]
    if not hands or len(fingers) < len(hands):
        return None
    counts = [count_fingers([one]) for one in fingers]
    together = count_fingers(fingers)
    is_plain = all(
        not _is_number(hand) or hand.prediction.best == count.best
        for hand, count in zip(hands, counts, strict=True)
    )
    return together if is_plain else together.as_unsure()


def _is_number(hand: DetectedSign) -> bool:
    """Returns whether the hand surely shows a number that the class taught, or that a detector knows."""
    is_trained = hand.is_taught or hand.features is None
    return is_trained and hand.prediction.sign in NUMBERS


class NumberSpotter:
    """Counts frames until a number is steady. Another number, a hand more or less, or a moving hand restarts it.

    Args:
        min_confidence: mean confidence of the frames from which the number counts.
    """

    def __init__(self, min_confidence: float = MIN_CONFIDENCE) -> None:
        self._filter = StabilityFilter(min_confidence)
        self._last: tuple[float, list[DetectedSign]] | None = None

    @property
    def progress(self) -> float:
        """Progress of the candidate number towards a decision, 0 to 1."""
        return self._filter.progress

    @property
    def label(self) -> str:
        """The candidate number; "" if there is none."""
        return self._filter.label

    def reset(self) -> None:
        """Discards all frames."""
        self._filter.reset()
        self._last = None

    def update(self, time_s: float, hands: list[DetectedSign]) -> Decision | None:
        """Adds the next frame (time in s, on any clock); returns the number once it is steady."""
        hands = sorted(hands, key=lambda hand: float(np.mean(hand.outline[:, 0])))
        number, rests = shown_number(hands), self._rest(time_s, hands)
        self._last = time_s, hands
        label = number.best if number and number.is_sure and rests else None
        if number is None or label is None:
            return self._filter.update(FramePrediction(time_s, None), MIN_HOLD_S)
        frame = FramePrediction(time_s, label, number.confidence, number.second)
        return self._filter.update(frame, MIN_HOLD_S)

    def _rest(self, time_s: float, hands: list[DetectedSign]) -> bool:
        """Returns whether the same number of hands was there in the last frame, and each at rest since."""
        if self._last is None:
            return True
        last_s, last = self._last
        return len(last) == len(hands) and all(
            is_still(before.outline, now.outline, time_s - last_s)
            for before, now in zip(last, hands, strict=True)
        )
