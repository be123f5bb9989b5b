"""Judges a program: runs each case of an activity, or uses a recorded run of the case, and evaluates every check."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pinel_desktop.activities.checks import Check
from pinel_desktop.activities.checks.base import CheckResult, RealRobotTolerance, Value
from pinel_desktop.activities.diagnosis import Advice, Facts, advice_of, fits
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity, Case
from pinel_desktop.activities.run_log import RunLog, RunLogBuilder
from pinel_desktop.activities.wording import TextByLanguage, texts_of
from pinel_desktop.events.model import Event
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.execution.limits import StepLimit
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.reading import ParseResult
from pinel_desktop.robot import Pose2D, SimulationConfig
from pinel_desktop.runs.spec import INTERRUPTED_REASONS, RunSpec
from pinel_desktop.runs.start import start
from sim.world import world_from_document

# a busy loop reaches these limits after 10 s of robot time at rest, and after 33 s in all; a
# program that passes an activity takes some thousand steps
STEP_LIMIT = StepLimit(at_rest=300_000, total=1_000_000)
_REST_S = 1.0  # time in which the robot comes to rest after a stop at the time limit
_NO_PARAMS: dict[str, Any] = {"check": True, "label": True, "checks": {"__all__": {"label"}}}


@dataclass(frozen=True, slots=True)
class CheckReport:
    """Result of one check.

    Attributes:
        kind, params: kind and parameters of the check.
        measured, target: in the unit of the check: m, degrees, s, a number or a name.
        block, pointer: id of the block to look at, and JSON pointer of its command; None without one.
        words: message about a check that does not hold, by language.
    """

    kind: str
    params: dict[str, Any]
    holds: bool
    measured: Value
    target: Value
    block: str | None
    pointer: str | None
    words: TextByLanguage


@dataclass(frozen=True, slots=True)
class CaseReport:
    """Result of one run of the program; `reason` is `too_long` if the run exceeded the activity's time limit.

    Attributes:
        case: number of the case, from 1.
        recorded: whether the group watched this run; other runs were executed for the checks.
        advice: advice about this run alone; None if it passes.
    """

    state: str
    reason: str | None
    params: dict[str, Any]
    duration_s: float
    telemetry_sha256: str | None
    checks: tuple[CheckReport, ...]
    case: int = 1
    recorded: bool = False
    advice: Advice | None = None

    @property
    def passed(self) -> bool:
        return bool(self.checks) and all(check.holds for check in self.checks)


@dataclass(frozen=True, slots=True)
class Report:
    """Result of one program. A program with faults is not run and has no cases."""

    program: str
    faults: tuple[Fault, ...]
    cases: tuple[CaseReport, ...]

    @property
    def passed(self) -> bool:
        """True if the program passes the activity."""
        return not self.faults and bool(self.cases) and all(case.passed for case in self.cases)

    @property
    def advice(self) -> Advice | None:
        """The only advice to show: the first diagnosis that fits a run, else the first check that fails."""
        found = [case.advice for case in self.cases if case.advice is not None]
        return min(found, key=_rank, default=None)


def _rank(advice: Advice) -> float:
    return float("inf") if advice.diagnosis is None else advice.diagnosis


@dataclass(frozen=True, slots=True)
class RecordedRun:
    """A run that the group watched.

    Attributes:
        log: all events of the run.
        case: number of the run's case, from 1.
        tolerance: tolerance for a real robot; None for the simulator.
    """

    log: RunLog
    case: int = 1
    tolerance: RealRobotTolerance | None = None


def check_program(
    activity: Activity,
    reading: ParseResult,
    program: str = "",
    recorded: RecordedRun | None = None,
    on_run: Callable[[int, RunLog], object] = lambda case, log: None,
) -> Report:
    """Runs a program in each case of the activity.

    Args:
        program: name of the program in the report.
        recorded: a recorded run of one case, which is judged instead of a new run of that case.
        on_run: called with the number and the run of each case.

    Raises:
        PinelError: `unknown_robot`, or what `world_of` raises.
    """
    if reading.program is None or reading.document is None:
        return Report(program, reading.faults, ())
    reports = []
    for number, case in enumerate(activity.cases, 1):
        recorded_run = recorded if recorded and recorded.case == number else None
        log = recorded_run.log if recorded_run else run_case(activity, case, reading)
        on_run(number, log)
        tolerance = recorded_run.tolerance if recorded_run else None
        is_recorded, document = recorded_run is not None, reading.document
        reports.append(
            judge_run(activity, number, document, log, recorded=is_recorded, tolerance=tolerance)
        )
        if reports[-1].reason == "too_busy":
            break  # the program would not end in the other cases either
    return Report(program, (), tuple(reports))


def spec_of(activity: Activity, case: Case, reading: ParseResult) -> RunSpec:
    """Returns the spec of a program without faults in a case. Raises what `world_of` raises."""
    assert reading.program is not None
    assert reading.document is not None
    return RunSpec(
        document=reading.document,
        world=world_of(activity, case),
        setting=SimulationConfig(activity.model, activity.preset, activity.feedback),
        seed=case.seed,
        inputs=ScriptedInputs(case.gestures, case.answers, all_gestures=True),
        program=reading.program,
    )


def run_case(activity: Activity, case: Case, reading: ParseResult) -> RunLog:
    """Runs a program without faults in a case, until the activity's time limit. Raises what `world_of` raises."""
    writer, control = RunLogBuilder(), RunControl()
    last_tick = round(activity.limit_s * TICK_HZ)

    def observe(tick: int, event: Event) -> None:
        writer.observe(tick, event)
        if tick >= last_tick:
            control.stop()

    start(spec_of(activity, case, reading), observe, control, step_limit=STEP_LIMIT)
    return writer.log()


def path_of(
    activity: Activity, number: int, log: RunLog, n_poses: int
) -> list[tuple[float, float, float]]:
    """Returns poses of a run from its start to its end: x and y in m, yaw in rad, world frame.

    Args:
        number: number of the case, from 1.
        n_poses: the most poses, evenly spaced in time.

    Raises:
        PinelError: what `world_of` raises.
    """
    case = activity.cases[number - 1]
    start = Pose2D(*world_from_document(world_of(activity, case)).start)
    rows = np.linspace(0, len(log.poses) - 1, min(n_poses, len(log.poses)))
    poses = [start.compose(Pose2D(*log.poses[row])) for row in np.rint(rows).astype(int)]
    return [(round(x, 3), round(y, 3), round(yaw, 3)) for x, y, yaw in poses]


def evaluate(check: Check, evidence: Evidence, tolerance: RealRobotTolerance | None) -> CheckResult:
    """Evaluates a check, for a real robot with `tolerance`.

    If the check does not pass even so, returns the result of the check without tolerance.
    """
    if tolerance is not None:
        result = check.with_tolerance(tolerance).evaluate(evidence)
        if result.passed:
            return result
    return check.evaluate(evidence)


def judge_run(
    activity: Activity,
    number: int,
    document: Mapping[str, Any],
    log: RunLog,
    *,
    recorded: bool = False,
    tolerance: RealRobotTolerance | None = None,
) -> CaseReport:
    """Judges one run of a program, new or recorded.

    Args:
        number: number of the case, from 1.
        document: the program in its normal form.
        recorded: whether the group watched the run.
        tolerance: tolerance for a real robot; None for the simulator.

    Raises:
        PinelError: what `world_of` raises.
    """
    case = activity.cases[number - 1]
    world = world_from_document(world_of(activity, case))
    checks = [*activity.checks, *case.checks]
    evidence = Evidence(document, world, in_time(log, activity, tolerance))
    reports = tuple(
        _check_report(check, evaluate(check, evidence, tolerance), evidence) for check in checks
    )
    ended = evidence.log.ended
    return CaseReport(
        state=str(ended["state"]),
        reason=ended.get("reason"),
        params=dict(ended.get("params") or {}),
        duration_s=evidence.duration_s,
        telemetry_sha256=ended.get("telemetry_sha256"),
        checks=reports,
        case=number,
        recorded=recorded,
        advice=_advice(activity, checks, number, evidence, reports),
    )


def in_time(log: RunLog, activity: Activity, tolerance: RealRobotTolerance | None) -> RunLog:
    """Returns the log. If the run exceeded the activity's time limit, its end becomes the failure `too_long`.

    A run that somebody stopped after the limit fails, too, and so does a live run beyond the limit. A run on a real
    robot, which has a tolerance, has no time limit: its speed is limited for people's safety.
    """
    limit_s = activity.limit_s
    duration_s = (len(log.poses) - 1) / TICK_HZ
    ended = log.ended
    is_stopped = ended["state"] == "stopped" and duration_s >= limit_s
    if tolerance or (not is_stopped and duration_s <= limit_s + _REST_S):
        return log
    end = {**ended, "state": "failed", "reason": "too_long", "params": {"limit": limit_s}}
    before = log.events[:-1] if log.is_over else log.events
    return replace(log, events=(*before, end))


def _check_report(check: Check, result: CheckResult, evidence: Evidence) -> CheckReport:
    command = evidence.command_at(result.pointer) if result.pointer else None
    return CheckReport(
        kind=check.check,
        params=check.model_dump(exclude=_NO_PARAMS),
        holds=result.passed,
        measured=result.measured,
        target=result.target,
        block=command.block if command else None,
        pointer=result.pointer,
        words={} if result.passed else texts_of(result.code, result.values, command),
    )


def _advice(
    activity: Activity,
    checks: list[Check],
    number: int,
    evidence: Evidence,
    reports: tuple[CheckReport, ...],
) -> Advice | None:
    """Returns the first diagnosis that fits a run, else the message of the first check that fails."""
    failed = next((report for report in reports if not report.holds), None)
    if failed is None:
        return None
    # the program did not cause such an end
    if evidence.log.ended.get("reason") in INTERRUPTED_REASONS:
        return Advice(texts_of(str(evidence.log.ended["reason"]), {}, None), None, None)
    facts = Facts(evidence, activity.cases, number, checks)
    for index, diagnosis in enumerate(activity.diagnoses):
        if fits(diagnosis, facts):
            return advice_of(diagnosis, index, facts)
    return Advice(failed.words, failed.block, failed.pointer)
