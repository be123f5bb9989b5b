"""The robot models: complete, and able to drive their planned motions."""

import math

import pytest

from pinel_desktop.robot import PIONEER_3DX, ROBOTS, SMALL_ROBOT, RobotModel

robots = pytest.mark.parametrize("robot", ROBOTS.values(), ids=ROBOTS)


def test_records_are_kept_by_their_names_and_the_pioneer_is_first() -> None:
    assert list(ROBOTS) == [robot.name for robot in ROBOTS.values()]
    assert next(iter(ROBOTS)) == PIONEER_3DX.name


@robots
def test_motors_reach_the_planned_accelerations_with_room_to_spare(robot: RobotModel) -> None:
    inertia = 0.5 * robot.mass_kg * robot.radius_m**2
    assert robot.max_force_n > 2 * robot.mass_kg * robot.acceleration_mps2
    assert robot.max_torque_nm > 2 * inertia * robot.angular_acceleration_radps2


@robots
def test_usual_speeds_are_within_the_greatest(robot: RobotModel) -> None:
    assert 0 < robot.start_v_mps <= robot.max_v_mps
    assert 0 < robot.start_omega_radps <= robot.max_omega_radps


@robots
def test_wheels_are_under_the_body(robot: RobotModel) -> None:
    assert robot.radius_m < robot.track_m < 2 * robot.radius_m


@robots
def test_each_direction_has_the_sonars_that_look_there(robot: RobotModel) -> None:
    n_sonars = len(robot.sonars)
    towards = {"front": 0.0, "left": 90.0, "right": -90.0, "back": 180.0}
    assert set(robot.distance_sonars) == set(towards)
    for direction, indices in robot.distance_sonars.items():
        for index in indices:
            assert 0 <= index < n_sonars
            off = robot.sonars[index].angle_rad - math.radians(towards[direction])
            assert abs(math.remainder(off, math.tau)) <= math.radians(46)


def test_small_robot_has_three_sonars_none_behind_and_no_scanner() -> None:
    assert len(SMALL_ROBOT.sonars) == 3
    assert SMALL_ROBOT.distance_sonars["back"] == ()
    assert SMALL_ROBOT.lidar_range_m == 0.0
