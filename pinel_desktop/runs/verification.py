"""Whether a recorded run comes out the same when it is run again, and where it first differs if not."""

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
        outcome: `identical` to the bit; `equal` within 0.1 mm and 0.1 mrad; `different`; or `altered`: the record does
            not agree with itself, or with a replay that gave the recorded `telemetry_sha256`.
        n_ticks: how many ticks were compared.
        whole: whether that is the whole run; a run that was cut off is compared as far as its record goes.
        recorded_sha256, repeated_sha256: `telemetry_sha256` of both; that of a run that was cut off is None.
        difference: where they first differ; None where they do not.
        parts: what of an altered record was changed or is missing.
    """

    outcome: Outcome
    n_ticks: int
    whole: bool
    recorded_sha256: str | None
    repeated_sha256: str
    difference: FirstDivergence | None = None
    parts: tuple[Discrepancy, ...] = ()


def verify_run(store: Store, row: RunRow) -> VerificationResult:
    """Runs a recorded run again in this process and compares all that the store holds of it.

    It is run with what commands and sensors meant then (`execution.semantics`). Raises PinelError `run_not_simulated`
    for a real robot's, `run_not_ended` for one that has not, `run_not_repeatable` for a record of an earlier release
    that does not tell all that is needed, `run_newer` for one of a later release, `run_damaged` and StoreError
    `run_damaged` for one that cannot be read, and what reading and opening raise.
    """
    if row.link != "sim":
        raise PinelError("run_not_simulated", link=row.link)
    if row.state == "running":
        raise PinelError("run_not_ended", id=row.id)
    record = Record(row, store.runs.telemetry(row.id).rows, store.runs.events(row.id))
    until = len(record.rows) if row.reason in INTERRUPTED_REASONS else None
    replay = ReplayLog()
    # a replay that goes beyond the record differs: a made-up program need not be run to its end, which may be far
    max_ticks = len(record.rows) + 1 if until is None else until
    spec = spec_of(row, _document(store, row), RecordedInputs(record.events, max_ticks))
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
    """What was changed of the record; nothing where it is sound and the replay merely differs."""
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
