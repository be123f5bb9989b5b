import math

import pytest

from pinel_desktop.control import (
    ArcTracker,
    Gains,
    GoalCheck,
    LineTracker,
    ProgressCheck,
    Trim,
    hold_position,
)
from pinel_desktop.robot import STANDSTILL, Pose2D, Twist2D


def test_robot_on_its_set_point_gets_the_feedforward_only() -> None:
    twist = LineTracker(Pose2D()).correct(Pose2D(0.4, 0, 0), 0.0, 0.5)
    assert twist == (0.5, 0.0)


def test_robot_left_of_the_line_is_steered_right_and_behind_is_sped_up() -> None:
    twist = LineTracker(Pose2D()).correct(Pose2D(0.4, 0.05, 0), 0.02, 0.5)
    assert twist.v_mps > 0.5
    assert twist.omega_radps < 0


def test_backing_robot_left_of_the_line_is_steered_so_that_it_comes_back() -> None:
    # backwards, a heading to the left takes the tail to the right
    twist = LineTracker(Pose2D()).correct(Pose2D(-0.4, 0.05, 0), 0.0, -0.5)
    assert twist.omega_radps > 0


def test_error_across_the_end_of_the_circle_is_small() -> None:
    line = LineTracker(Pose2D(0, 0, math.pi))
    twist = line.correct(Pose2D(0, 0, -math.pi + 0.01), 0.0, 0.0)
    assert abs(twist.omega_radps) < 0.1


def test_fine_tolerance_first_then_a_near_one_and_the_coarse_one_last() -> None:
    goal = GoalCheck(fine=0.001, near=0.004, coarse=0.01, settle_ticks=10)
    assert not goal.is_reached(0.003, STANDSTILL, ticks_past_end=10)
    assert goal.is_reached(0.003, STANDSTILL, ticks_past_end=11)
    assert not goal.is_reached(0.005, STANDSTILL, ticks_past_end=20)
    assert goal.is_reached(0.005, STANDSTILL, ticks_past_end=21)
    assert not goal.is_reached(0.02, STANDSTILL, ticks_past_end=1000)


def test_robot_that_still_drives_has_not_arrived_and_one_that_trembles_has_after_patience() -> None:
    goal, trembling = GoalCheck(fine=0.01, near=0.01, coarse=0.01), Twist2D(0.005, 0.01)
    assert not goal.is_reached(0.0, trembling, ticks_past_end=1)
    assert goal.is_reached(0.0, trembling, ticks_past_end=16)
    assert not goal.is_reached(0.0, Twist2D(0.1, 0.0), ticks_past_end=100)


def test_trim_learns_from_the_way_beside_the_line_and_turns_against_it() -> None:
    gains, trim = Gains(integral=10.0), Trim()
    left_of_it = Pose2D(0.4, 0.01, 0)
    line = LineTracker(Pose2D(), gains, trim)
    first = line.correct(left_of_it, 0.0, 0.5).omega_radps
    final = [line.correct(left_of_it, 0.0, 0.5).omega_radps for _ in range(20)][-1]
    assert final < first < 0.0
    per_m_before = trim.per_m
    line.correct(left_of_it, 0.0, 0.0)
    assert trim.per_m == per_m_before


def test_trim_is_bounded_and_learns_nothing_far_from_the_line() -> None:
    gains, trim = Gains(integral=10.0), Trim()
    for _ in range(1000):
        LineTracker(Pose2D(), gains, trim).correct(Pose2D(0.4, 0.5, 0), 0.0, 0.5)
    assert trim.per_m == 0.0
    for _ in range(10_000):
        LineTracker(Pose2D(), gains, trim).correct(Pose2D(0.4, 0.015, 0), 0.0, 0.5)
    assert -0.1 < trim.per_m < 0.0


@pytest.mark.parametrize("yaw", [0.0, math.pi / 2, math.pi])
def test_robot_that_turns_on_the_spot_drives_towards_the_spot_when_it_is_ahead(yaw: float) -> None:
    start = Pose2D(1.0, 1.0, 0.0)
    behind = Pose2D(1.0 - 0.002 * math.cos(yaw), 1.0 - 0.002 * math.sin(yaw), yaw)
    assert hold_position(start, behind, Gains()) == pytest.approx(0.008)


def test_robot_that_was_pushed_off_its_spot_only_creeps_back_and_may_arrive() -> None:
    creeping = Twist2D(hold_position(Pose2D(1.0, 0.0, 0.0), Pose2D(), Gains()), 0.0)
    assert creeping.v_mps > 0.0
    assert GoalCheck(fine=0.01, near=0.01, coarse=0.01).is_reached(0.0, creeping, ticks_past_end=16)


def test_progress_counts_in_either_direction_and_stuck_is_only_after_patience() -> None:
    check = ProgressCheck(step=0.01, timeout_ticks=60)
    assert not check.stuck(0.0, tick=1)
    assert not check.stuck(-0.02, tick=50)
    assert not check.stuck(-0.025, tick=109)
    assert check.stuck(-0.025, tick=110)


@pytest.mark.parametrize(
    ("radius", "angle", "end"),
    [
        (2, math.pi / 2, (2, 2, math.pi / 2)),
        (2, -math.pi / 2, (2, -2, -math.pi / 2)),
        (-2, math.pi / 2, (-2, -2, math.pi / 2)),
        (-2, -math.pi / 2, (-2, 2, -math.pi / 2)),
        (0, 1, (0, 0, 1)),
    ],
)
def test_arc_ends_left_for_positive_angles_and_behind_for_negative_radii(
    radius: float, angle: float, end: tuple[float, float, float]
) -> None:
    assert ArcTracker(Pose2D(), radius, angle).point(angle) == pytest.approx(end)


def test_robot_on_the_arc_gets_the_feedforward_of_both_velocities() -> None:
    arc = ArcTracker(Pose2D(), -0.5, 2.0)
    twist = arc.correct(arc.point(0.7), 0.7, 0.8)
    assert twist == pytest.approx((-0.4, 0.8))


def test_robot_beside_the_arc_is_steered_back_to_it() -> None:
    arc = ArcTracker(Pose2D(), 1.0, 2.0)
    inside = Pose2D(0.0, 0.05, 0.0)
    assert arc.correct(inside, 0.0, 0.5).omega_radps < 0.5
    behind = Pose2D(-0.02, 0.0, 0.0)
    assert arc.correct(behind, 0.0, 0.5).v_mps > 0.5


@pytest.mark.parametrize("radius", [0.01, 0.5, -3.0])
def test_arc_counts_its_way_beyond_a_full_circle(radius: float) -> None:
    arc = ArcTracker(Pose2D(1.0, 2.0, 0.5), radius, 10.0)
    done = [arc.done(arc.point(i / 10)) for i in range(101)]
    assert done[-1] == pytest.approx(10.0)
    assert arc.errors(arc.point(10.0), 10.0) == pytest.approx((0, 0, 0))
