"""What sets a real robot apart from an ideal one: slip, lag, latency, odometry that drifts, sensors that err.

All of it depends on the run's seed and the tick only (`sim.noise`): who reads which sensor changes nothing.
"""

import math
from collections import deque
from dataclasses import dataclass

from sim.noise import Noise
from sim.simulator import SUBSTEP_S, SUBSTEPS, TICK_S, Simulator

_LEFT, _RIGHT, _BIAS, _POSE, _SONAR, _LIDAR = range(1, 7)
_STANDS_MPS = 1e-3  # a wheel that is told to stand is held by its friction from here on


@dataclass(frozen=True, slots=True)
class Realism:
    """How far from ideal. Standard deviations where it says noise or bias.

    Attributes:
        wheel_bias: how much farther a wheel rolls than it is told, over the whole run, as a part of the way.
        wheel_noise: the same, anew at every tick.
        lag_s: time constant with which a wheel follows its command.
        latency_s: from the command to the wheel, a whole number of substeps.
        pose_noise_m, pose_noise_rad: of a pose that is measured from outside, in x and in y, and in yaw.
        sonar_noise: as a part of the distance.
        lidar_noise_m: the same at every distance.
    """

    wheel_bias: float
    wheel_noise: float
    lag_s: float
    latency_s: float
    pose_noise_m: float
    pose_noise_rad: float
    sonar_noise: float
    lidar_noise_m: float

    @property
    def delay_s(self) -> float:
        """How late a velocity is there on the average: a wheel that lags is late by its time constant."""
        return self.latency_s + self.lag_s


REALISTIC = Realism(
    # Wheels of a class's Pioneer differ by about half a per cent (tyres, load); the rest is chosen so that a square
    # of 1 m driven by odometry misses its start by some centimetres, as J. Borenstein and L. Feng measured for such
    # robots ("Measurement and correction of systematic odometry errors", 1996).
    wheel_bias=0.005,
    wheel_noise=0.02,
    lag_s=0.06,
    latency_s=0.05,
    # a marker under a camera that looks down on a floor of some metres
    pose_noise_m=0.001,
    pose_noise_rad=math.radians(0.1),
    sonar_noise=0.01,  # Polaroid 6500 module: 1 % of the distance
    lidar_noise_m=0.005,  # SICK LMS 200 technical description: statistical error, one sigma
)

Pose = tuple[float, float, float]


class RealisticDrive:
    """Wheels between the command and the simulated body, and the odometry that they give.

    Encoders count how far the wheels have turned: the body's way without the slip that they cannot see. Wheels that are
    blocked stand, and so does the count.

    Attributes:
        odometry: x and y (m) and yaw (rad, not wrapped) as the wheels tell, from the true start on.
        speed: v (m/s) and omega (rad/s) as the wheels tell, the mean of the last tick.
        tick_number: of the last tick.
    """

    def __init__(
        self, simulator: Simulator, track_m: float, seed: int, realism: Realism = REALISTIC
    ) -> None:
        self._simulator, self._half_track, self._realism = simulator, track_m / 2.0, realism
        self._noises = Noise(seed, _LEFT), Noise(seed, _RIGHT)
        bias = Noise(seed, _BIAS)
        self._biases = tuple(1.0 + realism.wheel_bias * bias.normal(0, side) for side in (0, 1))
        self._on_its_way = deque([(0.0, 0.0)] * round(realism.latency_s / SUBSTEP_S))
        self._nearer = 1.0 - math.exp(-SUBSTEP_S / realism.lag_s)
        self._left = self._right = 0.0
        self.tick_number = 0
        self._pose: Pose = simulator.state()[:3]
        self.odometry: Pose = self._pose
        self.speed = (0.0, 0.0)

    def tick(self, v_mps: float, omega_radps: float) -> None:
        """Lets one tick pass with that command."""
        self.tick_number += 1
        turn = omega_radps * self._half_track
        command = (v_mps - turn, v_mps + turn)
        slips = self._slips()
        for _ in range(SUBSTEPS):
            self._on_its_way.append(command)
            self._follow(*self._on_its_way.popleft())
            left, right = self._left * slips[0], self._right * slips[1]
            self._simulator.substep((left + right) / 2.0, (right - left) / 2.0 / self._half_track)
        self._count(slips)

    def _follow(self, left: float, right: float) -> None:
        """One substep, in which the wheels come nearer to what they are told."""
        self._left += (left - self._left) * self._nearer
        self._right += (right - self._right) * self._nearer
        if left == 0.0 and abs(self._left) < _STANDS_MPS:
            self._left = 0.0
        if right == 0.0 and abs(self._right) < _STANDS_MPS:
            self._right = 0.0

    def _slips(self) -> tuple[float, float]:
        """How far each wheel moves the body for each metre that it turns, left and right."""
        noise, number = self._realism.wheel_noise, self.tick_number
        left, right = (
            bias + noise * source.normal(number)
            for bias, source in zip(self._biases, self._noises, strict=True)
        )
        return left, right

    def _count(self, slips: tuple[float, float]) -> None:
        """Adds to the odometry what the wheels have turned since the last tick."""
        x0, y0, yaw0 = self._pose
        x, y, yaw = self._pose = self._simulator.state()[:3]
        middle, turned = (yaw0 + yaw) / 2.0, yaw - yaw0
        ahead = (x - x0) * math.cos(middle) + (y - y0) * math.sin(middle)
        left = (ahead - turned * self._half_track) / slips[0]
        right = (ahead + turned * self._half_track) / slips[1]
        ahead, turned = (left + right) / 2.0, (right - left) / 2.0 / self._half_track
        odo_x, odo_y, odo_yaw = self.odometry
        middle = odo_yaw + turned / 2.0
        self.odometry = (
            odo_x + ahead * math.cos(middle),
            odo_y + ahead * math.sin(middle),
            odo_yaw + turned,
        )
        self.speed = (ahead / TICK_S, turned / TICK_S)


class Measuring:
    """The errors of what is measured, at each tick others."""

    def __init__(self, seed: int, realism: Realism = REALISTIC) -> None:
        self._realism = realism
        self._pose, self._sonar, self._lidar = (
            Noise(seed, channel) for channel in (_POSE, _SONAR, _LIDAR)
        )

    def pose(self, tick: int, pose: Pose) -> Pose:
        """A pose as it is measured from outside. At the start the robot stands on its mark, which is known."""
        if tick == 0:
            return pose
        x, y, yaw = pose
        noise, spread = self._pose.normal, self._realism.pose_noise_m
        return (
            x + spread * noise(tick, 0),
            y + spread * noise(tick, 1),
            yaw + self._realism.pose_noise_rad * noise(tick, 2),
        )

    def sonar(self, tick: int, index: int, distance_m: float) -> float:
        """A distance as sonar `index` measures it; may lie beyond its range."""
        return distance_m * (1.0 + self._realism.sonar_noise * self._sonar.normal(tick, index))

    def lidar(self, tick: int, angle_rad: float, distance_m: float) -> float:
        """A distance as the scanner measures it at an angle, told apart to half a degree."""
        beam = round(math.degrees(angle_rad) * 2.0) % 720
        return distance_m + self._realism.lidar_noise_m * self._lidar.normal(tick, beam)
