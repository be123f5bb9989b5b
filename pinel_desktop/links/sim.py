"""The built-in simulator as a robot link. Its poses are in the world's frame."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import (
    STANDSTILL,
    Laser,
    Pose2D,
    RobotModel,
    RobotState,
    Segment,
    Sensors,
    SimulationConfig,
    Twist2D,
    wrap_angle,
)
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.robot.sensors import missing
from sim.realistic import REALISTIC, MeasurementNoise, RealisticDrive
from sim.simulator import TICK_S, Simulator
from sim.world import World, WorldError, load_world, world_from_document

_ROUNDING_M = 1e-6  # error of a scan, which is computed in single precision


class SimSensors(Sensors):
    """Exact sensors of the simulated robot, computed by ray casting and point-in-area tests."""

    def __init__(self, simulator: Simulator, robot: RobotModel, world: World) -> None:
        self._simulator, self._robot, self._world = simulator, robot, world
        self._rays = [(*sonar.ray, sonar.angle_rad) for sonar in robot.sonars]
        self._reaches = [along + robot.sonar_range_m for _, along, _ in self._rays]
        self._sonar_parts = simulator.fan(
            [
                (*start, start[0] + reach * math.cos(angle), start[1] + reach * math.sin(angle))
                for (start, _, angle), reach in zip(self._rays, self._reaches, strict=True)
            ]
        )
        self._scanner: Callable[[float], list[float]] | None = None

    def sonar(self, index: int) -> float:
        if index >= len(self._rays):
            missing("sonar")
        start, along, angle = self._rays[index]
        distance = self._simulator.ray(angle, self._reaches[index], start)
        return max(0.0, min(distance - along, self._robot.sonar_range_m))

    def sonars(self) -> list[float]:
        max_range_m, rays = self._robot.sonar_range_m, zip(self._rays, self._reaches, strict=True)
        return [
            0.0
            if (found := part * reach - along) < 0.0
            else max_range_m
            if found > max_range_m
            else found
            for part, ((_, along, _), reach) in zip(self._sonar_parts(), rays, strict=True)
        ]

    def lidar(self, angle_rad: float) -> float:
        laser = self._laser()
        found = self._simulator.ray(angle_rad, laser.range_m, (laser.x_m, laser.y_m))
        return max(laser.min_m, found)

    def scan(self) -> list[float]:
        laser = self._laser()
        if self._scanner is None:
            self._scanner = self._simulator.scanner(laser.angles_rad, (laser.x_m, laser.y_m))
        nothing = laser.range_m - _ROUNDING_M
        return [
            laser.range_m if found > nothing else max(laser.min_m, found)
            for found in self._scanner(laser.range_m)
        ]

    def _laser(self) -> Laser:
        return self._robot.laser or missing("lidar")

    def bumper(self) -> bool:
        return self._simulator.touching() if self._robot.has_bumper else missing("bumper")

    def floor(self) -> str:
        return self._simulator.floor_color()

    def compass(self) -> float:
        """Returns the heading in rad from north (the world's y axis), positive to the right."""
        return wrap_angle(math.pi / 2.0 - self._simulator.state()[2])

    def cell(self) -> str:
        return self._simulator.zone()

    def places(self) -> dict[str, tuple[float, float]]:
        return {zone.name: zone.shape.center for zone in self._world.zones}

    def obstacles(self) -> tuple[Segment, ...]:
        """Returns walls and edges of fixed boxes; movable boxes are not on the map."""
        walls = [(*wall.start, *wall.end) for wall in self._world.walls]
        rings = [box.corners() for box in self._world.boxes if not box.movable]
        edges = [(*a, *b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
        return (*walls, *edges)


class RealisticSensors(SimSensors):
    """`SimSensors` with the measurement errors of real sensors."""

    def __init__(
        self,
        simulator: Simulator,
        robot: RobotModel,
        world: World,
        drive: RealisticDrive,
        measuring: MeasurementNoise,
    ) -> None:
        super().__init__(simulator, robot, world)
        self._drive, self._measuring = drive, measuring

    def sonar(self, index: int) -> float:
        return self._sonar_errs(index, super().sonar(index))

    def sonars(self) -> list[float]:
        return [self._sonar_errs(index, exact) for index, exact in enumerate(super().sonars())]

    def lidar(self, angle_rad: float) -> float:
        return self._lidar_errs(angle_rad, super().lidar(angle_rad))

    def scan(self) -> list[float]:
        beams = zip(self._laser().angles_rad, super().scan(), strict=True)
        return [self._lidar_errs(angle, exact) for angle, exact in beams]

    def _sonar_errs(self, index: int, exact: float) -> float:
        reach = self._robot.sonar_range_m
        if exact >= reach:
            return reach
        measured = self._measuring.sonar(self._drive.tick_number, index, exact)
        return max(0.0, min(measured, reach))

    def _lidar_errs(self, angle_rad: float, exact: float) -> float:
        laser = self._laser()
        if exact >= laser.range_m:
            return laser.range_m
        measured = self._measuring.lidar(self._drive.tick_number, angle_rad, exact)
        return max(laser.min_m, min(measured, laser.range_m))


class SimLink:
    """Drives the simulated robot. Time passes only in `advance`, one tick of 1/30 s at a time.

    With the preset `realistic`, wheels slip, lag and respond with latency, and measurements have errors. With the
    preset `ideal`, measurements are exact for either feedback.
    """

    simulated = True

    def __init__(
        self,
        *,
        world: str | dict[str, Any],
        setting: SimulationConfig,
        seed: int,
        robot: RobotProfile | None = None,
    ) -> None:
        try:
            read = load_world if isinstance(world, str) else world_from_document
            self._world = read(world)  # type: ignore[arg-type] # `read` matches the type of `world`
        except WorldError as error:
            raise PinelError(error.code, **error.params) from error
        model = setting.robot
        self._max_v, self._max_omega = model.max_v_mps, model.max_omega_radps
        self._twist = STANDSTILL
        self.simulator = Simulator(self._world, model)
        self.command_delay_s = self.simulator.delay_s
        self.slips = setting.preset == "realistic"
        self._drive: RealisticDrive | None = None
        self.sensors: Sensors = SimSensors(self.simulator, model, self._world)
        if self.slips:
            self._make_realistic(model, setting, seed)

    def _make_realistic(self, robot: RobotModel, setting: SimulationConfig, seed: int) -> None:
        realism = replace(REALISTIC, **setting.parameters.changes)
        self._drive = RealisticDrive(self.simulator, robot.track_m, seed, realism)
        self._measuring = MeasurementNoise(seed, realism)
        self._uses_odometry = setting.feedback == "odometry"
        self.command_delay_s += REALISTIC.delay_s
        self.sensors = RealisticSensors(
            self.simulator, robot, self._world, self._drive, self._measuring
        )

    def connect(self, cancelled: Callable[[], bool] = lambda: False) -> None:
        """Does nothing: the simulator is ready once constructed."""

    def read(self) -> RobotState:
        x, y, yaw, v, omega = self.simulator.state()
        pose = Pose2D(x, y, wrap_angle(yaw))
        if self._drive is None:
            return RobotState(pose, Twist2D(v, omega), pose)
        return RobotState(self._estimate(self._drive), Twist2D(*self._drive.speed), pose)

    def _estimate(self, drive: RealisticDrive) -> Pose2D:
        if self._uses_odometry:
            x, y, yaw = drive.odometry
        else:
            x, y, yaw = self._measuring.pose(drive.tick_number, self.simulator.state()[:3])
        return Pose2D(x, y, wrap_angle(yaw))

    def bumper(self) -> bool:
        return self.simulator.touching()

    def movable_boxes(self) -> dict[int, Pose2D]:
        return {
            index: Pose2D(x, y, wrap_angle(yaw))
            for index, (x, y, yaw) in self.simulator.boxes().items()
        }

    def command(self, twist: Twist2D) -> None:
        v, omega = twist
        if not (-self._max_v <= v <= self._max_v and -self._max_omega <= omega <= self._max_omega):
            v = min(max(v, -self._max_v), self._max_v)
            omega = min(max(omega, -self._max_omega), self._max_omega)
            twist = Twist2D(v, omega)
        self._twist = twist

    def advance(self, dt_s: float) -> None:
        """Steps the simulator by one tick. Raises ValueError unless `dt_s` is `TICK_S`."""
        if dt_s != TICK_S:
            raise ValueError(f"the simulator steps in ticks of {TICK_S} s, not {dt_s}")
        v, omega = self._twist
        if self._drive is None:
            self.simulator.tick(v, omega)
        else:
            self._drive.tick(v, omega)

    def close(self) -> None:
        self._twist = STANDSTILL
