"""Compares the record of a run with its replay, part by part."""

import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from itertools import zip_longest
from operator import attrgetter
from typing import Any

import numpy as np

from pinel_desktop import __version__
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event, RunEnded
from pinel_desktop.events.model import Telemetry as Sample
from pinel_desktop.execution.clock import TICK_HZ
from storage import RunRow
from storage.runs.telemetry import COLUMNS, STEPS, Rows, pack, unpack

EQUAL_M = 1e-4  # tolerance between platforms: their math functions differ in the last digit
_EQUAL_OVER_ALL_M = 1e-2  # a long path's length sums up many such differences
# Fields that earlier records lack, with what their replay gives for them: of releases before 0.3 the metric, of those
# before numbers were shown by hand the others.
_ADDED_METRIC = "estimated_closing_error_m"
_ADDED_FIELDS: Mapping[str, Any] = {_ADDED_METRIC: None, "what": "sign", "number": -1}
_ABSENT = object()
_ANGLES = ("yaw_rad", "goal_yaw_rad", "true_yaw_rad")
_SHA256 = re.compile(r"[0-9a-f]{64}\Z")
_HEAD = ("v", "type", "run", "seq", "tick")
_NOTHING: Mapping[str, Any] = {}
_sample = attrgetter(*COLUMNS[1:])

Wire = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Discrepancy:
    """A part of a record that was changed or is missing; `code` and `params` select the message."""

    code: str
    params: dict[str, Any]


@dataclass(frozen=True, slots=True)
class FirstDivergence:
    """The first value of a replay that differs from the record by more than the tolerance."""

    tick: int
    column: str
    recorded: float
    repeated: float

    @property
    def time_s(self) -> float:
        """Robot time since the start, in s."""
        return self.tick / TICK_HZ


@dataclass(frozen=True, slots=True)
class Record:
    """The stored data of a run; the columns of `rows` are `storage.runs.telemetry.COLUMNS`."""

    row: RunRow
    rows: Rows
    events: Sequence[Wire]

    @property
    def ended(self) -> Wire:
        """The closing event; an empty mapping if the record lacks it."""
        last = self.events[-1] if self.events else _NOTHING
        return last if last.get("type") == RunEnded.type else _NOTHING


class ReplayLog:
    """The events and telemetry of a replay, in the form in which the store returns them."""

    def __init__(self) -> None:
        self.events: list[Wire] = []
        self._samples: list[tuple[float, ...]] = []
        self._stamp = EventSequencer("")

    def observe(self, tick: int, event: Event) -> None:
        """Adds an event; must be called with every event of the replay."""
        if type(event) is Sample:
            self._samples.append((tick, *_sample(event)))
        elif event.is_recorded:
            self.events.append(json.loads(json.dumps(self._stamp.wire(tick, event))))

    def rows(self) -> Rows:
        """Returns the telemetry, rounded as the store rounds it."""
        rows = np.array(self._samples, dtype=np.float64).reshape(-1, len(COLUMNS))
        return unpack(pack(rows), len(rows))


def gaps(record: Record) -> list[Discrepancy]:
    """Returns the first missing tick of a record as a discrepancy, if any tick is missing."""
    ticks = record.rows[:, 0]
    wrong = np.flatnonzero(ticks != np.arange(1, len(ticks) + 1))
    return [Discrepancy("part_ticks", {"tick": int(wrong[0]) + 1})] if len(wrong) else []


def inconsistencies(record: Record) -> list[Discrepancy]:
    """Returns the contradictions within the record of a run that reached its end; needs no replay."""
    row, ended, n_rows = record.row, record.ended, len(record.rows)
    parts = gaps(record)
    if not parts and ended and n_rows != ended["tick"]:
        parts.append(Discrepancy("part_rows", {"recorded": n_rows, "expected": ended["tick"]}))
    if not ended:
        parts.append(Discrepancy("part_ending", {}))
    parts += _wrong_fields(row, ended) if ended else []
    if ended and not any(part.code == "part_figure" for part in parts):
        parts += _wrong_summary(row, ended)
    if not _SHA256.match(row.telemetry_sha256 or ""):
        parts.append(Discrepancy("part_hash", {}))
    return parts


def discrepancies(record: Record, replay: ReplayLog, *, exactly: bool) -> list[Discrepancy]:
    """Returns the parts of a record that differ from its replay.

    Args:
        exactly: allows no tolerance; for a replay that gave the recorded `telemetry_sha256`.
    """
    parts: list[Discrepancy] = []
    rows, everything = replay.rows(), record.row.app_version == __version__
    if len(record.rows) != len(rows):
        parts.append(
            Discrepancy("part_rows", {"recorded": len(record.rows), "expected": len(rows)})
        )
    elif found := first_difference(record.rows, rows, exactly=exactly):
        parts.append(Discrepancy("part_sample", {**asdict(found), "time": round(found.time_s, 2)}))
    limit = 0.0 if exactly else _EQUAL_OVER_ALL_M
    parts += _wrong_fields(record.row, replay.events[-1], limit, hashed=exactly)
    limit = 0.0 if exactly else EQUAL_M
    return parts + _wrong_events(record.events, replay.events, limit, everything=everything)


def first_difference(
    recorded: Rows, repeated: Rows, *, exactly: bool = False
) -> FirstDivergence | None:
    """Returns the first difference in the rows that both tables have; both must be rounded as the store rounds them.

    Args:
        exactly: reports differences below the tolerance, too.
    """
    n = min(len(recorded), len(repeated))
    was, now = recorded[:n], repeated[:n]
    deviation = np.abs(was - now)
    for place, name in enumerate(COLUMNS):
        if name in _ANGLES and not exactly:
            deviation[:, place] = np.abs(
                np.remainder(deviation[:, place] + math.pi, math.tau) - math.pi
            )
    deviation[np.isnan(was) & np.isnan(now)] = 0.0
    limits = np.array([0.0 if exactly else _limit(STEPS[name]) for name in COLUMNS])
    wrong = np.argwhere(~(deviation <= limits))  # null beside a number is wrong
    if not len(wrong):
        return None
    i, place = wrong[0]
    return FirstDivergence(
        int(repeated[i, 0]), COLUMNS[place], float(was[i, place]), float(now[i, place])
    )


def _limit(step: float) -> float:
    """Returns the tolerance for numbers that are rounded to `step`; ticks and bumper are whole numbers."""
    return 0.5 if step >= 1.0 else 1.5 * max(step, EQUAL_M)


_COMPARED_FIELDS = (
    "state",
    "reason",
    "params",
    "block",
    "n_executed",
    "duration_s",
    "path_length_m",
    "closing_error_m",
)


def _wrong_fields(
    row: RunRow, ended: Wire, limit: float = 0.0, *, hashed: bool = True
) -> list[Discrepancy]:
    names = (*_COMPARED_FIELDS, "telemetry_sha256") if hashed else _COMPARED_FIELDS
    return [
        Discrepancy("part_figure", {"name": name, "recorded": is_, "expected": ended.get(name)})
        for name in names
        if not _same(is_ := getattr(row, name), ended.get(name), limit)
    ]


def _wrong_summary(row: RunRow, ended: Wire) -> list[Discrepancy]:
    expected = {name: value for name, value in ended.items() if name not in _HEAD}
    return [] if _same(row.summary, expected, 0.0) else [Discrepancy("part_summary", {})]


def _wrong_events(
    recorded: Sequence[Wire], repeated: Sequence[Wire], limit: float, *, everything: bool
) -> list[Discrepancy]:
    pairs = zip_longest(_plain(recorded), _plain(repeated))
    for number, (was, now) in enumerate(pairs, 1):
        if was is None or now is None or not _is_same_event(was, now, limit, everything=everything):
            event = now or was or _NOTHING
            place = {"number": number, "type": event["type"], "tick": event["tick"]}
            counts = {"recorded": len(recorded), "expected": len(repeated)}
            return [Discrepancy("part_events", {**place, **counts})]
    return []


def _is_same_event(was: Wire, now: Wire, limit: float, *, everything: bool) -> bool:
    # `_wrong_fields` compares the other fields
    if limit and was["type"] == now["type"] == RunEnded.type:
        return _same(was.get(_ADDED_METRIC), now.get(_ADDED_METRIC), _EQUAL_OVER_ALL_M)
    return _same(was, _comparable(was, now, everything=everything), limit)


def _comparable(was: Wire, now: Wire, *, everything: bool) -> dict[str, Any]:
    """Returns the fields of a repeated event that its record must have; an older release may have recorded fewer."""
    return {
        name: value
        for name, value in now.items()
        if name in was or (everything and _ADDED_FIELDS.get(name, _ABSENT) != value)
    }


def same_beginning(
    recorded: Sequence[Wire], repeated: Sequence[Wire], tick: int
) -> list[Discrepancy]:
    """Compares the events before `tick`, at which the record of an interrupted run breaks off."""
    was, now = ([e for e in events if e["tick"] < tick] for events in (recorded, repeated))
    return _wrong_events(was, now, EQUAL_M, everything=False)


def _plain(events: Sequence[Wire]) -> Iterator[dict[str, Any]]:
    """Yields events without `run` and `seq`: lossy events are numbered, too, and differ between run and replay."""
    for event in events:
        yield {name: value for name, value in event.items() if name not in ("run", "seq")}


def _same(a: Any, b: Any, limit: float) -> bool:
    if isinstance(a, bool) or isinstance(b, bool):
        return a is b
    if isinstance(a, int | float) and isinstance(b, int | float):
        return a == b or abs(a - b) <= limit
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_same(a[key], b[key], limit) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        pairs = zip(a, b, strict=False)
        return len(a) == len(b) and all(_same(one, other, limit) for one, other in pairs)
    return bool(a == b)
