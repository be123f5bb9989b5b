"""The run that successive HTTP calls extend: it waits up to a minute for the next call."""

import contextlib
import threading
import time
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.engine.commands import Abandon, AnswerCapture, Append, Finish
from pinel_desktop.errors import PinelError
from pinel_desktop.execution.control import BY_PERSON
from pinel_desktop.robot.robot_profile import ROOM
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.web.legacy.run_store import Commands, LegacyRunStore, with_blocks
from storage import StoreError

Event = dict[str, Any]
Cancel = Callable[[], None]

# Time from the end of a call to the start of the next one; a later call starts a new run.
NEXT_CALL_TIMEOUT_S = 60.0
# The same after a page has reported the end of its batch: as in the original, the robot's side may
# then disconnect.
BATCH_END_TIMEOUT_S = 3.0
_END_S = 10.0
_POLL_S = 0.2


class ExecuteOutcome(NamedTuple):
    """Outcome of a call.

    Attributes:
        n_executed: number of its commands that were executed, including nested commands.
        code, params: why the call was not executed to its end; None if it was.
        results: the gesture result after each executed top-level command of the call, by its index.
    """

    state: Literal["ok", "stopped", "failed"]
    n_executed: int
    code: str | None = None
    params: Mapping[str, Any] = MappingProxyType({})
    results: Mapping[int, str] = MappingProxyType({})


def by_timer(delay_s: float, call: Callable[[], None]) -> Cancel:
    """Calls `call` after a delay; the returned function cancels it."""
    timer = threading.Timer(delay_s, call)
    timer.daemon = True
    timer.start()
    return timer.cancel


class OpenRun:
    """Executes one call after another in a live run; thread-safe.

    Args:
        make_spec: returns the spec of a run of a document.
        check: called with all commands of the run, including the new call; raises PinelError if there are too many.
        schedule: as `by_timer`.

    Attributes:
        result: the last gesture result of all runs; "" if nothing was recognised, None before any.
        capture_started_s: start of the capture that waits for a sign, by the monotonic clock; None without one.
        cut_short: outcome of the last run if it was stopped or failed; None while another run is open.
    """

    def __init__(
        self,
        engine: EngineClient,
        store: LegacyRunStore,
        make_spec: Callable[[dict[str, Any]], RunSpec],
        check: Callable[[Commands], None],
        schedule: Callable[[float, Callable[[], None]], Cancel] = by_timer,
    ) -> None:
        self.result: str | None = None
        self.cut_short: ExecuteOutcome | None = None
        self._engine, self._store = engine, store
        self._make_spec, self._check, self._schedule = make_spec, check, schedule
        self._changed = threading.Condition()
        self._state: Literal["idle", "busy", "waiting", "ending"] = "idle"
        self._outcome: ExecuteOutcome | None = None
        self._caller_left = False
        self._cancel_end: Cancel = _nothing
        self._run: str | None = None
        self._commands: Commands = []
        self._n_executed = self._n_blocks = self._n_before_call = 0
        self._results: dict[int, str] = {}
        self._run_result = ""
        self.capture_started_s: float | None = None

    @property
    def is_watched(self) -> bool:
        """True if a person can stop the robot: the caller waits, or no call is running and the robot is at rest."""
        return self._state in ("waiting", "ending") or (
            self._state == "busy" and not self._caller_left
        )

    def call(self, commands: Commands, withdrawn: threading.Event) -> ExecuteOutcome | None:
        """Executes the commands. If the caller disconnects meanwhile, stops the robot and returns None.

        Raises:
            PinelError, StoreError: as `begin`.
        """
        if not commands:
            return ExecuteOutcome("ok", 0)
        self.begin(commands)
        return self.wait(withdrawn.is_set)

    def begin(self, commands: Commands) -> None:
        """Starts the execution of the commands; `wait` must follow.

        Raises:
            PinelError: `bridge_busy`, `run_in_progress`, `engine_not_ready`, and the errors of `make_spec` and `check`.
            StoreError: if the run cannot be stored.
        """
        self._acquire()
        before = self._commands, self._n_blocks
        try:
            self._send(commands)
        except BaseException:
            self._release(*before)
            raise

    def end_capture(self) -> None:
        """Ends the capture in progress with an empty result."""
        if (run := self._run) is not None:
            with contextlib.suppress(PinelError):  # the run has just ended
                self._engine.command(run, AnswerCapture(result="", by="camera"))

    def observe(self, event: Event) -> None:
        """Handles an event of a live run. Must be called for every event, in order, after the store has it."""
        if event["run"] != self._run:
            return
        match event["type"]:
            case "capture_started":
                self.capture_started_s = time.monotonic()
            case "gesture_result":
                self.capture_started_s = None
                if event["what"] == "sign":  # the original knows no numbers
                    self.result = self._run_result = event["result"]
            case "block_ended":
                self._command_done(event["pointer"])
            case "commands_awaited":
                self._calls_done(event)
            case "run_ended":
                self._ended(event)

    def close(self) -> None:
        """Cancels the timer that ends the run; the engine, which is closed after this, ends the run."""
        self._cancel_end()

    def _acquire(self) -> None:
        with self._changed:
            self._changed.wait_for(self._is_up_to_date, _END_S)
            if self._state not in ("idle", "waiting"):
                raise PinelError("bridge_busy")
            if self._run is None and self._engine.live_run is not None:
                raise PinelError("run_in_progress")
            self._cancel_end()
            self._state, self._outcome, self._caller_left = "busy", None, False
            self._results = {}

    def _is_up_to_date(self) -> bool:
        """False if the run has ended and its `run_ended` event has not been observed yet."""
        is_over = self._run is not None and self._engine.live_run != self._run
        return self._state != "ending" and (self._state == "busy" or not is_over)

    def _release(self, commands: Commands, n_blocks: int) -> None:
        with self._changed:
            self._state = "idle"
            if self._run is not None:
                self._commands, self._n_blocks = commands, n_blocks
                self._await_next_call()

    def _send(self, commands: Commands) -> None:
        labelled, n_blocks = with_blocks(commands, self._n_blocks)
        whole = [*self._commands, *labelled]
        self._check(whole)
        run, self._n_before_call = self._run, len(self._commands)
        self._commands, self._n_blocks = whole, n_blocks
        if run is None:
            self._begin(whole)
        else:
            self._store.grow(run, whole)
            self._engine.command(run, Append(commands=labelled))

    def _begin(self, commands: Commands) -> None:
        spec = self._make_spec(self._store.document(commands))
        run = self._store.begin(spec, ROOM if spec.robot else str(spec.world["name"]))  # type: ignore[index] # a document
        self._run, self.cut_short = run, None
        try:
            self._engine.run(run, spec, [Append(commands=[])])
        except PinelError:
            self._forget()
            self._store.discard(run)
            raise

    def wait(self, has_left: Callable[[], bool]) -> ExecuteOutcome | None:
        """Returns the outcome of the call that `begin` started.

        If the caller disconnects, stops the robot and returns None.
        """
        with self._changed:
            while self._outcome is None:
                if has_left():
                    self._caller_left = True
                    break
                self._changed.wait(_POLL_S)
            outcome, run = self._outcome, self._run
        if outcome is None and run is not None:
            with contextlib.suppress(PinelError):  # the run has just ended
                self._engine.command(run, Abandon())
        return outcome

    def _command_done(self, pointer: str) -> None:
        """Records the gesture result after a top-level command of the call."""
        _, _, place = pointer.partition("/commands/")
        if place.isdecimal():
            self._results[int(place) - self._n_before_call] = self.result or ""

    def _calls_done(self, event: Event) -> None:
        with self._changed:
            if event["result"] != self._run_result:  # a command has set it; no event reported it
                self.result = self._run_result = event["result"]
            n_executed = event["n_executed"] - self._n_executed
            self._outcome = ExecuteOutcome("ok", n_executed, results=self._results)
            self._n_executed = event["n_executed"]
            self._await_next_call()
            self._changed.notify_all()

    def wait_less(self) -> None:
        """Shortens the timeout for the next call, after a page reported the end of its batch.

        A running call continues.
        """
        with self._changed:
            if self._state == "waiting":
                self._cancel_end()
                self._cancel_end = self._schedule(BATCH_END_TIMEOUT_S, self._end)

    def _await_next_call(self) -> None:
        self._state = "waiting"
        self._cancel_end = self._schedule(NEXT_CALL_TIMEOUT_S, self._end)

    def _end(self) -> None:
        with self._changed:
            run = self._run
            if self._state != "waiting" or run is None:
                return
            self._state = "ending"
        with contextlib.suppress(PinelError):  # the run has just ended
            self._engine.command(run, Finish())

    def _ended(self, event: Event) -> None:
        with self._changed:
            self._cancel_end()
            run, commands, outcome = self._run, self._commands, self._outcome_of(event)
            # A run that got no further call finishes without error. If a person ended the run while
            # it waited, its state is "finished" too.
            self.cut_short = None if self._state == "ending" else outcome
            if self._state == "busy" and event["state"] == "finished":
                # the run was stopped between two calls, before it received the commands of this one
                commands = commands[: self._n_before_call]
            self._state = "ending"
        if run is not None:
            with contextlib.suppress(StoreError):  # the run still has its document
                self._store.settle(run, commands)
        with self._changed:
            self._forget()
            self._state, self._outcome = "idle", outcome
            self._changed.notify_all()

    def _outcome_of(self, event: Event) -> ExecuteOutcome:
        n_executed = (event["n_executed"] or self._n_executed) - self._n_executed
        if event["state"] == "failed":
            reason = event["reason"], event["params"]
            return ExecuteOutcome("failed", n_executed, *reason, results=self._results)
        return ExecuteOutcome(
            "stopped", n_executed, event["reason"] or BY_PERSON, results=self._results
        )

    def _forget(self) -> None:
        self._run, self._commands = None, []
        self._run_result, self.capture_started_s = "", None
        self._n_executed = self._n_blocks = self._n_before_call = 0


def _nothing() -> None:
    return
