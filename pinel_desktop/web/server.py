"""Werkzeug's threaded server on 127.0.0.1: a thread per request, so that streams do not block, and a clean end."""

import logging
import socket
import sys
import threading
from collections.abc import Callable
from typing import Any

from werkzeug.serving import BaseWSGIServer, WSGIRequestHandler, make_server

from pinel_desktop.errors import PinelError

HOST = "127.0.0.1"
_POLL_S = 0.05
# Blockly nests each block in the one above it, two levels of JSON per block, and Python's JSON parser recurses;
# this is enough for a stack of thousands of blocks.
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
        self._server: BaseWSGIServer | None = None
        self._thread: threading.Thread | None = None

    def start(self, app: Wsgi) -> None:
        """Answers requests, each on its own thread, until `close`."""
        sys.setrecursionlimit(max(sys.getrecursionlimit(), _RECURSION_LIMIT))
        threading.stack_size(_STACK_BYTES)
        self._server = make_server(
            self.host,
            self.port,
            app,
            threaded=True,
            request_handler=_QuietHandler,
            fd=self._socket.fileno(),
        )
        self._thread = threading.Thread(
            target=self._server.serve_forever, args=(_POLL_S,), name="web", daemon=True
        )
        self._thread.start()

    def close(self) -> None:
        """Stops the server. Close the hub first, which ends the streams."""
        if self._server is not None and self._thread is not None:
            self._server.shutdown()
            self._thread.join()
            self._server.server_close()
        self._socket.close()


class _QuietHandler(WSGIRequestHandler):
    """Does not log addresses, because the first contains a one-time key."""

    def log(self, type: str, message: str, *args: Any) -> None:
        _log.debug("%s: request", type)


def _listening(port: int) -> socket.socket:
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    if sys.platform == "win32":  # where SO_REUSEADDR would let another program take over the port
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
    else:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((HOST, port))
        listener.listen(128)
    except OSError as error:
        listener.close()
        raise PinelError("port_taken", port=port, reason=error.strerror) from error
    return listener
