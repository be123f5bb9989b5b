"""Robot models: the dimensions and limits that `sim` and `execution` use."""

import math
from dataclasses import dataclass
from typing import Literal

Direction = Literal["front", "left", "right", "back"]


@dataclass(frozen=True, slots=True)
class RobotModel:
    """Dimensions and limits of one robot model, in SI units.

    Attributes:
        name: key of the record.
        title: name for people.
        radius_m: radius of the circle around the body.
        track_m: distance between the middles of the two wheels.
        mass_kg: mass without payload.
        max_force_n: largest force with which the wheels push the body.
        max_torque_nm: largest torque with which the wheels turn the body.
        max_v_mps, max_omega_radps: physical limits.
        start_v_mps, start_omega_radps: limits of motion commands until a program sets others.
        acceleration_mps2, angular_acceleration_radps2: of planned motions.
        smoothing_s: time over which an acceleration builds up, the S of the S-curve.
        sonar_angles_rad: direction of each sonar from the heading, by index; a sonar is on the hull in its direction,
            `radius_m` from the centre.
        sonar_range_m: reading of a sonar with nothing in range.
        distance_sonars: indices of the sonars of each direction, possibly none; their smallest reading is the
            distance in that direction. Ahead and behind it passes over walls beside the robot's way.
        lidar_range_m: reading of the laser scanner, in the robot's centre, with nothing in range; 0 without a scanner.
    """

    name: str
    title: str
    radius_m: float
    track_m: float
    mass_kg: float
    max_force_n: float
    max_torque_nm: float
    max_v_mps: float
    max_omega_radps: float
    start_v_mps: float
    start_omega_radps: float
    acceleration_mps2: float
    angular_acceleration_radps2: float
    smoothing_s: float
    sonar_angles_rad: tuple[float, ...]
    sonar_range_m: float
    distance_sonars: dict[Direction, tuple[int, ...]]
    lidar_range_m: float


# Angles of SonarUnit 0 to 15 in ARIA's parameter file p3dx.p (Adept MobileRobots): eight in front, 0 on the left, and
# eight behind, 8 on the right. ARIA's positions are up to 0.27 m from the centre, because the real hull is longer
# behind; here all sonars are on the simulated hull, a circle.
_PIONEER_SONARS_DEG = (90, 50, 30, 10, -10, -30, -50, -90, -90, -130, -150, -170, 170, 150, 130, 90)

PIONEER_3DX = RobotModel(
    # Adept MobileRobots, Pioneer 3-DX datasheet: 9 kg, 445 x 393 mm (swing radius 0.26 m with the bumpers),
    # 1.2 m/s, 300 degrees/s. The track is rounded from its ROS models. Force and torque let the wheels reach any
    # planned acceleration and stall at a wall.
    name="pioneer_3dx",
    title="Pioneer 3-DX",
    radius_m=0.2225,
    track_m=0.33,
    mass_kg=9.0,
    max_force_n=80.0,
    max_torque_nm=25.0,
    max_v_mps=1.2,
    max_omega_radps=math.radians(300.0),
    start_v_mps=0.6,
    start_omega_radps=math.radians(90.0),
    acceleration_mps2=1.0,
    angular_acceleration_radps2=4.0,
    smoothing_s=0.1,
    sonar_angles_rad=tuple(math.radians(angle) for angle in _PIONEER_SONARS_DEG),
    # Pioneer 3 Operations Manual: sensitivity from 10 cm to 5 m
    sonar_range_m=5.0,
    # a quarter of the ring each, which covers everything that the hull could hit
    distance_sonars={
        "front": (2, 3, 4, 5),
        "left": (14, 15, 0, 1),
        "right": (6, 7, 8, 9),
        "back": (10, 11, 12, 13),
    },
    # SICK LMS 200 technical description: 8 m at a resolution of 1 mm; ARIA mounts it 2 cm from the centre
    lidar_range_m=8.0,
)

SMALL_ROBOT = RobotModel(
    # Not a product: chosen as a robot that a class can build on a round base of 16 cm with two gear motors and three
    # HC-SR04 sonars, 45 degrees apart, with a range of 4 m by their datasheet.
    name="small_robot",
    title="Mini 16",
    radius_m=0.08,
    track_m=0.13,
    mass_kg=0.8,
    max_force_n=6.0,
    max_torque_nm=0.25,
    max_v_mps=0.5,
    max_omega_radps=math.radians(360.0),
    start_v_mps=0.3,
    start_omega_radps=math.radians(120.0),
    acceleration_mps2=0.8,
    angular_acceleration_radps2=8.0,
    smoothing_s=0.1,
    sonar_angles_rad=tuple(math.radians(angle) for angle in (45, 0, -45)),
    sonar_range_m=4.0,
    distance_sonars={"front": (1,), "left": (0,), "right": (2,), "back": ()},
    lidar_range_m=0.0,
)

ROBOTS = {robot.name: robot for robot in (PIONEER_3DX, SMALL_ROBOT)}
