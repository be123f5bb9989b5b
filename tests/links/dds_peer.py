"""The process of a DDS robot, as a test sees it."""

import json
import queue
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

from pinel_desktop.robot import Twist2D
from tests.links.unicycle import standstill_since_s

_ROOT = Path(__file__).parents[2]
_ANSWERS_WITHIN_S = 30.0


class DdsPeer:
    """A robot in a process of its own (`tests/links/dds_robot.py`).

    Attributes:
        received: velocities that reached it, with the time (s, monotonic, the same clock in all processes of a PC).
        senders: who sent each of `received`.
        stamps: seconds of the stamps of the commands that had one.
    """

    def __init__(self, domain: int, **behaviour: Any) -> None:
        self.received: list[tuple[float, Twist2D]] = []
        self.senders: list[int] = []
        self.stamps: list[int] = []
        self._responses: queue.Queue[str] = queue.Queue()
        self._is_mute = bool(behaviour.get("is_mute"))
        started = json.dumps({"domain": domain, **behaviour})
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.links.dds_robot", started],
            cwd=_ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()
        assert self._responses.get(timeout=_ANSWERS_WITHIN_S) == "ready"

    @property
    def is_mute(self) -> bool:
        return self._is_mute

    @is_mute.setter
    def is_mute(self, is_mute: bool) -> None:
        self._is_mute = is_mute
        self.change(is_mute=is_mute)

    def change(self, **behaviour: Any) -> None:
        """Changes what the robot does; it does when this returns."""
        assert self.process.stdin is not None
        self.process.stdin.write(json.dumps(behaviour) + "\n")
        self.process.stdin.flush()
        assert self._responses.get(timeout=_ANSWERS_WITHIN_S) == "changed"

    def standstill_since_s(self) -> float | None:
        """Since when only zeros have come (monotonic); None if the last velocity was another one."""
        return standstill_since_s(list(self.received))

    def close(self) -> None:
        self.process.kill()
        self.process.communicate()
        self._listener.join()

    def _listen(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            message = json.loads(line)
            if "heard" in message:
                at_s, v, omega = message["heard"]
                self.senders.append(message["by"])
                self.received.append((at_s, Twist2D(v, omega)))
                if message["stamp"] is not None:
                    self.stamps.append(message["stamp"])
            else:
                self._responses.put(next(iter(message)))
