"""Robots as records: measures and limits in one place, handed to `sim` and to `execution`."""

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class RobotModel:
    """Measures and limits of one kind of robot, in SI units.

    Attributes:
        name: key of the record.
        title: name for people.
        radius_m: radius of the circle that holds the body.
        mass_kg: mass without payload.
        max_force_n: largest force with which the wheels push the body.
        max_torque_nm: largest torque with which the wheels turn the body.
        max_v_mps, max_omega_radps: what the robot can do at most.
        start_v_mps, start_omega_radps: limits of motion commands until a program sets others.
        acceleration_mps2, angular_acceleration_radps2: of planned motions.
        smoothing_s: time over which an acceleration builds up, the S of the S-curve.
    """

    name: str
    title: str
    radius_m: float
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


PIONEER_3DX = RobotModel(
    # Adept MobileRobots, Pioneer 3-DX datasheet: 9 kg, 445 x 393 mm (swing radius 0.26 m with the bumpers),
    # 1.2 m/s, 300 degrees/s. Force and torque let the wheels reach any planned acceleration and stall at a wall.
    name="pioneer_3dx",
    title="Pioneer 3-DX",
    radius_m=0.2225,
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
)
