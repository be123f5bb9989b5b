"""Hands are found and followed; the hands here are drawn."""

import cv2
import numpy as np
import pytest

from pinel_desktop.gestures.hands import HandDetector, HandTracker, without_duplicates
from pinel_desktop.gestures.landmarks import Hand
from tests.gestures.drawn import OPEN, Picture, drawn_hand, mirrored, on_wall


class CountingDetector(HandDetector):
    """Counts how often palms are looked for."""

    n_searches = 0

    def detect(self, picture: Picture, **options: object) -> list[Hand]:
        self.n_searches += 1
        return super().detect(picture, **options)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def detector() -> CountingDetector:
    return CountingDetector()


def frame(left: int, top: int = 40) -> Picture:
    return on_wall(drawn_hand(OPEN, 320), 960, 540, left, top)


def middle(hand: Hand) -> float:
    return float(hand.points[:, 0].mean())


def test_the_landmarks_of_a_hand_lie_on_it(detector: HandDetector) -> None:
    (hand,) = detector.detect(drawn_hand(OPEN))
    assert hand.presence > 0.9
    tips = hand.points[[8, 12, 16, 20], :2]
    drawn = np.array([[240, 180], [296, 150], [352, 165], [410, 215]])
    assert np.abs(tips - drawn).max() < 40


def test_left_and_right_are_seen_alike(detector: HandDetector) -> None:
    (hand,), (other,) = detector.detect(drawn_hand()), detector.detect(mirrored(drawn_hand()))
    assert {hand.handedness, other.handedness} == {"left", "right"}
    assert np.abs(hand.in_crop[:, :2] - other.in_crop[:, :2]).max() < 15


def test_two_hands_are_two(detector: HandDetector) -> None:
    picture = frame(20)
    picture[40:360, 600:920] = mirrored(drawn_hand(OPEN, 320))
    found = sorted(detector.detect(picture), key=middle)
    assert [hand.handedness for hand in found] in (["left", "right"], ["right", "left"])
    assert middle(found[1]) - middle(found[0]) > 400


@pytest.mark.parametrize("size", [150, 640])
def test_small_and_close_hands_are_found(detector: HandDetector, size: int) -> None:
    (hand,) = detector.detect(on_wall(drawn_hand(OPEN, size), 1280, 720, 300, 20))
    assert hand.presence > 0.5


def test_a_hand_that_fills_the_picture_is_found_with_padding(detector: HandDetector) -> None:
    close = drawn_hand(OPEN)[110:560, 120:500]
    assert detector.detect(np.ascontiguousarray(close))[0].presence > 0.5


@pytest.mark.parametrize("value", [0, 127, 255])
def test_an_empty_picture_shows_no_hand(detector: HandDetector, value: int) -> None:
    found = detector.detect(np.full((480, 640, 3), value, np.uint8))
    assert all(hand.presence < 0.5 for hand in found)


def test_noise_is_no_hand(detector: HandDetector) -> None:
    noise = np.random.default_rng(1).integers(0, 256, (480, 640, 3), dtype=np.uint8)
    assert all(hand.presence < 0.5 for hand in detector.detect(noise))


def test_palms_that_are_not_accepted_are_passed_over(detector: HandDetector) -> None:
    assert detector.detect(frame(200), accepts=lambda palm: False) == []


def test_a_moving_hand_is_followed_without_searching(detector: CountingDetector) -> None:
    tracker = HandTracker(detector)
    (before,) = tracker.update(frame(100))
    detector.n_searches = 0
    for left in range(110, 210, 10):
        (hand,) = tracker.update(frame(left))
    assert detector.n_searches == 0
    assert middle(hand) - middle(before) == pytest.approx(100, abs=10)


def test_a_second_hand_is_found_beside_a_followed_one_where_both_are_looked_for(
    detector: HandDetector,
) -> None:
    alone, both = frame(20), frame(20)
    both[40:360, 600:920] = mirrored(drawn_hand(OPEN, 320))
    for asked in (True, False):
        tracker = HandTracker(detector)
        assert len(tracker.update(alone, both=asked)) == 1
        seen = [len(tracker.update(both, both=asked)) for _ in range(6)]
        assert seen[-1] == (2 if asked else 1)
        assert len(tracker.update(alone, both=asked)) == 1


def test_a_hand_that_left_is_given_up_and_found_again_elsewhere(detector: HandDetector) -> None:
    tracker = HandTracker(detector)
    assert len(tracker.update(frame(100))) == 1
    assert tracker.update(np.full((540, 960, 3), 90, np.uint8)) == []
    (hand,) = tracker.update(frame(600))
    assert middle(hand) > 600


def test_a_hand_that_becomes_the_other_one_is_seen_as_that(detector: HandDetector) -> None:
    tracker = HandTracker(detector)
    (hand,) = tracker.update(frame(300))
    (other,) = tracker.update(mirrored(frame(340)))
    assert other.handedness != hand.handedness


def test_the_same_hand_found_twice_is_one(detector: HandDetector) -> None:
    (hand,) = detector.detect(drawn_hand())
    assert without_duplicates([hand, hand]) == [hand]


def test_very_large_and_very_narrow_pictures_are_no_trouble(detector: HandDetector) -> None:
    large = np.asarray(cv2.resize(frame(200), (7680, 4320)), np.uint8)
    assert detector.detect(large)[0].presence > 0.5
    assert all(hand.presence < 0.5 for hand in detector.detect(np.zeros((16, 4000, 3), np.uint8)))
