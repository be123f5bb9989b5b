"""Crops follow a hand wherever it is, however large, and whichever way it points."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.gestures.regions import Region, around_hand, around_palm

POINTS = np.random.default_rng(5).normal(size=(21, 2)) * 40 + [300, 200]


def turned(points: np.ndarray, angle: float) -> np.ndarray:
    """Clockwise in a picture, whose y goes downwards."""
    cos, sin = math.cos(angle), math.sin(angle)
    moved: np.ndarray = points @ np.array([[cos, sin], [-sin, cos]])
    return moved


@given(st.floats(0.1, 10), st.floats(-3, 3), st.floats(-500, 500))
def test_the_crop_of_a_hand_moves_turns_and_grows_with_it(
    scale: float, angle: float, shift: float
) -> None:
    before = around_hand(POINTS)
    after = around_hand(turned(POINTS, angle) * scale + shift)
    middle = turned(np.array([before.x, before.y]), angle) * scale + shift
    assert (after.x, after.y) == pytest.approx(tuple(middle), abs=1e-6 * max(1, scale) * 1000)
    assert after.side == pytest.approx(before.side * scale)
    assert math.remainder(after.angle_rad - before.angle_rad - angle, 2 * math.pi) == pytest.approx(
        0, abs=1e-9
    )


def test_the_crop_of_an_upright_palm_reaches_above_it() -> None:
    region = around_palm(np.array([100, 200]), np.array([100, 100]), np.array([100, 150, 80, 80]))
    assert region == Region(100, 110, 208, 0)


def test_the_middle_of_a_crop_is_the_middle_of_its_region_mirrored_or_not() -> None:
    region = Region(320, 240, 100, 0.3)
    for mirrored in (False, True):
        to_picture = region.to_picture(224, mirrored=mirrored)
        assert to_picture @ [112, 112, 1] == pytest.approx([320, 240])


def test_mirroring_swaps_left_and_right_of_a_crop() -> None:
    region = Region(320, 240, 224, 0)
    assert region.to_picture(224, mirrored=False) @ [0, 0, 1] == pytest.approx([208, 128])
    assert region.to_picture(224, mirrored=True) @ [0, 0, 1] == pytest.approx([432, 128])
