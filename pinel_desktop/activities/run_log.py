"""The log of a run: what a live run and its record have in common. Poses are rounded as the store rounds them."""

from array import array
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.events.model import Event, RunEnded, Telemetry
from pinel_desktop.events.types import RECORDED

STEP_M, STEP_RAD, STEP_DONE = 1e-4, 1e-4, 1e-3  # resolution of a record
# the telemetry columns that checks use
COLUMNS = ("x_m", "y_m", "yaw_rad", "done", "bumper", "true_x_m", "true_y_m", "true_yaw_rad")
_MISSING = float("nan")
_NO_END: Mapping[str, Any] = {
    "type": RunEnded.type,
    "state": "failed",
    "reason": "interrupted",
    "params": {},
}

Wire = Mapping[str, Any]
Rows = NDArray[np.float64]


@dataclass(frozen=True)
class RunLog:
    """Telemetry and events of a run.

    Attributes:
        poses: true poses in the start frame, shape (n + 1, 3), m and rad; row i is tick i, row 0 the start. If the
            true pose is unknown, the robot's own estimate.
        done: completed part of the running motion, shape (n + 1,).
        bumper: whether the robot touched something, shape (n + 1,).
        is_true: whether all poses are true ones.
        events: the other events, in wire format.
    """

    poses: Rows
    done: Rows
    bumper: NDArray[np.bool_]
    is_true: bool
    events: tuple[Wire, ...]

    @classmethod
    def of_columns(cls, column: Callable[[str], Rows], events: Iterable[Wire]) -> "RunLog":
        """Creates the log from telemetry columns in order of ticks, with NaN for null, and from the other events."""
        values = {name: column(name) for name in COLUMNS}
        own = np.column_stack([values["x_m"], values["y_m"], values["yaw_rad"]])
        true = np.column_stack([values[f"true_{name}"] for name in ("x_m", "y_m", "yaw_rad")])
        known = ~np.isnan(true).any(axis=1, keepdims=True)
        poses = np.where(known, true, own)
        start = np.zeros((1, 3))
        steps = np.array([STEP_M, STEP_M, STEP_RAD])
        return cls(
            poses=np.concatenate([start, np.rint(poses / steps) * steps]),
            done=np.concatenate([[0.0], np.rint(values["done"] / STEP_DONE) * STEP_DONE]),
            bumper=np.concatenate([[False], values["bumper"] > 0.5]),
            is_true=bool(known.all()),
            events=tuple(event for event in events if event["type"] != Telemetry.type),
        )

    @classmethod
    def of_events(cls, events: Iterable[Wire]) -> "RunLog":
        """Creates the log from all events of a run in wire format, telemetry included."""
        every = list(events)
        samples = [event for event in every if event["type"] == Telemetry.type]

        def column(name: str) -> Rows:
            values = [event.get(name) for event in samples]
            return np.array([_MISSING if v is None else float(v) for v in values], dtype=np.float64)

        return cls.of_columns(column, every)

    @property
    def is_over(self) -> bool:
        """Whether the log has a closing event."""
        return bool(self.events) and self.events[-1].get("type") == RunEnded.type

    @property
    def ended(self) -> Wire:
        """The closing event; without one, the closing event of an interrupted run."""
        return self.events[-1] if self.is_over else _NO_END


class RunLogBuilder:
    """Builds the log of a live run; `observe` or `add_event` must receive all events of the run.

    The log may be read at any time, but not while another thread adds events.
    """

    def __init__(self) -> None:
        self._samples = array("d")
        self._events: list[Wire] = []

    def observe(self, tick: int, event: Event) -> None:
        """Adds an event of the executor."""
        if type(event) is Telemetry:
            self._add(attrgetter(*COLUMNS)(event))
        elif event.is_recorded:
            self._events.append({**event.to_wire(), "tick": tick})

    def add_event(self, event: Wire) -> None:
        """Adds an event in wire format."""
        if event["type"] == Telemetry.type:
            self._add(tuple(event.get(name) for name in COLUMNS))
        elif event["type"] in RECORDED:
            self._events.append(event)

    def log(self) -> RunLog:
        """Returns the log of all events so far."""
        rows = np.array(self._samples, dtype=np.float64).reshape(-1, len(COLUMNS))
        return RunLog.of_columns(lambda name: rows[:, COLUMNS.index(name)], self._events)

    def _add(self, values: tuple[float | None, ...]) -> None:
        self._samples.extend(_MISSING if value is None else float(value) for value in values)
