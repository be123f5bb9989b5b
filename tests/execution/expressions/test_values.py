"""How values are display_text and compared, beyond what expressions in tests reach."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.execution.expressions.values import (
    display_text,
    from_answer,
    number_text,
    plain,
    same,
)


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (3.0, "3"),
        (-0.0, "0"),
        (0.5, "0.5"),
        (-2.25, "-2.25"),
        (0.1 + 0.2, "0.3"),
        (1 / 3, "0.333333333333"),
        (200 / 3, "66.6666666667"),
        (1e-6, "0.000001"),
        (1.5e-5, "0.000015"),
        (1e-7, "1e-07"),
        (123456.789, "123456.789"),
        (1234567890123.5, "1234567890123.5"),
        (2.0**52, "4503599627370496"),
        (1e20, "1e+20"),
    ],
)
def test_numbers_are_shown_as_pupils_write_them(number: float, text: str) -> None:
    assert number_text(number) == text


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_shown_number_is_the_number_and_has_no_trailing_zeros(number: float) -> None:
    text = number_text(number)
    assert math.isclose(float(text), number, rel_tol=1e-11, abs_tol=1e-320)
    if "e" not in text and "." in text:
        assert text[-1] not in "0."
    if 1e-6 <= abs(number) < 2**53:
        assert "e" not in text


@given(st.floats(-1e6, 1e6))
def test_what_is_shown_reads_as_the_same_number(number: float) -> None:
    read = from_answer(number_text(number))
    if abs(number) >= 1e-6:
        assert read == pytest.approx(number, rel=1e-11)


def test_booleans_are_shown_as_words_and_lists_with_commas() -> None:
    assert display_text(True, "say") == "true"
    assert display_text([1.0, "a", False], "say") == "1, a, false"


def test_equality_looks_at_types_inside_lists_too() -> None:
    assert same([1.0, "a"], [1.0, "a"])
    assert not same([1.0], [True])
    assert not same([], "")
    assert not same(1.0, True)


def test_plain_values_are_json_without_points_behind_whole_numbers() -> None:
    value = plain([3.0, 0.5, "a", True, 1e300])
    assert value == [3, 0.5, "a", True, 1e300]
    assert [type(item) for item in value] == [int, float, str, bool, float]
