"""Collects what one source of truth sees of the robot in a live run, and records it at the end."""

import logging
import threading
from collections.abc import Callable, Mapping
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import TruthSourceChanged, TruthState
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.messages import explain
from pinel_desktop.robot import Pose2D
from pinel_desktop.runs.truth import Source, TruePose, Truth, in_start_frame
from storage import Store, StoreError

_log = logging.getLogger(__name__)
Publish = Callable[[dict[str, Any]], None]
Language = Callable[[], str]


class TruthCollector:
    """Follows one run at a time; thread-safe. It tells the pages when the source sees the robot no more, and again.

    Args:
        publish: sends an event to all pages.
        language: returns the chosen language.
    """

    def __init__(self, source: Source, store: Store, publish: Publish, language: Language) -> None:
        self._source, self._store = source, store
        self._publish, self._language = publish, language
        self._lock = threading.Lock()
        self._run: str | None = None
        self._problem: str | None = None
        self._tick = 0
        self._believed: dict[int, Pose2D] = {}
        self._seen: dict[int, TruePose] = {}
        self._recording: threading.Thread | None = None

    @property
    def run(self) -> str | None:
        """The followed run; None without one."""
        return self._run

    def begin(self, run_id: str) -> None:
        """Follows a run that starts."""
        with self._lock:
            self._run, self._problem, self._tick = run_id, None, 0
            self._believed, self._seen = {}, {}

    def observe(self, event: Mapping[str, Any]) -> None:
        """Handles a sample of the followed run: where the robot itself believes to be."""
        with self._lock:
            self._tick = event["tick"]
            self._believed[self._tick] = Pose2D(event["x_m"], event["y_m"], event["yaw_rad"])

    def believed(self, age_s: float) -> tuple[int, Pose2D] | None:
        """Returns the tick so long ago, and where the robot believed to be then; None outside of the run."""
        with self._lock:
            tick = self._tick - round(age_s * TICK_HZ)
            pose = self._believed.get(tick)
            return None if pose is None else (tick, pose)

    def add(self, seen: TruePose) -> None:
        """Adds a pose with its tick, in any frame that stays the same for the run."""
        assert seen.tick is not None
        with self._lock:
            self._seen[seen.tick] = seen
        self.report(None)

    def report(self, problem: PinelError | None) -> None:
        """Tells the pages a problem, or that it is over, where that is new."""
        with self._lock:
            run, code = self._run, problem.code if problem else None
            if run is None or code == self._problem:
                return
            self._problem = code
        if problem:
            _log.warning("a source of truth: %s", problem.code)
        self._publish_state(run, "problem" if problem else "seeing", problem)

    def end(self) -> None:
        """Records what was seen, on a thread of its own: the end of a run waits for nothing."""
        with self._lock:
            run, self._run = self._run, None
            seen = [self._seen[tick] for tick in sorted(self._seen)]
            believed = self._believed
        if run:
            self._recording = threading.Thread(
                target=self._record, args=(run, seen, believed), name="truth-of-run"
            )
            self._recording.start()

    def close(self) -> None:
        """Waits until what was seen is recorded."""
        if self._recording is not None:
            self._recording.join()

    def _record(self, run: str, seen: list[TruePose], believed: dict[int, Pose2D]) -> None:
        aligned = in_start_frame(seen, believed.get)
        try:
            if aligned:
                rows = Truth(self._source, tuple(aligned)).as_rows()
                self._store.truths.record(run, self._source, rows)
        except StoreError:
            _log.exception("what a source of truth has seen is not recorded")
            return
        self._publish_state(run, "recorded" if aligned else "nothing", None)

    def _publish_state(self, run: str, state: TruthState, problem: PinelError | None) -> None:
        text = explain(problem, self._language()) if problem else None
        event = TruthSourceChanged(
            run=run,
            source=self._source,
            state=state,
            code=problem.code if problem else None,
            message=text.message if text else "",
            remedy=text.remedy if text else "",
        )
        self._publish(event.to_wire())
