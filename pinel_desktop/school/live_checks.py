"""Publishes the check results of a live run to the page.

The judge's process is asked twice a second at most. After each response it pauses nine times as long as the evaluation
took. So the judge works a tenth of the time at most, and the robot's process gets the PC's cores. A pause lasts ten
seconds at most, also after a slow response such as the first one of a judge that has to start.
"""

import contextlib
import logging
import threading
import time
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import CheckProgress, CheckStatusChanged

if TYPE_CHECKING:
    from pinel_desktop.judge.client import JudgeClient
    from pinel_desktop.judge.messages import RunStartInfo

_EVERY_S = 0.5
_PAUSE_RATIO = 9  # ratio of a pause to the duration of the evaluation before it
_MAX_PAUSE_S = 10.0

_log = logging.getLogger(__name__)


class LiveChecks:
    """Evaluates every run of an activity from its first event to its last; must be closed.

    Args:
        judge: returns the client of the app's judge; called for each evaluation.
        publish: sends an event to the page.
        language: returns the chosen language.
    """

    def __init__(
        self,
        judge: "Callable[[], JudgeClient]",
        publish: Callable[[dict[str, Any]], None],
        language: Callable[[], str],
    ) -> None:
        self._judge = judge
        self._publish, self._language = publish, language
        self._worker = ThreadPoolExecutor(1, thread_name_prefix="live-checks")
        self._run: _EventBuffer | None = None

    def expect(self, run_id: str, start_info: "RunStartInfo") -> None:
        """Selects the run to follow; its evaluation starts with its first event."""
        if self._run is not None:
            self._run.stop.set()
        self._run = _EventBuffer(run_id, start_info)

    def observe(self, event: Mapping[str, Any]) -> None:
        """Handles an event of the engine; called from one thread."""
        run = self._run
        if run is None or run.id != event["run"]:
            return
        if not run.is_followed:
            run.is_followed = True
            with contextlib.suppress(RuntimeError):  # the app is closing
                self._worker.submit(self._follow, run)
        run.add(event)

    def close(self) -> None:
        """Stops the evaluation."""
        if self._run is not None:
            self._run.stop.set()
        self._worker.shutdown(wait=False, cancel_futures=True)

    def _follow(self, run: "_EventBuffer") -> None:
        try:
            self._publish_changes(run)
        except PinelError as error:  # the judge's process exited or hangs
            _log.warning("the checks of run %s are not followed: %s", run.id, error)
        finally:
            run.forget()

    def _publish_changes(self, run: "_EventBuffer") -> None:
        """Asks the judge repeatedly until the run has ended; publishes each change of the check results."""
        from pinel_desktop.judge.messages import RunUpdate  # noqa: PLC0415 - heavy

        first: RunStartInfo | None = run.start_info
        published: list[CheckProgress] | None = None
        while True:
            is_over, events = run.is_over, run.drain()
            started_s = time.perf_counter()
            checks = self._judge().evaluate_live(RunUpdate(run.id, first, events, self._language()))
            if checks is None:
                return
            if checks != published:
                self._publish(CheckStatusChanged(run.id, checks).to_wire())
            first, published = None, checks
            pause_s = pause_after_s(time.perf_counter() - started_s)
            if is_over or (run.stop.wait(pause_s) and not run.is_over):
                return


def pause_after_s(judging_s: float) -> float:
    """Returns the pause after an evaluation that took `judging_s`."""
    return min(max(_EVERY_S, _PAUSE_RATIO * judging_s), _MAX_PAUSE_S)


class _EventBuffer:
    """A live run with the events that the judge has not received yet.

    Attributes:
        begun: start data of the run, by which the judge decides if it can evaluate the run live.
        is_followed: True after the run's first event.
        stop: set when the run has ended, or its evaluation is no longer needed.
        is_over: True after the run's last event.
    """

    def __init__(self, run_id: str, start_info: "RunStartInfo") -> None:
        self.id, self.start_info = run_id, start_info
        self.is_followed = False
        self.stop = threading.Event()
        self.is_over = False
        self._lock = threading.Lock()
        self._events: list[Mapping[str, Any]] | None = []

    def add(self, event: Mapping[str, Any]) -> None:
        with self._lock:
            if self._events is not None:
                self._events.append(event)
        if event["type"] == "run_ended":
            self.is_over = True
            self.stop.set()

    def drain(self) -> list[Mapping[str, Any]]:
        """Returns the events since the last call, and removes them."""
        with self._lock:
            events, self._events = self._events or [], []
        return events

    def forget(self) -> None:
        """Drops the events, and all later ones."""
        with self._lock:
            self._events = None
