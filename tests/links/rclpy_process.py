"""Programs on a real rclpy (`rclpy_robot.py`), in processes of their own, and where that rclpy comes from."""

import json
import os
import subprocess
import threading
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.links.ros2 import installed
from pinel_desktop.robot import Twist2D
from tests.links.unicycle import standstill_since_s

_PROGRAM = Path(__file__).parent / "rclpy_robot.py"
# What `make test` installs: rclpy as wheels, which bring Fast DDS and no set-up file.
_WHEELS = Path(__file__).parents[2] / "build" / "ros"
_NEEDS = "import rclpy, nav_msgs.msg, sensor_msgs.msg"
_ENDS_WITHIN_S = 20.0


def use_real_ros(monkeypatch: pytest.MonkeyPatch, logs: Path) -> None:
    """Lets links and programs find the ROS of this terminal or PC, else that of `make test`. Skips without any."""
    if installed.node_command("") is None:
        monkeypatch.setenv("PATH", str(_WHEELS / "bin"), prepend=os.pathsep)
        monkeypatch.setenv("ROS_VERSION", "2")
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    monkeypatch.setenv("ROS_LOG_DIR", str(logs))
    python = _command(["-c", _NEEDS])
    if python is None or subprocess.run(python, capture_output=True, check=False).returncode:
        pytest.skip("this PC has no ROS 2 with rclpy: its node is tested with a fake one only")


def _command(arguments: list[str]) -> list[str] | None:
    """Runs a program by the Python of the ROS that the link would take."""
    command = installed.node_command("")
    return command and [*command[: command.index(str(installed.NODE))], *arguments]


class RclpyProgram:
    """A robot or another program in a domain.

    Args:
        behaviour: as `rclpy_robot.py` describes.

    Attributes:
        received: the velocities that came, with their times (s, monotonic).
    """

    def __init__(self, domain: int, **behaviour: Any) -> None:
        self.received: list[tuple[float, Twist2D]] = []
        command = _command([str(_PROGRAM), str(domain), json.dumps(behaviour)])
        assert command is not None
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        assert self.process.stdout is not None
        assert self.process.stdout.readline() == "ready\n"
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    def _listen(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            at_s, v, omega = json.loads(line)
            self.received.append((at_s, Twist2D(v, omega)))

    def change(self, **behaviour: Any) -> None:
        """What it does from now on, of what can change."""
        assert self.process.stdin is not None
        self.process.stdin.write(json.dumps(behaviour) + "\n")
        self.process.stdin.flush()

    def standstill_since_s(self) -> float | None:
        """Since when only zeros have come; None if the last velocity was another one."""
        return standstill_since_s(list(self.received))

    def close(self) -> None:
        """Ends it, frozen or not."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        try:
            self.process.wait(_ENDS_WITHIN_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self._listener.join()
        assert self.process.stdout is not None
        self.process.stdout.close()
