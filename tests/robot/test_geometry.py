import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.robot import Pose2D, wrap_angle

angles = st.floats(-50, 50)
metres = st.floats(-100, 100)
poses = st.builds(Pose2D, metres, metres, st.floats(-math.pi, math.pi, exclude_min=True))


@given(angles)
def test_wrapped_angle_is_the_same_direction_in_the_half_open_range(angle: float) -> None:
    wrapped = wrap_angle(angle)
    assert -math.pi < wrapped <= math.pi
    assert math.isclose(math.cos(wrapped), math.cos(angle), abs_tol=1e-12)
    assert math.isclose(math.sin(wrapped), math.sin(angle), abs_tol=1e-12)


def test_half_a_turn_is_plus_pi_from_either_side() -> None:
    assert wrap_angle(-math.pi) == wrap_angle(math.pi) == math.pi


@given(poses, poses)
def test_compose_undoes_relative_to(origin: Pose2D, pose: Pose2D) -> None:
    back = origin.compose(pose.relative_to(origin))
    assert back.x_m == pytest.approx(pose.x_m, abs=1e-9)
    assert back.y_m == pytest.approx(pose.y_m, abs=1e-9)
    assert wrap_angle(back.yaw_rad - pose.yaw_rad) == pytest.approx(0, abs=1e-9)


def test_relative_pose_looks_from_the_origin() -> None:
    origin = Pose2D(1.0, 1.0, math.pi / 2)
    ahead = Pose2D(1.0, 3.0, math.pi / 2).relative_to(origin)
    assert ahead == pytest.approx(Pose2D(2.0, 0.0, 0.0))
