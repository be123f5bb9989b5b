"""A run as one value: everything that decides what happens in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, Protocol

from pinel_desktop.execution.inputs import Inputs, ScriptedInputs
from pinel_desktop.execution.semantics import CURRENT
from pinel_desktop.robot import SimulationConfig, simulation_config_from

if TYPE_CHECKING:  # heavy, and the app starts without it
    from pinel_desktop.execution.control import RunControl
    from pinel_desktop.execution.executor import Observer
    from pinel_desktop.program.model import Program
    from pinel_desktop.robot.robot_profile import RobotProfile

Pace = Literal["live", "max"]
Document = dict[str, Any] | list[Any]
# reasons of runs that PINEL or the PC lost: their record breaks off, and the program has no part in it
INTERRUPTED_REASONS = ("interrupted", "engine_lost", "real_engine_lost", "internal_error")


class RunInputs(Inputs, Protocol):
    """Inputs that may also make requests: those of a recorded run bring its pauses and its Stop."""

    def attach(self, control: RunControl) -> Observer | None:
        """Called once before the run begins; returns what must observe the run, or None."""
        ...


@dataclass(frozen=True, slots=True)
class RunSpec:
    """What is run, on what, and where its inputs come from; `runs.start.start` executes it.

    The same spec gives the same run, tick by tick, on a simulated link. Replaying a recorded run is starting its spec
    with `RecordedInputs`.

    Attributes:
        document: the program document.
        world: name or document of the simulator's world, or of the room that a real robot drives in.
        link: name of the robot link (`links.LINK_NAMES`).
        robot: how the link reaches its robot, and what it may do; None for the simulator.
        setting: the robot, how it is simulated and what it knows of its pose.
        seed: of the run's random numbers.
        inputs: where results of captures and answers to questions come from.
        pace: `live` for ticks in real time, `max` for as fast as they can; a real robot runs live only.
        semantics: version of what commands and sensors mean (`execution.semantics`).
        program: `document` when it has been read before, which spares `start` the reading.
    """

    document: Document
    world: str | dict[str, Any]
    link: str = "sim"
    robot: RobotProfile | None = None
    setting: SimulationConfig = field(default_factory=SimulationConfig)
    seed: int = 0
    inputs: RunInputs = field(default_factory=ScriptedInputs)
    pace: Pace = "max"
    semantics: int = CURRENT
    program: Program | None = field(default=None, compare=False)

    def as_message(self) -> dict[str, Any]:
        """Plain JSON data for the engine's process, without the inputs, which are live there."""
        return {
            "document": self.document,
            "world": self.world,
            "link": self.link,
            "robot": self.robot and self.robot.as_message(),
            "setting": self.setting.as_parameters(),
            "seed": self.seed,
            "pace": self.pace,
            "semantics": self.semantics,
        }


def spec_from(message: Mapping[str, Any], inputs: RunInputs) -> RunSpec:
    """The spec of a message.

    Raises PinelError `run_damaged` for a setting that never was one, and what `record_from` raises for the robot.
    """
    robot = message["robot"] and _profile_from(message["robot"])
    setting = simulation_config_from(message["setting"])
    return RunSpec(**{**message, "setting": setting, "robot": robot}, inputs=inputs)


def _profile_from(message: Mapping[str, Any]) -> RobotProfile:
    from pinel_desktop.robot.robot_profile import profile_from  # noqa: PLC0415 - for real robots only

    return profile_from(message)
