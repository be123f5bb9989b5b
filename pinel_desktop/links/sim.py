"""The built-in simulator as a robot link. Its frame is the world's."""

from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import (
    STANDSTILL,
    Pose2D,
    RobotModel,
    RobotState,
    Segment,
    Sensors,
    Setting,
    Twist2D,
    wrap_angle,
)
from sim.simulator import SUBSTEP_S, TICK_S, Simulator
from sim.world import World, WorldError, load_world, world_from_document


class SimSensors(Sensors):
    """Everything a program can ask for, computed from the world by rays and areas."""

    def __init__(self, simulator: Simulator, robot: RobotModel, world: World) -> None:
        self._simulator, self._robot, self._world = simulator, robot, world

    def sonar(self, index: int) -> float:
        robot = self._robot
        # A ray from the centre: one from the hull could begin inside the wall that the hull touches.
        reach = robot.radius_m + robot.sonar_range_m
        seen = self._simulator.ray(robot.sonar_angles_rad[index], reach)
        return max(0.0, min(seen - robot.radius_m, robot.sonar_range_m))

    def lidar(self, angle_rad: float) -> float:
        return self._simulator.ray(angle_rad, self._robot.lidar_range_m)

    def bumper(self) -> bool:
        return self._simulator.touching()

    def floor(self) -> str:
        return self._simulator.floor_color()

    def cell(self) -> str:
        return self._simulator.zone()

    def obstacles(self) -> tuple[Segment, ...]:
        """Walls and edges of boxes; those that may be pushed about are on no map."""
        walls = [(*wall.start, *wall.end) for wall in self._world.walls]
        rings = [box.corners() for box in self._world.boxes if not box.movable]
        edges = [(*a, *b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
        return (*walls, *edges)


class SimLink:
    """Drives the simulated robot; time passes only in `advance`, one tick of 1/30 s at a time."""

    simulated = True
    command_delay_s = SUBSTEP_S

    def __init__(self, *, world: str | dict[str, Any], setting: Setting, seed: int) -> None:
        try:
            read = load_world if isinstance(world, str) else world_from_document
            self._world = read(world)  # type: ignore[arg-type] # as its type says
        except WorldError as error:
            raise PinelError(error.code, **error.params) from error
        robot = setting.robot
        self._robot, self._seed = robot, seed
        self._max_v, self._max_omega = robot.max_v_mps, robot.max_omega_radps
        self._twist = STANDSTILL
        self.simulator = Simulator(self._world, robot)
        self.sensors: Sensors = SimSensors(self.simulator, robot, self._world)

    def connect(self) -> None:
        """Nothing to do: the simulator is there."""

    def read(self) -> RobotState:
        x, y, yaw, v, omega = self.simulator.state()
        pose = Pose2D(x, y, wrap_angle(yaw))
        return RobotState(pose, Twist2D(v, omega), pose)

    def bumper(self) -> bool:
        return self.simulator.touching()

    def command(self, twist: Twist2D) -> None:
        v, omega = twist
        if not (-self._max_v <= v <= self._max_v and -self._max_omega <= omega <= self._max_omega):
            v = min(max(v, -self._max_v), self._max_v)
            omega = min(max(omega, -self._max_omega), self._max_omega)
            twist = Twist2D(v, omega)
        self._twist = twist

    def advance(self, dt_s: float) -> None:
        """Steps the simulator by one tick; `dt_s` must be that tick."""
        if dt_s != TICK_S:
            raise ValueError(f"the simulator steps in ticks of {TICK_S} s, not {dt_s}")
        v, omega = self._twist
        self.simulator.tick(v, omega)

    def close(self) -> None:
        self._twist = STANDSTILL
