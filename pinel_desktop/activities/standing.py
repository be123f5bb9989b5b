"""How a run that goes on stands with the checks of its activity: the code of the verdict, asked again and again."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from pinel_desktop.activities import check_kinds as kinds
from pinel_desktop.activities.check_kinds import Slack
from pinel_desktop.activities.checking import find_on_robot, limited
from pinel_desktop.activities.checks import Finding
from pinel_desktop.activities.criteria import criterion_of, measured_of
from pinel_desktop.activities.evidence import Evidence, RunLog
from pinel_desktop.activities.model import Activity
from pinel_desktop.activities.recorded import (
    begins_like,
    case_of_real_run,
    case_of_run,
    cases_in,
    obstacles,
)
from pinel_desktop.robot import Setting
from sim.world import world_from_document

State = Literal["open", "met", "broken"]

# where the robot is tells nothing before it has been elsewhere
_ABOUT_THE_END = (kinds.EndsAt, kinds.EndsHeading, kinds.EndsIn, kinds.Closed)


@dataclass(frozen=True, slots=True)
class Standing:
    """How a run stands with one check, in one language.

    Attributes:
        criterion: what counts.
        measured: how far the run is; "" where a number says nothing more.
        state: `met` while it holds, `open` while it does not hold yet, `broken` where this run will not fulfil it.
    """

    criterion: str
    measured: str
    state: State


def standings_before(activity: Activity, language: str) -> list[Standing]:
    """The check list before a run; of several cases what all of them share."""
    checks = [*activity.checks, *(activity.cases[0].checks if len(activity.cases) == 1 else ())]
    return [Standing(criterion_of(check, language), "", "open") for check in checks]


class RunStanding:
    """Follows one run of a program that is to solve an activity.

    Args:
        document: the program in its normal form.
        world, setting: of the run.
        slack: how exactly the robot drives; None for the simulator's.

    Raises:
        PinelError: what `activities.world_of` raises.
    """

    def __init__(
        self,
        activity: Activity,
        document: Mapping[str, Any],
        world: Mapping[str, Any],
        setting: Setting,
        slack: Slack | None = None,
    ) -> None:
        self._activity, self._document = activity, document
        self._world_document, self._setting = world, setting
        self._slack = slack
        self._cases = _cases(activity, world, setting, slack)
        self._world = world_from_document(dict(world)) if self._cases else None
        self._did_not_hold: set[int] = set()  # ids of checks

    @property
    def is_of_activity(self) -> bool:
        """Whether the activity's checks are about the run.

        In the simulator it must have world, start and robot of the activity; a real robot tells all that the checks
        need, or none of them is followed.
        """
        return bool(self._cases)

    def of(self, log: RunLog, language: str) -> list[Standing]:
        """The check list after all that the run has told so far."""
        assert self._world is not None
        if self._slack is None:
            log = limited(log, self._activity.limit_s)
        evidence = Evidence(self._document, self._world, log)
        return [
            self._standing(check, find_on_robot(check, evidence, self._slack), log, language)
            for check in self._checks(log)
        ]

    def _checks(self, log: RunLog) -> list[kinds.Check]:
        """Those of the activity, and those of the case as soon as it is known which one the run is."""
        if log.is_over:
            number = self._case(log)
            numbers = [] if number is None else [number]
        else:
            numbers = [n for n in self._cases if begins_like(self._activity.cases[n - 1], log)]
        own = self._activity.cases[numbers[0] - 1].checks if len(numbers) == 1 else []
        return [*self._activity.checks, *own]

    def _case(self, log: RunLog) -> int | None:
        if self._slack:
            return case_of_real_run(self._activity, log)
        return case_of_run(self._activity, self._world_document, self._setting, log)

    def _standing(
        self, check: kinds.Check, finding: Finding, log: RunLog, language: str
    ) -> Standing:
        state = self._state(check, finding, is_over=log.is_over)
        measured = "" if state == "open" and finding.holds else measured_of(finding, language)
        return Standing(criterion_of(check, language), measured, state)

    def _state(self, check: kinds.Check, finding: Finding, *, is_over: bool) -> State:
        if is_over:
            return "met" if finding.holds else "broken"
        if finding.is_lost:
            return "broken"
        if not finding.holds:
            self._did_not_hold.add(id(check))
            return "open"
        is_early = isinstance(check, _ABOUT_THE_END) and id(check) not in self._did_not_hold
        return "open" if is_early else "met"


def _cases(
    activity: Activity, world: Mapping[str, Any], setting: Setting, slack: Slack | None
) -> list[int]:
    """Numbers from 1 of the cases that the run may be."""
    if slack is None:
        return cases_in(activity, world, setting)
    return [] if obstacles(activity) else list(range(1, len(activity.cases) + 1))
