"""Jobs: one function makes them, one runs them. A job is a pure function of its fields, on any process and machine."""

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from pinel_desktop.activities.checking import STEP_LIMIT, judge_run
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.activities.faults import world_of
from pinel_desktop.activities.model import Activity
from pinel_desktop.activities.run_log import RunLog, RunLogBuilder
from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.control import RunControl
from pinel_desktop.program.reading import ParseResult, read_document
from pinel_desktop.robot import SimulationConfig
from pinel_desktop.runs.fixed_inputs import FixedInputs
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from pinel_desktop.sweep.rows import TOO_LONG, Row
from sim.world import World, WorldError, world_from_document

DEFAULT_LIMIT_S = 300.0  # as that of an activity

Named = tuple[str, Mapping[str, Any]]  # a program or a world: its name and its document


_NONE = FixedInputs()


@dataclass(frozen=True, slots=True)
class Job:
    """One run of a program in the simulator.

    Documents are JSON texts: jobs can be compared, and a process parses each document once.

    Attributes:
        index: place of the job and of its row.
        program, document: name of the program, and its document.
        world, floor: name of the world, and its document with the start of the robot.
        activity: the activity that judges the run by its first case; None for no judging.
        limit_s: robot time after which the run is stopped and failed.
        n_poses: the most poses of the row's path; 0 for no path.
    """

    index: int
    program: str
    document: str
    world: str
    floor: str
    setting: SimulationConfig
    seed: int
    inputs: FixedInputs = _NONE
    activity: str | None = None
    limit_s: float = DEFAULT_LIMIT_S
    n_poses: int = 0


def make_jobs(
    programs: Iterable[Named],
    worlds: Iterable[Named],
    setting: SimulationConfig,
    seeds: Sequence[int],
    *,
    inputs: FixedInputs | None = None,
    activity: Activity | None = None,
    limit_s: float | None = None,
    n_poses: int = 0,
) -> Iterator[Job]:
    """Yields jobs in a fixed order: program by program, in each world, with each seed.

    Args:
        programs, worlds: names and documents, without faults; `worlds_of` is the world of an activity.
        inputs: None for those of the activity's first case.
        activity: judges each run in its world, by the checks of the activity and of its first case.
        limit_s: None for the limit of the activity.

    Raises:
        PinelError: a world that does not suit the activity.
    """
    case = activity.cases[0] if activity else None
    if inputs is None:
        inputs = FixedInputs(tuple(case.gestures), tuple(case.answers)) if case else _NONE
    limit_s = limit_s or (activity.limit_s if activity else DEFAULT_LIMIT_S)
    places = [(name, *_judged(activity, floor, limit_s)) for name, floor in worlds]
    index = 0
    for program, document in programs:
        text = _json(document)
        for world, floor, judge in places:
            for seed in seeds:
                run = (index, program, text, world, floor, setting, seed)
                yield Job(*run, inputs, judge, limit_s, n_poses)
                index += 1


def worlds_of(activity: Activity) -> list[Named]:
    """Returns the world of an activity by its name, for `make_jobs`. Raises what `world_of` raises."""
    world = world_of(activity)
    return [(activity.world if isinstance(activity.world, str) else activity.name, world)]


def _judged(
    activity: Activity | None, floor: Mapping[str, Any], limit_s: float
) -> tuple[str, str | None]:
    """Returns a world with the start of the activity's first case, and the activity in this world with this case."""
    if activity is None:
        return _json(floor), None
    first = {"world": dict(floor), "limit_s": limit_s, "cases": activity.cases[:1]}
    judge = activity.model_copy(update={**first, "solution": None})
    return _json(world_of(judge, judge.cases[0])), judge.model_dump_json(exclude_none=True)


def _json(document: Mapping[str, Any]) -> str:
    return json.dumps(document, ensure_ascii=False)


def run_job(job: Job) -> Row:
    """Runs a job; whatever fails in it is the outcome of its row.

    It needs nothing but the job, so that any process can run it: of a pool, or of a cluster.
    """
    row = Row(job.index, job.program, job.world, job.seed)
    try:
        return _result(job, row)
    except PinelError as error:
        return replace(row, reason=error.code, params=error.params, cause="failure")
    except Exception as error:
        # a defect of PINEL in one run must not end the other runs
        detail = f"{type(error).__name__}: {error}"
        return replace(row, reason="internal_error", params={"detail": detail}, cause="failure")


def _result(job: Job, row: Row) -> Row:
    reading = _reading(job.document)
    if reading.document is None:
        raise PinelError("invalid_program", count=len(reading.faults))
    floor, world = _floor(job.floor)
    evidence = Evidence(reading.document, world, _run(job, reading, floor))
    ended = evidence.log.ended
    row = replace(
        row,
        state=str(ended["state"]),
        reason=ended.get("reason"),
        params=dict(ended.get("params") or {}),
        block=ended.get("block"),
        n_collisions=_n_collisions(evidence.log),
        closing_error_m=ended.get("closing_error_m"),
        duration_s=round(evidence.duration_s, 3),
        end=_end(evidence),
        telemetry_sha256=ended.get("telemetry_sha256"),
        path=_path(evidence, job.n_poses),
    )
    if row.state == "stopped":  # nobody stops these runs but their limit
        row = replace(row, state="failed", reason=TOO_LONG, params={"limit": job.limit_s})
    return _with_cause(row, _activity(job.activity) if job.activity else None, evidence)


def _run(job: Job, reading: ParseResult, floor: dict[str, Any]) -> RunLog:
    """Runs a job until its limit."""
    assert reading.document is not None
    writer, control = RunLogBuilder(), RunControl()
    last_tick = round(job.limit_s * TICK_HZ)

    def observe(tick: int, event: Event) -> None:
        writer.observe(tick, event)
        if tick >= last_tick:
            control.stop()

    spec = RunSpec(
        document=reading.document,
        world=floor,
        setting=job.setting,
        seed=job.seed,
        inputs=job.inputs.source(),
        program=reading.program,
    )
    start(spec, observe, control, step_limit=STEP_LIMIT)
    return writer.log()


def _with_cause(row: Row, activity: Activity | None, evidence: Evidence) -> Row:
    """Adds whether the run passed, and why it did not go well: what the group sees first comes first."""
    report = judge_run(activity, 1, evidence.document, evidence.log) if activity else None
    if report is not None:
        row = replace(row, passed=report.passed)
        if report.passed:
            return replace(row, block=None)
    if evidence.touch_tick is not None:
        motion = evidence.motion_at(evidence.touch_tick)
        pointer, block = (motion.pointer, motion.block) if motion else (None, None)
        return replace(row, cause="collision", block=block, pointer=pointer)
    if row.state == "failed":
        running = evidence.running
        pointer = running.pointer if running and running.block == row.block else None
        return replace(row, cause="failure", pointer=pointer)
    if report is None:
        return row
    failed = next((check for check in report.checks if not check.holds), None)
    source = report.advice or failed
    block, pointer = (source.block, source.pointer) if source else (None, None)
    kind = failed.kind if failed else None
    return replace(row, cause="check", check=kind, block=block, pointer=pointer)


def _n_collisions(log: RunLog) -> int:
    """Returns how often the robot began to touch something."""
    return int(np.count_nonzero(log.bumper[1:] & ~log.bumper[:-1]))


def _end(evidence: Evidence) -> tuple[float, float, float]:
    x, y = evidence.in_world[-1]
    yaw = evidence.end[2] + evidence.world.start[2]
    return round(float(x), 4), round(float(y), 4), round(float(yaw), 4)


def _path(evidence: Evidence, n_poses: int) -> tuple[tuple[float, float], ...]:
    points = evidence.in_world
    rows = np.rint(np.linspace(0, len(points) - 1, min(n_poses, len(points)))).astype(int)
    return tuple((round(float(x), 3), round(float(y), 3)) for x, y in points[rows])


# A process runs many jobs of the same few documents, of which each is parsed once.


@lru_cache(maxsize=8)
def _reading(text: str) -> ParseResult:
    return read_document(json.loads(text))


@lru_cache(maxsize=8)
def _floor(text: str) -> tuple[dict[str, Any], World]:
    """Returns a world's document, and the world."""
    document = json.loads(text)
    try:
        return document, world_from_document(document)
    except WorldError as error:
        raise PinelError(error.code, **error.params) from error


@lru_cache(maxsize=8)
def _activity(text: str) -> Activity:
    return Activity.model_validate_json(text)
