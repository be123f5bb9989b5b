"""One process that the app owns: it is started, started again when it dies, and ended with the app."""

import logging
import subprocess
import threading
import time
from collections.abc import Callable, Sequence
from typing import Any, BinaryIO, Literal, cast

from pinel_desktop.processes.heartbeat import Heartbeat, Patience, Seen
from pinel_desktop.processes.messages import PING, PONG, Message, encoded, read_messages
from pinel_desktop.processes.outbox import Outbox

ProcessState = Literal["starting", "ready", "lost"]

_log = logging.getLogger(__name__)
_CLOSE_TIMEOUT_S = 4.0
# A process that dies sooner than this after its start, so often in a row, is not started again by itself.
_SHORT_LIFE_S = 3.0
_SHORT_LIVES = 3


class OwnedProcess:
    """Keeps one process running and exchanges JSON lines with it; thread-safe. No call waits for a process that hangs.

    The process tells that it is ready with a message of the type `NAME_ready`, and ends when its standard input ends.

    Args:
        name: of the process, for that message and the log.
        command: starts it.
        on_message: called on the reader thread with every further message, in order.
        on_death: called on the reader thread when the process has died by itself, before the next one starts.
        on_ready: called on the reader thread when it, or the next one after its death, is ready.
        on_lost: called when the process is not started again by itself; must not wait.
        patience: of a process that answers each `PING` with a `PONG` at once: one that hangs is ended.
    """

    def __init__(
        self,
        name: str,
        command: Sequence[str],
        on_message: Callable[[Message], None],
        on_death: Callable[[], None],
        on_ready: Callable[[], None] = lambda: None,
        on_lost: Callable[[], None] = lambda: None,
        patience: Patience | None = None,
    ) -> None:
        self._name, self._command = name, list(command)
        self._on_message, self._on_death = on_message, on_death
        self._on_ready, self._on_lost = on_ready, on_lost
        self._lock = threading.RLock()
        self._process: subprocess.Popen[bytes] | None = None
        self._reader: threading.Thread | None = None
        self._outbox = Outbox()
        self._state: ProcessState = "starting"
        self._closing = False
        self._n_short_lives = 0
        self._ready = threading.Event()
        self._n_heard, self._is_handing_on = 0, False
        self._heartbeat: Heartbeat | None = None
        if patience is not None:
            self._heartbeat = Heartbeat(self._seen, self._ping, self._kill_silent, patience)
            self._heartbeat.start(f"{name}-heartbeat")

    @property
    def state(self) -> ProcessState:
        """`starting` until the process has said it is ready; `lost` when it is not started again by itself."""
        return self._state

    @property
    def pid(self) -> int | None:
        """Id of the process."""
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
                _log.error("the %s does not start: %s", self._name, error)
                self._give_up()
                return
            self._outbox = Outbox()
            self._outbox.start_writing(_pipe(self._process.stdin), f"{self._name}-writer")
            self._reader = threading.Thread(
                target=self._read, args=(self._process,), name=f"{self._name}-reader", daemon=True
            )
            self._reader.start()

    def wait_until_ready(self, timeout_s: float) -> bool:
        """Waits for the process; False when it is not ready after `timeout_s`, or closed before."""
        self._ready.wait(timeout_s)
        return self._state == "ready"

    def send(self, message: Message) -> bool:
        """Sends a message, in order, without waiting; one to a process that has ended is lost.

        False when the process does not read, and so much waits for it that this message was not taken.
        """
        line = encoded(message)
        with self._lock:
            return self._closing or self._outbox.put(line)

    def kill(self) -> None:
        """Ends a process that hangs at once; the next one starts by itself."""
        with self._lock:
            if self._process and not self._closing:
                self._process.kill()

    def _kill_silent(self, pid: int) -> None:
        with self._lock:
            if self.pid == pid:
                _log.error("the %s hangs and is ended", self._name)
                self.kill()

    def _ping(self) -> None:
        self.send(PING)

    def _seen(self) -> Seen:
        with self._lock:
            is_ready = self._state == "ready"
            pid = None if self._state == "lost" else self.pid
            return Seen(pid, self._n_heard, is_ready, self._is_handing_on)

    def close(self) -> None:
        """Ends the pipe after all that was sent, whereupon the process exits, and waits for it."""
        with self._lock:
            self._closing = True
            if self._heartbeat is not None:
                self._heartbeat.close()
            self._ready.set()  # who waits for a process that is starting would wait in vain
            process, reader, outbox = self._process, self._reader, self._outbox
        if process is None or reader is None:
            return
        if self._state == "starting":  # it does nothing yet, and its imports would keep us waiting
            process.kill()
        outbox.end()
        try:
            process.wait(_CLOSE_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        if reader is not threading.current_thread():
            reader.join()

    def _read(self, process: subprocess.Popen[bytes]) -> None:
        born = time.monotonic()
        messages = _pipe(process.stdout)
        for message in read_messages(messages):
            self._n_heard += 1
            self._is_handing_on = True
            self._take(message)
            self._is_handing_on = False
        messages.close()
        process.wait()
        if not self._closing:
            self._revive(short_life=time.monotonic() - born < _SHORT_LIFE_S)

    def _take(self, message: Message) -> None:
        if message.get("type") == f"{self._name}_ready":
            self._state = "ready"
            self._ready.set()
            self._on_ready()
        elif message != PONG:
            self._on_message(message)

    def _revive(self, *, short_life: bool) -> None:
        with self._lock:
            self._state = "starting"
            self._outbox.end()
        _log.error("the %s died", self._name)
        self._on_death()
        self._n_short_lives = self._n_short_lives + 1 if short_life else 0
        if self._n_short_lives >= _SHORT_LIVES:
            self._give_up()
        else:
            self.start()

    def _give_up(self) -> None:
        self._state = "lost"
        self._on_lost()  # before anybody who waits finds that it is lost
        self._ready.set()


def _pipe(pipe: Any) -> BinaryIO:
    if pipe is None:
        raise OSError("the process has no pipe")
    return cast(BinaryIO, pipe)
