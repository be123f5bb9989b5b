"""Which runs are parts of the offered pattern."""

import math

from pinel_desktop.calibration.pattern import shape_of

_SQUARE = [(0.0, 0.0), (1.2, 0.0), (1.2, 1.2), (0.0, 1.2), (0.0, 0.01)]


def test_squares_and_lines_are_recognised_by_their_path() -> None:
    assert shape_of(_SQUARE) == "left"
    assert shape_of([(x, -y) for x, y in _SQUARE]) == "right"
    assert shape_of([(0.0, 0.0), (1.0, 0.01), (2.0, 0.0)]) == "line"


def test_other_runs_are_none() -> None:
    circle = [(math.sin(i / 10), 1 - math.cos(i / 10)) for i in range(63)]
    thin = [(0.0, 0.0), (2.0, 0.0), (2.0, 0.4), (0.0, 0.4), (0.0, 0.0)]
    corner = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]
    for other in ([], [(0.0, 0.0)], circle, thin, corner, [(0.0, 0.0), (0.3, 0.0)], _SQUARE[:4]):
        assert shape_of(other) is None
