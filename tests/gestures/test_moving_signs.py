"""Signs that move are recognised by a few examples, and nothing else is. Real hands, computed ways."""

import numpy as np
import pytest

from pinel_desktop.gestures.moving.moving_signs import MovingSignClassifier
from pinel_desktop.gestures.training import moving_hands as hands
from tests.camera.moving_hands import movements
from tests.camera.taught_hands import shown

TAUGHT = {"Z": "B", "J": "A"}  # here with the hands of which there are recordings
EXAMPLES, OTHERS = range(5), range(100, 120)


@pytest.fixture(scope="module")
def known() -> MovingSignClassifier:
    return MovingSignClassifier(
        {
            sign: np.array(movements(hand, hands.letter_path(sign), EXAMPLES))
            for sign, hand in TAUGHT.items()
        }
    )


def read(known: MovingSignClassifier, hand: str, path_letter: str) -> list[str | None]:
    return [
        known.predict(one).sign for one in movements(hand, hands.letter_path(path_letter), OTHERS)
    ]


@pytest.mark.parametrize(("sign", "hand"), TAUGHT.items())
def test_five_examples_are_enough_at_another_speed_size_and_place(
    known: MovingSignClassifier, sign: str, hand: str
) -> None:
    found = read(known, hand, sign)
    assert len(found) >= 18
    assert set(found) <= {sign, None}
    assert found.count(sign) >= 0.85 * len(found)


@pytest.mark.parametrize(("hand", "path_letter"), [("A", "Z"), ("B", "J"), ("A", "X"), ("B", "H")])
def test_another_hand_or_another_way_is_no_sign(
    known: MovingSignClassifier, hand: str, path_letter: str
) -> None:
    found = read(known, hand, path_letter)
    assert len(found) >= 15
    assert found.count(None) >= 0.9 * len(found)


def test_what_is_thought_of_a_movement_names_the_likeliest_two(known: MovingSignClassifier) -> None:
    reading = known.predict(movements("B", hands.letter_path("Z"), range(100, 101))[0])
    assert (reading.sign, reading.best, reading.second) == ("Z", "Z", "J")
    assert 0.5 < reading.confidence <= 1.0


def test_a_hand_may_begin_a_sign_that_begins_like_it(known: MovingSignClassifier) -> None:
    only_z = MovingSignClassifier({"Z": np.array(movements("B", hands.letter_path("Z"), EXAMPLES))})
    b, a = (shown(letter)[3] for letter in "BA")
    assert only_z.may_begin(b.points, is_left=b.is_left)
    assert not only_z.may_begin(a.points, is_left=a.is_left)


def test_without_examples_nothing_is_a_sign() -> None:
    none = MovingSignClassifier({})
    found = movements("B", hands.letter_path("Z"), range(1))
    assert none.predict(found[0]).sign is None
    assert not none.may_begin(shown("B")[0].points, is_left=False)


def test_one_example_will_do() -> None:
    one = np.array(movements("B", hands.letter_path("Z"), range(1)))
    found = read(MovingSignClassifier({"Z": one}), "B", "Z")
    assert found.count("Z") >= 0.5 * len(found)
