"""Records the events of live runs into the store: in batches of about a second, the start and the end at once.

numpy takes longer to load than the rest of the store, so it is imported when first used, or by `warm_up`.
"""

import threading
import time
from array import array
from collections.abc import Callable, Collection, Mapping
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeout
from math import hypot
from typing import Any

from storage.errors import StoreError
from storage.runs.runs import Batch
from storage.store import Store

Event = Mapping[str, Any]

_EVERY_S = 1.0
_END_TIMEOUT_S = 2.0
_TRAIL_STEP_M = 0.01
_RETRY_S = 1.5

Cancel = Callable[[], None]


def _by_timer(delay_s: float, call: Callable[[], None]) -> Cancel:
    timer = threading.Timer(delay_s, call)
    timer.daemon = True
    timer.start()
    return timer.cancel


class RunRecorder:
    """Records every event of a run, in order, from one thread at a time.

    A batch that cannot be written, as on a full disk, stays in memory. It is tried again with the next batch, after
    any other successful write, and every 1.5 s. Attempts go on until the batch is on disk, also after the run has
    ended. So a run never waits for the disk, and loses nothing if space is freed in time.

    Args:
        on_change: called with the error when writing fails, and with None when it works again.
        recorded: types of event that are recorded, None for all.
        urgent: types of event that are written at once, because no event may follow for a long time.
        schedule: calls a function after a delay in s, unless cancelled; used only while batches are unsaved.

    Attributes:
        problem: why the last batch could not be written, None if it was.
    """

    def __init__(
        self,
        store: Store,
        on_change: Callable[[StoreError | None], None] = lambda problem: None,
        *,
        recorded: Collection[str] | None = None,
        urgent: Collection[str] = ("run_ended",),
        clock: Callable[[], float] = time.monotonic,
        schedule: Callable[[float, Callable[[], None]], Cancel] = _by_timer,
    ) -> None:
        self.problem: StoreError | None = None
        self._store = store
        self._on_change = on_change
        self._recorded, self._urgent = recorded, urgent
        self._clock = clock
        self._flushed_at = clock()
        self._run = _Recording("")
        self._unsaved: list[Batch] = []
        # one thread adds events, others call `flush`
        self._taking = threading.Lock()
        self._lock = threading.Lock()
        self._schedule = schedule
        self._cancel_retry: Cancel | None = None
        self._closed = False
        store.listen(self._after_write)

    def __call__(self, event: Event) -> None:
        """Records one event. For `run_ended`, waits until the run is on disk or writing fails, 2 s at most."""
        if self._recorded is not None and event["type"] not in self._recorded:
            return
        with self._taking:
            if event["run"] != self._run.run_id:
                self._run = _Recording(event["run"])
            self._run.add(event)
        if event["type"] in self._urgent or self._clock() - self._flushed_at >= _EVERY_S:
            written = self.flush()
            if event["type"] == "run_ended":
                _wait(written)

    def flush(self) -> "Future[list[Batch]]":
        """Submits the pending events to the writer; from any thread."""
        with self._taking:
            self._flushed_at = self._clock()
            batch = self._run.drain(self._store.now())
            if batch is not None:
                with self._lock:
                    self._unsaved.append(batch)
        return self._submit()

    def unsaved_end(self, run_id: str) -> Event | None:
        """Returns the end of a run that has ended but is not on disk; None for any other run."""
        with self._lock:
            ends = [batch.ended for batch in self._unsaved if batch.run_id == run_id]
        return next((ended for ended in ends if ended is not None), None)

    def close(self) -> None:
        """Stops all further attempts. Call `flush` before."""
        self._closed = True
        self._plan_retry()

    def _submit(self) -> "Future[list[Batch]]":
        written = self._store.record(self._waiting)
        written.add_done_callback(self._after_attempt)
        return written

    def _waiting(self) -> list[Batch]:
        with self._lock:
            return list(self._unsaved)

    def _after_attempt(self, written: "Future[list[Batch]]") -> None:
        error = written.exception()
        problem = error if isinstance(error, StoreError) else None
        if error is None:
            done = written.result()
            with self._lock:
                self._unsaved = [batch for batch in self._unsaved if batch not in done]
        elif problem is None:
            problem = StoreError("database_failed", path=str(self._store.path), problem=str(error))
        changed = (problem and problem.code) != (self.problem and self.problem.code)
        self.problem = problem
        self._plan_retry()
        if changed:
            self._on_change(problem)

    def _after_write(self) -> None:
        if self.problem is not None and not self._closed:
            self._submit()

    def _plan_retry(self) -> None:
        """Schedules an attempt while there is a problem and a file to write to; otherwise cancels it."""
        with self._lock:
            hopeful = self.problem is not None and self._store.can_write and not self._closed
            if hopeful and self._cancel_retry is None:
                self._cancel_retry = self._schedule(_RETRY_S, self._retry)
            elif not hopeful and self._cancel_retry is not None:
                self._cancel_retry()
                self._cancel_retry = None

    def _retry(self) -> None:
        with self._lock:
            self._cancel_retry = None
        if not self._closed:
            self._submit()


def warm_up() -> None:
    """Imports modules that the first run would otherwise wait for."""
    from storage.runs import simplify_path, telemetry  # noqa: F401, PLC0415 - needs numpy


class _Recording:
    """The pending events of one run."""

    def __init__(self, run_id: str) -> None:
        self.run_id = run_id
        self._events: list[Event] = []
        self._samples: list[Event] = []
        self._n_chunks = 0
        self._trail = array("d")

    def add(self, event: Event) -> None:
        if event["type"] != "telemetry":
            self._events.append(event)
            return
        self._samples.append(event)
        self._follow(float(event["x_m"]), float(event["y_m"]))

    def drain(self, now: str) -> Batch | None:
        """Returns all pending events as a batch, None if there are none."""
        if not self._events and not self._samples:
            return None
        from storage.runs.simplify_path import outline_of_trail  # noqa: PLC0415 - needs numpy
        from storage.runs.telemetry import pack, rows_of  # noqa: PLC0415

        batch = Batch(self.run_id, now, events=self._events)
        if self._samples:
            blob = pack(rows_of(self._samples))
            batch.chunks.append(
                (self._n_chunks, int(self._samples[0]["tick"]), len(self._samples), blob)
            )
            self._n_chunks += 1
        if self._events and self._events[-1]["type"] == "run_ended":
            batch.ended = self._events[-1]
            batch.path = outline_of_trail(self._trail)
        self._events, self._samples = [], []
        return batch

    def _follow(self, x_m: float, y_m: float) -> None:
        """Adds a point for each centimetre, so that an hour's run stays small in memory."""
        if not self._trail or hypot(x_m - self._trail[-2], y_m - self._trail[-1]) >= _TRAIL_STEP_M:
            self._trail.extend((x_m, y_m))


def _wait(written: "Future[list[Batch]]") -> None:
    """Waits for the disk, 2 s at most: the page should find the run ended when it receives the event."""
    try:
        written.result(_END_TIMEOUT_S)
    except (StoreError, FutureTimeout):
        return
    except Exception:
        return
