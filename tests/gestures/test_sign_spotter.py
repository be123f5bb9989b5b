"""Letters at rest and signs that move, in one video: which of them counts."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np
import pytest

from pinel_desktop.gestures.moving.movements import HandObservation
from pinel_desktop.gestures.moving.moving_signs import MovingSignClassifier
from pinel_desktop.gestures.sign_spotter import HOLD_BEFORE_MOVING_SIGN_S, SignSpotter
from pinel_desktop.gestures.stability import Decision, FramePrediction
from pinel_desktop.gestures.training import moving_hands as hands
from tests.camera.moving_hands import movements, observations

Z = hands.letter_path("Z")


@pytest.fixture(scope="module")
def known() -> MovingSignClassifier:
    """Z, signed with the hand of B."""
    return MovingSignClassifier({"Z": np.array(movements("B", Z, range(5)))})


def decided(
    known: MovingSignClassifier, video: Iterable[HandObservation], letter: str | None
) -> Iterator[tuple[float, Decision]]:
    """What is decided while every frame is read as this letter, whatever the hand does; with the time."""
    spotter = SignSpotter()
    spotter.set_moving_signs(known)
    for one in video:
        prediction = FramePrediction(one.time_s, letter, 0.99, "D", one.points)
        if decision := spotter.update(prediction, one.is_left):
            yield one.time_s, decision


def labels(found: Iterable[tuple[float, Decision]]) -> list[str]:
    return [decision.label for _, decision in found]


@pytest.mark.parametrize("seed", range(201, 207))
def test_a_sign_that_moves_is_it_and_no_letter_before_or_after(
    known: MovingSignClassifier, seed: int
) -> None:
    video = observations("B", Z, seed)
    longer = [replace(video[-1], time_s=video[-1].time_s + i / 15) for i in range(1, 31)]
    assert labels(decided(known, video + longer, "B")) == ["Z"]


def test_where_no_sign_moves_the_letter_is_decided_as_ever() -> None:
    (first, decision), *_ = decided(MovingSignClassifier({}), observations("B", Z, 201), "B")
    assert decision.label == "B"
    assert first < 0.5


def test_a_letter_that_may_begin_a_sign_is_held_for_longer_than_another(
    known: MovingSignClassifier,
) -> None:
    times = {}
    for letter in "AB":
        (times[letter], decision), *_ = decided(
            known, observations(letter, hands.still(2.0), 7), letter
        )
        assert decision.label == letter
    assert times["A"] < 0.6
    assert HOLD_BEFORE_MOVING_SIGN_S <= times["B"] < HOLD_BEFORE_MOVING_SIGN_S + 0.4


def test_a_hand_that_moves_for_nothing_is_no_letter_meanwhile(known: MovingSignClassifier) -> None:
    aside = hands.strokes((0.0, -1.0)), 0.8
    found = list(decided(known, observations("A", aside, 3), "A"))
    assert {decision.label for _, decision in found} <= {"A"}
    moving = [time_s for time_s, _ in found if 0.95 < time_s < 1.3]
    assert moving == []


def test_what_follows_a_sign_counts_once_the_hand_has_moved_again(
    known: MovingSignClassifier,
) -> None:
    video = observations("B", Z, 201)
    after = observations("A", hands.still(1.5), 8)
    shifted = [replace(one, time_s=one.time_s + video[-1].time_s + 0.2) for one in after]
    found = [*decided(known, video, "B")]
    assert labels(found) == ["Z"]
    spotter = SignSpotter()
    spotter.set_moving_signs(known)
    spotted = []
    for one, letter in [*((one, "B") for one in video), *((one, "A") for one in shifted)]:
        decision = spotter.update(
            FramePrediction(one.time_s, letter, 0.99, "D", one.points), one.is_left
        )
        spotted += [decision.label] if decision else []
    assert spotted[:2] == ["Z", "A"]
