"""Shares and their intervals, against figures worked out elsewhere."""

import math

import numpy as np
import pytest

from pinel_desktop.gestures.training.accuracy_metrics import (
    Proportion,
    calibration_error,
    proportions_by,
)


@pytest.mark.parametrize(
    ("n", "of", "low", "high"),
    [  # Newcombe, Statistics in Medicine 17 (1998), table I, method 3
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_intervals_are_those_of_wilson(n: int, of: int, low: float, high: float) -> None:
    assert Proportion(n, of).interval == pytest.approx((low, high), abs=5e-5)


def test_a_share_of_nothing_is_unknown() -> None:
    assert math.isnan(Proportion(0, 0).value)
    assert Proportion(0, 0).as_object() == {"share": None, "low": 0.0, "high": 1.0, "n": 0, "of": 0}


def test_shares_are_counted_by_group() -> None:
    found = proportions_by(["b", "a", "b"], np.array([True, False, False]))
    assert found == {"a": Proportion(0, 1), "b": Proportion(1, 2)}


def test_a_confidence_that_keeps_its_promise_has_no_error() -> None:
    confidence = np.repeat([0.25, 0.75], 100)
    right = np.concatenate([np.arange(100) < 25, np.arange(100) < 75])
    assert calibration_error(confidence, right) == pytest.approx(0)


def test_a_boaster_is_found_out() -> None:
    assert calibration_error(np.full(100, 0.95), np.arange(100) < 50) == pytest.approx(0.45)
