"""The simulation configuration of a run: robot model, realism, pose feedback."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

from pinel_desktop.errors import PinelError
from pinel_desktop.robot.models import PIONEER_3DX, ROBOTS, RobotModel
from pinel_desktop.robot.robot_parameters import RobotParameters, robot_parameters_from

Preset = Literal["ideal", "realistic"]
Feedback = Literal["pose", "odometry"]
PRESETS: tuple[Preset, ...] = get_args(Preset)
FEEDBACKS: tuple[Feedback, ...] = get_args(Feedback)
_NAMES = ("model", "preset", "feedback")
_UNCHANGED = RobotParameters()
_PARAMETERS = "robot_parameters"  # "robot" is the record of a real one


@dataclass(frozen=True, slots=True)
class SimulationConfig:
    """The simulation configuration of a run; recorded with the run, so that verification can repeat it.

    Attributes:
        model: name of the robot's model in ROBOTS.
        preset: noise, slip and latency of the simulator.
        feedback: source of the robot's pose. `pose` is the measurement of a camera above the floor, with noise of 1 mm
            and 0.1 degrees; `odometry` is wheel odometry. With the preset `ideal` both are exact.
        parameters: in what the robot differs from its model and from the preset `realistic`. An ideal robot has none.
    """

    model: str = PIONEER_3DX.name
    preset: Preset = "ideal"
    feedback: Feedback = "pose"
    parameters: RobotParameters = _UNCHANGED

    def __post_init__(self) -> None:
        """Raises PinelError `robot_parameters_ideal` for an ideal robot with parameters."""
        if self.preset == "ideal" and self.parameters.changes:
            raise PinelError("robot_parameters_ideal")

    @property
    def robot(self) -> RobotModel:
        """The robot's model. Raises PinelError `unknown_robot`."""
        if self.model not in ROBOTS:
            raise PinelError("unknown_robot", value=self.model, allowed=list(ROBOTS))
        return ROBOTS[self.model]

    def as_parameters(self) -> dict[str, Any]:
        """Returns plain JSON data for the run's record and the engine's messages."""
        changes = self.parameters.changes
        return {
            "model": self.model,
            "preset": self.preset,
            "feedback": self.feedback,
            **({_PARAMETERS: changes} if changes else {}),
        }


def simulation_config_from(parameters: Mapping[str, Any]) -> SimulationConfig:
    """Reads the configuration from a run's parameters.

    A missing parameter gets its default, the fixed value of earlier releases. Raises PinelError `run_damaged` for
    invalid parameters.
    """
    known = {name: parameters[name] for name in _NAMES if name in parameters}
    try:
        changes = robot_parameters_from(parameters.get(_PARAMETERS, {}))
        setting = SimulationConfig(**known, parameters=changes)
    except (PinelError, AttributeError) as error:  # AttributeError: no mapping
        raise PinelError("run_damaged", part="parameters") from error
    if (
        not isinstance(setting.model, str)
        or setting.preset not in PRESETS
        or setting.feedback not in FEEDBACKS
    ):
        raise PinelError("run_damaged", part="parameters")
    return setting
