"""Supports teachers who make an activity: proposes checks for a sample solution, and tries the activity's checks."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from pinel_desktop.activities.checking import check_program, run_case
from pinel_desktop.activities.checks import KINDS
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity
from pinel_desktop.program.reading import ParseResult, read_document
from pinel_desktop.robot import Preset
from sim.world import world_from_document

_EMPTY: Mapping[str, Any] = {"pinel_ir": 1, "name": "", "functions": [], "commands": []}

Who = Literal["solution", "empty"]


@dataclass(frozen=True, slots=True)
class Proposal:
    """Initial values of the teacher's form for a sample solution, which the ideal robot ran.

    Attributes:
        finished: the solution ended by itself and without a failure.
        zones: names of the zones of the world.
        checks: one check of each kind that is of use for this solution, in the format of an activity.
    """

    finished: bool
    zones: list[str]
    checks: list[dict[str, Any]]


def proposal_for(activity: Activity, solution: ParseResult) -> Proposal:
    """Runs a program without faults in the activity's first case.

    Raises:
        PinelError: what `world_of` raises.
    """
    assert solution.document is not None
    case = activity.cases[0]
    world, log = world_from_document(world_of(activity, case)), run_case(activity, case, solution)
    evidence = Evidence(solution.document, world, log)
    proposed = {name: kind.proposed(evidence) for name, kind in KINDS.items()}
    return Proposal(
        finished=evidence.log.ended["state"] == "finished",
        zones=[zone.name for zone in world.zones],
        checks=[
            {"check": name, **values} for name, values in proposed.items() if values is not None
        ],
    )


@dataclass(frozen=True, slots=True)
class Trial:
    """Result of the checks for one program and one robot.

    Attributes:
        preset: `ideal`, or `realistic` with the pose of a camera.
        texts: the reason why the program does not pass, by language; empty if it passes.
    """

    program: Who
    preset: Preset
    passed: bool
    texts: Mapping[str, str]

    @property
    def is_right(self) -> bool:
        """Whether the result is as expected: the solution passes, the program without commands does not."""
        return self.passed == (self.program == "solution")


def trials(activity: Activity, presets: tuple[Preset, ...] = ("ideal", "realistic")) -> list[Trial]:
    """Checks the activity's own solution and a program without commands, with each robot.

    Raises:
        PinelError: what `world_of` raises.
    """
    programs: dict[Who, Mapping[str, Any]] = {
        "solution": activity.solution or _EMPTY,
        "empty": _EMPTY,
    }
    return [
        _trial(activity, who, document, preset)
        for preset in presets
        for who, document in programs.items()
    ]


def _trial(activity: Activity, who: Who, document: Mapping[str, Any], preset: Preset) -> Trial:
    tried = activity.model_copy(update={"preset": preset, "feedback": "pose"})
    report = check_program(tried, read_document(dict(document)))
    texts = report.advice.words if report.advice else {}
    return Trial(who, preset, report.passed, texts)
