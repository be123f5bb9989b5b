"""Letters at rest and signs that move, in one video: which of them counts."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np
import pytest

from pinel_desktop.gestures.movements import Glimpse
from pinel_desktop.gestures.moving_signs import MovingSigns
from pinel_desktop.gestures.sign_watch import HELD_S, SignWatch
from pinel_desktop.gestures.training import moving_hands as hands
from pinel_desktop.gestures.vote import Ballot, Decision
from tests.camera.moving_hands import glimpses, movements

Z = hands.letter_path("Z")


@pytest.fixture(scope="module")
def known() -> MovingSigns:
    """Z, signed with the hand of B."""
    return MovingSigns({"Z": np.array(movements("B", Z, range(5)))})


def decided(
    known: MovingSigns, video: Iterable[Glimpse], letter: str | None
) -> Iterator[tuple[float, Decision]]:
    """What is decided while every frame is read as this letter, whatever the hand does; with the time."""
    watch = SignWatch()
    watch.know(known)
    for one in video:
        ballot = Ballot(one.time_s, letter, 0.99, "D", one.points)
        if decision := watch.see(ballot, one.is_left):
            yield one.time_s, decision


def labels(found: Iterable[tuple[float, Decision]]) -> list[str]:
    return [decision.label for _, decision in found]


@pytest.mark.parametrize("seed", range(201, 207))
def test_a_sign_that_moves_is_it_and_no_letter_before_or_after(
    known: MovingSigns, seed: int
) -> None:
    video = glimpses("B", Z, seed)
    longer = [replace(video[-1], time_s=video[-1].time_s + i / 15) for i in range(1, 31)]
    assert labels(decided(known, video + longer, "B")) == ["Z"]


def test_where_no_sign_moves_the_letter_is_decided_as_ever() -> None:
    (first, decision), *_ = decided(MovingSigns({}), glimpses("B", Z, 201), "B")
    assert decision.label == "B"
    assert first < 0.5


def test_a_letter_that_may_begin_a_sign_is_held_for_longer_than_another(
    known: MovingSigns,
) -> None:
    times = {}
    for letter in "AB":
        (times[letter], decision), *_ = decided(
            known, glimpses(letter, hands.still(2.0), 7), letter
        )
        assert decision.label == letter
    assert times["A"] < 0.6
    assert HELD_S <= times["B"] < HELD_S + 0.4


def test_a_hand_that_moves_for_nothing_is_no_letter_meanwhile(known: MovingSigns) -> None:
    aside = hands.strokes((0.0, -1.0)), 0.8
    found = list(decided(known, glimpses("A", aside, 3), "A"))
    assert {decision.label for _, decision in found} <= {"A"}
    moving = [time_s for time_s, _ in found if 0.95 < time_s < 1.3]
    assert moving == []


def test_what_follows_a_sign_counts_once_the_hand_has_moved_again(known: MovingSigns) -> None:
    video = glimpses("B", Z, 201)
    after = glimpses("A", hands.still(1.5), 8)
    later = [replace(one, time_s=one.time_s + video[-1].time_s + 0.2) for one in after]
    found = [*decided(known, video, "B")]
    assert labels(found) == ["Z"]
    watch = SignWatch()
    watch.know(known)
    said = []
    for one, letter in [*((one, "B") for one in video), *((one, "A") for one in later)]:
        decision = watch.see(Ballot(one.time_s, letter, 0.99, "D", one.points), one.is_left)
        said += [decision.label] if decision else []
    assert said[:2] == ["Z", "A"]
