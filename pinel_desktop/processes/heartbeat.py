"""Probes a supervised process: a frozen one is found within seconds, a busy one is left alone.

Silence is counted in beats of the app's own thread, never by the clock. A beat that comes late (a PC that slept, an app
that was stopped, more work than the PC has cores for) says nothing about the process, and the count begins again.
"""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

BEAT_S = 0.5


@dataclass(frozen=True, slots=True)
class HangTimeouts:
    """After how much silence a process hangs, in s.

    Attributes:
        hang_timeout_s: one that does nothing at all, such as one that was stopped.
        busy_timeout_s: one that computes or waits for a disk: a long program is read, a library is loaded.
        start_timeout_s: one that has not said yet that it is ready.
    """

    hang_timeout_s: float = 2.0
    busy_timeout_s: float = 10.0
    start_timeout_s: float = 60.0
    beat_s: float = BEAT_S


TIMEOUTS = HangTimeouts()


class ResponseTimer:
    """Counts how long a process has been silent while the app ran on time."""

    def __init__(self, beat_s: float, now_s: float) -> None:
        self._beat_s, self._last_s = beat_s, now_s
        self._n_received = -1
        self._n_beats = 0

    def beat(self, now_s: float, n_received: int, *, is_app_busy: bool) -> float:
        """To be called at each beat; gives the silence in s.

        Args:
            n_received: messages of the process so far.
            is_app_busy: more of them may be waiting to be read.
        """
        is_late = now_s - self._last_s > 2 * self._beat_s
        is_counted = n_received == self._n_received and not is_late and not is_app_busy
        self._last_s, self._n_received = now_s, n_received
        self._n_beats = self._n_beats + 1 if is_counted else 0
        return self._n_beats * self._beat_s


SampleResult = Literal["nothing", "something", "traced"]


class ProcessSampler:
    """What a process does while it is silent, as the system tells it."""

    def __init__(self) -> None:
        self._used_s: float | None = None

    def reset(self) -> None:
        """Another silence begins."""
        self._used_s = None

    def sample(self, pid: int) -> SampleResult:
        """What it has done since the first sample of this silence; nothing where it has exited."""
        import psutil  # noqa: PLC0415 - for a process that is silent only

        try:
            process = psutil.Process(pid)
            status, used_s = process.status(), sum(process.cpu_times()[:2])
        except psutil.Error:
            return "nothing"
        if self._used_s is None:
            self._used_s = used_s
        if status == psutil.STATUS_TRACING_STOP:
            return "traced"
        if status == psutil.STATUS_STOPPED:
            return "nothing"
        works = status in (psutil.STATUS_RUNNING, psutil.STATUS_DISK_SLEEP)
        return "something" if works or used_s > self._used_s else "nothing"


def is_hung(
    unresponsive_s: float, timeouts: HangTimeouts, *, is_ready: bool, doing: SampleResult
) -> bool:
    """Whether a process is to be replaced; one that a debugger holds never is."""
    if doing == "traced":
        return False
    if not is_ready:
        return unresponsive_s >= timeouts.start_timeout_s
    is_busy = doing == "something"
    return unresponsive_s >= (timeouts.busy_timeout_s if is_busy else timeouts.hang_timeout_s)


@dataclass(frozen=True, slots=True)
class ProcessSnapshot:
    """What the app knows of its process at a beat."""

    pid: int | None
    n_received: int
    is_ready: bool
    is_app_busy: bool


class Heartbeat:
    """A thread that probes the process at each beat, and ends one that hangs.

    Args:
        snapshot: tells how the process stands.
        probe: sends it the request that it answers as soon as it does its work.
        kill: kills the process with that id, if it is still the one.
    """

    def __init__(
        self,
        snapshot: Callable[[], ProcessSnapshot],
        probe: Callable[[], object],
        kill: Callable[[int], object],
        timeouts: HangTimeouts,
    ) -> None:
        self._snapshot, self._probe, self._kill, self._timeouts = snapshot, probe, kill, timeouts
        self._closing = threading.Event()
        self._sampler = ProcessSampler()

    def start(self, name: str) -> None:
        threading.Thread(target=self._beat, name=name, daemon=True).start()

    def close(self) -> None:
        """Ends no process any more; returns at once."""
        self._closing.set()

    def _beat(self) -> None:
        beat_s, pid = self._timeouts.beat_s, None
        response_timer = ResponseTimer(beat_s, time.monotonic())
        while not self._closing.wait(beat_s):
            now = self._snapshot()
            if now.pid != pid:  # the next one has its time too
                pid, response_timer = now.pid, ResponseTimer(beat_s, time.monotonic())
            unresponsive_s = response_timer.beat(
                time.monotonic(), now.n_received, is_app_busy=now.is_app_busy
            )
            if pid is not None and self._is_hung(pid, unresponsive_s, now):
                self._kill(pid)
            elif now.is_ready:
                self._probe()

    def _is_hung(self, pid: int, unresponsive_s: float, now: ProcessSnapshot) -> bool:
        if not unresponsive_s:
            self._sampler.reset()
            return False
        doing = self._sampler.sample(pid)
        return is_hung(unresponsive_s, self._timeouts, is_ready=now.is_ready, doing=doing)
