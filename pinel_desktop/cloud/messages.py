"""Requests of the app to the process of the clouds, as plain data for JSON lines."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from types import MappingProxyType
from typing import Any

from pinel_desktop.robot import SimulationConfig, robot_parameters_from
from pinel_desktop.runs.fixed_inputs import FixedInputs

N_ROBOTS = 50
STOP = "cloud_stop"


@dataclass(frozen=True, slots=True)
class CloudRequest:
    """A program to be driven by `N_ROBOTS` robots, each with the slip of its own seed.

    Attributes:
        cloud: id of the cloud.
        document: the program's document.
        world: the world's document with the start of the robot.
        model: name of the robot's model.
        robot_parameters: the errors of a calibrated robot; empty for the preset's.
        activity: the activity as JSON with one case, by which it judges each run; None without one.
        case: what this case gives to the program, as text; "" without an activity, or if it has one case only.
        inputs: what the program reads.
        language: language of the sentence for the group.
    """

    cloud: str
    document: Mapping[str, Any]
    world: Mapping[str, Any]
    model: str
    robot_parameters: Mapping[str, float]
    activity: str | None
    case: str
    inputs: FixedInputs
    language: str

    def as_message(self) -> dict[str, Any]:
        """Returns the request as plain data."""
        return {"type": "cloud_begin", **asdict(self)}

    @classmethod
    def from_message(cls, message: Mapping[str, Any]) -> "CloudRequest":
        """Reads the request from plain data."""
        parts = {name: message[name] for name in cls.__slots__}
        return cls(**{**parts, "inputs": FixedInputs.from_message(message["inputs"])})

    @property
    def setting(self) -> SimulationConfig:
        """The setting of all robots of clouds."""
        return cloud_setting(self.model, self.robot_parameters)


def cloud_setting(
    model: str, robot_parameters: Mapping[str, float] = MappingProxyType({})
) -> SimulationConfig:
    """Returns the realistic robot, which knows its pose by its wheels only, as a real one without a camera above it."""
    parameters = robot_parameters_from(robot_parameters)
    return SimulationConfig(model, "realistic", "odometry", parameters)
