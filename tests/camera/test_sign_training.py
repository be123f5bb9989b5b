"""The classifier learns what a class taught beside the frames; hands are chosen to learn from."""

import base64
import threading
import time
from dataclasses import replace

import numpy as np
import pytest

from pinel_desktop.camera.frame_analyzer import DetectedSign
from pinel_desktop.camera.sign_training import (
    MovementCollector,
    SampleCollector,
    SignTrainer,
    TrainedSigns,
)
from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.classifier import SignClassifier, SignPrediction
from pinel_desktop.gestures.features import N_FEATURES
from pinel_desktop.gestures.letters import LETTERS
from pinel_desktop.gestures.training.moving_hands import letter_path
from tests.camera.moving_hands import movements, observations
from tests.camera.moving_hands import packed as packed_movements
from tests.camera.taught_hands import packed, shown

WAIT_S = 30.0
POINTS = np.random.default_rng(1).uniform(100, 300, (21, 2)).astype(np.float32)
FEATURES = np.linspace(-3, 3, N_FEATURES, dtype=np.float32)
HAND = DetectedSign(
    box=(100.0, 100.0, 300.0, 300.0),
    points=POINTS,
    handedness="right",
    features=FEATURES,
    prediction=SignPrediction(None, "A", 0.4, "B", 0.3),
    is_taught=False,
)


@pytest.fixture(scope="module")
def letters() -> SignClassifier:
    return weights_file.load()


def message(sign: str, samples: bytes, movements: bytes = b"") -> dict[str, str]:
    hands, moves = (base64.b64encode(octets).decode("ascii") for octets in (samples, movements))
    return {"sign": sign, "samples": hands, "movements": moves}


def trained_by(trainer: SignTrainer) -> TrainedSigns:
    deadline = time.monotonic() + WAIT_S
    while (found := trainer.pop_result()) is None:
        assert time.monotonic() < deadline
        threading.Event().wait(0.01)
    return found


def test_the_list_of_letters_is_what_the_classifier_that_ships_knows(
    letters: SignClassifier,
) -> None:
    assert letters.signs == LETTERS


def test_a_sign_of_the_class_is_known_besides_the_letters(letters: SignClassifier) -> None:
    trainer, hands = SignTrainer(letters), shown("B")
    trainer.train([message("vai", packed(hands[:10]))])
    assert trainer.is_busy
    found = trained_by(trainer)
    assert not trainer.is_busy
    assert found.classifier.signs == (*LETTERS, "vai")
    assert found.taught == {"vai"}
    trainer.train([])
    assert trained_by(trainer).classifier is letters


def test_a_sign_that_moves_is_known_beside_the_letters_as_they_are(
    letters: SignClassifier,
) -> None:
    trainer, moves = SignTrainer(letters), movements("B", letter_path("Z"), range(3))
    trainer.train([message("Z", b"", packed_movements(moves))])
    trained = trained_by(trainer)
    assert (trained.classifier, trained.taught, trained.moving.signs) == (
        letters,
        frozenset(),
        ("Z",),
    )
    assert trained.moving.predict(moves[0]).sign == "Z"


def test_of_two_classes_the_later_one_counts(letters: SignClassifier) -> None:
    trainer, samples = SignTrainer(letters), packed(shown("B")[:1])
    for sign in ("7", "8", "9"):
        trainer.train([message(sign, samples)])
    assert trained_by(trainer).taught == {"9"}
    threading.Event().wait(0.5)
    assert trainer.pop_result() is None


@pytest.mark.parametrize("samples", ["no base64!", base64.b64encode(b"abc").decode(), None])
def test_samples_that_are_none_leave_the_letters(letters: SignClassifier, samples: object) -> None:
    trainer = SignTrainer(letters)
    for kinds in (("samples", "movements"), ("movements", "samples")):
        trainer.train([{"sign": "7", **dict(zip(kinds, (samples, ""), strict=True))}])
        trained = trained_by(trainer)
        assert (trained.classifier, trained.moving.signs) == (letters, ())


class FrameFeed:
    """Frames of 30 a second given to a taker."""

    def __init__(self) -> None:
        self._collector, self._time_s = SampleCollector(), 0.0

    def show(self, *hands: DetectedSign) -> str | None:
        self._time_s += 1 / 30
        return self._collector.update(self._time_s, hands)


@pytest.fixture
def feed() -> FrameFeed:
    return FrameFeed()


def test_a_hand_at_rest_is_taken_about_eight_times_a_second(feed: FrameFeed) -> None:
    samples = [sample for _ in range(61) if (sample := feed.show(HAND))]
    assert 14 <= len(samples) <= 17
    numbers = np.frombuffer(base64.b64decode(samples[0]), "<f2")
    assert numbers.shape == (N_FEATURES,)
    assert np.allclose(numbers, FEATURES, atol=2e-3)


def test_neither_a_hand_that_moves_nor_one_of_two_nor_none_is_taken(feed: FrameFeed) -> None:
    for n in range(30):
        assert feed.show(replace(HAND, points=POINTS + 25 * n)) is None
    for _ in range(30):
        assert feed.show(HAND, HAND) is None
        assert feed.show() is None


def test_a_hand_whose_numbers_are_none_is_not_taken(feed: FrameFeed) -> None:
    for value in (np.nan, 1e6):
        hand = replace(HAND, features=np.full(N_FEATURES, value, np.float32))
        assert not any(feed.show(hand) for _ in range(30))


def test_a_movement_from_rest_to_rest_is_taken_once_and_none_of_two_hands() -> None:
    def collected(n_hands: int) -> list[str]:
        collector = MovementCollector()
        results = [
            collector.update(one.time_s, [replace(HAND, points=one.points)] * n_hands)
            for one in observations("B", letter_path("Z"), 1)
        ]
        return [movement for movement in results if movement]

    (movement,) = collected(1)
    assert len(base64.b64decode(movement)) == 2 * N_FEATURES
    assert collected(2) == collected(0) == []
