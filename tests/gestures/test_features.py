"""What the numbers of a hand depend on, and what they do not."""

from dataclasses import replace

import numpy as np
import pytest

from pinel_desktop.gestures.features import BLOCKS, N_FEATURES, N_SHAPE, features
from pinel_desktop.gestures.hands import HandDetector
from pinel_desktop.gestures.landmarks import Hand
from tests.gestures.drawn import OPEN, drawn_hand, mirrored, on_wall


@pytest.fixture(scope="module")
def detector() -> HandDetector:
    return HandDetector()


@pytest.fixture(scope="module")
def hand(detector: HandDetector) -> Hand:
    (found,) = detector.detect(drawn_hand(OPEN))
    return found


def test_a_hand_has_852_numbers_of_shape_and_896_of_what_was_seen(hand: Hand) -> None:
    numbers = features(hand)
    assert numbers.shape == (N_FEATURES,) == (852 + 896,)
    assert numbers.dtype == np.float32
    assert np.isfinite(numbers).all()
    assert [block.stop - block.start for block in BLOCKS] == [852, 896]


def test_place_and_size_in_the_picture_change_nothing(hand: Hand) -> None:
    moved = replace(hand, points=hand.points * 3 + [500, -80, 0])
    assert features(moved) == pytest.approx(features(hand), abs=1e-5)


def test_a_direction_in_the_picture_is_kept(hand: Hand) -> None:
    x, y, z = hand.points.T
    lying = replace(hand, points=np.column_stack([-y, x, z]))
    assert np.abs(features(lying)[:N_SHAPE] - features(hand)[:N_SHAPE]).max() > 0.5


def test_a_left_hand_has_nearly_the_numbers_of_its_mirror_image(detector: HandDetector) -> None:
    (one,) = detector.detect(drawn_hand(OPEN))
    (other,) = detector.detect(mirrored(drawn_hand(OPEN)))
    bent, *_ = detector.detect(drawn_hand(()))
    same = np.linalg.norm(features(one) - features(other))
    assert same < 0.5 * np.linalg.norm(features(one) - features(bent))


def test_the_same_hand_elsewhere_in_a_larger_picture_has_nearly_the_same_numbers(
    detector: HandDetector, hand: Hand
) -> None:
    (small,) = detector.detect(on_wall(drawn_hand(OPEN, 400), 1280, 720, 700, 200))
    bent, *_ = detector.detect(drawn_hand(()))
    distance = np.linalg.norm(features(small) - features(hand))
    assert distance < 0.5 * np.linalg.norm(features(bent) - features(hand))


def test_degenerate_landmarks_give_finite_numbers(hand: Hand) -> None:
    point = replace(
        hand, points=np.zeros((21, 3)), world=np.zeros((21, 3)), in_crop=np.zeros((21, 3))
    )
    assert np.isfinite(features(point)).all()
