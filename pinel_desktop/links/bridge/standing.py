"""A bridge that listens as long as its owner wants, also while no run drives a robot over it.

It answers `/bridge/*` by itself, and hands further routes on to somebody else.
"""

import threading
import time
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.callers import Callers
from pinel_desktop.links.bridge.listener import MAX_BODY_BYTES, Answered, Listener
from pinel_desktop.links.bridge.routes import Answer, Request, Routes, refusal
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

    def begin(self, client: str) -> dict[str, Any]:
        return {"ok": True, "active": False}

    def end(self, client: str) -> dict[str, Any]:
        raise PinelError("bridge_not_running")


class StandingBridge:
    """Listens once constructed, answers after `start`.

    Args:
        handed: the routes that `ask` answers.
        ask: called on the listener's thread; must not wait. The future is cancelled when the client hangs up.

    Raises:
        PinelError: `bridge_port_busy`, `bridge_address_wrong`.
    """

    def __init__(
        self,
        record: BridgeRecord,
        handed: Mapping[str, HandedRoute],
        ask: Callable[[Request], Future[Answer]],
    ) -> None:
        self._host, self._handed, self._ask = record.host, handed, ask
        self._callers = Callers(record)
        self._idle = self._routes = Routes(record, _Idle())
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

    def attach(self, routes: Routes) -> None:
        """`/bridge/*` is a run's until `detach`."""
        self._routes = routes

    def detach(self, routes: Routes) -> None:
        """The run that attached these drives no more."""
        if self._routes is routes:
            self._routes = self._idle

    def _max_body(self, target: str) -> int:
        route = self._handed.get(target.partition("?")[0])
        return route.max_body if route else MAX_BODY_BYTES

    def _answer(self, request: Request) -> Answered:
        path, _, query = request.target.partition("?")
        if path in self._handed:
            return self._hand_on(request, self._handed[path], query)
        if path in self._routes.paths:
            return self._routes.answer(request)
        known = [*self._routes.paths, *self._handed]
        return refusal(PinelError("bridge_path_unknown", path=path, known=known))

    def _hand_on(self, request: Request, route: HandedRoute, query: str) -> Answered:
        try:
            origin = self._callers.require_program_or_own_page(request.headers)
        except PinelError as error:
            return refusal(error)
        shared = _shared_with(origin)
        try:
            if request.method == "OPTIONS" and origin:
                return Answer(204, None, {**shared, **_preflight(route)})
            self._callers.require_key(request.headers, query)
            if request.method != route.method:
                allowed = route.method
                raise PinelError("bridge_method_wrong", method=request.method, allowed=allowed)
        except PinelError as error:
            return _with(refusal(error), shared)
        return _when_done(self._ask(request), shared)


def standing_bridge(record: BridgeRecord) -> StandingBridge | None:
    """The bridge of this process that listens where the record says; None where none does."""
    with _lock:
        bridge = _standing.get(record.port)
    return bridge if bridge and bridge.serves(record) else None


def _shared_with(origin: str | None) -> dict[str, str]:
    """Lets a web page of that origin read the answer."""
    return {"Access-Control-Allow-Origin": origin, "Vary": "Origin"} if origin else {}


def _preflight(route: HandedRoute) -> dict[str, str]:
    """What a browser wants to know before it sends a page's request."""
    return {
        "Access-Control-Allow-Methods": route.method,
        "Access-Control-Allow-Headers": "Content-Type, X-PINEL-Key",
        "Access-Control-Allow-Private-Network": "true",
    }


def _with(answer: Answer, headers: Mapping[str, str]) -> Answer:
    return Answer(answer.status, answer.document, {**answer.headers, **headers}, answer.jpeg)


def _when_done(asked: "Future[Answer]", headers: Mapping[str, str]) -> "Future[Answer]":
    """The answer with more headers; cancelling it cancels what was asked."""
    told: Future[Answer] = Future()

    def settle(answer: "Future[Answer]") -> None:
        if not answer.cancelled() and told.set_running_or_notify_cancel():
            told.set_result(_with(answer.result(), headers))

    told.add_done_callback(lambda done: asked.cancel() if done.cancelled() else None)
    asked.add_done_callback(settle)
    return told
