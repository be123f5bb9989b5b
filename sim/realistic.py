"""Imperfections of a real robot: wheel slip, lag, latency, odometry drift, sensor noise.

All random numbers depend only on the run's seed and the tick (`sim.noise`). Reading a sensor changes none of them.
"""

import math
from collections import deque
from dataclasses import dataclass

from sim.noise import Noise
from sim.simulator import SUBSTEP_S, SUBSTEPS, TICK_S, Simulator

_LEFT, _RIGHT, _BIAS, _POSE, _SONAR, _LIDAR = range(1, 7)
_STANDSTILL_MPS = 1e-3  # below this speed friction stops a wheel whose command is zero


@dataclass(frozen=True, slots=True)
class Realism:
    """Parameters of the imperfections; each noise is a standard deviation.

    Attributes:
        wheel_bias_sd: standard deviation of the relative error of a wheel's distance, constant over the run.
        wheel_noise: relative error of a wheel's distance, drawn at every tick.
        lag_s: time constant of the wheel's first-order response.
        latency_s: time from the command to the wheel, a whole number of substeps.
        pose_noise_m, pose_noise_rad: error of an externally measured pose, in x and y, and in yaw.
        sonar_noise: relative error of a sonar's distance.
        lidar_noise_m: error of a lidar's distance, the same at every distance.
        track_m: true distance between the wheels; None if it is the track that the robot believes to have.
        wheel_bias_left, wheel_bias_right: mean of the relative error of a wheel's distance.
    """

    wheel_bias_sd: float
    wheel_noise: float
    lag_s: float
    latency_s: float
    pose_noise_m: float
    pose_noise_rad: float
    sonar_noise: float
    lidar_noise_m: float
    track_m: float | None = None
    wheel_bias_left: float = 0.0
    wheel_bias_right: float = 0.0

    @property
    def delay_s(self) -> float:
        """Mean delay of a velocity, in s: latency plus the time constant of the lag."""
        return self.latency_s + self.lag_s


REALISTIC = Realism(
    # The wheels of a Pioneer in use differ by about 0.5 % (tyres, load). The other values make a
    # square of 1 m driven by odometry end some centimetres from its start. J. Borenstein and L.
    # Feng measured that for robots of this kind ("Measurement and correction of systematic odometry
    # errors in mobile robots", 1996).
    wheel_bias_sd=0.005,
    wheel_noise=0.02,
    lag_s=0.06,
    latency_s=0.05,
    # measurement of a marker by a camera above a floor of some metres
    pose_noise_m=0.001,
    pose_noise_rad=math.radians(0.1),
    sonar_noise=0.01,  # Polaroid 6500 module: 1 % of the distance
    lidar_noise_m=0.005,  # SICK LMS 200 technical description: statistical error, one sigma
)

Pose = tuple[float, float, float]


class RealisticDrive:
    """Simulates the wheels between the command and the body, and their odometry.

    Encoders measure the rotation of the wheels: the body's motion without slip, which encoders cannot measure. Blocked
    wheels do not rotate, so their encoders count nothing. Commands become speeds of wheels, and rotations become
    odometry, by the track that the robot believes to have (`track_m`); the body moves by its true track.

    Attributes:
        odometry: x and y (m) and yaw (rad, not wrapped) in the world's frame, integrated from the true start.
        speed: v (m/s) and omega (rad/s) from the encoders, mean of the last tick.
        tick_number: number of the last tick.
    """

    def __init__(
        self, simulator: Simulator, track_m: float, seed: int, realism: Realism = REALISTIC
    ) -> None:
        self._simulator, self._realism = simulator, realism
        self._believed_half_track = track_m / 2.0
        self._half_track = (realism.track_m or track_m) / 2.0
        self._noises = Noise(seed, _LEFT), Noise(seed, _RIGHT)
        bias, means = Noise(seed, _BIAS), (realism.wheel_bias_left, realism.wheel_bias_right)
        self._biases = tuple(
            1.0 + mean + realism.wheel_bias_sd * bias.normal(0, side)
            for side, mean in enumerate(means)
        )
        self._in_transit = deque([(0.0, 0.0)] * round(realism.latency_s / SUBSTEP_S))
        self._response = 1.0 - math.exp(-SUBSTEP_S / realism.lag_s)
        self._left = self._right = 0.0
        self.tick_number = 0
        self._pose: Pose = simulator.state()[:3]
        self.odometry: Pose = self._pose
        self.speed = (0.0, 0.0)

    def tick(self, v_mps: float, omega_radps: float) -> None:
        """Advances by one tick with the given command."""
        self.tick_number += 1
        turn = omega_radps * self._believed_half_track
        command = (v_mps - turn, v_mps + turn)
        slips = self._slips()
        for _ in range(SUBSTEPS):
            self._in_transit.append(command)
            self._respond(*self._in_transit.popleft())
            left, right = self._left * slips[0], self._right * slips[1]
            self._simulator.substep((left + right) / 2.0, (right - left) / 2.0 / self._half_track)
        self._count(slips)

    def _respond(self, left: float, right: float) -> None:
        """Advances the wheels' first-order response to their command (m/s) by one substep."""
        self._left += (left - self._left) * self._response
        self._right += (right - self._right) * self._response
        if left == 0.0 and abs(self._left) < _STANDSTILL_MPS:
            self._left = 0.0
        if right == 0.0 and abs(self._right) < _STANDSTILL_MPS:
            self._right = 0.0

    def _slips(self) -> tuple[float, float]:
        """Returns the distance by which the left and the right wheel move the body, per metre of rotation."""
        noise, number = self._realism.wheel_noise, self.tick_number
        left, right = (
            bias + noise * source.normal(number)
            for bias, source in zip(self._biases, self._noises, strict=True)
        )
        return left, right

    def _count(self, slips: tuple[float, float]) -> None:
        """Adds the rotation of the wheels since the last tick to the odometry."""
        x0, y0, yaw0 = self._pose
        x, y, yaw = self._pose = self._simulator.state()[:3]
        middle, turned = (yaw0 + yaw) / 2.0, yaw - yaw0
        ahead = (x - x0) * math.cos(middle) + (y - y0) * math.sin(middle)
        left = (ahead - turned * self._half_track) / slips[0]
        right = (ahead + turned * self._half_track) / slips[1]
        ahead, turned = (left + right) / 2.0, (right - left) / 2.0 / self._believed_half_track
        odo_x, odo_y, odo_yaw = self.odometry
        middle = odo_yaw + turned / 2.0
        self.odometry = (
            odo_x + ahead * math.cos(middle),
            odo_y + ahead * math.sin(middle),
            odo_yaw + turned,
        )
        self.speed = (ahead / TICK_S, turned / TICK_S)


class MeasurementNoise:
    """Adds noise to measurements, with new random numbers at every tick."""

    def __init__(self, seed: int, realism: Realism = REALISTIC) -> None:
        self._realism = realism
        self._pose, self._sonar, self._lidar = (
            Noise(seed, channel) for channel in (_POSE, _SONAR, _LIDAR)
        )

    def pose(self, tick: int, pose: Pose) -> Pose:
        """Returns an externally measured pose (m, rad). At tick 0 it is exact: the robot is placed on a known mark."""
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
        """Returns a distance (m) as sonar `index` measures it; the result may exceed the sonar's range."""
        return distance_m * (1.0 + self._realism.sonar_noise * self._sonar.normal(tick, index))

    def lidar(self, tick: int, angle_rad: float, distance_m: float) -> float:
        """Returns a distance (m) as the scanner measures it at an angle; each half degree has its own noise."""
        beam = round(math.degrees(angle_rad) * 2.0) % 720
        return distance_m + self._realism.lidar_noise_m * self._lidar.normal(tick, beam)
