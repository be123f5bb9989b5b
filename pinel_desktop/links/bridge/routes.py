"""Which requests of the bridge are answered, and how: pure but for the exchange behind them."""

import hmac
import ipaddress
import json
import socket
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NoReturn
from urllib.parse import parse_qs, urlsplit

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.exchange import POSE_EXAMPLE, Exchange
from pinel_desktop.messages import explain
from pinel_desktop.robot.record import BridgeRecord

KEY_HEADER = "x-pinel-key"
STATUS = {
    "bridge_request_wrong": 400,
    "bridge_key_wrong": 401,
    "bridge_host_wrong": 403,
    "bridge_origin_wrong": 403,
    "bridge_path_unknown": 404,
    "bridge_method_wrong": 405,
    "bridge_other_client": 409,
    "bridge_client_restarted": 409,
    "bridge_not_running": 409,
    "bridge_too_large": 413,
    "bridge_json_invalid": 422,
    "bridge_pose_invalid": 422,
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
    """Status, JSON document, and more headers than those that every answer has."""

    status: int
    document: Mapping[str, Any]
    headers: Mapping[str, str] = field(default_factory=dict)


class Routes:
    """Answers requests for the record's address and key."""

    def __init__(self, record: BridgeRecord, exchange: Exchange) -> None:
        self._key = record.key
        self._names = {"localhost", record.host.lower(), *_names_of_this_pc()}
        self._exchange = exchange
        self._routes: dict[str, tuple[str, Callable[[Request], dict[str, Any]]]] = {
            "/bridge/cmd_vel": ("GET", lambda request: exchange.velocity(request.client)),
            "/bridge/pose": (
                "POST",
                lambda request: exchange.take_pose(request.client, _document(request.body)),
            ),
            "/bridge/status": ("GET", lambda request: exchange.status()),
            "/bridge/run_start": ("POST", lambda request: exchange.begin(request.client)),
            "/bridge/run_end": ("POST", lambda request: exchange.end(request.client)),
        }

    def answer(self, request: Request) -> Answer:
        """The answer to any request; what is wrong with it is said in words."""
        try:
            return Answer(200, self._answer(request))
        except PinelError as error:
            return refusal(error)

    def _answer(self, request: Request) -> dict[str, Any]:
        path, _, query = request.target.partition("?")
        self._require_own_site(request.headers)
        self._require_key(request.headers, query)
        if path not in self._routes:
            raise PinelError("bridge_path_unknown", path=path, known=list(self._routes))
        method, handle = self._routes[path]
        if request.method != method:
            raise PinelError("bridge_method_wrong", method=request.method, allowed=method)
        return handle(request)

    def _require_own_site(self, headers: Mapping[str, str]) -> None:
        """Refuses what a foreign web page makes a browser send, also by a name that leads here (DNS rebinding)."""
        if "origin" in headers or headers.get("sec-fetch-site", "none") != "none":
            raise PinelError("bridge_origin_wrong", origin=headers.get("origin", ""))
        host = headers.get("host", "")
        name = _name_in(host)
        if host and name not in self._names and not _is_ip(name):
            raise PinelError("bridge_host_wrong", host=host)

    def _require_key(self, headers: Mapping[str, str], query: str) -> None:
        if not self._key:
            return
        given = headers.get(KEY_HEADER, "").encode("latin-1") or _key_in(query)
        if not hmac.compare_digest(given, self._key.encode()):
            raise PinelError("bridge_key_wrong")


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


def _document(body: bytes) -> Any:
    """The body as JSON without NaN and Infinity, which JSON does not have. Raises PinelError `bridge_json_invalid`."""
    try:
        return json.loads(body, parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise PinelError("bridge_json_invalid", detail=str(error), example=POSE_EXAMPLE) from error


def _no_number(text: str) -> NoReturn:
    raise ValueError(f"{text} is no number")


def _key_in(query: str) -> bytes:
    return parse_qs(query).get("key", [""])[0].encode(errors="replace")


def _name_in(host: str) -> str:
    """The name of a Host header, without its port; "" for none."""
    try:
        return (urlsplit(f"//{host}").hostname or "").lower()
    except ValueError:
        return ""


def _is_ip(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _names_of_this_pc() -> set[str]:
    name = socket.gethostname().lower()
    return {name, name.partition(".")[0], f"{name.partition('.')[0]}.local"}
