"""Whether a recorded run comes out the same when it is run again, and where it first differs if not."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.execution.recorder import Recorder
from pinel_desktop.execution.repeating import Repeater
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import setting_from
from storage import RunRow, Store
from storage.telemetry import STEPS, Telemetry

Outcome = Literal["identical", "equal", "different"]
EQUAL_M = 1e-4  # between platforms, whose mathematical functions differ in the last digit
# a record that breaks off there, as when the power was cut, is compared as far as it goes
_CUT_OFF = ("interrupted", "engine_lost", "internal_error")


@dataclass(frozen=True, slots=True)
class Difference:
    """The first tick at which a repetition is not what was recorded, beyond what the record rounds to."""

    tick: int
    column: str
    recorded: float
    repeated: float

    @property
    def time_s(self) -> float:
        """Robot time since the start."""
        return self.tick / TICK_HZ


@dataclass(frozen=True, slots=True)
class Verdict:
    """What a repetition showed.

    Attributes:
        outcome: `identical` to the bit; `equal` within 0.1 mm and 0.1 mrad; or `different`.
        n_ticks: how many ticks were compared.
        whole: whether that is the whole run; a run that was cut off is compared as far as its record goes.
        recorded_sha256, repeated_sha256: `telemetry_sha256` of both; that of a run that was cut off is None.
        difference: where they first differ; None where they do not.
    """

    outcome: Outcome
    n_ticks: int
    whole: bool
    recorded_sha256: str | None
    repeated_sha256: str
    difference: Difference | None = None


def verify_run(store: Store, row: RunRow) -> Verdict:
    """Runs a recorded run again in this process and compares.

    Raises PinelError `run_not_simulated` for a real robot's, `run_not_ended` for one that has not, `run_not_repeatable`
    for a record of an earlier release that does not tell all that is needed, and what reading and opening raise.
    """
    if row.link != "sim":
        raise PinelError("run_not_simulated", link=row.link)
    if row.state == "running":
        raise PinelError("run_not_ended", id=row.id)
    recorded = store.runs.telemetry(row.id)
    until = len(recorded.rows) if row.reason in _CUT_OFF else None
    repeater = Repeater(store.runs.events(row.id), until)
    result = _repeated(row, _document(store, row), repeater)
    repeated_sha256 = result.telemetry.sha256()
    n_ticks = len(recorded.rows)
    if until is None and repeated_sha256 == row.telemetry_sha256:
        return Verdict("identical", n_ticks, True, row.telemetry_sha256, repeated_sha256)
    difference = _first_difference(recorded, result.telemetry, whole=until is None)
    outcome: Outcome = "equal" if difference is None else "different"
    return Verdict(
        outcome, n_ticks, until is None, row.telemetry_sha256, repeated_sha256, difference
    )


def _document(store: Store, row: RunRow) -> dict[str, Any]:
    version = store.versions.get(row.version_id) if row.version_id else None
    document = version.document if version else row.document
    if document is None:
        raise PinelError("run_not_repeatable")
    return document


def _repeated(row: RunRow, document: dict[str, Any], repeater: Repeater) -> RunResult:
    reading = read_document(document)
    if reading.program is None:
        raise PinelError("invalid_program", count=len(reading.faults))
    setting = setting_from(row.parameters)
    options = RunOptions(
        observer=repeater.observe,
        control=repeater.control,
        gestures=repeater.gestures,
        answers=repeater.answers,
        seed=row.seed,
        robot=setting.robot,
    )
    link = open_link(row.link, world=row.world_document, setting=setting, seed=row.seed)
    return execute(reading.program, link, options)


def _first_difference(recorded: Telemetry, repeated: Recorder, *, whole: bool) -> Difference | None:
    """Compares tick by tick; the record is rounded, so what lies within its rounding is no difference."""
    columns = [recorded.column(name).tolist() for name in Recorder.NAMES]
    allowed = [max(STEPS[name], EQUAL_M) for name in Recorder.NAMES]
    rows = repeated.rows
    n_repeated = len(rows) // Recorder.COLUMNS
    for i in range(min(len(columns[0]), n_repeated)):
        row = rows[i * Recorder.COLUMNS : (i + 1) * Recorder.COLUMNS]
        was = [column[i] for column in columns]
        for name, before, now, limit in zip(Recorder.NAMES, was, row, allowed, strict=True):
            if _distance(name, before, now) > limit:
                return Difference(round(row[0]), name, before, now)
    if whole and len(columns[0]) != n_repeated:
        return _of_length(columns[0], rows, n_repeated)
    return None


def _distance(name: str, a: float, b: float) -> float:
    return abs(math.remainder(a - b, math.tau)) if name == "yaw_rad" else abs(a - b)


def _of_length(ticks: Sequence[float], rows: Sequence[float], n_repeated: int) -> Difference:
    """One of them goes on where the other has ended."""
    last = rows[(n_repeated - 1) * Recorder.COLUMNS] if n_repeated else 0.0
    before = ticks[-1] if ticks else 0.0
    return Difference(round(min(before, last)) + 1, "tick", before, last)
