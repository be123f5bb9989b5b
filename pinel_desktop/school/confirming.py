"""Re-verifies runs that came with merged files, while no run is live on this PC: repeats each run and judges it again.

A process of its own (`pinel runs verify`) repeats one run at a time, at the lowest priority. If a run starts on this
PC, the repeating process is killed and the repetition is tried again later. If the repeated record is the same, the
judge decides as for a run of this PC. Only then the pass counts.
"""

import json
import logging
import subprocess
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Literal

from pinel_desktop.errors import PinelError
from pinel_desktop.processes import own_command
from storage import SIMULATOR, RunRow, Store, StoreError
from storage.run_validity import ConfirmationFinding

if TYPE_CHECKING:
    from pinel_desktop.judge.messages import Verdict

_log = logging.getLogger(__name__)
_SCAN_INTERVAL_S = 15.0  # between two searches for marked runs
_POLL_S = 0.2  # between two checks whether a run has started on this PC
_TIMEOUT_S = 600.0  # a run that takes longer to repeat counts as not repeatable
_SAME = ("identical", "equal")
Repeated = Literal["same", "different", "impossible", "interrupted"]


class Confirmer:
    """Re-verifies marked runs on a thread; must be closed.

    Args:
        judge: returns the verdict on a run from its record, as the grader does.
        command: repeats the run whose id is appended, and prints the outcome as JSON; None is
            `pinel runs verify --json`.
        interval_s: time between two searches for marked runs without `check_now`.
    """

    def __init__(
        self,
        store: Store,
        judge: "Callable[[RunRow], Verdict]",
        grade: Callable[[str], None] = lambda _run_id: None,
        *,
        command: Sequence[str] | None = None,
        interval_s: float = _SCAN_INTERVAL_S,
    ) -> None:
        self._store, self._judge, self._grade = store, judge, grade
        self._command = command or own_command("--db", str(store.path), "runs", "verify", "--json")
        self._interval_s = interval_s
        self._check_requested, self._closing = threading.Event(), threading.Event()
        self._thread = threading.Thread(target=self._work, name="confirmer", daemon=True)

    def start(self) -> None:
        """Starts the search for marked runs."""
        self._thread.start()

    def check_now(self) -> None:
        """Searches for marked runs at once; called when a file was merged or a run has ended."""
        self._check_requested.set()

    def close(self) -> None:
        """Kills the process that repeats a run; the run stays marked."""
        self._closing.set()
        self._check_requested.set()
        if self._thread.is_alive():
            self._thread.join()

    def _work(self) -> None:
        while True:
            self._check_requested.clear()
            if self._closing.is_set():
                return
            try:
                if self._store.can_write:
                    self._confirm_all()
            except (StoreError, OSError) as error:
                # a full disk, or no memory for a process: tried again after the interval
                _log.warning("runs were not confirmed: %s", error)
            self._check_requested.wait(self._interval_s)

    def _confirm_all(self) -> None:
        """Tries each marked run once, including runs that are merged meanwhile."""
        tried: set[str] = set()
        while left := [key for key in self._store.unconfirmed.waiting() if key not in tried]:
            if self._is_busy():
                break
            tried.add(left[0])
            self.confirm(left[0])

    def _is_busy(self) -> bool:
        return self._closing.is_set() or bool(self._store.runs.running())

    def confirm(self, run_id: str) -> None:
        """Repeats one run and stores the finding; stores nothing if a run starts on this PC meanwhile."""
        try:
            run = self._store.runs.get(run_id)
            found = self._repeated(run)
            if found == "interrupted":
                return
            finding = self._finding(run, found)
        except (PinelError, StoreError) as error:
            # the run, its activity or its program is missing or damaged
            if isinstance(error, PinelError) and error.code == "judge_lost":
                return  # the PC was busy, or the app is closing: tried again
            _log.info("run %s cannot be confirmed: %s", run_id, error)
            finding = "not_repeatable"
        if finding is not None:
            self._store.unconfirmed.note(run_id, finding)
            return
        self._store.unconfirmed.confirm(run_id)
        self._grade(run_id)  # does nothing if the run already has its result

    def _finding(self, run: RunRow, found: Repeated) -> ConfirmationFinding | None:
        """Returns the finding that prevents the confirmation; None if the run is confirmed."""
        if found == "impossible":
            return "not_repeatable"
        if found == "different":
            return "differs"
        if run.passed and not (run.state == "finished" and self._judge(run).passed):
            return "not_passed"
        return None

    def _repeated(self, run: RunRow) -> Repeated:
        if run.link != SIMULATOR:
            return "impossible"
        with subprocess.Popen(
            [*self._command, run.id],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        ) as process:
            _lower_priority(process.pid)
            return self._await_outcome(process)

    def _await_outcome(self, process: "subprocess.Popen[bytes]") -> Repeated:
        waited_s = 0.0
        while True:
            try:
                output, _ = process.communicate(timeout=_POLL_S)
                return _outcome(output)
            except subprocess.TimeoutExpired:
                waited_s += _POLL_S
            if self._is_busy() or waited_s > _TIMEOUT_S:
                process.kill()
                process.communicate()
                return "impossible" if waited_s > _TIMEOUT_S else "interrupted"


def _outcome(output: bytes) -> Repeated:
    try:
        outcome = json.loads(output)["outcome"]
    except (ValueError, KeyError, TypeError):  # no JSON, but a text why the run cannot be repeated
        return "impossible"
    return "same" if outcome in _SAME else "different"


def _lower_priority(pid: int) -> None:
    """Gives the process only the processor time that other processes leave."""
    import psutil  # noqa: PLC0415 - not needed to start

    with suppress(psutil.Error, OSError):
        # the constant exists on Windows only; 19 is the lowest priority for `nice`
        lowest = getattr(psutil, "IDLE_PRIORITY_CLASS", 19)
        psutil.Process(pid).nice(lowest)
