"""A bridge that listens as long as its owner wants, also while no run drives a robot over it.

It answers `/bridge/*` by itself, and hands further routes on to somebody else.
"""

import threading
import time
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

from pinel_desktop.links.bridge.http_server import (
    MAX_BODY_BYTES,
    BridgeHttpServer,
    ResponseOrFuture,
)
from pinel_desktop.links.bridge.request_guard import RequestGuard
from pinel_desktop.links.bridge.routes import (
    BridgeHandler,
    Door,
    Request,
    Response,
    Routes,
    with_headers,
)
from pinel_desktop.robot.robot_profile import BridgeProfile

_EVERYWHERE = ("0.0.0.0", "::")
# the bridges of this process, by port
_bridges: "dict[int, PersistentBridge]" = {}
_lock = threading.Lock()


@dataclass(frozen=True, slots=True)
class DelegatedRoute:
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

    def handle_pose(self, client: str, document: object) -> dict[str, Any]:
        return {"ok": True}

    def status(self) -> dict[str, Any]:
        return {"active": False}


class PersistentBridge:
    """Listens once constructed, answers after `start`.

    Args:
        delegated: the routes that `ask` answers.
        ask: takes the request, the number of the page's batch (None between two), and whether a web page asks; called
            on the listener's thread; must not wait. The future is cancelled when the client hangs up.
        file_pages: as in `Callers`.
        on_batch_end: as in `Batch`.

    Raises:
        PinelError: `bridge_port_busy`, `bridge_address_wrong`.
    """

    def __init__(
        self,
        record: BridgeProfile,
        delegated: Mapping[str, DelegatedRoute],
        ask: Callable[[Request, int | None, bool], Future[Response]],
        *,
        file_pages: bool = False,
        on_batch_end: Callable[[], None] = lambda: None,
    ) -> None:
        self._host, self._delegated, self._ask = record.host, delegated, ask
        self._idle = _Idle()
        callers = RequestGuard(record, file_pages=file_pages)
        self._routes = Routes(self._idle, callers, on_batch_end)
        self._routes.add({path: Door(route.method) for path, route in delegated.items()})
        self._server = BridgeHttpServer(record.host, record.port, self._respond, self._max_body)
        self.port = self._server.port

    def start(self) -> None:
        """From now on the transports of runs at this address use it."""
        self._server.start()
        with _lock:
            _bridges[self.port] = self

    def close(self) -> None:
        """Closes all connections."""
        with _lock:
            _bridges.pop(self.port, None)
        self._server.close()

    def serves(self, record: BridgeProfile) -> bool:
        """Whether it listens where the record says."""
        return record.port == self.port and self._host in (record.host, *_EVERYWHERE)

    def attach(self, handler: BridgeHandler) -> None:
        """`/bridge/*` is a run's until `detach`."""
        self._routes.conversation = handler

    def detach(self, handler: BridgeHandler) -> None:
        """The run that attached this drives no more."""
        if self._routes.conversation is handler:
            self._routes.conversation = self._idle

    def _max_body(self, target: str) -> int:
        route = self._delegated.get(target.partition("?")[0])
        return route.max_body if route else MAX_BODY_BYTES

    def _respond(self, request: Request) -> ResponseOrFuture:
        refused, shared = self._routes.enter(request)
        if refused is not None:
            return refused
        if request.target.partition("?")[0] not in self._delegated:
            return with_headers(self._routes.reply(request), shared)
        is_of_page = "Access-Control-Allow-Origin" in shared
        return _when_done(self._ask(request, self._routes.batch.number, is_of_page), shared)


def find_persistent_bridge(record: BridgeProfile) -> PersistentBridge | None:
    """The bridge of this process that listens where the record says; None where none does."""
    with _lock:
        bridge = _bridges.get(record.port)
    return bridge if bridge and bridge.serves(record) else None


def _when_done(asked: "Future[Response]", headers: Mapping[str, str]) -> "Future[Response]":
    """The answer with more headers; cancelling it cancels what was asked."""
    response: Future[Response] = Future()

    def settle(answer: "Future[Response]") -> None:
        if not answer.cancelled() and response.set_running_or_notify_cancel():
            response.set_result(with_headers(answer.result(), headers))

    response.add_done_callback(lambda done: asked.cancel() if done.cancelled() else None)
    asked.add_done_callback(settle)
    return response
