"""Movements are cut out of a video from rest to rest, and brought to one form."""

import numpy as np
import pytest
from numpy.typing import NDArray

from pinel_desktop.gestures.moving.movements import (
    MAX_DURATION_S,
    N_FRAMES,
    N_NUMBERS,
    PATH,
    SHAPE,
    TIME,
    HandObservation,
    Movement,
    MovementSegmenter,
    movement,
    shape,
)

HAND = np.random.default_rng(1).uniform(-50, 50, (21, 2))
SIZE = float(np.ptp(HAND, axis=0).max())


def video(
    *phases: tuple[float, float], size: float = 1.0, rate_hz: float = 15.0, is_left: bool = False
) -> list[HandObservation]:
    """A hand that goes to the side: phases of (seconds, hand sizes a second)."""
    observations, x, time_s = [], 0.0, 0.0
    for lasts_s, speed in phases:
        for _ in range(round(lasts_s * rate_hz)):
            time_s += 1 / rate_hz
            x += speed * SIZE / rate_hz
            points = (HAND + np.array([x, 0.0])) * size
            points[:, 0] *= -1 if is_left else 1
            observations.append(HandObservation(time_s, (points + 300).astype(np.float32), is_left))
    return observations


def cut(observations: list[HandObservation]) -> list[Movement]:
    segmenter = MovementSegmenter()
    return [found for one in observations if (found := segmenter.update(one)) is not None]


MOVED = ((0.6, 0.0), (0.8, 2.0), (0.6, 0.0))


def test_a_movement_from_rest_to_rest_is_one() -> None:
    (found,) = cut(video(*MOVED))
    assert found.shape == (N_FRAMES, N_NUMBERS)
    assert found[-1, TIME] == pytest.approx(1.2, abs=0.1)  # with a moment of rest at both ends
    assert np.isfinite(found.astype(np.float16)).all()


@pytest.mark.parametrize(
    "other",
    [
        {"size": 2.5},
        {"rate_hz": 30.0},
        {"is_left": True},
    ],
)
def test_size_rate_and_chirality_change_little(other: dict[str, float]) -> None:
    (one,), (same,) = cut(video(*MOVED)), cut(video(*MOVED, **other))  # type: ignore[arg-type]
    assert same[:, SHAPE] == pytest.approx(one[:, SHAPE], abs=0.02)
    assert same[-1, PATH] == pytest.approx(one[-1, PATH], abs=0.35)


@pytest.mark.parametrize(
    "phases",
    [
        ((3.0, 0.0),),
        ((1.0, 0.3), (1.0, 0.0)),  # it drifts
        ((0.6, 0.0), (0.8, 2.0)),  # it goes on
        ((0.6, 0.0), (MAX_DURATION_S + 1, 2.0), (0.6, 0.0)),
    ],
)
def test_what_does_not_move_from_rest_to_rest_is_none(phases: tuple[tuple[float, float]]) -> None:
    assert cut(video(*phases)) == []


def test_a_pause_as_at_the_corners_of_a_z_does_not_end_it() -> None:
    corners = (
        (0.6, 0.0),
        (0.5, 2.0),
        (0.13, 0.0),
        (0.5, -2.0),
        (0.13, 0.0),
        (0.5, 2.0),
        (0.6, 0.0),
    )
    assert len(cut(video(*corners))) == 1


def test_a_hand_that_was_away_begins_anew() -> None:
    observations = video(*MOVED)
    without = [one for one in observations if not 0.9 < one.time_s < 1.25]
    assert [found[-1, TIME] for found in cut(without)] == []


def test_a_hand_at_rest_has_the_shape_of_a_movement_s_frames() -> None:
    observations = video(*MOVED, is_left=True)
    rest_shape: NDArray[np.float64] = shape(observations[0].points, is_left=True)
    assert movement(observations)[0, SHAPE] == pytest.approx(rest_shape, abs=1e-3)
