"""The check list of a live run: evaluates the checks repeatedly, as for the verdict."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from pinel_desktop.activities.checking import evaluate, in_time
from pinel_desktop.activities.checks import Check
from pinel_desktop.activities.checks.base import CheckResult, RealRobotTolerance
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.activities.model import Activity
from pinel_desktop.activities.recorded import (
    begins_like,
    case_of_real_run,
    case_of_run,
    cases_in,
    judging_blockers,
)
from pinel_desktop.activities.run_log import RunLog
from pinel_desktop.robot import SimulationConfig
from sim.world import World, world_from_document

State = Literal["open", "met", "broken"]


@dataclass(frozen=True, slots=True)
class CheckStatus:
    """The status of one check of a run, in one language.

    Attributes:
        criterion: the criterion as an instruction.
        measured: the progress of the run; "" if a number adds nothing.
        state: `met` while it passes, `open` while it does not pass yet, `broken` if this run cannot fulfil it any
            more.
    """

    criterion: str
    measured: str
    state: State


def initial_check_list(activity: Activity, language: str) -> list[CheckStatus]:
    """Returns the check list before a run; of several cases, only the common checks."""
    checks = [*activity.checks, *(activity.cases[0].checks if len(activity.cases) == 1 else ())]
    return [CheckStatus(check.line(language), "", "open") for check in checks]


class LiveEvaluation:
    """Evaluates the checks of an activity for one live run.

    Args:
        document: the program in its normal form.
        world, setting: world document and robot setting of the run.
        tolerance: tolerance for a real robot; None for the simulator.

    Raises:
        PinelError: what `activities.world_of` raises.
    """

    def __init__(
        self,
        activity: Activity,
        document: Mapping[str, Any],
        world: Mapping[str, Any],
        setting: SimulationConfig,
        tolerance: RealRobotTolerance | None = None,
    ) -> None:
        self._activity, self._document = activity, document
        self._world, self._setting = world, setting
        self._tolerance = tolerance
        self._cases = self._possible_cases()
        self._has_failed: set[int] = set()  # ids of checks

    @property
    def applies(self) -> bool:
        """Whether the activity's checks apply to the run.

        A simulated run must have the world, start and robot of the activity. A run on a real robot must provide the
        data of all checks.
        """
        return bool(self._cases)

    def evaluate(self, log: RunLog, language: str) -> list[CheckStatus]:
        """Returns the check list for all events of the run so far."""
        log = in_time(log, self._activity, self._tolerance)
        evidence = Evidence(self._document, self._floor, log)
        return [
            self._status(check, evaluate(check, evidence, self._tolerance), log, language)
            for check in self._checks(log)
        ]

    @cached_property
    def _floor(self) -> World:
        return world_from_document(dict(self._world))

    def _possible_cases(self) -> list[int]:
        """Returns the numbers, from 1, of the cases that the run may be."""
        if self._tolerance is None:
            return cases_in(self._activity, self._world, self._setting)
        all_cases = range(1, len(self._activity.cases) + 1)
        return [] if judging_blockers(self._activity) else list(all_cases)

    def _checks(self, log: RunLog) -> list[Check]:
        """Returns the activity's checks, and the case's own checks once the case of the run is known."""
        cases = self._activity.cases
        if log.is_over:
            number = self._case(log)
            numbers = [] if number is None else [number]
        else:
            numbers = [n for n in self._cases if begins_like(cases[n - 1], log)]
        own = cases[numbers[0] - 1].checks if len(numbers) == 1 else []
        return [*self._activity.checks, *own]

    def _case(self, log: RunLog) -> int | None:
        if self._tolerance:
            return case_of_real_run(self._activity, log)
        return case_of_run(self._activity, self._world, self._setting, log)

    def _status(self, check: Check, result: CheckResult, log: RunLog, language: str) -> CheckStatus:
        state = self._state(check, result, is_over=log.is_over)
        is_early = state == "open" and result.passed
        measured = "" if is_early else result.progress_text(language)
        return CheckStatus(check.line(language), measured, state)

    def _state(self, check: Check, result: CheckResult, *, is_over: bool) -> State:
        if is_over:
            return "met" if result.passed else "broken"
        if result.is_irrecoverable:
            return "broken"
        if not result.passed:
            self._has_failed.add(id(check))
            return "open"
        is_early = check.is_about_end and id(check) not in self._has_failed
        return "open" if is_early else "met"
