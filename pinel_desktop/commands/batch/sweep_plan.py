"""The runs of a sweep, as the options of `pinel sweep` say."""

import hashlib
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from pinel_desktop.activities import Activity, choose_activity
from pinel_desktop.activities.faults import require_fulfillable
from pinel_desktop.commands.batch.parameter_ranges import chosen_ranges
from pinel_desktop.commands.batch.robot_parameters import chosen_parameters
from pinel_desktop.commands.program_file import read_file
from pinel_desktop.commands.typed_inputs import typed_answers, typed_gestures
from pinel_desktop.commands.world_file import choose_world
from pinel_desktop.errors import PinelError
from pinel_desktop.processes.versions import versions
from pinel_desktop.program.faults import Fault
from pinel_desktop.robot import Feedback, Preset, RobotModel, SimulationConfig
from pinel_desktop.runs.fixed_inputs import FixedInputs
from pinel_desktop.runs.robot_checks import missing_on_model
from pinel_desktop.sweep import Job, make_jobs, worlds_of
from pinel_desktop.sweep.jobs import Named
from pinel_desktop.sweep.variation import ParameterRange, varied

_WORLD = "empty_room"


class ProgramFileError(PinelError):
    """A program file with faults."""

    def __init__(self, path: str, faults: Sequence[Fault]) -> None:
        super().__init__("sweep_program", path=path, count=len(faults))
        self.faults = tuple(faults)


@dataclass(frozen=True, slots=True)
class SweepPlan:
    """Everything that decides the rows of a sweep.

    Attributes:
        inputs: what all runs read; None for what the activity gives.
        ranges: parameters that differ from seed to seed.
    """

    programs: Sequence[Named]
    worlds: Sequence[Named]
    activity: Activity | None
    setting: SimulationConfig
    n_seeds: int
    ranges: Sequence[ParameterRange]
    inputs: FixedInputs | None

    @property
    def n_runs(self) -> int:
        return len(self.programs) * len(self.worlds) * self.n_seeds

    def jobs(self) -> Iterator[Job]:
        """Yields the jobs in their order."""
        seeds = range(self.n_seeds)
        activity, inputs = self.activity, self.inputs
        jobs = make_jobs(
            self.programs, self.worlds, self.setting, seeds, inputs=inputs, activity=activity
        )
        return varied(jobs, self.ranges) if self.ranges else jobs

    @property
    def fingerprint(self) -> str:
        """Hash of the plan and of the versions that run it: plans with equal ones have equal rows."""
        activity = self.activity and self.activity.model_dump(mode="json")
        parts = (
            versions(),
            self.programs,
            self.worlds,
            activity,
            self.setting.as_parameters(),
            self.n_seeds,
            self.ranges,
            self.inputs and self.inputs.as_message(),
        )
        return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def planned(
    programs: Sequence[str],
    *,
    activity: str | None,
    worlds: Sequence[str],
    seeds: int,
    vary: Sequence[str],
    gestures: str,
    answers: Sequence[str],
    **robot: Any,
) -> SweepPlan:
    """Returns the plan of the options, named as those of `pinel sweep`.

    Raises:
        PinelError: what an option says cannot be run; errors of files have their faults.
    """
    judge = choose_activity(activity) if activity is not None else None
    if judge is not None:
        require_fulfillable(judge)
    setting = _setting(judge, **robot)
    ranges = chosen_ranges(vary, setting.parameters)
    if setting.preset == "ideal" and ranges:
        raise PinelError("robot_parameters_ideal")
    documents = [(file, _document(file, setting.robot)) for file in programs]
    places = _worlds(worlds, judge, setting)
    inputs = _inputs(gestures, answers)
    plan = SweepPlan(documents, places, judge, setting, seeds, ranges, inputs)
    next(plan.jobs())  # names what does not suit the activity, before the journal begins
    return plan


def _setting(
    activity: Activity | None,
    *,
    robot: str | None,
    preset: Preset,
    feedback: Feedback | None,
    parameters: Sequence[str],
) -> SimulationConfig:
    """Returns the simulated robot; that of the activity where an option is missing."""
    usual = SimulationConfig(activity.model, preset, activity.feedback) if activity else None
    usual = usual or SimulationConfig(preset=preset)
    return SimulationConfig(
        robot or usual.model, preset, feedback or usual.feedback, chosen_parameters(parameters)
    )


def _inputs(gestures: str, answers: Sequence[str]) -> FixedInputs | None:
    """Returns what the options say; None without them."""
    if not gestures and not answers:
        return None
    return FixedInputs(tuple(typed_gestures(gestures)), tuple(typed_answers(answers)))


def _document(file: str, model: RobotModel) -> dict[str, Any]:
    reading = read_file(file)
    faults = reading.faults or missing_on_model(reading.document, model)
    if faults or reading.document is None:
        raise ProgramFileError(file, faults)
    return reading.document


def _worlds(
    typed: Sequence[str], activity: Activity | None, setting: SimulationConfig
) -> list[Named]:
    if activity is not None and not typed:
        return worlds_of(activity)
    chosen = [choose_world(one, robot=setting.model) for one in typed or (_WORLD,)]
    return [(one.name, one.document) for one in chosen]
