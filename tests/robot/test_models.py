"""The robot models: complete, and able to drive their planned motions."""

import math

import pytest

from pinel_desktop.robot import PIONEER_3DX, ROBOTS, SMALL_ROBOT, RobotModel, Sonar
from sim.simulator import SUBSTEPS

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
def test_wheels_reach_a_planned_velocity_within_a_substep(robot: RobotModel) -> None:
    inertia = 0.5 * robot.mass_kg * robot.radius_m**2
    assert robot.max_force_n >= SUBSTEPS * robot.mass_kg * robot.acceleration_mps2
    assert robot.max_torque_nm >= SUBSTEPS * inertia * robot.angular_acceleration_radps2


@robots
def test_hull_is_a_ring_of_corners_around_the_centre(robot: RobotModel) -> None:
    ring = zip(robot.hull_m, robot.hull_m[1:] + robot.hull_m[:1], strict=True)
    assert all(ax * by - ay * bx > 0 for (ax, ay), (bx, by) in ring)  # counterclockwise
    assert all(math.hypot(x, y) < 1.3 * robot.radius_m for x, y in robot.hull_m)


@robots
def test_the_line_of_a_sonar_leads_through_its_place(robot: RobotModel) -> None:
    for sonar in robot.sonars:
        (x, y), along = sonar.ray
        assert (x, y, along) == (0.0, 0.0, robot.radius_m)  # all are on the simulated hull


def test_a_sonar_beside_the_centre_looks_from_beside_it() -> None:
    start, along = Sonar(0.1, 0.05, math.pi / 2).ray
    assert (start, along) == ((0.1, 0.0), 0.05)


@robots
def test_what_a_robot_lacks_is_what_its_record_does_not_have(robot: RobotModel) -> None:
    assert robot.lacks("sonar") == (not robot.sonars)
    assert robot.lacks("sonar", len(robot.sonars))
    assert robot.lacks("lidar", 0) == (robot.laser is None)
    assert robot.lacks("bumper") != robot.has_bumper
    assert robot.lacks("distance", "back") == (not robot.distance_sonars["back"])
    assert not robot.lacks("heading")


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


def test_turtlebot_has_a_scanner_all_around_and_neither_sonars_nor_bumper() -> None:
    burger = ROBOTS["turtlebot3_burger"]
    assert (burger.max_v_mps, burger.max_omega_radps, burger.track_m) == (0.22, 2.84, 0.16)
    assert not burger.lacks("lidar", 180)
    assert all(burger.lacks(sensor) for sensor in ("sonar", "distance", "bumper"))
    assert burger.laser is not None
    assert (burger.laser.min_m, burger.laser.range_m) == (0.12, 3.5)
