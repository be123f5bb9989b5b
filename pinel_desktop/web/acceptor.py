"""Accepts connections on one thread, and hands each over when the head of its request is complete.

So a client that sends half a request occupies no thread. If the head has no secret of the guard, the connection is
unknown. Unknown connections get few slots and short timeouts, and so do not displace the page.
"""

import re
import selectors
import socket
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any

HEAD_S = 10.0  # for a whole head; slow clients cannot prolong it
# Unknown connections are refused without reading the body. If the socket were closed at once, a
# client that still sends would lose the response.
_REFUSED_S = 2.0
# between two parts of the page's body; long enough to read a file from a slow stick
_BODY_PART_S = 30.0
_MAX_HEAD = 2**16  # a longer head is handed over incomplete
_END_OF_HEAD = re.compile(rb"\r?\n\r?\n")
_POLL_S = 0.05
_BUSY = b"HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n"


class Connection(socket.socket):
    """An accepted connection. Reading returns the bytes received with the head first, and b"" after the timeout."""

    def __init__(self, accepted: socket.socket, head_s: float) -> None:
        super().__init__(fileno=accepted.detach())
        self.setblocking(False)
        self.head = bytearray()
        self.deadline_s = time.monotonic() + head_s
        self.is_known = False

    def receive_head(self) -> bool:
        """Receives available bytes; True if the head is complete or exceeds `_MAX_HEAD`. Raises OSError."""
        received = self.recv(_MAX_HEAD)
        if not received:
            raise ConnectionAbortedError
        self.head += received
        return len(self.head) > _MAX_HEAD or _END_OF_HEAD.search(self.head) is not None

    def begin_body(self, *, is_known: bool) -> None:
        """Prepares the connection for the thread that answers the request, which reads the body."""
        self.is_known = is_known
        self.deadline_s = time.monotonic() + _REFUSED_S
        self.setblocking(True)

    def recv_into(self, buffer: Any, nbytes: int = 0, flags: int = 0) -> int:
        if self.head:
            n = min(len(buffer), len(self.head))
            buffer[:n] = self.head[:n]
            del self.head[:n]
            return n
        left_s = _BODY_PART_S if self.is_known else self.deadline_s - time.monotonic()
        self.settimeout(max(left_s, 0.0))
        try:
            return super().recv_into(buffer, nbytes, flags)
        except (TimeoutError, BlockingIOError):
            return 0
        finally:
            self.settimeout(None)


class Acceptor:
    """Accepts connections with `run`, until `close`.

    Args:
        is_known: True if the head of a request contains a secret of this server.
        answer: called with a connection whose head is complete; must not block. May raise RuntimeError or OSError.
        max_waiting: connections without a complete head; if there are more, the oldest is closed.
        max_answered: unknown connections that are answered at the same time.
    """

    def __init__(
        self,
        listener: socket.socket,
        is_known: Callable[[bytes], bool],
        answer: Callable[[Connection], None],
        *,
        max_waiting: int,
        max_answered: int,
        head_s: float = HEAD_S,
    ) -> None:
        self._listener, self._is_known, self._respond = listener, is_known, answer
        self._max_waiting, self._head_s = max_waiting, head_s
        self._stranger_slots = threading.BoundedSemaphore(max_answered)
        self._waiting: dict[Connection, None] = {}  # the oldest first
        self._closing = threading.Event()

    def close(self) -> None:
        """Ends `run`."""
        self._closing.set()

    def run(self) -> None:
        """Accepts connections and hands them over until `close`."""
        self._listener.setblocking(False)
        with selectors.DefaultSelector() as self._selector:
            self._selector.register(self._listener, selectors.EVENT_READ)
            while not self._closing.is_set():
                for key, _ in self._selector.select(_POLL_S):
                    self._serve(key.fileobj)
                self._close_late()
            while self._waiting:
                self._close_oldest()

    def forget(self, connection: Connection) -> None:
        """Releases the slot of an answered connection; called on any thread."""
        if not connection.is_known:
            self._stranger_slots.release()

    def _serve(self, ready: object) -> None:
        if ready is self._listener:
            self._accept()
        elif ready in self._waiting:  # else it was just closed in favour of a newer connection
            assert isinstance(ready, Connection)
            self._receive(ready)

    def _accept(self) -> None:
        try:
            accepted, _ = self._listener.accept()
        except (BlockingIOError, ConnectionAbortedError):
            return
        except OSError:  # the limit of open files is reached
            if self._waiting:
                self._close_oldest()
            else:
                self._closing.wait(_POLL_S)
            return
        if len(self._waiting) >= self._max_waiting:
            self._close_oldest()
        connection = Connection(accepted, self._head_s)
        self._waiting[connection] = None
        self._selector.register(connection, selectors.EVENT_READ)
        # the head has usually arrived already; then newer connections cannot displace this one
        self._receive(connection)

    def _receive(self, connection: Connection) -> None:
        try:
            if connection.receive_head():
                self._hand_over(connection)
        except BlockingIOError:
            return
        except OSError:
            self._drop(connection)

    def _hand_over(self, connection: Connection) -> None:
        self._release(connection)
        is_known = self._is_known(bytes(connection.head))
        if not is_known and not self._stranger_slots.acquire(blocking=False):
            with suppress(OSError):
                connection.send(_BUSY)
            connection.close()
            return
        connection.begin_body(is_known=is_known)
        try:
            self._respond(connection)
        except (RuntimeError, OSError):  # the limit of threads is reached
            connection.close()
            self.forget(connection)

    def _close_late(self) -> None:
        now_s = time.monotonic()
        while self._waiting and next(iter(self._waiting)).deadline_s <= now_s:
            self._close_oldest()

    def _close_oldest(self) -> None:
        self._drop(next(iter(self._waiting)))

    def _drop(self, connection: Connection) -> None:
        if connection in self._waiting:
            self._release(connection)
        connection.close()

    def _release(self, connection: Connection) -> None:
        del self._waiting[connection]
        self._selector.unregister(connection)
