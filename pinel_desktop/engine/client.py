"""The app's side of the engine: owns its process, sends messages, hands on its events."""

import contextlib
import logging
import subprocess
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from typing import Any, BinaryIO, Literal, cast

from pinel_desktop.engine.commands import Command, Evaluate
from pinel_desktop.engine.protocol import Message, read_messages, write_message
from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import RunEnded
from pinel_desktop.events.stamp import EventStamp
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.processes import own_command
from pinel_desktop.runs.spec import RunSpec

EngineState = Literal["starting", "ready", "lost"]
EventSink = Callable[[dict[str, Any]], None]

_log = logging.getLogger(__name__)
_CLOSE_TIMEOUT_S = 4.0
_ANSWER_TIMEOUT_S = 2.0
# A process that dies sooner than this after its start, so often in a row, is not started again by itself.
_SHORT_LIFE_S = 3.0
_SHORT_LIVES = 3


class EngineClient:
    """Starts the engine process and keeps one running; thread-safe.

    `on_event` is called on the reader thread with every event object of ARCHITECTURE.md, in order. When the
    process dies during a run, the client makes up the missing `run_ended` (failed, `engine_lost`).
    """

    def __init__(self, on_event: EventSink, command: Sequence[str] | None = None) -> None:
        self._on_event = on_event
        self._command = list(command or own_command("engine"))
        self._lock = threading.RLock()
        self._process: subprocess.Popen[bytes] | None = None
        self._reader: threading.Thread | None = None
        self._state: EngineState = "starting"
        self._live: str | None = None
        self._next_seq = 0
        self._tick = 0
        self._closing = False
        self._n_short_lives = 0
        self._ready = threading.Event()
        self._n_questions = 0
        self._questions: dict[int, Future[Any]] = {}

    @property
    def state(self) -> EngineState:
        """`starting` until the process has said it is ready; `lost` when it cannot be started again."""
        return self._state

    @property
    def live_run(self) -> str | None:
        """Id of the run that has begun and not ended."""
        return self._live

    @property
    def pid(self) -> int | None:
        """Id of the engine's process."""
        return self._process.pid if self._process else None

    def start(self) -> None:
        """Starts the process; returns at once, the state tells when it is ready."""
        with self._lock:
            if self._closing:  # a process that died while the app was ending needs no successor
                return
            self._state = "starting"
            self._ready.clear()
            try:
                self._process = subprocess.Popen(
                    self._command,
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
                )
            except OSError as error:
                _log.error("the engine does not start: %s", error)
                self._state = "lost"
                self._ready.set()
                return
            self._reader = threading.Thread(
                target=self._read, args=(self._process,), name="engine-reader", daemon=True
            )
            self._reader.start()

    def wait_until_ready(self, timeout_s: float) -> bool:
        """Waits for the process; False when it is not ready after `timeout_s`."""
        self._ready.wait(timeout_s)
        return self._state == "ready"

    def run(self, run_id: str, spec: RunSpec, commands: Sequence[Command] = ()) -> None:
        """Begins a live run, whose inputs are a person's. Raises PinelError `run_in_progress` or `engine_not_ready`.

        Args:
            commands: applied before the first block begins, such as breakpoints, a speed, or a step to hold there.
        """
        with self._lock:
            if self._live is not None:
                raise PinelError("run_in_progress")
            if self._state == "lost":  # one more try, which the next press of Run will find
                self.start()
            if self._state != "ready":
                raise PinelError("engine_not_ready")
            self._live, self._next_seq, self._tick = run_id, 0, 0
            first = [dict(command) for command in commands]
            self._send({"run": run_id, "spec": spec.as_message(), "commands": first})

    def command(self, run_id: str, command: Command) -> Any:
        """Sends a command to the live run; gives the value of `Evaluate` as plain data, None for all others.

        Raises PinelError `run_not_live` when that run is not the live one; for `Evaluate` also `run_not_paused`,
        `peek_not_possible`, `peek_invalid` and what evaluating the expression raises.
        """
        if isinstance(command, Evaluate):
            return self._evaluate(run_id, command)
        self._tell(run_id, command)
        return None

    def _evaluate(self, run_id: str, command: Evaluate) -> Any:
        answer: Future[Any] = Future()
        with self._lock:
            question = self._n_questions = self._n_questions + 1
            self._questions[question] = answer
        try:
            self._tell(run_id, command, question=question)
            return answer.result(_ANSWER_TIMEOUT_S)
        except TimeoutError as error:  # the run went on before the question's turn came
            raise PinelError("run_not_paused") from error
        finally:
            self._questions.pop(question, None)

    def close(self) -> None:
        """Ends the pipe (the engine sends zeros and exits) and waits for the process."""
        with self._lock:
            self._closing = True
            process, reader = self._process, self._reader
        if process is None or reader is None:
            return
        if (
            self._state == "starting"
        ):  # it drives nothing yet, and its imports would keep us waiting
            process.kill()
        with contextlib.suppress(OSError):  # the process may have ended already
            _pipe(process.stdin).close()
        try:
            process.wait(_CLOSE_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        if reader is not threading.current_thread():
            reader.join()

    def _tell(self, run_id: str, command: Command, **more: Any) -> None:
        with self._lock:
            if self._live != run_id:
                raise PinelError("run_not_live")
            self._send({"run": run_id, "command": dict(command), **more})

    def _send(self, message: Message) -> None:
        try:
            write_message(_pipe(self._process.stdin if self._process else None), message)
        except OSError:
            _log.warning("the engine has ended; its reader reports it")

    def _read(self, process: subprocess.Popen[bytes]) -> None:
        born = time.monotonic()
        events = _pipe(process.stdout)
        for message in read_messages(events):
            if message.get("type") == "engine_ready":
                self._state = "ready"
                self._ready.set()
            elif message.get("type") == "evaluated":
                self._settle(message)
            else:
                self._hand_on(message)
        events.close()
        process.wait()
        if not self._closing:
            self._revive(short_life=time.monotonic() - born < _SHORT_LIFE_S)

    def _settle(self, message: Message) -> None:
        """Gives an answer of the engine to who asked."""
        answer = self._questions.pop(message["question"], None)
        if answer is None:
            return
        if "code" in message:
            answer.set_exception(PinelError(message["code"], **message["params"]))
        else:
            answer.set_result(message["value"])

    def _hand_on(self, event: dict[str, Any]) -> None:
        with self._lock:
            self._next_seq, self._tick = event["seq"] + 1, event["tick"]
            if event["type"] == "run_ended" and event["run"] == self._live:
                self._live = None
        self._on_event(event)

    def _revive(self, *, short_life: bool) -> None:
        """Reports the run that was lost with the process, and starts a new one."""
        with self._lock:
            lost_run, seq, tick = self._live, self._next_seq, self._tick
            self._live = None
            self._state = "starting"
            process = self._process
        if process is not None and process.stdin is not None:
            process.stdin.close()
        _log.error("the engine died (run: %s)", lost_run)
        if lost_run is not None:
            ended = RunEnded.cut_off("engine_lost", tick / TICK_HZ)
            self._on_event(EventStamp(lost_run, seq).wire(tick, ended))
        self._n_short_lives = self._n_short_lives + 1 if short_life else 0
        if self._n_short_lives >= _SHORT_LIVES:
            self._state = "lost"
            self._ready.set()
        else:
            self.start()


def _pipe(pipe: Any) -> BinaryIO:
    if pipe is None:
        raise OSError("the process has no pipe")
    return cast(BinaryIO, pipe)
