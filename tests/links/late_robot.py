"""A robot that answers late, sticks and slips, in a time that the test makes: as real ones do, and repeatable.

Its link follows commands at the robot's own loop, after a latency, through drives with a lag; it reports at a rate.
"""

import math
from dataclasses import dataclass, field
from random import Random
from typing import Any

from pinel_desktop import links
from pinel_desktop.execution.clock import WallTime
from pinel_desktop.links.real import delay_s
from pinel_desktop.robot import STANDSTILL, Pose2D, RobotState, Sensors, Twist2D
from pinel_desktop.robot.robot_profile import BridgeProfile, Room
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start

PROFILE = BridgeProfile(max_v_mps=0.5, max_omega_dps=90.0, room=Room(width_m=20.0, depth_m=20.0))
_STEP_S = 0.001
_TRACK_M = 0.33


@dataclass
class Trouble:
    """What is wrong with the robot.

    Attributes:
        period_s: from one report to the next.
        latency_s: of a command, beside the robot's own loop.
        lag_s: time constant of its drives.
        sticks_mps: slower wheels do not turn.
        slip: part of the way that wheels turn in vain.
        known_delay_s: what the link tells; None for what it measures of `period_s`.
    """

    period_s: float = 0.02
    latency_s: float = 0.0
    lag_s: float = 0.0
    sticks_mps: float = 0.0
    slip: float = 0.0
    known_delay_s: float | None = None
    seed: int = 0


@dataclass
class Clock:
    """Time that passes when somebody sleeps."""

    now_s: float = 0.0

    def sleep(self, seconds: float) -> None:
        self.now_s += max(seconds, 1e-4)

    def wall(self) -> WallTime:
        return WallTime(lambda: self.now_s, self.sleep)


@dataclass
class LateRobot:
    """The robot and its link.

    Attributes:
        farthest_m: how far ahead of its start it has been.
    """

    trouble: Trouble
    clock: Clock = field(default_factory=Clock)
    simulated = False
    slips = True
    command_delay_s = 0.1
    farthest_m: float = 0.0
    x_m: float = 0.0
    y_m: float = 0.0
    yaw_rad: float = 0.0

    def __post_init__(self) -> None:
        self.sensors = Sensors()
        draw, trouble = Random(self.trouble.seed), self.trouble
        self._loop_s = min(trouble.period_s, 0.05)
        self._reports_at_s = draw.random() * trouble.period_s
        self._loops_at_s = draw.random() * self._loop_s
        self._at_s = 0.0
        self._in_transit: list[tuple[float, Twist2D]] = []
        self._goal = self._twist = STANDSTILL
        self._reported = RobotState(Pose2D(), STANDSTILL)

    def connect(self, cancelled: Any = None) -> None:
        known = self.trouble.known_delay_s
        self.command_delay_s = delay_s(self.trouble.period_s) if known is None else known

    def read(self) -> RobotState:
        while self._at_s < self.clock.now_s:
            self._at_s += _STEP_S
            self._step()
        return self._reported

    def command(self, twist: Twist2D) -> None:
        self.read()
        v, omega = PROFILE.max_v_mps, math.radians(PROFILE.max_omega_dps)
        limited = Twist2D(min(max(twist.v_mps, -v), v), min(max(twist.omega_radps, -omega), omega))
        self._in_transit.append((self.clock.now_s + self.trouble.latency_s, limited))

    def bumper(self) -> bool:
        return False

    def movable_boxes(self) -> dict[int, Pose2D]:
        return {}

    def advance(self, dt_s: float) -> None:
        """Does nothing: its time is the clock's."""

    def close(self) -> None:
        self.command(STANDSTILL)

    def _step(self) -> None:
        if self._at_s >= self._loops_at_s:
            self._loops_at_s += self._loop_s
            while self._in_transit and self._in_transit[0][0] <= self._at_s:
                self._goal = self._turning(self._in_transit.pop(0)[1])
        v, omega = self._twist
        part = min(1.0, _STEP_S / (self.trouble.lag_s or _STEP_S))
        v += (self._goal.v_mps - v) * part
        omega += (self._goal.omega_radps - omega) * part
        self._twist = Twist2D(v, omega)
        grip = 1.0 - self.trouble.slip
        self.yaw_rad += omega * grip * _STEP_S
        self.x_m += v * grip * _STEP_S * math.cos(self.yaw_rad)
        self.y_m += v * grip * _STEP_S * math.sin(self.yaw_rad)
        self.farthest_m = max(self.farthest_m, self.x_m)
        if self._at_s >= self._reports_at_s:
            self._reports_at_s += self.trouble.period_s
            pose = Pose2D(self.x_m, self.y_m, math.remainder(self.yaw_rad, math.tau))
            self._reported = RobotState(pose, Twist2D(v * grip, omega * grip))

    def _turning(self, twist: Twist2D) -> Twist2D:
        """What becomes of a velocity when slow wheels do not turn."""
        wheels = [twist.v_mps + side * twist.omega_radps * _TRACK_M / 2 for side in (-1.0, 1.0)]
        left, right = (0.0 if abs(mps) < self.trouble.sticks_mps else mps for mps in wheels)
        return Twist2D((left + right) / 2, (right - left) / _TRACK_M)


def drive(document: Any, trouble: Trouble, monkeypatch: Any) -> tuple[Any, LateRobot]:
    """How a program's run ended on the robot, and where the robot is."""
    global _robot  # noqa: PLW0603 - `open_link` finds a backend by its name in a module
    _robot = LateRobot(trouble)
    monkeypatch.setitem(links._BACKENDS, "late", (__name__, "late_link"))
    spec = RunSpec(document, "empty_room", link="late", robot=PROFILE, pace="live")
    return start(spec, wall=_robot.clock.wall()).ended, _robot


_robot = LateRobot(Trouble())


def late_link(**_options: Any) -> LateRobot:
    return _robot
