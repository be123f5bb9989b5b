"""Supervisor of a child process: starts it, sends requests and probes, replaces it if it dies or hangs, ends it.

A process that is needed now and then only has an idle timeout: it ends, and `start` starts the next one.
"""

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
        idle_end_s: ends a process without a request or `mark_used` for so long, in s of `clock`; None never does.
    """

    def __init__(  # noqa: PLR0913 - callbacks and timeouts, each with a default
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
        idle_end_s: float | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._name, self._command, self._lost_code = name, list(command), lost_code
        self._on_message, self._on_death = on_message, on_death
        self._on_ready, self._on_lost = on_ready, on_lost
        self._lock = threading.RLock()
        self._process: subprocess.Popen[bytes] | None = None
        self._ending: subprocess.Popen[bytes] | None = None  # the last idle process
        self._reader: threading.Thread | None = None
        self._outbox = Outbox()
        self._state: ProcessState = "starting"
        self._closing = False
        self._n_fast_failures = 0
        self._ready = threading.Event()
        self._n_received, self._is_receiving = 0, False
        self._numbers = count(1)
        self._requests: dict[int, Future[Any]] = {}
        self._idle_end_s, self._clock, self._used_s = idle_end_s, clock, 0.0
        self._heartbeat = Heartbeat(self._snapshot, self._probe, self._kill_hung, timeouts)
        self._has_heartbeat = False

    @property
    def state(self) -> ProcessState:
        """`starting` until the process is ready, also after an idle one; `lost` after the supervisor has given up."""
        return self._state

    @property
    def pid(self) -> int | None:
        """Id of the process; None before its start, and from its end as an idle process to the next start."""
        return self._process.pid if self._process else None

    def start(self) -> None:
        """Starts the process, or restarts an idle or lost one; else marks it as used. Returns at once."""
        with self._lock:
            self.mark_used()
            if self._process is not None and self._state != "lost":
                return
            if not self._has_heartbeat:
                self._has_heartbeat = True
                self._heartbeat.start(f"{self._name}-heartbeat")
            self._kill_ending()
            self._launch()

    def mark_used(self) -> None:
        """Restarts the idle timeout."""
        self._used_s = self._clock()

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
            self.mark_used()
        try:
            if not self.send({"request": number, **message}):
                raise PinelError(self._lost_code)
            return answer.result(timeout_s)
        finally:
            self._requests.pop(number, None)
            self.mark_used()

    def close(self) -> None:
        """Fails pending requests, closes the pipe after all sent messages, and waits until the process exits."""
        with self._lock:
            self._closing = True
            self._fail_requests()
            self._heartbeat.close()
            self._ready.set()  # releases callers of `wait_until_ready`
            self._kill_ending()
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

    def _probe(self) -> None:
        if not self._end_if_idle():
            self.send(PING)

    def _end_if_idle(self) -> bool:
        """Ends a ready process that nobody uses; returns whether it was ended."""
        with self._lock:
            if self._idle_end_s is None or self._clock() - self._used_s < self._idle_end_s:
                return False
            if self._requests or self._closing or self._state != "ready":
                return False
            self._ending, self._process = self._process, None
            self._state = "starting"
            self._ready.clear()
            self._outbox.end()
        _log.info("the %s is idle and ends", self._name)
        return True

    def _kill_ending(self) -> None:
        """Kills an idle process that has not ended by itself; it has nothing left to do."""
        if self._ending is not None:
            self._ending.kill()

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
            if process is not self._process:  # an idle process that is ending
                continue
            self._n_received += 1
            self._is_receiving = True
            self._receive(message)
            self._is_receiving = False
        messages.close()
        status = process.wait()
        if not self._closing and process is self._process:
            _log.error("the %s died with status %s", self._name, status)
            self._replace(is_fast_failure=time.monotonic() - born < _MIN_UPTIME_S)

    def _receive(self, message: Message) -> None:
        if message.get("type") == f"{self._name}_ready":
            self.mark_used()
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
