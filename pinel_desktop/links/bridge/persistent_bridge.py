"""A bridge that outlives runs: it listens from `start` to `close`, also while no run drives a robot.

It responds to `/bridge/*` itself, and delegates further routes to another process.
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
    AccessRule,
    BridgeHandler,
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
    """A route to whose requests another process responds.

    Attributes:
        method: the HTTP method.
        max_body: maximum size of a body, in bytes.
    """

    method: str
    max_body: int = MAX_BODY_BYTES


class _Idle:
    """Handler of the robot's requests while no run drives: zero velocity, and `active` false."""

    def velocity(self, client: str) -> dict[str, Any]:
        return {"linear_x": 0.0, "angular_z": 0.0, "ts": time.time()}

    def handle_pose(self, client: str, document: object) -> dict[str, Any]:
        return {"ok": True}

    def status(self) -> dict[str, Any]:
        return {"active": False}


class PersistentBridge:
    """A bridge between runs. Listens once constructed, responds after `start`.

    Args:
        delegated: the routes that `ask` handles.
        ask: receives the request, the number of the page's batch (None outside a batch), and whether a web page sent
            it. Called on the server's thread; must not wait. Its future is cancelled if the client disconnects.
        file_pages: as in `RequestGuard`.
        on_batch_end: as `on_end` in `Batch`.

    Raises:
        PinelError: `bridge_port_busy`, `bridge_address_wrong`.
    """

    def __init__(
        self,
        profile: BridgeProfile,
        delegated: Mapping[str, DelegatedRoute],
        ask: Callable[[Request, int | None, bool], Future[Response]],
        *,
        file_pages: bool = False,
        on_batch_end: Callable[[], None] = lambda: None,
    ) -> None:
        self._host, self._delegated, self._ask = profile.host, delegated, ask
        self._idle = _Idle()
        callers = RequestGuard(profile, file_pages=file_pages)
        self._routes = Routes(self._idle, callers, on_batch_end)
        self._routes.add({path: AccessRule(route.method) for path, route in delegated.items()})
        self._server = BridgeHttpServer(profile.host, profile.port, self._respond, self._max_body)
        self.port = self._server.port

    def start(self) -> None:
        """Starts to respond; from now on runs with this address use this bridge."""
        self._server.start()
        with _lock:
            _bridges[self.port] = self

    def close(self) -> None:
        """Stops listening and closes all connections."""
        with _lock:
            _bridges.pop(self.port, None)
        self._server.close()

    def serves(self, profile: BridgeProfile) -> bool:
        """Returns whether the bridge listens at the address of the profile."""
        return profile.port == self.port and self._host in (profile.host, *_EVERYWHERE)

    def attach(self, handler: BridgeHandler) -> None:
        """Passes requests to `/bridge/*` to the handler of a run, until `detach`."""
        self._routes.handler = handler

    def detach(self, handler: BridgeHandler) -> None:
        """Removes the handler of a run that has ended."""
        if self._routes.handler is handler:
            self._routes.handler = self._idle

    def _max_body(self, target: str) -> int:
        route = self._delegated.get(target.partition("?")[0])
        return route.max_body if route else MAX_BODY_BYTES

    def _respond(self, request: Request) -> ResponseOrFuture:
        refused, shared = self._routes.admit(request)
        if refused is not None:
            return refused
        if request.target.partition("?")[0] not in self._delegated:
            return with_headers(self._routes.reply(request), shared)
        is_of_page = "Access-Control-Allow-Origin" in shared
        return _when_done(self._ask(request, self._routes.batch.number, is_of_page), shared)


def find_persistent_bridge(profile: BridgeProfile) -> PersistentBridge | None:
    """Returns the bridge of this process that listens at the address of the profile; None without one."""
    with _lock:
        bridge = _bridges.get(profile.port)
    return bridge if bridge and bridge.serves(profile) else None


def _when_done(asked: "Future[Response]", headers: Mapping[str, str]) -> "Future[Response]":
    """Returns a future of the response with additional headers; cancelling it cancels `asked`."""
    response: Future[Response] = Future()

    def settle(answer: "Future[Response]") -> None:
        if not answer.cancelled() and response.set_running_or_notify_cancel():
            response.set_result(with_headers(answer.result(), headers))

    response.add_done_callback(lambda done: asked.cancel() if done.cancelled() else None)
    asked.add_done_callback(settle)
    return response
