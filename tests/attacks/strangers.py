"""Programs of this PC that know no key and keep the server's connections busy.

As a program it does so with new connections again and again: `python -m tests.attacks.strangers PORT`.
"""

import itertools
import resource
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress

HOST = "127.0.0.1"
_AT_ONCE, _PAUSE_S = (
    200,
    0.05,
)  # some 3,000 a second; who takes a whole core for it leaves none to the app
_BODY = "Content-Length: 1000000\r\nContent-Type: application/json\r\n\r\n{"


class Strangers:
    """Connections whose requests are sent by half, in three ways."""

    def __init__(self, port: int) -> None:
        self._halves = itertools.cycle(
            [
                b"",
                b"GET / HTTP/1.1\r\nHost:",
                f"POST /api/groups HTTP/1.1\r\nHost: {HOST}:{port}\r\n{_BODY}".encode(),
            ]
        )
        self._port = port
        self._open: list[socket.socket] = []

    def connect(self, n: int) -> None:
        """Waits for nobody: where the server takes none, the rest stays half-open."""
        for half in itertools.islice(self._halves, n):
            client = socket.socket()
            self._open.append(client)
            client.setblocking(False)
            with suppress(OSError):
                client.connect_ex((HOST, self._port))
                client.send(half)

    def close(self) -> None:
        for client in self._open:
            client.close()
        self._open.clear()


@contextmanager
def strangers(port: int) -> Iterator[Strangers]:
    """May open as many connections as the system lets a program open."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    with ExitStack() as stack:
        stack.callback(resource.setrlimit, resource.RLIMIT_NOFILE, (soft, hard))
        resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
        attack = Strangers(port)
        stack.callback(attack.close)
        yield attack


@contextmanager
def flood(port: int) -> Iterator[None]:
    """A program that connects again and again, as fast as it can."""
    command = [sys.executable, "-m", "tests.attacks.strangers", str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        assert process.stdout
        assert process.stdout.readline()
        yield
        assert process.poll() is None
        process.kill()


def _flood(port: int) -> None:
    attack = Strangers(port)
    for n in itertools.count():
        attack.connect(_AT_ONCE)
        attack.close()
        time.sleep(_PAUSE_S)
        if n == 0:
            print("begun", flush=True)


if __name__ == "__main__":
    _flood(int(sys.argv[1]))
