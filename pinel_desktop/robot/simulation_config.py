"""The robot setting of a simulated run: model, realism, pose feedback."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal, get_args

from pinel_desktop.errors import PinelError
from pinel_desktop.robot.models import PIONEER_3DX, ROBOTS, RobotModel

Preset = Literal["ideal", "realistic"]
Feedback = Literal["pose", "odometry"]
PRESETS: tuple[Preset, ...] = get_args(Preset)
FEEDBACKS: tuple[Feedback, ...] = get_args(Feedback)


@dataclass(frozen=True, slots=True)
class SimulationConfig:
    """The robot setting of a run; recorded with the run, so that verification can repeat it.

    Attributes:
        model: name of the robot's record in ROBOTS.
        preset: noise, slip and latency of the simulator.
        feedback: source of the robot's pose: what a camera above the floor measures, with noise of 1 mm and 0.1
            degrees, or wheel odometry. With the preset `ideal` both are exact.
    """

    model: str = PIONEER_3DX.name
    preset: Preset = "ideal"
    feedback: Feedback = "pose"

    @property
    def robot(self) -> RobotModel:
        """The record of the robot. Raises PinelError `unknown_robot`."""
        if self.model not in ROBOTS:
            raise PinelError("unknown_robot", value=self.model, allowed=list(ROBOTS))
        return ROBOTS[self.model]

    def as_parameters(self) -> dict[str, Any]:
        """Plain JSON data for the run's record and the engine's messages."""
        return asdict(self)


def simulation_config_from(parameters: Mapping[str, Any]) -> SimulationConfig:
    """The setting in a run's parameters; missing ones have the values of releases that had no choice.

    Raises PinelError `run_damaged` for invalid parameters.
    """
    known = {name: parameters[name] for name in SimulationConfig.__slots__ if name in parameters}
    setting = SimulationConfig(**known)
    if (
        not isinstance(setting.model, str)
        or setting.preset not in PRESETS
        or setting.feedback not in FEEDBACKS
    ):
        raise PinelError("run_damaged", part="parameters")
    return setting
