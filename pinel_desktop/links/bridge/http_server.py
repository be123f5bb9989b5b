"""A small HTTP/1.1 server (asyncio) on one thread. No request waits for another connection.

Flask would delay the start of the engine, and the engine serves no page.
"""

import asyncio
import contextlib
import errno
import json
import socket
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Future
from http import HTTPStatus

from pinel_desktop.errors import PinelError
from pinel_desktop.links.bridge.routes import Request, Response, refusal

MAX_BODY_BYTES = 64 * 1024
_MAX_HEAD_BYTES = 8 * 1024
# Time limit of a whole request, from the previous response on. Single bytes do not extend it.
REQUEST_S = 10.0
# After a refusal the connection stays open for this time. If it were closed while the client still
# sends, the client would lose the response.
_CLOSE_TIMEOUT_S = 2.0
# If there are more, the connection whose last complete request is oldest is closed.
MAX_CONNECTIONS = 32
_ROUNDS = 1_000
_PICTURE_S = 0.1
_BOUNDARY = "frame"
STREAM_TYPE = f"multipart/x-mixed-replace; boundary={_BOUNDARY}"
_END_OF_HEAD = b"\r\n\r\n"

# A response, or a future for the response of another process.
ResponseOrFuture = Response | Future[Response]


class BridgeHttpServer:
    """HTTP server of the bridge. Listens once constructed, responds after `start`.

    Args:
        respond: called on the server's thread; must not wait. A future that it returns is cancelled if the client
            disconnects.
        max_body: returns the maximum size of a body in bytes for the target of a request.

    Raises:
        PinelError: `bridge_port_busy`, `bridge_address_wrong`.
    """

    def __init__(
        self,
        host: str,
        port: int,
        respond: Callable[[Request], ResponseOrFuture],
        max_body: Callable[[str], int] = lambda target: MAX_BODY_BYTES,
    ) -> None:
        self._socket = _listening(host, port)
        self.port: int = self._socket.getsockname()[1]
        self._respond, self._max_body = respond, max_body
        self._connections: dict[_Connection, None] = {}  # ordered by their last response
        self._ready = threading.Event()
        self._thread = threading.Thread(target=self._work, name="bridge", daemon=True)

    def start(self) -> None:
        """Responds to requests until `close`."""
        self._thread.start()
        self._ready.wait()

    def close(self) -> None:
        """Closes all connections; safe without `start`."""
        if self._thread.is_alive():
            self._loop.call_soon_threadsafe(self._ending.set)
            self._thread.join()
        self._socket.close()

    def _work(self) -> None:
        try:
            asyncio.run(self._serve())
        finally:
            self._ready.set()

    async def _serve(self) -> None:
        self._loop, self._ending = asyncio.get_running_loop(), asyncio.Event()
        server = await self._loop.create_server(self._connection, sock=self._socket)
        self._ready.set()
        await self._ending.wait()
        await self._close_connections()
        server.close()
        await server.wait_closed()
        await asyncio.sleep(0)  # connections close in the loop's next iteration

    async def _close_connections(self) -> None:
        """Closes all connections, also sockets that become connections in the loop's next iterations."""
        for _ in range(_ROUNDS):  # bounded, so that a flood of connections cannot prevent the end
            for connection in list(self._connections):
                connection.abort()
            if len(asyncio.all_tasks()) == 1:
                return
            await asyncio.sleep(0)

    def _connection(self) -> "_Connection":
        return _Connection(self._respond, self._max_body, self._connections)


class _Connection(asyncio.Protocol):
    """One connection of a client. Responds to each HTTP/1.1 request before it reads the next one."""

    def __init__(
        self,
        respond: Callable[[Request], ResponseOrFuture],
        max_body: Callable[[str], int],
        connections: "dict[_Connection, None]",
    ) -> None:
        self._respond, self._max_body, self._connections = respond, max_body, connections
        self._loop = asyncio.get_running_loop()
        self._buffer = bytearray()
        self._has_sent_continue = False
        self._awaited: Future[Response] | None = None
        self._is_stream = self._is_full = self._is_leaving = False

    @property
    def is_waiting(self) -> bool:
        """Whether the response is pending in another process."""
        return self._awaited is not None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        self._client: str = transport.get_extra_info("peername")[0]
        while len(self._connections) >= MAX_CONNECTIONS:
            idle = (other for other in self._connections if not other.is_waiting)
            next(idle, next(iter(self._connections))).abort()
        self._begin_request()

    def _begin_request(self) -> None:
        self._connections.pop(self, None)
        self._connections[self] = None
        self._has_sent_continue = False
        self._deadline = self._loop.call_later(REQUEST_S, self.abort)

    def connection_lost(self, error: Exception | None) -> None:
        self._deadline.cancel()
        self._connections.pop(self, None)
        if self._awaited is not None:
            self._awaited.cancel()

    def abort(self) -> None:
        """Closes the connection without a response."""
        self._connections.pop(self, None)
        self._transport.abort()

    def pause_writing(self) -> None:
        """Handles a client that does not read: a stream's next frame is delayed, other connections are closed."""
        if not self._is_stream:
            self.abort()
            return
        self._is_full = True
        self._deadline = self._loop.call_later(REQUEST_S, self.abort)

    def resume_writing(self) -> None:
        """Handles a client that has read its frame."""
        self._is_full = False
        self._deadline.cancel()

    def data_received(self, data: bytes) -> None:
        if self._is_leaving:
            return
        self._buffer += data
        if self.is_waiting or self._is_stream:
            if len(self._buffer) > MAX_BODY_BYTES:
                self.abort()
            return
        self._process_next()

    def _process_next(self) -> None:
        """Responds to the first request in the buffer, if it is complete.

        Pipelined requests behind it wait until other connections have had their turn.
        """
        if self._transport.is_closing() or self.is_waiting or self._is_leaving:
            return
        try:
            request, self._is_last = self._next_request()
        except PinelError as error:
            self._refuse(error)
            return
        if request is None:
            self._transport.resume_reading()
            return
        self._request = request
        self._ask()

    def _ask(self) -> None:
        answer = self._respond(self._request)
        if isinstance(answer, Response):
            self._on_response(answer)
            return
        self._deadline.cancel()
        self._awaited = answer
        self._transport.resume_reading()  # else a disconnection would not be detected
        _enable_keepalive(self._transport.get_extra_info("socket"))
        answer.add_done_callback(self._settled)

    def _settled(self, answer: "Future[Response]") -> None:
        """Passes a finished response to the server's thread; called on any thread."""
        if not answer.cancelled():
            with contextlib.suppress(RuntimeError):  # the server was closed meanwhile
                self._loop.call_soon_threadsafe(self._on_response, answer.result())

    def _on_response(self, answer: Response) -> None:
        self._awaited = None
        if self._transport.is_closing():
            return
        if answer.jpeg is not None:
            self._show(answer, answer.jpeg)
        elif self._is_stream:  # the end of the stream
            self._transport.close()
        else:
            self._reply(answer)
            if self._buffer:
                self._transport.pause_reading()
                self._loop.call_soon(self._process_next)
            else:
                self._transport.resume_reading()

    def _show(self, answer: Response, jpeg: bytes) -> None:
        """Sends one frame of a stream. Requests the next one after 0.1 s, or once the client has read this one."""
        self._deadline.cancel()
        if not self._is_stream:
            self._is_stream = True
            self._transport.write(_head(answer, {"Content-Type": STREAM_TYPE}, is_last=True))
        self._transport.write(_part(jpeg))
        self._loop.call_later(_PICTURE_S, self._ask_again)

    def _ask_again(self) -> None:
        if self._transport.is_closing():
            return
        if self._is_full:
            self._loop.call_later(_PICTURE_S, self._ask_again)
        else:
            self._ask()

    def _next_request(self) -> tuple[Request | None, bool]:
        """Returns a complete request, and whether the connection closes after it; None while it is incomplete.

        Raises PinelError `bridge_request_wrong`, `bridge_too_large`.
        """
        end = self._buffer.find(_END_OF_HEAD)
        if end < 0:
            if len(self._buffer) > _MAX_HEAD_BYTES:
                raise PinelError("bridge_request_wrong", detail="head too long")
            return None, False
        method, target, version, headers = _parsed(bytes(self._buffer[:end]))
        length, begin = _length(headers, self._max_body(target)), end + len(_END_OF_HEAD)
        if len(self._buffer) < begin + length:
            self._send_continue(headers)
            return None, False
        body = bytes(self._buffer[begin : begin + length])
        del self._buffer[: begin + length]
        connection = headers.get("connection", "").lower()
        is_last = connection == "close" or (version == "HTTP/1.0" and connection != "keep-alive")
        return Request(method, target, headers, body, self._client), is_last

    def _send_continue(self, headers: dict[str, str]) -> None:
        """Sends `100 Continue` to a client that waits for it before it sends a large body."""
        if headers.get("expect", "").lower() == "100-continue" and not self._has_sent_continue:
            self._has_sent_continue = True
            self._transport.write(b"HTTP/1.1 100 Continue\r\n\r\n")

    def _refuse(self, error: PinelError) -> None:
        """Responds with an error to a request that is not read to its end; drops the rest of the request."""
        self._deadline.cancel()
        self._is_leaving = True
        self._buffer.clear()
        self._transport.write(_encoded(refusal(error), is_last=True))
        self._transport.write_eof()
        self._transport.resume_reading()
        self._deadline = self._loop.call_later(_CLOSE_TIMEOUT_S, self.abort)

    def _reply(self, answer: Response) -> None:
        self._deadline.cancel()
        self._transport.write(_encoded(answer, self._is_last))
        if self._is_last:
            self._transport.close()
        self._begin_request()  # the deadline also ends a client that does not read its response


def _parsed(head: bytes) -> tuple[str, str, str, dict[str, str]]:
    """Returns method, target, version and headers. Raises PinelError `bridge_request_wrong`."""
    first, *lines = head.decode("latin-1").split("\r\n")
    parts = first.split(" ")
    if len(parts) != 3 or parts[2] not in ("HTTP/1.0", "HTTP/1.1") or parts[1][:1] != "/":
        raise PinelError("bridge_request_wrong", detail=first)
    headers: dict[str, str] = {}
    for line in lines:
        name, colon, value = line.partition(":")
        name = name.lower()
        is_twice = name in headers and name in ("host", "content-length")
        if not colon or not name or name != name.strip() or is_twice:
            raise PinelError("bridge_request_wrong", detail=line)
        headers[name] = value.strip()
    return parts[0], parts[1], parts[2], headers


def _length(headers: dict[str, str], max_bytes: int) -> int:
    """Returns the size of the body in bytes. Raises PinelError `bridge_request_wrong`, `bridge_too_large`."""
    if "transfer-encoding" in headers:
        raise PinelError("bridge_request_wrong", detail="Transfer-Encoding")
    text = headers.get("content-length", "0")
    if not (text.isascii() and text.isdigit()):
        raise PinelError("bridge_request_wrong", detail=f"Content-Length: {text}")
    if len(text) > 9 or int(text) > max_bytes:
        raise PinelError("bridge_too_large", max_kib=max_bytes // 1024)
    return int(text)


def _encoded(answer: Response, is_last: bool) -> bytes:
    document = answer.document
    body = b"" if document is None else json.dumps(document, allow_nan=False).encode()
    headers = {"Content-Type": "application/json", "Content-Length": str(len(body))}
    return _head(answer, headers, is_last=is_last) + body


def _head(answer: Response, headers: dict[str, str], *, is_last: bool) -> bytes:
    all_headers = {
        **headers,
        "Cache-Control": "no-store",
        "Connection": "close" if is_last else "keep-alive",
        **answer.headers,
    }
    lines = [f"HTTP/1.1 {answer.status} {HTTPStatus(answer.status).phrase}"]
    lines += [f"{name}: {value}" for name, value in all_headers.items()]
    return "\r\n".join([*lines, "", ""]).encode()


def _part(jpeg: bytes) -> bytes:
    head = f"--{_BOUNDARY}\r\nContent-Type: image/jpeg\r\nContent-Length: {len(jpeg)}\r\n\r\n"
    return head.encode() + jpeg + b"\r\n"


def _enable_keepalive(connected: socket.socket) -> None:
    """Enables TCP keepalive, which detects an unreachable client within seconds: the robot must then stop."""
    connected.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    for name, value in (("TCP_KEEPIDLE", 2), ("TCP_KEEPINTVL", 1), ("TCP_KEEPCNT", 3)):
        if hasattr(socket, name):
            connected.setsockopt(socket.IPPROTO_TCP, getattr(socket, name), value)


def _listening(host: str, port: int) -> socket.socket:
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM
        )[0]
        listener = socket.socket(family, kind, protocol)
    except (OSError, UnicodeError) as error:  # unknown or invalid host name
        raise _cannot_listen(host, port, error) from error
    try:
        if sys.platform == "win32":  # there SO_REUSEADDR lets another program bind the port, too
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
        else:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(address)
        listener.listen(MAX_CONNECTIONS)
    except OSError as error:
        listener.close()
        raise _cannot_listen(host, port, error) from error
    return listener


def _cannot_listen(host: str, port: int, error: OSError | UnicodeError) -> PinelError:
    if isinstance(error, OSError) and error.errno == errno.EADDRINUSE:
        return PinelError("bridge_port_busy", port=port, host=host)
    detail = error.strerror if isinstance(error, OSError) else str(error)
    return PinelError("bridge_address_wrong", host=host, port=port, detail=detail)
