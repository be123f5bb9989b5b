"""Parameters in which a simulated robot differs from its model and from the preset `realistic`."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from pinel_desktop.errors import PinelError

# Lowest and highest value of each parameter. Together they let no wheel roll backwards: the noise of a
# wheel is at most 3.47 standard deviations (`sim.noise`).
BOUNDS: dict[str, tuple[float, float]] = {
    "track_m": (0.05, 1.0),
    "wheel_bias_left": (-0.2, 0.2),
    "wheel_bias_right": (-0.2, 0.2),
    "wheel_bias_sd": (0.0, 0.05),
    "wheel_noise": (0.0, 0.15),
    "lag_s": (0.001, 1.0),
    "latency_s": (0.0, 1.0),
    "pose_noise_m": (0.0, 0.5),
    "pose_noise_rad": (0.0, 0.5),
    "sonar_noise": (0.0, 0.5),
    "lidar_noise_m": (0.0, 0.5),
}


@dataclass(frozen=True, slots=True)
class RobotParameters:
    """The true parameters of one simulated robot, in SI units; None is the value of model and preset.

    They change what the physics and the sensors do, not what the robot believes: controller and wheel odometry keep
    the model's track, wheels of equal size and the preset's delay, as on a real robot that nobody measured. A robot
    with a greater track than its model therefore turns less than it reports.

    Attributes:
        track_m: distance between the wheels.
        wheel_bias_left, wheel_bias_right: relative error of a wheel's distance, constant; 0.01 is a wheel whose radius
            is 1 % greater than the model's.
        wheel_bias_sd: standard deviation of a further such error, drawn for each wheel and each run.
        wheel_noise, lag_s, latency_s, pose_noise_m, pose_noise_rad, sonar_noise, lidar_noise_m: as in
            `sim.realistic.Realism`.
    """

    track_m: float | None = None
    wheel_bias_left: float | None = None
    wheel_bias_right: float | None = None
    wheel_bias_sd: float | None = None
    wheel_noise: float | None = None
    lag_s: float | None = None
    latency_s: float | None = None
    pose_noise_m: float | None = None
    pose_noise_rad: float | None = None
    sonar_noise: float | None = None
    lidar_noise_m: float | None = None

    @property
    def changes(self) -> dict[str, float]:
        """The given parameters, by name."""
        values = ((field.name, getattr(self, field.name)) for field in fields(self))
        return {name: value for name, value in values if value is not None}


def robot_parameters_from(values: Mapping[str, Any]) -> RobotParameters:
    """Reads parameters by name.

    Raises PinelError `unknown_robot_parameter`, `robot_parameter_range` for a value that is no number or out of bounds.
    """
    for name, value in values.items():
        if name not in BOUNDS:
            raise PinelError("unknown_robot_parameter", value=name, allowed=list(BOUNDS))
        low, high = BOUNDS[name]
        if not _is_number(value) or not low <= value <= high:
            raise PinelError("robot_parameter_range", name=name, value=value, low=low, high=high)
    return RobotParameters(**{name: float(value) for name, value in values.items()})


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
