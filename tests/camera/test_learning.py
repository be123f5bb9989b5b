"""The classifier learns what a class taught beside the frames; hands are chosen to learn from."""

import base64
import threading
import time
from dataclasses import replace

import numpy as np
import pytest

from pinel_desktop.camera.learning import Learner, Learnt, MovementTaker, SampleTaker
from pinel_desktop.camera.sight import SeenSign
from pinel_desktop.gestures import weights_file
from pinel_desktop.gestures.classifier import Reading, SignClassifier
from pinel_desktop.gestures.features import N_FEATURES
from pinel_desktop.gestures.letters import LETTERS
from pinel_desktop.gestures.training.moving_hands import letter_path
from tests.camera.moving_hands import glimpses, movements
from tests.camera.moving_hands import packed as packed_movements
from tests.camera.taught_hands import packed, shown

WAIT_S = 30.0
HAND = SeenSign(
    points=np.random.default_rng(1).uniform(100, 300, (21, 2)).astype(np.float32),
    handedness="right",
    features=np.linspace(-3, 3, N_FEATURES, dtype=np.float32),
    reading=Reading(None, "A", 0.4, "B", 0.3),
    is_taught=False,
)


@pytest.fixture(scope="module")
def letters() -> SignClassifier:
    return weights_file.load()


def message(sign: str, samples: bytes, movements: bytes = b"") -> dict[str, str]:
    hands, ways = (base64.b64encode(octets).decode("ascii") for octets in (samples, movements))
    return {"sign": sign, "samples": hands, "movements": ways}


def learnt_by(learner: Learner) -> Learnt:
    deadline = time.monotonic() + WAIT_S
    while (found := learner.take()) is None:
        assert time.monotonic() < deadline
        threading.Event().wait(0.01)
    return found


def test_the_list_of_letters_is_what_the_classifier_that_ships_knows(
    letters: SignClassifier,
) -> None:
    assert letters.signs == LETTERS


def test_a_sign_of_the_class_is_known_besides_the_letters(letters: SignClassifier) -> None:
    learner, hands = Learner(letters), shown("B")
    learner.learn([message("vai", packed(hands[:10]))])
    assert learner.is_busy
    found = learnt_by(learner)
    assert not learner.is_busy
    assert found.classifier.signs == (*LETTERS, "vai")
    assert found.taught == {"vai"}
    learner.learn([])
    assert learnt_by(learner).classifier is letters


def test_a_sign_that_moves_is_known_beside_the_letters_as_they_are(
    letters: SignClassifier,
) -> None:
    learner, ways = Learner(letters), movements("B", letter_path("Z"), range(3))
    learner.learn([message("Z", b"", packed_movements(ways))])
    learnt = learnt_by(learner)
    assert (learnt.classifier, learnt.taught, learnt.moving.signs) == (letters, frozenset(), ("Z",))
    assert learnt.moving.read(ways[0]).sign == "Z"


def test_of_two_classes_the_later_one_counts(letters: SignClassifier) -> None:
    learner, samples = Learner(letters), packed(shown("B")[:1])
    for sign in ("7", "8", "9"):
        learner.learn([message(sign, samples)])
    assert learnt_by(learner).taught == {"9"}
    threading.Event().wait(0.5)
    assert learner.take() is None


@pytest.mark.parametrize("samples", ["no base64!", base64.b64encode(b"abc").decode(), None])
def test_samples_that_are_none_leave_the_letters(letters: SignClassifier, samples: object) -> None:
    learner = Learner(letters)
    for kinds in (("samples", "movements"), ("movements", "samples")):
        learner.learn([{"sign": "7", **dict(zip(kinds, (samples, ""), strict=True))}])
        learnt = learnt_by(learner)
        assert (learnt.classifier, learnt.moving.signs) == (letters, ())


class Taking:
    """Frames of 30 a second given to a taker."""

    def __init__(self) -> None:
        self._taker, self._time_s = SampleTaker(), 0.0

    def take(self, *hands: SeenSign) -> str | None:
        self._time_s += 1 / 30
        return self._taker.take(self._time_s, hands)


@pytest.fixture
def taking() -> Taking:
    return Taking()


def test_a_hand_at_rest_is_taken_about_eight_times_a_second(taking: Taking) -> None:
    samples = [sample for _ in range(61) if (sample := taking.take(HAND))]
    assert 14 <= len(samples) <= 17
    kept = np.frombuffer(base64.b64decode(samples[0]), "<f2")
    assert kept.shape == (N_FEATURES,)
    assert np.allclose(kept, HAND.features, atol=2e-3)


def test_neither_a_hand_that_moves_nor_one_of_two_nor_none_is_taken(taking: Taking) -> None:
    for n in range(30):
        assert taking.take(replace(HAND, points=HAND.points + 25 * n)) is None
    for _ in range(30):
        assert taking.take(HAND, HAND) is None
        assert taking.take() is None


def test_a_hand_whose_numbers_are_none_is_not_taken(taking: Taking) -> None:
    for value in (np.nan, 1e6):
        hand = replace(HAND, features=np.full(N_FEATURES, value, np.float32))
        assert not any(taking.take(hand) for _ in range(30))


def test_a_movement_from_rest_to_rest_is_taken_once_and_none_of_two_hands() -> None:
    def taken(n_hands: int) -> list[str]:
        taker = MovementTaker()
        seen = [
            taker.take(one.time_s, [replace(HAND, points=one.points)] * n_hands)
            for one in glimpses("B", letter_path("Z"), 1)
        ]
        return [movement for movement in seen if movement]

    (movement,) = taken(1)
    assert len(base64.b64decode(movement)) == 2 * N_FEATURES
    assert taken(2) == taken(0) == []
