"""Unknown connections get few slots and short timeouts; the page gets enough of both."""

import socket
import threading
from collections.abc import Iterator
from contextlib import ExitStack
from typing import Any

import pytest

from pinel_desktop.web import server
from pinel_desktop.web.server import Server
from tests.attacks.damage import wait_until

WAIT_S = 60.0
AT_ONCE_S = 0.05
FRIEND = b"Cookie: friend\r\n"
N_PARTS = 20


class Echo:
    """Responds with the length of the body; to /wait only after `released` is set."""

    def __init__(self) -> None:
        self.released = threading.Event()
        self.n_waiting = threading.Semaphore(0)

    def __call__(self, environ: dict[str, Any], start_response: Any) -> list[bytes]:
        body = environ["wsgi.input"].read(int(environ.get("CONTENT_LENGTH") or 0))
        if environ["PATH_INFO"] == "/wait":
            self.n_waiting.release()
            self.released.wait(WAIT_S)
        start_response("200 OK", [("Content-Type", "text/plain")])
        return [f"{len(body)} bytes".encode()]


class Site:
    """A server and its clients."""

    def __init__(self) -> None:
        self.app, self._server, self._stack = Echo(), Server(), ExitStack()
        self._stack.callback(self._server.close)
        self._stack.callback(self.app.released.set)

    def start(self, **options: float) -> None:
        self._server.start(self.app, lambda head: FRIEND in head, **options)

    def client(self, *parts: bytes) -> socket.socket:
        """Returns a client that has sent the parts.

        Before `start`, they arrive before the server accepts the connection.
        """
        client = socket.create_connection((self._server.host, self._server.port), WAIT_S)
        self._stack.enter_context(client)
        for part in parts:
            client.sendall(part)
        return client

    def ask(self, *parts: bytes) -> bytes:
        return answer(self.client(*parts))

    def close_server(self) -> None:
        self._server.close()

    def close(self) -> None:
        self._stack.close()


def answer(client: socket.socket) -> bytes:
    """Returns all bytes that the server sends until it closes the connection."""
    received = b""
    while part := client.recv(65536):
        received += part
    return received


def asked(path: str = "/", more: bytes = b"", body: int = 0) -> bytes:
    length = f"Content-Length: {body}\r\n".encode() if body else b""
    return f"POST {path} HTTP/1.1\r\nHost: x\r\n".encode() + more + length + b"\r\n"


@pytest.fixture
def site() -> Iterator[Site]:
    site = Site()
    yield site
    site.close()


@pytest.mark.parametrize("end", [b"\r\n\r\n", b"\n\n"])
def test_a_head_may_come_in_parts_and_the_body_with_it_or_after_it(site: Site, end: bytes) -> None:
    site.start()
    head = b"POST / HTTP/1.1\r\nHost: x\r\n" + FRIEND + b"Content-Length: 4" + end
    whole = head + b"abcd"
    for cut in range(1, len(whole)):
        assert site.ask(whole[:cut], whole[cut:]).endswith(b"4 bytes\r\n0\r\n\r\n")


@pytest.mark.parametrize("half", [b"", b"GET / HTTP/1.1\r\nHost:"])
def test_a_head_that_does_not_come_to_its_end_is_waited_for_so_long_and_no_longer(
    site: Site, half: bytes
) -> None:
    site.start(head_s=AT_ONCE_S)
    assert site.ask(half) == b""


def test_dripping_bytes_does_not_prolong_it(site: Site) -> None:
    site.start(head_s=AT_ONCE_S)
    client = site.client(b"GET / HTTP/1.1\r\nX: ")
    client.settimeout(0.01)
    wait_until(lambda: _is_closed_after_another_byte(client), WAIT_S)


def _is_closed_after_another_byte(client: socket.socket) -> bool:
    try:
        client.sendall(b"x")
        return client.recv(1) == b""
    except TimeoutError:
        return False
    except ConnectionError:
        return True


@pytest.mark.parametrize(
    ("head", "status"),
    [
        (b"GET /" + 70_000 * b"a", b"414"),
        (b"GET / HTTP/1.1\r\nX: " + 70_000 * b"a", b"431"),
        (b"nonsense", b"400"),
    ],
    ids=["address", "header", "nonsense"],
)
def test_a_head_that_is_too_long_or_none_is_refused(site: Site, head: bytes, status: bytes) -> None:
    site.start()
    first, _, _ = site.ask(head + b"\r\n\r\n").partition(b"\r\n")
    assert status in first


def test_the_page_may_take_longer_for_a_body_than_for_a_head(site: Site) -> None:
    client = site.client(asked(more=FRIEND, body=N_PARTS))
    site.start(head_s=AT_ONCE_S)
    client.settimeout(AT_ONCE_S)
    for _ in range(N_PARTS):
        with pytest.raises(TimeoutError):
            client.recv(1)
        client.sendall(b"x")
    client.settimeout(WAIT_S)
    assert b"20 bytes" in answer(client)


def test_a_stranger_s_body_is_not_waited_for(site: Site) -> None:
    site.start()
    assert b"1 bytes" in site.ask(asked(body=1_000_000), b"x")


def test_of_too_many_without_a_whole_head_the_oldest_is_closed(site: Site) -> None:
    site.start()
    halves = [site.client(b"GET / HTTP/1.1\r\n") for _ in range(300)]
    assert answer(halves[0]) == b""
    halves[-1].sendall(b"Host: x\r\n\r\n")
    assert b"0 bytes" in answer(halves[-1])


def test_strangers_who_are_answered_slowly_leave_room_for_the_page(site: Site) -> None:
    site.start()
    last, busy = b"", 0
    while b"503" not in last:
        client = site.client(asked("/wait"))
        busy += 1
        assert busy < 100
        last = _refused_or_waiting(site, client)
    assert b"0 bytes" in site.ask(asked(more=FRIEND))
    site.app.released.set()
    wait_until(lambda: b"0 bytes" in site.ask(asked()), WAIT_S)


def _refused_or_waiting(site: Site, client: socket.socket) -> bytes:
    """Returns b"" when the app processes the request, else the server's own response."""
    client.settimeout(AT_ONCE_S)
    while not site.app.n_waiting.acquire(blocking=False):
        try:
            return answer(client)
        except TimeoutError:
            continue
    return b""


def test_closing_waits_for_requests_in_progress(
    site: Site, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server, "_LAST_REQUESTS_S", WAIT_S)
    site.start()
    client = site.client(asked("/wait", FRIEND))
    assert site.app.n_waiting.acquire(timeout=WAIT_S)
    closing = threading.Thread(target=site.close_server)
    closing.start()
    closing.join(0.2)
    assert closing.is_alive()
    site.app.released.set()
    closing.join(WAIT_S)
    assert not closing.is_alive()
    assert client.recv(12) == b"HTTP/1.1 200"
