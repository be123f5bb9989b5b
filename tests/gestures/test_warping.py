"""Dynamic time warping, held against its definition."""

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from pinel_desktop.gestures.moving.warping import dtw_distances


def by_definition(one: NDArray[np.float64], other: NDArray[np.float64], band: int) -> float:
    """Over all ways through the table: a diagonal step costs twice, the sum is divided by both lengths."""

    @cache
    def best(i: int, j: int) -> float:
        if i < 0 or j < 0 or abs(i - j) > band:
            return float("inf")
        cost = float(np.linalg.norm(one[i] - other[j]))
        if i == j == 0:
            return 2 * cost
        return min(best(i - 1, j - 1) + 2 * cost, best(i - 1, j) + cost, best(i, j - 1) + cost)

    return best(len(one) - 1, len(other) - 1) / (2 * len(one))


@pytest.mark.parametrize("band", [1, 4, 12])
def test_it_is_the_cheapest_way_within_the_band(band: int) -> None:
    chance = np.random.default_rng(band)
    one, others = chance.normal(size=(12, 3)), chance.normal(size=(5, 12, 3))
    expected = [by_definition(one, other, band) for other in others]
    assert dtw_distances(one, others, band) == pytest.approx(expected)


def test_another_pace_hardly_counts() -> None:
    even, late = np.linspace(0, 1, 38), np.linspace(0, 1, 38) ** 1.3
    path, slower = (np.stack([np.sin(6 * at), at], axis=1) for at in (even, late))
    warped, straight = (
        dtw_distances(path, slower[None])[0],
        np.linalg.norm(path - slower, axis=1).mean(),
    )
    assert warped < 0.25 * straight
    assert dtw_distances(path, path[None]) == pytest.approx([0.0])
