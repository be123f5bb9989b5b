"""HTTP requests that await the response of another process, to which they are sent as messages."""

import base64
import itertools
import os
import queue
import threading
import time
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from typing import Any, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.routes import Request, Response, refusal

Message = dict[str, Any]
# A limit per path, so that viewers of the camera's stream do not block other routes.
MAX_PENDING_PER_PATH = 4
# A process without a message for this time hangs. While it works on a response, it sends a
# keepalive once a second.
HANG_TIMEOUT_S = 5.0
_CHECK_S = 0.5


class _PendingRequest(NamedTuple):
    """A request without a response, and its arrival time (monotonic clock)."""

    response: Future[Response]
    path: str
    at_s: float


class PendingRequests:
    """All pending requests. `submit` never waits for the pipe.

    Args:
        send: sends a message to the process, on a thread of this class; may wait.
        hang_timeout_s: longest time without a message of the process while a request is pending.
    """

    def __init__(
        self, send: Callable[[Message], None], hang_timeout_s: float = HANG_TIMEOUT_S
    ) -> None:
        self._send, self._hang_timeout_s = send, hang_timeout_s
        self._numbers = itertools.count()
        self._lock = threading.Lock()
        self._open: dict[str, _PendingRequest] = {}
        self._last_message_s = time.monotonic()
        self._outbox: queue.SimpleQueue[Message | None] = queue.SimpleQueue()
        self._closing = threading.Event()
        for work in (self._write, self._watch):
            threading.Thread(target=work, name="bridge-questions", daemon=True).start()

    def submit(
        self, request: Request, batch: int | None = None, of_page: bool = False
    ) -> "Future[Response]":
        """Sends a request to the process and returns the future of its response; cancelling it withdraws the request.

        Args:
            batch: number of the page's batch; None outside a batch.
            of_page: whether a web page sent the request.
        """
        answer: Future[Response] = Future()
        path = request.target.partition("?")[0]
        with self._lock:
            if [one.path for one in self._open.values()].count(path) >= MAX_PENDING_PER_PATH:
                answer.set_result(refusal(PinelError("bridge_too_many", max=MAX_PENDING_PER_PATH)))
                return answer
            # unique also among the engines before this one
            number = f"{os.getpid()}-{next(self._numbers)}"
            self._open[number] = _PendingRequest(answer, path, time.monotonic())
        answer.add_done_callback(lambda done: self._withdraw(number) if done.cancelled() else None)
        self._outbox.put(
            {
                "type": "bridge_asked",
                "question": number,
                "method": request.method,
                "path": path,
                # the same for all frames of a stream
                "request": f"{os.getpid()}-{request.number}",
                "batch": batch,
                "of_page": of_page,
                "body": request.body.decode("utf-8", "surrogateescape"),
            }
        )
        return answer

    def notify(self, message: Message) -> None:
        """Sends the process a message without a response."""
        self._outbox.put(message)

    def record_keepalive(self) -> None:
        """Records that the process is alive."""
        self._last_message_s = time.monotonic()

    def settle(self, message: Mapping[str, Any]) -> None:
        """Handles the response to a request; ignores the response to a withdrawn request."""
        self.record_keepalive()
        jpeg = message.get("jpeg")
        picture = None if jpeg is None else base64.b64decode(jpeg)
        answer = Response(message["status"], message.get("document"), jpeg=picture)
        self._settle(message["question"], answer)

    def close(self) -> None:
        """Ends the threads; no further request is sent."""
        self._closing.set()
        self._outbox.put(None)

    def _settle(self, number: str, answer: Response) -> None:
        with self._lock:
            asked = self._open.pop(number, None)
        if asked and asked.response.set_running_or_notify_cancel():
            asked.response.set_result(answer)

    def _withdraw(self, number: str) -> None:
        with self._lock:
            self._open.pop(number, None)
        self._outbox.put({"type": "bridge_withdrawn", "question": number})

    def _write(self) -> None:
        while (message := self._outbox.get()) is not None:
            try:
                self._send(message)
            except OSError:
                return  # the process has exited, and this one will exit soon

    def _watch(self) -> None:
        """Refuses pending requests while the process hangs."""
        while not self._closing.wait(_CHECK_S):
            since_s = time.monotonic() - self._hang_timeout_s
            if self._last_message_s > since_s:
                continue
            with self._lock:
                due = [number for number, one in self._open.items() if one.at_s < since_s]
            for number in due:
                self._settle(number, refusal(PinelError("bridge_app_silent")))
                self._outbox.put({"type": "bridge_withdrawn", "question": number})
