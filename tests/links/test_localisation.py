"""Which poses of a robot's own localisation count, and how old each is."""

import math

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links.localisation import SIGMA_M, Localisation, LocalisedPose, sigmas_of
from pinel_desktop.links.transport import Localised

NOW_S, ROBOT_S = 100.0, 5000.0


def localised(stamp_s: float | None = ROBOT_S, frame: str = "map", x_m: float = 1.0) -> Localised:
    return Localised(x_m, 2.0, 7.0, None, 0.1, stamp_s, frame)


def newest(*messages: Localised, robot_s: float | None = ROBOT_S) -> LocalisedPose | PinelError:
    it = Localisation("map")
    for message in messages:
        it.add(message, NOW_S, robot_s)
    found = it.pop()
    assert found is not None
    assert it.pop() is None  # once
    return found


def test_a_pose_belongs_to_the_moment_of_its_stamp_by_the_robots_clock() -> None:
    found = newest(localised(ROBOT_S - 0.2))
    assert isinstance(found, LocalisedPose)
    assert found.at_s == pytest.approx(NOW_S - 0.2)
    assert found.pose == pytest.approx((1.0, 2.0, 7.0 - math.tau))
    assert (found.sigma_m, found.sigma_rad) == (SIGMA_M, 0.1)


@pytest.mark.parametrize("stamp_s", [None, ROBOT_S - 1e6, ROBOT_S + 1e6, math.nan])
def test_clocks_that_tell_nothing_make_a_pose_new(stamp_s: float | None) -> None:
    found = newest(localised(stamp_s))
    assert isinstance(found, LocalisedPose)
    assert found.at_s == NOW_S


def test_a_pose_that_comes_after_a_newer_one_is_skipped() -> None:
    found = newest(localised(x_m=1.0), localised(ROBOT_S - 0.1, x_m=9.0))
    assert isinstance(found, LocalisedPose)
    assert found.pose.x_m == 1.0


def test_the_frame_counts_without_a_slash_in_front() -> None:
    assert isinstance(newest(localised(frame="/map")), LocalisedPose)


@pytest.mark.parametrize("frame", ["odom", "", "maps"])
def test_another_frame_is_refused_by_its_name(frame: str) -> None:
    problem = newest(localised(frame=frame))
    assert isinstance(problem, PinelError)
    assert problem.code == "localisation_other_frame"
    assert problem.params == {"found": frame or "?", "wanted": "map"}


@pytest.mark.parametrize("x_m", [math.nan, math.inf, -1e9])
def test_an_impossible_place_is_refused(x_m: float) -> None:
    problem = newest(localised(x_m=x_m))
    assert isinstance(problem, PinelError)
    assert problem.code == "localisation_invalid"


def test_sigmas_are_those_of_the_covariance_where_it_states_any() -> None:
    sigma_m, sigma_rad = sigmas_of((0.04, 0.01, 0.0))
    assert sigma_m == pytest.approx(0.2)
    assert sigma_rad is None
    assert sigmas_of((math.nan, -1.0, math.inf)) == (None, None)
    assert sigmas_of(None) == (None, None)
