"""Werkzeug's threaded server on 127.0.0.1: one thread per request, so that streams do not block, and a clean end.

Connections come from the `Acceptor`, because Werkzeug alone gives each connection a thread without a timeout.
"""

import logging
import socket
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from werkzeug.serving import ThreadedWSGIServer, WSGIRequestHandler

from pinel_desktop.errors import PinelError
from pinel_desktop.web.acceptor import HEAD_S, Acceptor, Connection

HOST = "127.0.0.1"
_OPEN_FILES = 4096  # more than the app needs; most systems allow a process 1,024 by default
_MAX_WAITING = 256  # on Windows, `select` handles 512 sockets at most
_DEFER_S = 1  # a connection without any byte is accepted after this time
_LAST_REQUESTS_S = 1.0  # at the end, for requests in progress
_BACKLOG = 128  # with a longer one the page would wait behind a flood of connections
# Blockly nests each block in the block above it, two levels of JSON per block, and Python's JSON
# parser recurses. This limit is enough for a stack of thousands of blocks.
_RECURSION_LIMIT = 10_000
_STACK_BYTES = 16 * 2**20  # address space; memory only where used

_log = logging.getLogger(__name__)
Wsgi = Callable[..., Any]


class Server:
    """The HTTP server: listens once constructed, answers after `start`.

    Raises:
        PinelError: `port_taken`.
    """

    def __init__(self, port: int = 0) -> None:
        self._socket = _listening(port)
        self.host, self.port = self._socket.getsockname()[:2]
        self._answering: _Answering | None = None
        self._thread: threading.Thread | None = None

    def start(
        self, app: Wsgi, is_known: Callable[[bytes], bool], *, head_s: float = HEAD_S
    ) -> None:
        """Answers requests, each on its own thread, until `close`.

        Args:
            is_known: True if the head of a request contains a secret of this server.
            head_s: timeout for a complete head.
        """
        sys.setrecursionlimit(max(sys.getrecursionlimit(), _RECURSION_LIMIT))
        threading.stack_size(_STACK_BYTES)
        self._answering = _Answering(self._socket, app)
        max_waiting = max(8, min(_MAX_WAITING, _raised_file_limit() // 4))
        self._acceptor = self._answering.acceptor = Acceptor(
            self._socket,
            is_known,
            self._answering.respond,
            max_waiting=max_waiting,
            # the other files are for the page, the database and processes
            max_answered=max_waiting // 4,
            head_s=head_s,
        )
        self._thread = threading.Thread(target=self._acceptor.run, name="web", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stops the server, and gives requests a moment to end, such as the last save of a page that closes.

        Close the hub first, which ends the streams.
        """
        if self._answering is not None and self._thread is not None:
            self._acceptor.close()
            self._thread.join()
            self._answering.wait_for_requests(_LAST_REQUESTS_S)
            self._answering.server_close()
        self._socket.close()


class _Answering(ThreadedWSGIServer):
    """Answers each connection on a thread of its own."""

    acceptor: Acceptor

    def __init__(self, listener: socket.socket, app: Wsgi) -> None:
        host, port = listener.getsockname()[:2]
        super().__init__(host, port, app, _QuietHandler, fd=listener.fileno())
        self._n_requests, self._changed = 0, threading.Condition()

    @contextmanager
    def counted(self) -> Iterator[None]:
        """Counts a request while the app works on it."""
        with self._changed:
            self._n_requests += 1
        try:
            yield
        finally:
            with self._changed:
                self._n_requests -= 1
                self._changed.notify_all()

    def wait_for_requests(self, timeout_s: float) -> None:
        """Waits until the app works on no request."""
        with self._changed:
            self._changed.wait_for(lambda: self._n_requests == 0, timeout_s)

    def respond(self, connection: Connection) -> None:
        """Answers a connection.

        Raises RuntimeError if no thread can be started, OSError if the client has disconnected.
        """
        self.process_request(connection, connection.getpeername())

    def close_request(self, request: Any) -> None:
        super().close_request(request)
        self.acceptor.forget(request)


class _QuietHandler(WSGIRequestHandler):
    """Does not log addresses, because the first address contains a one-time key."""

    server: _Answering

    def run_wsgi(self) -> None:
        with self.server.counted():
            super().run_wsgi()

    def log(self, type: str, message: str, *args: Any) -> None:
        _log.debug("%s: request", type)


def _raised_file_limit() -> int:
    """Raises the limit of open files to `_OPEN_FILES`, as far as the system allows, and returns the limit."""
    if sys.platform == "win32":
        return _OPEN_FILES
    import resource  # noqa: PLC0415 - not on Windows

    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    highest = _OPEN_FILES if hard == resource.RLIM_INFINITY else min(_OPEN_FILES, hard)
    if soft != resource.RLIM_INFINITY and soft < highest:
        resource.setrlimit(resource.RLIMIT_NOFILE, (highest, hard))
    return max(soft, highest)


def _listening(port: int) -> socket.socket:
    """Returns a listening socket. On Linux it accepts a connection only with its first bytes.

    So the head of the page's request is complete at once, and later connections cannot displace it.
    """
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    if hasattr(socket, "TCP_DEFER_ACCEPT"):
        listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_DEFER_ACCEPT, _DEFER_S)
    if sys.platform == "win32":  # SO_REUSEADDR would let another program take over the port
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
    else:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((HOST, port))
        listener.listen(_BACKLOG)
    except OSError as error:
        listener.close()
        raise PinelError("port_taken", port=port, reason=error.strerror) from error
    return listener
