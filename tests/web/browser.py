"""A minimal HTTP client with cookies; sends exactly what the test specifies."""

import http.client
import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.cookies import SimpleCookie
from typing import Any
from urllib.parse import urlsplit

TIMEOUT_S = 60.0  # on a busy PC


@dataclass(frozen=True)
class ApiResponse:
    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def data(self) -> Any:
        return json.loads(self.body)

    @property
    def text(self) -> str:
        return self.body.decode("utf-8")

    @property
    def error(self) -> dict[str, Any]:
        found: dict[str, Any] = self.data["error"]
        return found


@dataclass
class Browser:
    host: str
    port: int
    headers: dict[str, str] = field(default_factory=dict)

    @classmethod
    def at(cls, address: str) -> "Browser":
        """A browser that has not opened the page yet."""
        parts = urlsplit(address)
        assert parts.hostname is not None
        assert parts.port is not None
        return cls(parts.hostname, parts.port)

    @classmethod
    def signed_in(cls, address: str) -> "Browser":
        """Opens the address with its key and stores the cookie."""
        browser = cls.at(address)
        answer = browser.get(address.partition(f":{browser.port}")[2])
        assert answer.status == 302, answer.body
        cookie = answer.headers["Set-Cookie"].partition(";")[0]
        browser.headers = {"Cookie": cookie, "Sec-Fetch-Site": "same-origin"}
        return browser

    def get(self, path: str, headers: Mapping[str, str] | None = None) -> ApiResponse:
        return self.send("GET", path, headers=headers)

    def post(self, path: str, data: Any = None) -> ApiResponse:
        return self.send("POST", path, data)

    def put(self, path: str, data: Any = None) -> ApiResponse:
        return self.send("PUT", path, data)

    def patch(self, path: str, data: Any = None) -> ApiResponse:
        return self.send("PATCH", path, data)

    def delete(self, path: str) -> ApiResponse:
        return self.send("DELETE", path)

    def send(
        self,
        method: str,
        path: str,
        data: Any = None,
        *,
        body: bytes | None = None,
        headers: Mapping[str, str] | None = None,
    ) -> ApiResponse:
        """Sends `data` as JSON, or `body` unchanged. A header with the value "" is omitted."""
        sent = {**self.headers, **(headers or {})}
        if data is not None:
            body = json.dumps(data).encode()
            sent.setdefault("Content-Type", "application/json")
        connection = http.client.HTTPConnection(self.host, self.port, timeout=TIMEOUT_S)
        try:
            connection.request(
                method, path, body=body, headers={k: v for k, v in sent.items() if v}
            )
            answer = connection.getresponse()
            self._store_cookies(answer.headers.get_all("Set-Cookie") or [])
            return ApiResponse(answer.status, dict(answer.getheaders()), answer.read())
        finally:
            connection.close()

    def _store_cookies(self, given: list[str]) -> None:
        if "Cookie" not in self.headers:
            return  # has not opened the page
        jar = SimpleCookie(self.headers["Cookie"])
        for line in given:
            jar.load(line)
        pairs = [f"{name}={cookie.value}" for name, cookie in jar.items() if cookie.value]
        self.headers = {**self.headers, "Cookie": "; ".join(pairs)}

    @contextmanager
    def stream(self) -> Iterator["Stream"]:
        """The open event stream."""
        connection = http.client.HTTPConnection(self.host, self.port, timeout=TIMEOUT_S)
        try:
            connection.request("GET", "/api/stream", headers=self.headers)
            answer = connection.getresponse()
            try:
                yield Stream(answer)
            finally:
                answer.close()
        finally:
            connection.close()


class Stream:
    def __init__(self, answer: http.client.HTTPResponse) -> None:
        self.status = answer.status
        self.type = answer.getheader("Content-Type")
        self._answer = answer

    def lines(self) -> Iterator[str]:
        """Lines until the stream ends."""
        while line := self._answer.readline():
            yield line.decode("utf-8").rstrip("\n")

    def events(self) -> Iterator[dict[str, Any]]:
        """Events until the stream ends."""
        for line in self.lines():
            if line.startswith("data: "):
                yield json.loads(line.removeprefix("data: "))

    def next(self) -> dict[str, Any]:
        return next(self.events())

    def until(self, kind: str) -> list[dict[str, Any]]:
        """Events up to the first of that type."""
        found = []
        for event in self.events():
            found.append(event)
            if event["type"] == kind:
                break
        return found
