"""Routes of the bridge: admits requests, dispatches them to handlers, and builds the responses."""

import contextlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import count
from typing import Any, NoReturn, Protocol

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.bridge_session import POSE_EXAMPLE
from pinel_desktop.links.bridge.request_guard import RequestGuard
from pinel_desktop.messages import explain

STATUS = {
    "bridge_request_wrong": 400,
    "bridge_key_wrong": 401,
    "bridge_host_wrong": 403,
    "bridge_origin_wrong": 403,
    "bridge_page_foreign": 403,
    "bridge_path_unknown": 404,
    "bridge_method_wrong": 405,
    "bridge_other_client": 409,
    "bridge_too_large": 413,
    "bridge_json_invalid": 422,
    "bridge_pose_invalid": 422,
    "bridge_too_many": 503,
    "bridge_app_silent": 504,
}


@dataclass(frozen=True, slots=True)
class Request:
    """An unchecked HTTP request. Names of `headers` are in lower case; `client` is the sender's IP address.

    Attributes:
        number: unique number of the request; all frames of a stream belong to the same request.
    """

    method: str
    target: str
    headers: Mapping[str, str]
    body: bytes
    client: str
    number: int = field(default_factory=count().__next__)


@dataclass(frozen=True, slots=True)
class Response:
    """An HTTP response: status, JSON document (None for an empty body), and additional headers.

    Attributes:
        jpeg: a frame of a stream, in place of the document. The server then repeats the request for the next frame.
    """

    status: int
    document: Mapping[str, Any] | list[Any] | None
    headers: Mapping[str, str] = field(default_factory=dict)
    jpeg: bytes | None = None


class BridgeHandler(Protocol):
    """Handler of the robot's requests: `BridgeSession` during a run, else `persistent_bridge._Idle`."""

    def velocity(self, client: str) -> dict[str, Any]: ...

    def handle_pose(self, client: str, document: object) -> dict[str, Any]: ...

    def status(self) -> dict[str, Any]: ...


class Batch:
    """The flag that a block page sets before its first command and clears after its last one.

    Args:
        on_end: called at each clearing; must not wait.
    """

    def __init__(self, on_end: Callable[[], None]) -> None:
        self._on_end = on_end
        self._number = 0
        self._is_on = False

    @property
    def number(self) -> int | None:
        """Number of the current batch; None outside a batch."""
        return self._number if self._is_on else None

    def begin(self) -> dict[str, Any]:
        self._number += 1
        self._is_on = True
        return {"ok": True}

    def end(self) -> dict[str, Any]:
        self._is_on = False
        self._on_end()
        return {"ok": True}


@dataclass(frozen=True, slots=True)
class AccessRule:
    """Access rule of a route.

    Attributes:
        method: the HTTP method.
        for_robots: whether only robots may use it, and no web page of this PC.
    """

    method: str
    for_robots: bool = False


class Routes:
    """Responds to requests to `/bridge/*`.

    Attributes:
        handler: handler of the robot's requests; replaced for each run.
        batch: the flag of a block page.
    """

    def __init__(
        self,
        handler: BridgeHandler,
        callers: RequestGuard,
        on_batch_end: Callable[[], None] = lambda: None,
    ) -> None:
        self.handler, self.batch = handler, Batch(on_batch_end)
        self._guard = callers
        self._routes: dict[str, tuple[AccessRule, Callable[[Request], dict[str, Any]]]] = {
            "/bridge/cmd_vel": (AccessRule("GET", for_robots=True), self._velocity),
            "/bridge/pose": (AccessRule("POST", for_robots=True), self._pose),
            "/bridge/status": (AccessRule("GET"), self._status),
            "/bridge/run_start": (AccessRule("POST"), lambda request: self.batch.begin()),
            "/bridge/run_end": (AccessRule("POST"), lambda request: self.batch.end()),
        }
        self._access_rules = {path: rule for path, (rule, _) in self._routes.items()}

    def add(self, rules: Mapping[str, AccessRule]) -> None:
        """Adds access rules of further routes, to whose requests another process responds."""
        self._access_rules |= rules

    def admit(self, request: Request) -> tuple[Response | None, dict[str, str]]:
        """Decides whether a request is admitted.

        Returns:
            The final response, or None if the request is admitted; and the CORS headers for its response.
        """
        path, _, query = request.target.partition("?")
        rule = self._access_rules.get(path)
        try:
            for_robots = rule is not None and rule.for_robots
            origin = self._guard.page_origin(request.headers, for_robots=for_robots)
        except PinelError as error:
            return refusal(error), {}
        shared = _cors_headers(origin)
        if request.method == "OPTIONS" and origin and rule:
            return Response(204, None, {**shared, **_preflight(rule.method)}), {}
        try:
            self._guard.require_key(request.headers, query)
            if rule is None:
                raise PinelError("bridge_path_unknown", path=path, known=list(self._access_rules))
            if request.method != rule.method:
                allowed = rule.method
                raise PinelError("bridge_method_wrong", method=request.method, allowed=allowed)
        except PinelError as error:
            return with_headers(refusal(error), shared), {}
        return None, shared

    def respond(self, request: Request) -> Response:
        """Returns the response to any request; a refused one gets a message with its remedy."""
        refused, shared = self.admit(request)
        return refused or with_headers(self.reply(request), shared)

    def reply(self, request: Request) -> Response:
        """Returns the response to an admitted request to `/bridge/*`."""
        _, handle = self._routes[request.target.partition("?")[0]]
        try:
            return Response(200, handle(request))
        except PinelError as error:
            return refusal(error)

    def _velocity(self, request: Request) -> dict[str, Any]:
        return self.handler.velocity(request.client)

    def _pose(self, request: Request) -> dict[str, Any]:
        try:
            document = _document(request.body)
        except PinelError:
            # the link counts it: it reports a robot that posts no valid pose
            with contextlib.suppress(PinelError):
                self.handler.handle_pose(request.client, None)
            raise
        return self.handler.handle_pose(request.client, document)

    def _status(self, request: Request) -> dict[str, Any]:
        """Returns `active`: a run drives the robot, or the page has an open batch. Clients exit once it is false."""
        status = self.handler.status()
        return {"active": status["active"] or self.batch.number is not None}


def refusal(error: PinelError) -> Response:
    """Returns the response for an error: code, message and remedy, in the language of the PC."""
    explanation = explain(error)
    document = {
        "error": {
            "code": error.code,
            "message": explanation.message,
            "remedy": explanation.remedy,
            "params": {name: _plain(value) for name, value in error.params.items()},
        }
    }
    allowed = error.params.get("allowed")
    return Response(STATUS[error.code], document, {"Allow": str(allowed)} if allowed else {})


def with_headers(answer: Response, headers: Mapping[str, str]) -> Response:
    """Returns the response with additional headers."""
    return Response(answer.status, answer.document, {**answer.headers, **headers}, answer.jpeg)


def _cors_headers(origin: str | None) -> dict[str, str]:
    """Returns the CORS headers with which a web page of that origin may read the response; {} without an origin."""
    return {"Access-Control-Allow-Origin": origin, "Vary": "Origin"} if origin else {}


def _preflight(method: str) -> dict[str, str]:
    """Returns the headers of the response to a CORS preflight."""
    return {
        "Access-Control-Allow-Methods": method,
        "Access-Control-Allow-Headers": "Content-Type, X-PINEL-Key",
        "Access-Control-Allow-Private-Network": "true",
    }


def _plain(value: object) -> object:
    return value if isinstance(value, list) else str(value)


def _document(body: bytes) -> Any:
    """Parses the body as strict JSON, without NaN and Infinity. Raises PinelError `bridge_json_invalid`."""
    try:
        return json.loads(body, parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise PinelError("bridge_json_invalid", detail=str(error), example=POSE_EXAMPLE) from error


def _no_number(text: str) -> NoReturn:
    raise ValueError(f"{text} is no number")
