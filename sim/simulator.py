"""Physics of one differential-drive robot in a world, on pymunk (Chipmunk 2D).

The robot is a dynamic circle. A kinematic body with the commanded velocity pulls it through a pivot joint and a gear
joint. The joints have the force limits of wheels: the robot follows commands exactly on free floor and stalls at a
wall. Setting the velocity of the circle itself would drive it through walls.

A movable box is a dynamic body joined to the floor in the same way, with the friction force as the limit. In worlds
with movable boxes the physics step is halved, which halves the depth by which a fast box penetrates a wall.
`TunnellingGuard` prevents boxes from passing through walls.
"""

import math
from collections.abc import Callable, Sequence
from typing import Protocol

import pymunk

from sim.floor import color_at, zone_at
from sim.pymunk_fastpath import BodyAccess, Fan, Rays, Stepper
from sim.tunnelling_guard import FIXED, MOVABLE, TunnellingGuard
from sim.world import WALL_RADIUS_M, Box, World

TICK_S = 1.0 / 30.0
SUBSTEPS = 8
SUBSTEP_S = TICK_S / SUBSTEPS
# Lengths are in metres here, so Chipmunk's default of 0.1 would let shapes overlap by 10 cm.
COLLISION_SLOP_M = 0.0005
BOX_FRICTION = 0.4  # cardboard and wood on a school's floor: 0.3 to 0.5
GRAVITY_MPS2 = 9.81
# Chipmunk's default of 10 is not enough for a light box between the robot and a wall.
ITERATIONS_WITH_MOVABLE = 40
STEPS_WITH_MOVABLE = 2  # physics steps per substep
_ROBOT = 0b10  # category of the robot's shape: rays start inside it and must not hit it
_ALL_BUT_ROBOT = pymunk.ShapeFilter(mask=pymunk.ShapeFilter.ALL_MASKS() ^ _ROBOT)


class RobotBody(Protocol):
    """Dimensions and limits of the robot, in SI units. The application's `RobotModel` implements this protocol."""

    @property
    def radius_m(self) -> float: ...
    @property
    def mass_kg(self) -> float: ...
    @property
    def max_force_n(self) -> float: ...
    @property
    def max_torque_nm(self) -> float: ...


class Simulator:
    """One robot in one world, stepped in ticks of 1/30 s of 8 substeps each.

    The same sequence of calls gives the same numbers to the bit, in any process, on one build and platform.

    Attributes:
        delay_s: time from the start of a tick until its velocity takes effect: one substep, or three quarters of a
            substep with movable boxes.
    """

    def __init__(self, world: World, robot: RobotBody) -> None:
        self.space = pymunk.Space()
        self.space.collision_slop = COLLISION_SLOP_M
        self._world = world
        self._movable: dict[int, pymunk.Body] = {}
        self._add_obstacles(world)
        self._steps_each = STEPS_WITH_MOVABLE if self._movable else 1
        # With movable boxes the velocity changes in two half jumps, on average 1.5 physics steps
        # late.
        self.delay_s = SUBSTEP_S if self._steps_each == 1 else 1.5 * SUBSTEP_S / self._steps_each
        self._body = self._add_robot(world, robot)
        self.wheels = self._add_wheels(robot)
        self._yaw, self._omega = world.start[2], 0.0
        self._translating = False
        self._last_command = (0.0, 0.0, 0.0)  # vx, vy, omega of the wheels
        self._robot, self._drive = BodyAccess(self._body), BodyAccess(self.wheels)
        self._steps = Stepper(self.space, SUBSTEP_S / self._steps_each).steps
        self._advance: Callable[[int], None] = self._steps
        self._rays = Rays(self.space, _ALL_BUT_ROBOT)
        if self._movable:
            self.space.iterations = ITERATIONS_WITH_MOVABLE
            guard = TunnellingGuard(self.space, list(self._movable.values()), self._body)
            self._advance = guard.wrap(self._steps_from_halfway)

    def _add_obstacles(self, world: World) -> None:
        static = self.space.static_body
        for wall in world.walls:
            self._add_fixed(pymunk.Segment(static, wall.start, wall.end, WALL_RADIUS_M))
        for index, box in enumerate(world.boxes):
            if box.movable:
                self._movable[index] = self._add_movable(box)
            else:
                self._add_fixed(pymunk.Poly(static, box.corners()))

    def _add_fixed(self, shape: pymunk.Shape) -> None:
        shape.friction = 0.5
        shape.filter = pymunk.ShapeFilter(categories=FIXED)
        self.space.add(shape)

    def _add_movable(self, box: Box) -> pymunk.Body:
        body = pymunk.Body(box.mass_kg, pymunk.moment_for_box(box.mass_kg, box.size))
        body.position, body.angle = box.center, box.angle_rad
        shape = pymunk.Poly.create_box(body, box.size)
        shape.friction = 0.5
        shape.filter = pymunk.ShapeFilter(categories=MOVABLE)
        floor = self.space.static_body
        slide = pymunk.PivotJoint(floor, body, (0.0, 0.0), (0.0, 0.0))
        turn = pymunk.GearJoint(floor, body, 0.0, 1.0)
        slide.max_bias = turn.max_bias = 0.0  # friction only; a bias would pull the box back
        slide.max_force = BOX_FRICTION * box.mass_kg * GRAVITY_MPS2
        turn.max_force = slide.max_force * _mean_radius(box.size)
        self.space.add(body, shape, slide, turn)
        return body

    def _add_robot(self, world: World, robot: RobotBody) -> pymunk.Body:
        moment = pymunk.moment_for_circle(robot.mass_kg, 0.0, robot.radius_m)
        body = pymunk.Body(robot.mass_kg, moment)
        x, y, yaw = world.start
        body.position, body.angle = (x, y), yaw
        shape = pymunk.Circle(body, robot.radius_m)
        shape.friction = 0.3
        shape.filter = pymunk.ShapeFilter(categories=_ROBOT)
        self.space.add(body, shape)
        return body

    def _add_wheels(self, robot: RobotBody) -> pymunk.Body:
        wheels = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        pull = pymunk.PivotJoint(wheels, self._body, (0.0, 0.0), (0.0, 0.0))
        turn = pymunk.GearJoint(wheels, self._body, 0.0, 1.0)
        # Without bias the joints transmit velocities only. With bias, a blocked robot would later
        # jump to the position of the wheels.
        pull.max_bias = turn.max_bias = 0.0
        pull.max_force, turn.max_force = robot.max_force_n, robot.max_torque_nm
        self.space.add(wheels, pull, turn)
        return wheels

    def tick(self, v_mps: float, omega_radps: float) -> None:
        """Advances by one tick with the given velocity."""
        self._set_velocity(v_mps, omega_radps, TICK_S)
        self._advance(SUBSTEPS * self._steps_each)
        self._yaw = self._robot.angle()

    def substep(self, v_mps: float, omega_radps: float) -> None:
        """Advances by one substep with the given velocity; a tick has `SUBSTEPS`."""
        self._set_velocity(v_mps, omega_radps, SUBSTEP_S)
        self._advance(self._steps_each)
        self._yaw = self._robot.angle()

    def _steps_from_halfway(self, number: int) -> None:
        """Makes `number` physics steps, and changes the velocity in two half jumps.

        One full jump within a halved physics step would exceed the force of the wheels.
        """
        (vx, vy), omega = self.wheels.velocity, self.wheels.angular_velocity
        was_vx, was_vy, was_omega = self._last_command
        self._last_command = vx, vy, omega
        if (vx, vy, omega) != (was_vx, was_vy, was_omega):
            self._drive.set_velocity((vx + was_vx) / 2.0, (vy + was_vy) / 2.0)
            self._drive.set_omega((omega + was_omega) / 2.0)
            self._steps(1)
            self._drive.set_velocity(vx, vy)
            self._drive.set_omega(omega)
            number -= 1
        self._steps(number)

    def _set_velocity(self, v_mps: float, omega_radps: float, time_s: float) -> None:
        """Sets the velocity for the next `time_s`; the arc driven in that time is replaced by its chord.

        The chord has the direction of the heading at the middle of the interval, which starts `delay_s` late. Its
        length is the arc's length times the sinc of half the angle.
        """
        half_angle = omega_radps * time_s / 2.0
        heading = self._yaw + self._omega * self.delay_s + half_angle
        chord = v_mps if half_angle == 0.0 else v_mps * math.sin(half_angle) / half_angle
        if (
            chord != 0.0 or self._translating
        ):  # setting a velocity in pymunk costs more than a substep
            self._drive.set_velocity(chord * math.cos(heading), chord * math.sin(heading))
            self._translating = chord != 0.0
        if omega_radps != self._omega:
            self._omega = omega_radps
            self._drive.set_omega(omega_radps)

    def state(self) -> tuple[float, float, float, float, float]:
        """Returns the true x, y (m), yaw (rad, not wrapped), forward speed (m/s) and angular speed (rad/s).

        The pose is in the world's frame.
        """
        yaw = self._yaw
        x, y = self._robot.position()
        vx, vy, omega = self._robot.velocity()
        return x, y, yaw, vx * math.cos(yaw) + vy * math.sin(yaw), omega

    def touching(self) -> bool:
        """Returns whether the robot touches a wall or a box."""
        touched = False

        def note(_arbiter: pymunk.Arbiter) -> None:
            nonlocal touched
            touched = True

        self._body.each_arbiter(note)
        return touched

    def ray(
        self, angle_rad: float, length_m: float, start: tuple[float, float] = (0.0, 0.0)
    ) -> float:
        """Returns the distance (m) from a point of the robot to the nearest shape in a direction, at most `length_m`.

        Args:
            angle_rad: direction relative to the heading, positive to the left.
            start: the point, in the robot's frame, in m.
        """
        x, y = self._at(start)
        angle = self._yaw + angle_rad
        end_x, end_y = x + length_m * math.cos(angle), y + length_m * math.sin(angle)
        return self._rays.fraction(x, y, end_x, end_y) * length_m

    def _at(self, place: tuple[float, float]) -> tuple[float, float]:
        """Transforms a point (m) from the robot's frame into the world's frame."""
        x, y = self._robot.position()
        ahead, left = place
        if ahead or left:
            cos, sin = math.cos(self._yaw), math.sin(self._yaw)
            return x + cos * ahead - sin * left, y + sin * ahead + cos * left
        return x, y

    def fan(
        self, beams: Sequence[tuple[float, float, float, float]]
    ) -> Callable[[], Sequence[float]]:
        """Returns a function that casts a few rays and returns the free fraction of each, 0 to 1.

        The next call of that function overwrites the returned buffer.

        Args:
            beams: start (x, y) and end (x, y) of each ray in the robot's frame, in m.
        """
        fractions = Fan(self.space, _ALL_BUT_ROBOT, beams).fractions
        position = self._robot.position
        return lambda: fractions(*position(), self._yaw)

    def scanner(
        self, angles_rad: Sequence[float], start: tuple[float, float] = (0.0, 0.0)
    ) -> Callable[[float], list[float]]:
        """Returns a function from a length (m) to the distances (m) of `ray` at all these angles from one start.

        The distances agree with `ray` within 2 mm. For many angles the function is much faster than `ray`.
        """
        from sim.beam_caster import BeamCaster  # noqa: PLC0415 - imports numpy, which loads slowly

        boxes = self._world.boxes
        fixed = [box for box in boxes if not box.movable]
        scan = BeamCaster(self._world.walls, fixed, WALL_RADIUS_M, angles_rad)

        def ranges(length_m: float) -> list[float]:
            moved: list[Box] = []
            if self._movable:
                poses = self.boxes().items()
                moved = [Box((x, y), boxes[index].size, yaw) for index, (x, y, yaw) in poses]
            return scan.ranges(*self._at(start), self._yaw, length_m, moved)

        return ranges

    def boxes(self) -> dict[int, tuple[float, float, float]]:
        """Returns the poses of the movable boxes by index: x, y of the centre (m), yaw (rad), in the world's frame."""
        return {index: (*body.position, body.angle) for index, body in self._movable.items()}

    def zone(self) -> str:
        """Returns the name of the world's zone under the robot's centre, or ""."""
        return zone_at(self._world.zones, *self._robot.position())

    def floor_color(self) -> str:
        """Returns the colour of the floor under the robot's centre."""
        return color_at(self._world.floor, *self._robot.position())


def _mean_radius(size: tuple[float, float]) -> float:
    """Returns the mean distance of a rectangle's points from its centre, within 5 %.

    It is the lever arm of friction against rotation.
    """
    return 0.26 * math.hypot(*size)
