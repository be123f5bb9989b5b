"""Supervisor of a child process: starts it, sends requests and probes, replaces it if it dies or hangs, ends it."""

import logging
import subprocess
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from itertools import count
from typing import Any, BinaryIO, Literal, cast

from pinel_desktop.errors import PinelError
from pinel_desktop.processes.heartbeat import TIMEOUTS, HangTimeouts, Heartbeat, ProcessSnapshot
from pinel_desktop.processes.messages import PING, PONG, RESPONSE, Message, encoded, read_messages
from pinel_desktop.processes.outbox import Outbox
from pinel_desktop.processes.standard_streams import error_output

ProcessState = Literal["starting", "ready", "lost"]

_log = logging.getLogger(__name__)
_CLOSE_TIMEOUT_S = 4.0
# The supervisor gives up after _MAX_FAST_FAILURES deaths in a row, each within _MIN_UPTIME_S.
_MIN_UPTIME_S = 3.0
_MAX_FAST_FAILURES = 3


def _ignore(*_: object) -> None:
    """Does nothing; default of each callback."""


class Supervisor:
    """Supervises one process and exchanges JSON lines with it; thread-safe. No call blocks on a hung process.

    The process reports that it is ready with a message of the type `NAME_ready`. It answers each `PING` with a `PONG`
    and each request with a `response`. It exits when its standard input ends.

    Args:
        name: name of the process, for the ready message and the log.
        command: command line that starts the process.
        lost_code: code of the PinelError for a request to a process that has died, or does not read.
        on_message: called on the reader thread with every other message, in order.
        on_death: called on the reader thread if the process died without `close`, before its replacement starts.
        on_ready: called on the reader thread when the process, or a replacement, is ready.
        on_lost: called when the supervisor gives up; must not block.
        timeouts: after these timeouts a hung process is killed, and so replaced.
    """

    def __init__(
        self,
        name: str,
        command: Sequence[str],
        lost_code: str,
        *,
        on_message: Callable[[Message], object] = _ignore,
        on_death: Callable[[], object] = _ignore,
        on_ready: Callable[[], object] = _ignore,
        on_lost: Callable[[], object] = _ignore,
        timeouts: HangTimeouts = TIMEOUTS,
    ) -> None:
        self._name, self._command, self._lost_code = name, list(command), lost_code
        self._on_message, self._on_death = on_message, on_death
        self._on_ready, self._on_lost = on_ready, on_lost
        self._lock = threading.RLock()
        self._process: subprocess.Popen[bytes] | None = None
        self._reader: threading.Thread | None = None
        self._outbox = Outbox()
        self._state: ProcessState = "starting"
        self._closing = False
        self._n_fast_failures = 0
        self._ready = threading.Event()
        self._n_received, self._is_receiving = 0, False
        self._numbers = count(1)
        self._requests: dict[int, Future[Any]] = {}
        self._heartbeat = Heartbeat(
            self._snapshot, lambda: self.send(PING), self._kill_hung, timeouts
        )

    @property
    def state(self) -> ProcessState:
        """`starting` until the process is ready; `lost` after the supervisor has given up."""
        return self._state

    @property
    def pid(self) -> int | None:
        """Id of the process; None before its start."""
        return self._process.pid if self._process else None

    def start(self) -> None:
        """Starts the process, or restarts a lost process; does nothing while it runs. Returns at once."""
        with self._lock:
            if self._process is None and self._state != "lost":
                self._heartbeat.start(f"{self._name}-heartbeat")
            elif self._state != "lost":
                return
            self._launch()

    def wait_until_ready(self, timeout_s: float) -> bool:
        """Waits for the process; False if it is not ready after `timeout_s`, or was closed or lost before."""
        self._ready.wait(timeout_s)
        return self._state == "ready"

    def send(self, message: Message) -> bool:
        """Sends a message, in order, without waiting. A message to a process that has ended is lost.

        Returns False if the process does not read and its queue overflows, so that the message was dropped.
        """
        line = encoded(message)
        with self._lock:
            return self._closing or self._outbox.put(line)

    def request(self, message: Message, timeout_s: float) -> Any:
        """Sends a request and returns the value of its response.

        Raises:
            TimeoutError: no response after `timeout_s`.
            PinelError: `lost_code` if the process is not ready, dies or does not read; the error in the response.
        """
        number, answer = next(self._numbers), Future[Any]()
        with self._lock:  # if the process dies from here on, `_fail_requests` finds the request
            if self._closing or self._state != "ready":
                raise PinelError(self._lost_code)
            self._requests[number] = answer
        try:
            if not self.send({"request": number, **message}):
                raise PinelError(self._lost_code)
            return answer.result(timeout_s)
        finally:
            self._requests.pop(number, None)

    def close(self) -> None:
        """Fails pending requests, closes the pipe after all sent messages, and waits until the process exits."""
        with self._lock:
            self._closing = True
            self._fail_requests()
            self._heartbeat.close()
            self._ready.set()  # releases callers of `wait_until_ready`
            process, reader, outbox = self._process, self._reader, self._outbox
        if process is None or reader is None:
            return
        if self._state == "starting":  # nothing to finish yet, and its imports would delay the exit
            process.kill()
        outbox.end()
        try:
            process.wait(_CLOSE_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        if reader is not threading.current_thread():
            reader.join()

    def _launch(self) -> None:
        with self._lock:
            if self._closing:  # a process that died while the app was ending needs no replacement
                return
            self._state = "starting"
            self._ready.clear()
            try:
                self._process = subprocess.Popen(
                    self._command,
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    stderr=error_output(),
                    creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
                )
            except OSError as error:
                _log.error("the %s does not start: %s", self._name, error)
                self._give_up()
                return
            self._outbox = Outbox()
            self._outbox.start_writing(_pipe(self._process.stdin), f"{self._name}-writer")
            self._reader = threading.Thread(
                target=self._read, args=(self._process,), name=f"{self._name}-reader", daemon=True
            )
            self._reader.start()

    def _kill_hung(self, pid: int) -> None:
        with self._lock:
            if self._process and self._process.pid == pid and not self._closing:
                _log.error("the %s hangs and is ended", self._name)
                self._process.kill()

    def _snapshot(self) -> ProcessSnapshot:
        with self._lock:
            is_ready = self._state == "ready"
            pid = None if self._state == "lost" else self.pid
            return ProcessSnapshot(pid, self._n_received, is_ready, self._is_receiving)

    def _read(self, process: subprocess.Popen[bytes]) -> None:
        born = time.monotonic()
        messages = _pipe(process.stdout)
        for message in read_messages(messages):
            self._n_received += 1
            self._is_receiving = True
            self._receive(message)
            self._is_receiving = False
        messages.close()
        status = process.wait()
        if not self._closing:
            _log.error("the %s died with status %s", self._name, status)
            self._replace(is_fast_failure=time.monotonic() - born < _MIN_UPTIME_S)

    def _receive(self, message: Message) -> None:
        if message.get("type") == f"{self._name}_ready":
            self._state = "ready"
            self._ready.set()
            self._on_ready()
        elif message.get("type") == RESPONSE:
            self._settle(message)
        elif message != PONG:
            self._on_message(message)

    def _settle(self, message: Message) -> None:
        """Passes a response to the caller of `request`, if it still waits."""
        with self._lock:
            answer = self._requests.pop(message["request"], None)
        if answer is None:
            return
        if "code" in message:
            answer.set_exception(PinelError(message["code"], **message["params"]))
        else:
            answer.set_result(message["value"])

    def _fail_requests(self) -> None:
        with self._lock:
            unanswered, self._requests = list(self._requests.values()), {}
        for answer in unanswered:
            answer.set_exception(PinelError(self._lost_code))

    def _replace(self, *, is_fast_failure: bool) -> None:
        with self._lock:
            self._state = "starting"
            if not self._closing:
                self._ready.clear()  # callers of `wait_until_ready` now wait for the replacement
            self._outbox.end()
        self._fail_requests()
        self._on_death()
        self._n_fast_failures = self._n_fast_failures + 1 if is_fast_failure else 0
        if self._n_fast_failures >= _MAX_FAST_FAILURES:
            self._give_up()
        else:
            self._launch()

    def _give_up(self) -> None:
        self._state = "lost"
        self._on_lost()  # before callers of `wait_until_ready` return
        with self._lock:
            if self._state == "lost":  # else `start` has restarted the process meanwhile
                self._ready.set()


def _pipe(pipe: Any) -> BinaryIO:
    if pipe is None:
        raise OSError("the process has no pipe")
    return cast(BinaryIO, pipe)
