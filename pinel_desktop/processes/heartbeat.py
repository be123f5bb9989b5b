"""Whether a process that the app owns still answers: a frozen one is found within seconds, a busy one is left alone.

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
class Patience:
    """After how much silence a process hangs, in s.

    Attributes:
        still_s: one that does nothing at all, such as one that was stopped.
        busy_s: one that computes or waits for a disk: a long program is read, a library is loaded.
        start_s: one that has not said yet that it is ready.
    """

    still_s: float = 2.0
    busy_s: float = 10.0
    start_s: float = 60.0
    beat_s: float = BEAT_S


class Silence:
    """Counts how long a process has been silent while the app ran on time."""

    def __init__(self, beat_s: float, now_s: float) -> None:
        self._beat_s, self._last_s = beat_s, now_s
        self._n_heard = -1
        self._n_beats = 0

    def beat(self, now_s: float, n_heard: int, *, is_app_busy: bool) -> float:
        """To be called at each beat; gives the silence in s.

        Args:
            n_heard: messages of the process so far.
            is_app_busy: what the process says may be waiting to be read.
        """
        is_late = now_s - self._last_s > 2 * self._beat_s
        is_counted = n_heard == self._n_heard and not is_late and not is_app_busy
        self._last_s, self._n_heard = now_s, n_heard
        self._n_beats = self._n_beats + 1 if is_counted else 0
        return self._n_beats * self._beat_s


Doing = Literal["nothing", "something", "traced"]


class Activity:
    """What a process does while it is silent, as the system tells it."""

    def __init__(self) -> None:
        self._used_s: float | None = None

    def forget(self) -> None:
        """Another silence begins."""
        self._used_s = None

    def look(self, pid: int) -> Doing:
        """What it has done since the first look at this silence; nothing where it has gone."""
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


def hangs(silent_s: float, patience: Patience, *, is_ready: bool, doing: Doing) -> bool:
    """Whether a process is to be ended; one that a debugger holds never is."""
    if doing == "traced":
        return False
    if not is_ready:
        return silent_s >= patience.start_s
    return silent_s >= (patience.busy_s if doing == "something" else patience.still_s)


@dataclass(frozen=True, slots=True)
class Seen:
    """What the app knows of its process at a beat."""

    pid: int | None
    n_heard: int
    is_ready: bool
    is_app_busy: bool


class Heartbeat:
    """A thread that asks the process for a sign of life, and ends one that hangs.

    Args:
        see: tells how the process stands.
        ask: sends it the question that it answers at once.
        end: kills the process with that id, if it is still the one.
    """

    def __init__(
        self,
        see: Callable[[], Seen],
        ask: Callable[[], object],
        end: Callable[[int], object],
        patience: Patience,
    ) -> None:
        self._see, self._ask, self._end, self._patience = see, ask, end, patience
        self._closing = threading.Event()
        self._activity = Activity()

    def start(self, name: str) -> None:
        threading.Thread(target=self._beat, name=name, daemon=True).start()

    def close(self) -> None:
        """Ends no process any more; returns at once."""
        self._closing.set()

    def _beat(self) -> None:
        beat_s, pid = self._patience.beat_s, None
        silence = Silence(beat_s, time.monotonic())
        while not self._closing.wait(beat_s):
            seen = self._see()
            if seen.pid != pid:  # the next one has its time too
                pid, silence = seen.pid, Silence(beat_s, time.monotonic())
            silent_s = silence.beat(time.monotonic(), seen.n_heard, is_app_busy=seen.is_app_busy)
            if pid is not None and self._hangs(pid, silent_s, seen):
                self._end(pid)
            elif seen.is_ready:
                self._ask()

    def _hangs(self, pid: int, silent_s: float, seen: Seen) -> bool:
        if not silent_s:
            self._activity.forget()
            return False
        doing = self._activity.look(pid)
        return hangs(silent_s, self._patience, is_ready=seen.is_ready, doing=doing)
