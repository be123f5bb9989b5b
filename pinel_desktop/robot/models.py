"""Robot models: hull, wheels, sensors and limits of each robot. The page draws them; `sim` and `execution` use them."""

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple

Direction = Literal["front", "left", "right", "back"]
# m in the robot's frame: x ahead, y to the left; origin is the point about which the robot turns
Point = tuple[float, float]

_PLACES = 9  # decimal places of a metre; removes rounding errors of sums of products


class Wheel(NamedTuple):
    """A driven wheel: its centre in the robot's frame, and its size, in m."""

    x_m: float
    y_m: float
    radius_m: float
    width_m: float


class Sonar(NamedTuple):
    """A sonar: its position in the robot's frame (m) and its direction from the heading (rad)."""

    x_m: float
    y_m: float
    angle_rad: float

    @property
    def ray(self) -> tuple[Point, float]:
        """Start of the sonar's ray in the robot's frame (m), and distance (m) from the start to the sonar.

        The start is the point of the sonar's line nearest to the robot's centre. A ray from the sonar itself could
        start inside a wall that the hull touches; a ray from that point cannot.
        """
        cos, sin = math.cos(self.angle_rad), math.sin(self.angle_rad)
        along = round(self.x_m * cos + self.y_m * sin, _PLACES)
        start = (round(self.x_m - along * cos, _PLACES), round(self.y_m - along * sin, _PLACES))
        return start, along


class Laser(NamedTuple):
    """A laser scanner: its field, its range, and its position in the robot's frame.

    Attributes:
        field_deg: width of the field of view, half of it to each side of the heading.
        range_m: maximum range; the reading without an obstacle in range.
        min_m: minimum range; the reading of every nearer obstacle.
        x_m, y_m: position of the scanner.
    """

    field_deg: int
    range_m: float
    min_m: float = 0.0
    x_m: float = 0.0
    y_m: float = 0.0

    @property
    def angles_rad(self) -> tuple[float, ...]:
        """Directions of a whole scan from the heading, from right to left, one per degree."""
        half = self.field_deg // 2
        return tuple(math.radians(angle) for angle in range(-half, half + 1))


@dataclass(frozen=True, slots=True)
class RobotModel:
    """One robot model, in SI units.

    Attributes:
        name: key of the model in ROBOTS.
        title: name for people.
        radius_m: radius of the circle around the body; the simulated hull.
        hull_m: corners of the outline seen from above, counterclockwise; for drawing.
        hull_round_m: length along its sides by which a corner of the drawing is rounded.
        wheels: the driven wheels, the left one first.
        mass_kg: mass without payload.
        max_force_n: maximum force with which the wheels push the body.
        max_torque_nm: maximum torque with which the wheels turn the body.
        max_v_mps, max_omega_radps: physical limits.
        start_v_mps, start_omega_radps: limits of motion commands until a program sets others.
        acceleration_mps2, angular_acceleration_radps2: accelerations of planned motions.
        smoothing_s: time over which an acceleration builds up, the S of the S-curve.
        sonars: the sonars by index.
        sonar_range_m: maximum range of a sonar; the reading without an obstacle in range.
        distance_sonars: indices of the sonars of each direction, possibly none. The distance in a direction is their
            smallest reading; the distances `front` and `back` ignore walls beside the robot's path.
        laser: the laser scanner; None without one.
        has_bumper: whether the robot has a bumper sensor.
    """

    name: str
    title: str
    radius_m: float
    hull_m: tuple[Point, ...]
    hull_round_m: float
    wheels: tuple[Wheel, Wheel]
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
    sonars: tuple[Sonar, ...]
    sonar_range_m: float
    distance_sonars: dict[Direction, tuple[int, ...]]
    laser: Laser | None
    has_bumper: bool

    @property
    def track_m(self) -> float:
        """Distance between the centres of the two wheels."""
        left, right = self.wheels
        return left.y_m - right.y_m

    @property
    def lidar_range_m(self) -> float:
        """Range of the laser scanner; 0 without one."""
        return self.laser.range_m if self.laser else 0.0

    def lacks(self, sensor: str, asked: object = None) -> bool:
        """Returns whether the model lacks a sensor of the language.

        Args:
            sensor: name of the sensor.
            asked: direction or index that the program passes to the sensor; None if only the run computes it.
        """
        if sensor == "distance":
            return not any(self.distance_sonars.get(one) for one in _directions(asked))
        if sensor == "sonar":
            return (asked if isinstance(asked, int | float) else 0) >= len(self.sonars)
        return (sensor == "lidar" and not self.laser) or (
            sensor == "bumper" and not self.has_bumper
        )


def _directions(asked: object) -> tuple[Direction, ...]:
    every: tuple[Direction, ...] = ("front", "left", "right", "back")
    return tuple(one for one in every if asked in (one, None))


def _both_sides(*left: Point) -> tuple[Point, ...]:
    """Returns the corners of a symmetric hull from its corners on the left, from front to back."""
    return (*left, *((x, -y) for x, y in reversed(left)))


def _on_the_hull(radius_m: float, *angles_deg: int) -> tuple[Sonar, ...]:
    angles = [math.radians(angle) for angle in angles_deg]
    return tuple(Sonar(radius_m * math.cos(a), radius_m * math.sin(a), a) for a in angles)


def _wheels(x_m: float, y_m: float, radius_m: float, width_m: float) -> tuple[Wheel, Wheel]:
    return Wheel(x_m, y_m, radius_m, width_m), Wheel(x_m, -y_m, radius_m, width_m)


PIONEER_3DX = RobotModel(
    # Adept MobileRobots, Pioneer 3-DX datasheet: 9 kg, 455 x 381 mm (swing radius 0.26 m with the bumpers), wheels of
    # 195 mm, 1.2 m/s, 300 degrees/s. The track is rounded from its ROS models. Force and torque let the wheels reach
    # any planned acceleration and stall at a wall.
    name="pioneer_3dx",
    title="Pioneer 3-DX",
    radius_m=0.2225,
    hull_m=_both_sides((0.2275, 0.065), (0.15, 0.1605), (-0.2275, 0.1605)),
    hull_round_m=0.07,
    wheels=_wheels(0.03, 0.165, 0.0975, 0.05),
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
    # Angles of SonarUnit 0 to 15 in ARIA's parameter file p3dx.p: eight in front, number 0 on the
    # left, and eight behind, number 8 on the right. ARIA's positions are up to 0.27 m from the
    # centre, because the real hull is longer behind. Here all sonars are on the simulated hull, a
    # circle.
    sonars=_on_the_hull(
        0.2225, 90, 50, 30, 10, -10, -30, -50, -90, -90, -130, -150, -170, 170, 150, 130, 90
    ),
    # Pioneer 3 Operations Manual: sensitivity from 10 cm to 5 m
    sonar_range_m=5.0,
    # Each direction has a quarter of the ring. Together they cover all that the hull can hit.
    distance_sonars={
        "front": (2, 3, 4, 5),
        "left": (14, 15, 0, 1),
        "right": (6, 7, 8, 9),
        "back": (10, 11, 12, 13),
    },
    # SICK LMS 200 technical description: 8 m at a resolution of 1 mm. ARIA mounts it 2 cm from the
    # centre; this model has it at the centre.
    laser=Laser(field_deg=180, range_m=8.0),
    has_bumper=True,
)

SMALL_ROBOT = RobotModel(
    # Not a product, but a robot that a class can build: a round base of 16 cm, two gear motors and
    # three HC-SR04 sonars 45 degrees apart. The range of 4 m is from the datasheet of the sonars.
    name="small_robot",
    title="Mini 16",
    radius_m=0.08,
    hull_m=_both_sides((0.08, 0.033), (0.033, 0.08), (-0.033, 0.08), (-0.08, 0.033)),
    hull_round_m=0.033,
    wheels=_wheels(0.0, 0.065, 0.033, 0.026),
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
    sonars=_on_the_hull(0.08, 45, 0, -45),
    sonar_range_m=4.0,
    distance_sonars={"front": (1,), "left": (0,), "right": (2,), "back": ()},
    laser=None,
    has_bumper=True,
)

TURTLEBOT3_BURGER = RobotModel(
    # ROBOTIS e-Manual, TurtleBot3, Specifications: 138 x 178 mm with the wheels, 1 kg, 0.22 m/s,
    # 2.84 rad/s. From its ROS packages: track, wheels, radius, and the centre of the hull 32 mm
    # behind the axle. The hull is 140 mm wide between the wheels. The force is the limit of the
    # tyres' grip on a floor, and the chosen accelerations need less.
    name="turtlebot3_burger",
    title="TurtleBot3 Burger",
    radius_m=0.105,
    hull_m=_both_sides((0.037, 0.035), (0.002, 0.07), (-0.066, 0.07), (-0.101, 0.035)),
    hull_round_m=0.012,
    wheels=_wheels(0.0, 0.08, 0.033, 0.018),
    mass_kg=1.0,
    max_force_n=6.0,
    max_torque_nm=0.4,
    max_v_mps=0.22,
    max_omega_radps=2.84,
    start_v_mps=0.2,
    start_omega_radps=math.radians(90.0),
    acceleration_mps2=0.6,
    angular_acceleration_radps2=3.2,
    smoothing_s=0.1,
    sonars=(),
    sonar_range_m=0.0,
    distance_sonars={"front": (), "left": (), "right": (), "back": ()},
    # e-Manual, Appendix LDS-01: 360 degrees, one reading per degree, 0.12 to 3.5 m
    laser=Laser(field_deg=360, range_m=3.5, min_m=0.12, x_m=-0.032),
    has_bumper=False,
)

ROBOTS = {robot.name: robot for robot in (PIONEER_3DX, SMALL_ROBOT, TURTLEBOT3_BURGER)}
