"""The landmarks from which a taught sign is drawn."""

import numpy as np
import pytest
from numpy.typing import NDArray

from pinel_desktop.gestures.features import features
from pinel_desktop.gestures.hands import HandDetector
from pinel_desktop.gestures.landmarks import Hand
from pinel_desktop.gestures.moving.movements import SHAPE
from pinel_desktop.gestures.training.moving_hands import letter_path
from pinel_desktop.gestures.typical_hand import landmarks_of_movement, medoid_landmarks
from tests.camera.moving_hands import movements
from tests.gestures.drawn import OPEN, drawn_hand, mirrored

Landmarks = NDArray[np.float64]


def hand_in(picture: NDArray[np.uint8]) -> Hand:
    return HandDetector().detect(picture)[0]


def packed(hand: Hand) -> bytes:
    return features(hand).astype("<f2").tobytes()


def from_wrist(points: Landmarks) -> Landmarks:
    """In units of the hand's size."""
    beneath = points - points[0]
    scaled: Landmarks = beneath / np.sqrt((beneath[:, :2] ** 2).sum(1).mean())
    return scaled


def test_landmarks_of_a_right_hand_are_those_of_its_mirror_image() -> None:
    hand = hand_in(mirrored(drawn_hand(OPEN)))
    assert hand.handedness == "right"
    expected = from_wrist(hand.points * [-1, 1, 1])
    assert np.array(medoid_landmarks([packed(hand)])) == pytest.approx(expected, abs=2e-3)


def test_landmarks_of_a_left_hand_are_those_of_a_right_one() -> None:
    hand = hand_in(drawn_hand(OPEN))
    assert hand.handedness == "left"
    expected = from_wrist(hand.points)  # its mirror image, a right hand, in a mirror
    assert np.array(medoid_landmarks([packed(hand)])) == pytest.approx(expected, abs=2e-3)


def test_of_several_hands_the_one_most_like_all_is_drawn() -> None:
    one, other = (packed(hand_in(drawn_hand(bent))) for bent in (OPEN, ()))
    assert medoid_landmarks([one, other, other]) == medoid_landmarks([other])


def test_a_sign_that_moves_is_drawn_as_its_hand_begins() -> None:
    (first, *_) = movements("B", letter_path("Z"), range(1))
    drawn = landmarks_of_movement(first.astype("<f2").tobytes())
    assert drawn[0] == [0.0, 0.0, 0.0]
    assert len(drawn) == 21
    (wrist, tip) = first[0, SHAPE].reshape(21, 2)[[0, 12]]
    assert drawn[12] == pytest.approx([wrist[0] - tip[0], tip[1] - wrist[1], 0.0], abs=0.01)
