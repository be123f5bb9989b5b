"""Verifies a recorded run: repeats it, and finds the first difference between record and replay."""

from dataclasses import dataclass
from typing import Any, Literal

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.executor import RunResult
from pinel_desktop.runs.comparison import (
    Discrepancy,
    FirstDivergence,
    Record,
    ReplayLog,
    discrepancies,
    first_difference,
    gaps,
    inconsistencies,
    same_beginning,
)
from pinel_desktop.runs.record import spec_of
from pinel_desktop.runs.recorded_inputs import RecordedInputs
from pinel_desktop.runs.spec import INTERRUPTED_REASONS
from pinel_desktop.runs.start import start
from storage import RunRow, Store

Outcome = Literal["identical", "equal", "different", "altered"]


@dataclass(frozen=True, slots=True)
class VerificationResult:
    """The result of a verification.

    Attributes:
        outcome: `identical`: equal bit by bit; `equal`: within 0.1 mm and 0.1 mrad; `different`; or `altered`: the
            record contradicts itself, or contradicts a replay with the recorded telemetry.
        n_ticks: number of compared ticks.
        whole: whether the whole run was compared; an interrupted run is compared up to the end of its record.
        recorded_sha256, repeated_sha256: `telemetry_sha256` of record and replay; the record of an interrupted run
            has None.
        difference: the first difference; None without one.
        parts: the changed or missing parts of an altered record.
    """

    outcome: Outcome
    n_ticks: int
    whole: bool
    recorded_sha256: str | None
    repeated_sha256: str
    difference: FirstDivergence | None = None
    parts: tuple[Discrepancy, ...] = ()


@dataclass(frozen=True, slots=True)
class RecordedRun:
    """Everything that the store holds of one run: any process can verify it, also on another machine."""

    record: Record
    document: dict[str, Any]


def recorded_run(store: Store, row: RunRow) -> RecordedRun:
    """Reads a run for `verify_recorded`.

    Raises:
        PinelError: `run_not_simulated` for a real robot's run, `run_not_ended` for a run without its end,
            `run_not_repeatable` for a record of an earlier release that lacks necessary data.
        StoreError: `run_damaged` for an unreadable record.
    """
    if row.link != "sim":
        raise PinelError("run_not_simulated", link=row.link)
    if row.state == "running":
        raise PinelError("run_not_ended", id=row.id)
    record = Record(row, store.runs.telemetry(row.id).rows, store.runs.events(row.id))
    return RecordedRun(record, _document(store, row))


def verify_run(store: Store, row: RunRow) -> VerificationResult:
    """Verifies a run of the store in this process.

    Raises what `recorded_run` and `verify_recorded` raise.
    """
    return verify_recorded(recorded_run(store, row))


def verify_recorded(run: RecordedRun) -> VerificationResult:
    """Repeats a recorded run in this process, and compares it with everything that the store holds of the run.

    The replay uses the recorded semantics version (`execution.semantics`).

    Raises:
        PinelError: `run_newer` for a record of a later release, `run_damaged` for an unreadable record, and what
            reading and opening raise.
    """
    record, row = run.record, run.record.row
    until = len(record.rows) if row.reason in INTERRUPTED_REASONS else None
    replay = ReplayLog()
    # The replay stops one tick after the record's end: one more tick proves a difference. A
    # forged program might run for long.
    max_ticks = len(record.rows) + 1 if until is None else until
    spec = spec_of(row, run.document, RecordedInputs(record.events, max_ticks))
    result = start(spec, replay.observe)
    difference = first_difference(record.rows, replay.rows())
    parts = _parts(record, replay, result, difference)
    is_same = until is None and result.ended.telemetry_sha256 == row.telemetry_sha256
    outcome: Outcome = "identical" if is_same else "equal"
    if parts:
        outcome = "altered"
    elif difference is not None:
        outcome = "different"
    return VerificationResult(
        outcome,
        len(record.rows),
        until is None,
        row.telemetry_sha256,
        result.ended.telemetry_sha256,
        difference,
        tuple(parts),
    )


def _parts(
    record: Record, replay: ReplayLog, result: RunResult, difference: FirstDivergence | None
) -> list[Discrepancy]:
    """Returns the changed parts of the record; none if the record is consistent and only the replay differs."""
    row = record.row
    if row.reason in INTERRUPTED_REASONS:
        beginning = same_beginning(record.events, replay.events, len(record.rows))
        return gaps(record) or ([] if difference else beginning)
    is_same = result.ended.telemetry_sha256 == row.telemetry_sha256
    if is_same and (parts := discrepancies(record, replay, exactly=True)):
        return parts
    if parts := inconsistencies(record):
        return parts
    if is_same or difference is not None:
        return []
    return discrepancies(record, replay, exactly=False)


def _document(store: Store, row: RunRow) -> dict[str, Any]:
    version = store.versions.get(row.version_id) if row.version_id else None
    document = version.document if version else row.document
    if document is None:
        raise PinelError("run_not_repeatable")
    return document
