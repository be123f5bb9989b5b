"""A bridge that listens as long as its owner wants, also while no run drives a robot over it.

It answers `/bridge/*` by itself, and hands further routes on to somebody else.
"""

import threading
import time
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

from pinel_desktop.links.bridge.callers import Callers
from pinel_desktop.links.bridge.listener import MAX_BODY_BYTES, Answered, Listener
from pinel_desktop.links.bridge.routes import (
    Answer,
    Conversation,
    Door,
    Request,
    Routes,
    with_headers,
)
from pinel_desktop.robot.record import BridgeRecord

_EVERYWHERE = ("0.0.0.0", "::")
# the bridges of this process, by port
_standing: "dict[int, StandingBridge]" = {}
_lock = threading.Lock()


@dataclass(frozen=True, slots=True)
class HandedRoute:
    """A route that somebody else answers.

    Attributes:
        max_body: bytes of the largest body.
    """

    method: str
    max_body: int = MAX_BODY_BYTES


class _Idle:
    """What the client of the bridge is told while no run drives: to stand still, and that nothing is active."""

    def velocity(self, client: str) -> dict[str, Any]:
        return {"linear_x": 0.0, "angular_z": 0.0, "ts": time.time()}

    def take_pose(self, client: str, document: object) -> dict[str, Any]:
        return {"ok": True}

    def status(self) -> dict[str, Any]:
        return {"active": False}


class StandingBridge:
    """Listens once constructed, answers after `start`.

    Args:
        handed: the routes that `ask` answers.
        ask: takes the request, the number of the page's batch (None between two), and whether a web page asks; called
            on the listener's thread; must not wait. The future is cancelled when the client hangs up.
        file_pages: as in `Callers`.
        on_batch_end: as in `Batch`.

    Raises:
        PinelError: `bridge_port_busy`, `bridge_address_wrong`.
    """

    def __init__(
        self,
        record: BridgeRecord,
        handed: Mapping[str, HandedRoute],
        ask: Callable[[Request, int | None, bool], Future[Answer]],
        *,
        file_pages: bool = False,
        on_batch_end: Callable[[], None] = lambda: None,
    ) -> None:
        self._host, self._handed, self._ask = record.host, handed, ask
        self._idle = _Idle()
        callers = Callers(record, file_pages=file_pages)
        self._routes = Routes(self._idle, callers, on_batch_end)
        self._routes.add({path: Door(route.method) for path, route in handed.items()})
        self._listener = Listener(record.host, record.port, self._answer, self._max_body)
        self.port = self._listener.port

    def start(self) -> None:
        """From now on the transports of runs at this address use it."""
        self._listener.start()
        with _lock:
            _standing[self.port] = self

    def close(self) -> None:
        """Closes all connections."""
        with _lock:
            _standing.pop(self.port, None)
        self._listener.close()

    def serves(self, record: BridgeRecord) -> bool:
        """Whether it listens where the record says."""
        return record.port == self.port and self._host in (record.host, *_EVERYWHERE)

    def attach(self, conversation: Conversation) -> None:
        """`/bridge/*` is a run's until `detach`."""
        self._routes.conversation = conversation

    def detach(self, conversation: Conversation) -> None:
        """The run that attached this drives no more."""
        if self._routes.conversation is conversation:
            self._routes.conversation = self._idle

    def _max_body(self, target: str) -> int:
        route = self._handed.get(target.partition("?")[0])
        return route.max_body if route else MAX_BODY_BYTES

    def _answer(self, request: Request) -> Answered:
        refused, shared = self._routes.enter(request)
        if refused is not None:
            return refused
        if request.target.partition("?")[0] not in self._handed:
            return with_headers(self._routes.reply(request), shared)
        is_of_page = "Access-Control-Allow-Origin" in shared
        return _when_done(self._ask(request, self._routes.batch.number, is_of_page), shared)


def standing_bridge(record: BridgeRecord) -> StandingBridge | None:
    """The bridge of this process that listens where the record says; None where none does."""
    with _lock:
        bridge = _standing.get(record.port)
    return bridge if bridge and bridge.serves(record) else None


def _when_done(asked: "Future[Answer]", headers: Mapping[str, str]) -> "Future[Answer]":
    """The answer with more headers; cancelling it cancels what was asked."""
    told: Future[Answer] = Future()

    def settle(answer: "Future[Answer]") -> None:
        if not answer.cancelled() and told.set_running_or_notify_cancel():
            told.set_result(with_headers(answer.result(), headers))

    told.add_done_callback(lambda done: asked.cancel() if done.cancelled() else None)
    asked.add_done_callback(settle)
    return told
