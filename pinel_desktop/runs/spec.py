"""A run as one value (`RunSpec`): everything that determines what happens in the run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, Protocol

from pinel_desktop.execution.inputs import Inputs, ScriptedInputs
from pinel_desktop.execution.semantics import CURRENT
from pinel_desktop.robot import SimulationConfig, simulation_config_from

if TYPE_CHECKING:  # a slow import, which the app's start avoids
    from pinel_desktop.execution.control import RunControl
    from pinel_desktop.execution.executor import Observer
    from pinel_desktop.program.model import Program
    from pinel_desktop.robot.robot_profile import RobotProfile

Pace = Literal["live", "max"]
Document = dict[str, Any] | list[Any]
# reasons of runs that ended by a failure of PINEL or of the PC, not of the program; their record is
# incomplete
INTERRUPTED_REASONS = ("interrupted", "engine_lost", "real_engine_lost", "internal_error")


class RunInputs(Inputs, Protocol):
    """Inputs that may also make requests: a recorded run's inputs replay its pauses and its stop."""

    def attach(self, control: RunControl) -> Observer | None:
        """Returns the observer that must receive the run's events, or None. Called once, before the run starts."""
        ...


@dataclass(frozen=True, slots=True)
class RunSpec:
    """Everything that determines a run; `runs.start.start` executes it.

    On a simulated link, the same spec gives the same run, tick by tick. A replay starts the spec of a recorded run
    with `RecordedInputs`.

    Attributes:
        document: the program document.
        world: name or document of the simulator's world, or of the room in which a real robot drives.
        link: name of the robot link (`links.LINK_NAMES`).
        robot: profile of a real robot: its connection and its limits; None for the simulator.
        setting: robot model, realism of the simulation, and source of the robot's pose.
        seed: seed of the run's random numbers.
        inputs: source of capture results and of answers to questions.
        pace: `live` paces ticks in real time, `max` does not pace them; a real robot's run is always live.
        semantics: version of the meaning of commands and sensors (`execution.semantics`).
        program: `document` if it was read before; `start` then does not read it again.
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
        """Returns plain JSON data for the engine's process. Lacks the inputs, because they are live there."""
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
    """Returns the spec of an engine message.

    Raises PinelError `run_damaged` for an invalid setting, and what `profile_from` raises for the robot.
    """
    robot = message["robot"] and _profile_from(message["robot"])
    setting = simulation_config_from(message["setting"])
    return RunSpec(**{**message, "setting": setting, "robot": robot}, inputs=inputs)


def _profile_from(message: Mapping[str, Any]) -> RobotProfile:
    from pinel_desktop.robot.robot_profile import profile_from  # noqa: PLC0415 - for real robots only

    return profile_from(message)
