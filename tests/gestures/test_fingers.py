"""Raised fingers, counted on recorded hands of letters, on hands made from them, and on drawn hands."""

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from pinel_desktop.gestures.features import features, palm_landmarks
from pinel_desktop.gestures.fingers import (
    MIN_CONFIDENCE,
    NumberPrediction,
    count_fingers,
    raised_probabilities,
)
from pinel_desktop.gestures.hands import HandDetector
from pinel_desktop.gestures.stability import MIN_CONFIDENCE as OF_STEADY_SIGNS
from tests.camera.taught_hands import shown
from tests.gestures.drawn import LETTER_L, OPEN, Picture, drawn_hand, mirrored, on_wall

Array = NDArray[np.float64]
RAISED = {"A": 0, "L": 2, "W": 3, "B": 4}
THUMB = slice(1, 5)


def hand(letter: str) -> Array:
    return palm_landmarks(shown(letter)[0].features)


def open_hand() -> Array:
    """The fingers of B and the thumb of L: there is no photograph of five."""
    landmarks = hand("B")
    landmarks[THUMB] = hand("L")[THUMB]
    return landmarks


@pytest.mark.parametrize("letter", RAISED)
def test_letters_have_as_many_raised_fingers_as_they_are_drawn_with(letter: str) -> None:
    for one in shown(letter):
        number = count_fingers([palm_landmarks(one.features)])
        assert number.is_sure
        assert int(number.best) == RAISED[letter]


def test_each_finger_is_counted_apart() -> None:
    assert (raised_probabilities(hand("L")) > 0.5).tolist() == [True, True, False, False, False]
    assert (raised_probabilities(hand("W")) > 0.5).tolist() == [False, True, True, True, False]


def test_two_hands_show_the_sum_up_to_ten() -> None:
    assert count_fingers([hand("B"), hand("W")]).best == "7"
    assert count_fingers([hand("A"), hand("L")]).best == "2"
    assert count_fingers([open_hand()]).best == "5"
    ten = count_fingers([open_hand(), open_hand()])
    assert (ten.best, ten.is_sure) == ("10", True)


def test_neither_size_nor_side_of_the_hand_makes_a_difference() -> None:
    for letter, n in RAISED.items():
        other_side = 1.7 * hand(letter) * [1.0, 1.0, -1.0]
        assert count_fingers([other_side]).best == str(n)


@pytest.fixture(scope="module")
def detector() -> HandDetector:
    return HandDetector()


def counted(detector: HandDetector, picture: Picture) -> NumberPrediction:
    return count_fingers([palm_landmarks(features(hand)) for hand in detector.detect(picture)])


@pytest.mark.parametrize("degrees", [0, 45, -45])
@pytest.mark.parametrize("is_other_hand", [False, True])
@pytest.mark.parametrize("n", range(2, 6))
def test_drawn_hands_are_counted_with_their_thumb_tilted_too_and_of_either_side(
    detector: HandDetector, n: int, is_other_hand: bool, degrees: int
) -> None:
    picture = drawn_hand(OPEN[: n - 1])
    picture = mirrored(picture) if is_other_hand else picture
    middle = (picture.shape[1] / 2, picture.shape[0] / 2)
    turn = cv2.getRotationMatrix2D(middle, degrees, 0.8)
    size = picture.shape[1::-1]
    turned = cv2.warpAffine(picture, turn, size, borderMode=cv2.BORDER_REPLICATE)
    assert counted(detector, np.asarray(turned, np.uint8)).best == str(n)


def test_two_drawn_hands_are_counted_together(detector: HandDetector) -> None:
    picture = on_wall(drawn_hand(OPEN, 320), 960, 540, 20, 40)
    picture[40:360, 600:920] = mirrored(drawn_hand(LETTER_L, 320))
    assert counted(detector, picture).best == "7"
    picture[40:360, 600:920] = mirrored(drawn_hand(OPEN, 320))
    assert counted(detector, picture).best == "10"


def test_half_bent_finger_is_a_doubt_between_two_numbers() -> None:
    """Between W and B only the little finger differs."""
    shares = []
    for part in np.linspace(0.0, 1.0, 21):
        landmarks = hand("B")
        landmarks[17:] = (1.0 - part) * hand("W")[17:] + part * landmarks[17:]
        number = count_fingers([landmarks])
        shares.append(number.confidence)
        assert {number.best, number.second} <= {"2", "3", "4"}
        assert number.is_sure == (number.confidence >= MIN_CONFIDENCE)
    assert shares[0] > MIN_CONFIDENCE < shares[-1]
    assert min(shares) < 0.75


def test_sure_number_becomes_steady_as_a_letter_does() -> None:
    assert MIN_CONFIDENCE >= OF_STEADY_SIGNS  # else a number could be sure and never count
    assert not count_fingers([hand("W")]).as_unsure().is_sure
