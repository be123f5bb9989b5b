"""Whether a program passes an activity: runs each case and evaluates every check."""

from dataclasses import dataclass
from typing import Any

from pinel_desktop.activities.checks import Evidence, RunObserver, holds
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity, Case
from pinel_desktop.events.model import Event
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.reading import Reading
from pinel_desktop.robot import Setting
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from sim.world import world_from_document


@dataclass(frozen=True, slots=True)
class CheckReport:
    """Result of one check; `kind` and `params` select the message."""

    kind: str
    params: dict[str, Any]
    holds: bool


@dataclass(frozen=True, slots=True)
class CaseReport:
    """One run of the program; `reason` is `too_long` if the activity's time limit ended it."""

    state: str
    reason: str | None
    params: dict[str, Any]
    duration_s: float
    telemetry_sha256: str
    checks: tuple[CheckReport, ...]


@dataclass(frozen=True, slots=True)
class Report:
    """Result of one program. A program with faults is not run and has no cases."""

    program: str
    faults: tuple[Fault, ...]
    cases: tuple[CaseReport, ...]

    @property
    def passed(self) -> bool:
        """True if the program passes the activity."""
        checks = [check for case in self.cases for check in case.checks]
        return not self.faults and bool(checks) and all(check.holds for check in checks)


def check_program(activity: Activity, reading: Reading, program: str = "") -> Report:
    """Runs a program in each case of the activity.

    Args:
        program: its name in the report.

    Raises:
        PinelError: `unknown_robot`, or what `world_of` raises.
    """
    if reading.program is None:
        return Report(program, reading.faults, ())
    return Report(program, (), tuple(_case(activity, case, reading) for case in activity.cases))


def spec_of(activity: Activity, case: Case, reading: Reading) -> RunSpec:
    """The run of a program without faults in a case. Raises what `world_of` raises."""
    assert reading.program is not None
    assert reading.document is not None
    return RunSpec(
        document=reading.document,
        world=world_of(activity, case),
        setting=Setting(activity.model, activity.preset, activity.feedback),
        seed=case.seed,
        inputs=ScriptedInputs(case.gestures, case.answers),
        program=reading.program,
    )


def _case(activity: Activity, case: Case, reading: Reading) -> CaseReport:
    assert reading.document is not None
    spec = spec_of(activity, case, reading)
    observed = RunObserver(world_from_document(world_of(activity, case)))
    control, last_tick = RunControl(), round(activity.limit_s * TICK_HZ)

    def observe(tick: int, event: Event) -> None:
        observed.observe(event)
        if tick >= last_tick:
            control.stop()

    result = start(spec, observe, control)
    ended = result.ended
    evidence = Evidence(reading.document, result, observed)
    checks = [
        CheckReport(check.check, check.model_dump(exclude={"check"}), holds(check, evidence))
        for check in (*activity.checks, *case.checks)
    ]
    stopped = ended.state == "stopped"
    return CaseReport(
        state="failed" if stopped else ended.state,
        reason="too_long" if stopped else ended.reason,
        params={"limit": activity.limit_s} if stopped else ended.params,
        duration_s=ended.duration_s,
        telemetry_sha256=ended.telemetry_sha256,
        checks=tuple(checks),
    )
