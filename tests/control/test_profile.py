import itertools
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.control import s_curve

DT = 1 / 30
SPEED, ACCELERATION, SMOOTHING = 0.6, 1.0, 0.1


def differences(values: list[float] | tuple[float, ...]) -> list[float]:
    return [(b - a) / DT for a, b in itertools.pairwise(values)]


@given(st.floats(-20, 20).filter(lambda d: abs(d) > 1e-6))
def test_profile_keeps_its_limits_and_ends_on_the_goal(distance: float) -> None:
    points = s_curve(distance, SPEED, ACCELERATION, SMOOTHING, DT)
    speeds = [0.0, *differences(points), 0.0]
    accelerations = [0.0, *differences(speeds), 0.0]
    jerks = differences(accelerations)
    assert points[0] == 0.0
    assert points[-1] == distance
    assert max(map(abs, speeds)) <= SPEED * (1 + 1e-6)
    assert max(map(abs, accelerations)) <= ACCELERATION * (1 + 1e-6)
    assert max(map(abs, jerks)) <= 2 * ACCELERATION / SMOOTHING * (1 + 1e-6)


@given(st.floats(1e-6, 20))
def test_profile_never_goes_back(distance: float) -> None:
    points = s_curve(distance, SPEED, ACCELERATION, SMOOTHING, DT)
    assert all(b >= a - 1e-12 for a, b in itertools.pairwise(points))


def test_profile_takes_no_longer_than_its_limits_ask_for() -> None:
    duration = (len(s_curve(1.0, SPEED, ACCELERATION, SMOOTHING, DT)) - 1) * DT
    assert duration == pytest.approx(1.0 / SPEED + SPEED / ACCELERATION + SMOOTHING, abs=DT)


def test_backwards_is_the_mirror_of_forwards() -> None:
    forwards = s_curve(math.pi, 1.5, 4.0, 0.1, DT)
    backwards = s_curve(-math.pi, 1.5, 4.0, 0.1, DT)
    assert backwards == tuple(-p for p in forwards)


def test_no_distance_needs_no_time() -> None:
    assert s_curve(0.0, SPEED, ACCELERATION, SMOOTHING, DT) == (0.0,)
