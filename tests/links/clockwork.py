"""A link without a simulator: its robot moves with the wall clock, also between calls."""

import math
from typing import Any, ClassVar

import pytest

from pinel_desktop import links
from pinel_desktop.execution.clock import WallTime
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotState, Sensors, SimulationConfig, Twist2D


class ClockworkLink:
    """A unicycle that follows commands instantly; `install` says by which wall time."""

    simulated = False
    command_delay_s = 0.0
    slips = False
    wall: ClassVar[WallTime]

    def __init__(self, *, world: Any, setting: SimulationConfig, seed: int, robot: Any) -> None:
        self.sensors = Sensors()
        self._now = self.wall.now
        self._pose, self._twist, self._at_s = Pose2D(), STANDSTILL, self._now()

    def connect(self, cancelled: Any = None) -> None:
        self._at_s = self._now()

    def read(self) -> RobotState:
        (x, y, yaw), (v, omega) = self._pose, self._twist
        dt, self._at_s = self._now() - self._at_s, self._now()
        self._pose = Pose2D(
            x + v * dt * math.cos(yaw), y + v * dt * math.sin(yaw), yaw + omega * dt
        )
        return RobotState(self._pose, self._twist)

    def bumper(self) -> bool:
        return False

    def movable_boxes(self) -> dict[int, Pose2D]:
        return {}

    def command(self, twist: Twist2D) -> None:
        self.read()
        self._twist = twist

    def advance(self, dt_s: float) -> None:
        """Does nothing: its time is the wall clock."""

    def close(self) -> None:
        self.command(STANDSTILL)


def install(monkeypatch: pytest.MonkeyPatch, wall: WallTime) -> None:
    """Registers it as the link `clockwork`."""
    monkeypatch.setattr(ClockworkLink, "wall", wall, raising=False)
    monkeypatch.setitem(links._BACKENDS, "clockwork", (__name__, ClockworkLink.__name__))
