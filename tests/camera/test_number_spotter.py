"""When a number counts as shown: steadily, by the fingers of all hands, or by a sign that the class taught."""

from dataclasses import replace

import numpy as np
import pytest

from pinel_desktop.camera.frame_analyzer import DetectedSign
from pinel_desktop.camera.number_spotter import MIN_HOLD_S, NumberSpotter, shown_number
from pinel_desktop.gestures.classifier import SignPrediction
from pinel_desktop.gestures.stability import Decision
from tests.camera.taught_hands import shown

FRAME_S = 1 / 15


def hand(letter: str, taught: str | None = None, x: float = 0.0) -> DetectedSign:
    """A hand of the recordings, `x` px further right; `taught` is the sign of the class that it surely shows."""
    one = shown(letter)[0]
    best = taught or letter
    prediction = SignPrediction(best, best, 0.99, "", 0.0)
    points = (one.points + np.array([x, 0])).astype(np.float32)
    box = (x, 0.0, x + 100.0, 100.0)
    return DetectedSign(
        box, prediction, points, "right", one.features, is_taught=taught is not None
    )


def decided(*frames: list[DetectedSign], frame_s: float = FRAME_S) -> list[tuple[int, Decision]]:
    spotter = NumberSpotter()
    found = [(i, spotter.update(i * frame_s, hands)) for i, hands in enumerate(frames)]
    return [(i, decision) for i, decision in found if decision]


def test_number_counts_after_it_was_held() -> None:
    [(frame, decision)] = decided(*[[hand("W")]] * 16)
    assert frame * FRAME_S == pytest.approx(MIN_HOLD_S, abs=FRAME_S)
    assert (decision.label, decision.is_moving) == ("3", False)
    assert decision.confidence >= 0.97


def test_second_hand_that_follows_is_waited_for() -> None:
    first, second = hand("B"), hand("W", x=300)
    [(_, decision)] = decided(*[[first]] * 10, *[[first, second]] * 16)
    assert decision.label == "7"


def test_order_of_the_hands_makes_no_difference() -> None:
    left, right = hand("B"), hand("W", x=300)
    [(_, decision)] = decided(*[[left, right], [right, left]] * 8)
    assert decision.label == "7"


def test_hand_that_moves_shows_no_number() -> None:
    assert decided(*[[hand("W", x=60.0 * i)] for i in range(20)]) == []


def of_detector(name: str, confidence: float = 0.8) -> DetectedSign:
    """A sign of a detector, which finds no landmarks."""
    return DetectedSign((0.0, 0.0, 90.0, 90.0), SignPrediction(name, name, confidence, "", 0.0))


def test_a_detectors_number_counts_and_no_other_sign_of_it() -> None:
    spotter = NumberSpotter(min_confidence=0.6)
    found = [spotter.update(i * FRAME_S, [of_detector("7")]) for i in range(16)]
    assert [decision.label for decision in found if decision] == ["7"]
    assert shown_number([of_detector("A")]) is None
    assert shown_number([of_detector("7"), of_detector("2")]) is None


def test_without_a_hand_there_is_no_number() -> None:
    assert shown_number([]) is None
    spotter = NumberSpotter()
    for i in range(8):
        spotter.update(i * FRAME_S, [hand("L")])
    assert (spotter.label, 0.0 < spotter.progress < 1.0) == ("2", True)
    spotter.update(8 * FRAME_S, [])
    assert (spotter.label, spotter.progress) == ("", 0.0)


def test_taught_number_on_the_only_hand_counts_instead_of_its_fingers() -> None:
    number = shown_number([hand("L", taught="7")])
    assert number is not None
    assert (number.best, number.is_sure) == ("7", True)
    other = shown_number([hand("L", taught="vai")])
    assert other is not None
    assert other.best == "2"


def test_taught_number_that_is_not_sure_leaves_the_fingers() -> None:
    unsure = hand("L", taught="7")
    number = shown_number([replace(unsure, prediction=replace(unsure.prediction, sign=None))])
    assert number is not None
    assert number.best == "2"


def test_beside_another_hand_a_taught_number_counts_only_where_the_fingers_say_the_same() -> None:
    same = shown_number([hand("B", taught="4"), hand("W")])
    assert same is not None
    assert (same.best, same.is_sure) == ("7", True)
    other = shown_number([hand("L", taught="7"), hand("W")])
    assert other is not None
    assert not other.is_sure
