"""Starts the double of AuRoRA (`aurora_double.py`) as a process of its own, and hears what it hears."""

import random
import socket
import subprocess
import sys
import threading
from pathlib import Path

from pinel_desktop.robot import Twist2D
from tests.links.unicycle import standstill_since_s

_DOUBLE = Path(__file__).with_name("aurora_double.py")
# Below the ports that Linux gives away by itself: a client that asks for one of those before anybody listens can
# come to be connected with itself.
_PORTS = range(20_000, 30_000)


def free_port() -> int:
    """A port of 127.0.0.1 that nobody listens on."""
    while True:
        port = random.choice(_PORTS)
        with socket.socket() as asked:
            asked.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                asked.bind(("127.0.0.1", port))
            except OSError:
                continue
            return port


class Aurora:
    """The double, looking for PINEL at a port of this PC from now on.

    Attributes:
        received: all velocities that reached it, with the time (s, monotonic).
        positions: where it truly was each time, from where it was switched on.
    """

    def __init__(self, port: int, *options: str) -> None:
        self.received: list[tuple[float, Twist2D]] = []
        self.positions: list[tuple[float, float]] = []
        self._is_mute = threading.Event()
        self._process = subprocess.Popen(
            [sys.executable, str(_DOUBLE), f"http://127.0.0.1:{port}", *options],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            bufsize=1,
        )
        self._reading = threading.Thread(target=self._read, daemon=True)
        self._reading.start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            if line == "mute\n":
                self._is_mute.set()
                continue
            at_s, v, omega, x, y = map(float, line.split())
            self.positions.append((x, y))
            self.received.append((at_s, Twist2D(v, omega)))

    @property
    def is_mute(self) -> bool:
        """Whether it posts no pose any more."""
        return self._is_mute.is_set()

    @is_mute.setter
    def is_mute(self, value: bool) -> None:
        assert value, "it does not speak again"
        self.order("mute")
        assert self._is_mute.wait(15.0), "it does not do what it is told"

    def order(self, line: str) -> None:
        """Lets something go wrong, as the double's page says: `restart 0.7`."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{line}\n")

    def standstill_since_s(self) -> float | None:
        """Since when only zeros have come (monotonic); None if the last velocity was another one."""
        return standstill_since_s(self.received)

    def kill(self) -> None:
        """Ends it at once, as a crash would."""
        self._process.kill()

    def has_ended(self, within_s: float) -> bool:
        """Whether it ends by itself within this time."""
        try:
            return self._process.wait(within_s) == 0
        except subprocess.TimeoutExpired:
            return False

    def close(self) -> None:
        """Ends it."""
        self._process.kill()
        self._process.wait()
        self._reading.join()
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.close()
        self._process.stdout.close()
