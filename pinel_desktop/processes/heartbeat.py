"""Heartbeat of a supervised process: detects a hung process within seconds, and tolerates a busy process for longer.

Response timeouts are counted in beats of the app's own thread, not by the clock. A late beat means that the PC slept,
the app was stopped, or the cores are overloaded. It is no evidence about the process, so the count restarts.
"""

import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

BEAT_S = 0.5
# Windows calls every process running that is not stopped
_HAS_STATUS = sys.platform != "win32"


@dataclass(frozen=True, slots=True)
class HangTimeouts:
    """Response timeouts after which a process counts as hung, in s.

    Attributes:
        hang_timeout_s: for a process that does nothing at all, such as a stopped process.
        busy_timeout_s: for a process that computes or waits for a disk: it reads a long program, or loads a library.
        start_timeout_s: for a process that has not sent its ready message yet.
        beat_s: period of the probes.
    """

    hang_timeout_s: float = 2.0
    busy_timeout_s: float = 10.0
    start_timeout_s: float = 60.0
    beat_s: float = BEAT_S


TIMEOUTS = HangTimeouts()


class ResponseTimer:
    """Measures the time without a message from a process, while the app ran on time."""

    def __init__(self, beat_s: float, now_s: float) -> None:
        self._beat_s, self._last_s = beat_s, now_s
        self._n_received = -1
        self._n_beats = 0

    def beat(self, now_s: float, n_received: int, *, is_app_busy: bool) -> float:
        """Counts a beat; returns the time without a response, in s. Call it at each beat.

        Args:
            n_received: number of messages received from the process so far.
            is_app_busy: whether the app handles a message, so that further messages may be unread.
        """
        is_late = now_s - self._last_s > 2 * self._beat_s
        is_counted = n_received == self._n_received and not is_late and not is_app_busy
        self._last_s, self._n_received = now_s, n_received
        self._n_beats = self._n_beats + 1 if is_counted else 0
        return self._n_beats * self._beat_s


SampleResult = Literal["nothing", "something", "traced"]


class ProcessSampler:
    """Samples from the operating system whether an unresponsive process works."""

    def __init__(self) -> None:
        self._used_s: float | None = None

    def reset(self) -> None:
        """Discards the samples, so that the next sample is the first again."""
        self._used_s = None

    def sample(self, pid: int) -> SampleResult:
        """Returns the activity of the process since the first sample after `reset`; "nothing" if it has exited."""
        import psutil  # noqa: PLC0415 - needed for an unresponsive process only

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
        is_working = status in (psutil.STATUS_RUNNING, psutil.STATUS_DISK_SLEEP)
        works = _HAS_STATUS and is_working
        return "something" if works or used_s > self._used_s else "nothing"


def is_hung(
    unresponsive_s: float, timeouts: HangTimeouts, *, is_ready: bool, doing: SampleResult
) -> bool:
    """Returns whether a process must be replaced; never true for a process stopped by a debugger."""
    if doing == "traced":
        return False
    if not is_ready:
        return unresponsive_s >= timeouts.start_timeout_s
    is_busy = doing == "something"
    return unresponsive_s >= (timeouts.busy_timeout_s if is_busy else timeouts.hang_timeout_s)


@dataclass(frozen=True, slots=True)
class ProcessSnapshot:
    """State of the process at a beat."""

    pid: int | None
    n_received: int
    is_ready: bool
    is_app_busy: bool


class Heartbeat:
    """A thread that probes the process at each beat, and kills a hung process.

    Args:
        snapshot: returns the state of the process.
        probe: sends the probe, which the process answers between two pieces of work.
        kill: kills the process with this id, if it is still the current process.
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
        """Stops probing, so that no process is killed from now on; returns at once."""
        self._closing.set()

    def _beat(self) -> None:
        beat_s, pid = self._timeouts.beat_s, None
        response_timer = ResponseTimer(beat_s, time.monotonic())
        while not self._closing.wait(beat_s):
            now = self._snapshot()
            if now.pid != pid:  # a new process gets the full timeout
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
