"""Tells the page how a run that goes on stands with the checks of its activity.

The judge's process is asked, twice a second at most; a question takes it so long that it works for at most a tenth of
the time, because the robot's process needs the PC's cores more. A slow answer, as the first one of a judge that has to
start, keeps the page waiting for ten seconds at most.
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
_PAUSES = 9  # a pause is that many times as long as judging took
_MAX_PAUSE_S = 10.0

_log = logging.getLogger(__name__)


class LiveChecks:
    """Follows every run of an activity from its first event to its last; must be closed.

    Args:
        judge: the judge of the app, which is asked for when there is something to judge.
        publish: sends an event to the page.
        language: the chosen language.
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
        """Follows that run as soon as its first event comes."""
        if self._run is not None:
            self._run.stop.set()
        self._run = _EventBuffer(run_id, start_info)

    def observe(self, event: Mapping[str, Any]) -> None:
        """Takes an event of the engine, from one thread."""
        run = self._run
        if run is None or run.id != event["run"]:
            return
        if not run.is_followed:
            run.is_followed = True
            with contextlib.suppress(RuntimeError):  # the app is closing
                self._worker.submit(self._follow, run)
        run.add(event)

    def close(self) -> None:
        """Follows no run any longer."""
        if self._run is not None:
            self._run.stop.set()
        self._worker.shutdown(wait=False, cancel_futures=True)

    def _follow(self, run: "_EventBuffer") -> None:
        try:
            self._publish_changes(run)
        except PinelError as error:  # a lost judge
            _log.warning("the checks of run %s are not followed: %s", run.id, error)
        finally:
            run.forget()

    def _publish_changes(self, run: "_EventBuffer") -> None:
        """Asks the judge again and again until the run is over; tells each change."""
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
    """How long the judge is left alone after an answer that took so long."""
    return min(max(_EVERY_S, _PAUSES * judging_s), _MAX_PAUSE_S)


class _EventBuffer:
    """A run, and what it has told since it was last asked.

    Attributes:
        start_info: what the judge needs of it; it knows whether it can follow a run on a real robot.
        is_followed: whether it has told its first event.
        stop: set when it is over, or nobody wants to know any more.
        is_over: whether it has told its last event.
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
        """What has come since the last call."""
        with self._lock:
            events, self._events = self._events or [], []
        return events

    def forget(self) -> None:
        """Keeps nothing from now on."""
        with self._lock:
            self._events = None
