"""Which requests of the bridge are answered, and how: pure but for the exchange behind them."""

import contextlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NoReturn, Protocol

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.callers import Callers
from pinel_desktop.links.bridge.exchange import POSE_EXAMPLE
from pinel_desktop.messages import explain
from pinel_desktop.robot.record import BridgeRecord

STATUS = {
    "bridge_request_wrong": 400,
    "bridge_key_wrong": 401,
    "bridge_host_wrong": 403,
    "bridge_origin_wrong": 403,
    "bridge_page_foreign": 403,
    "bridge_path_unknown": 404,
    "bridge_method_wrong": 405,
    "bridge_other_client": 409,
    "bridge_client_restarted": 409,
    "bridge_not_running": 409,
    "bridge_too_large": 413,
    "bridge_json_invalid": 422,
    "bridge_pose_invalid": 422,
    "bridge_too_many": 503,
    "bridge_app_silent": 504,
}


@dataclass(frozen=True, slots=True)
class Request:
    """A request as it came. `headers` have names in lower case; `client` is the sender's IP address."""

    method: str
    target: str
    headers: Mapping[str, str]
    body: bytes
    client: str


@dataclass(frozen=True, slots=True)
class Answer:
    """Status, JSON document (None for an empty body), and more headers than those that every answer has.

    Attributes:
        jpeg: a picture of a stream in place of the document; the same request is then made again for the next one.
    """

    status: int
    document: Mapping[str, Any] | None
    headers: Mapping[str, str] = field(default_factory=dict)
    jpeg: bytes | None = None


class Conversation(Protocol):
    """What the client of the bridge is told, and what becomes of what it tells: `exchange.Exchange`."""

    def velocity(self, client: str) -> dict[str, Any]: ...

    def take_pose(self, client: str, document: object) -> dict[str, Any]: ...

    def status(self) -> dict[str, Any]: ...

    def begin(self, client: str) -> dict[str, Any]: ...

    def end(self, client: str) -> dict[str, Any]: ...


class Routes:
    """Answers requests for the record's address and key."""

    def __init__(self, record: BridgeRecord, exchange: Conversation) -> None:
        self._callers = Callers(record)
        self._routes: dict[str, tuple[str, Callable[[Request], dict[str, Any]]]] = {
            "/bridge/cmd_vel": ("GET", lambda request: exchange.velocity(request.client)),
            "/bridge/pose": (
                "POST",
                lambda request: _take_pose(exchange, request),
            ),
            "/bridge/status": ("GET", lambda request: exchange.status()),
            "/bridge/run_start": ("POST", lambda request: exchange.begin(request.client)),
            "/bridge/run_end": ("POST", lambda request: exchange.end(request.client)),
        }

    @property
    def paths(self) -> list[str]:
        """All paths that are answered here."""
        return list(self._routes)

    def answer(self, request: Request) -> Answer:
        """The answer to any request; what is wrong with it is said in words."""
        try:
            return Answer(200, self._answer(request))
        except PinelError as error:
            return refusal(error)

    def _answer(self, request: Request) -> dict[str, Any]:
        path, _, query = request.target.partition("?")
        self._callers.require_program(request.headers)
        self._callers.require_key(request.headers, query)
        if path not in self._routes:
            raise PinelError("bridge_path_unknown", path=path, known=self.paths)
        method, handle = self._routes[path]
        if request.method != method:
            raise PinelError("bridge_method_wrong", method=request.method, allowed=method)
        return handle(request)


def refusal(error: PinelError) -> Answer:
    """The answer that says what is wrong, in the language of the PC."""
    words = explain(error)
    document = {
        "error": {
            "code": error.code,
            "message": words.message,
            "remedy": words.remedy,
            "params": {name: _plain(value) for name, value in error.params.items()},
        }
    }
    allowed = error.params.get("allowed")
    return Answer(STATUS[error.code], document, {"Allow": str(allowed)} if allowed else {})


def _plain(value: object) -> object:
    return value if isinstance(value, list) else str(value)


def _take_pose(exchange: Conversation, request: Request) -> dict[str, Any]:
    try:
        document = _document(request.body)
    except PinelError:
        # counts as an impossible pose: the link names a robot that posts nothing else
        with contextlib.suppress(PinelError):
            exchange.take_pose(request.client, None)
        raise
    return exchange.take_pose(request.client, document)


def _document(body: bytes) -> Any:
    """The body as JSON without NaN and Infinity, which JSON does not have. Raises PinelError `bridge_json_invalid`."""
    try:
        return json.loads(body, parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise PinelError("bridge_json_invalid", detail=str(error), example=POSE_EXAMPLE) from error


def _no_number(text: str) -> NoReturn:
    raise ValueError(f"{text} is no number")
