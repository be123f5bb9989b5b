"""The robot on Fast DDS as a process that tests start, watch, freeze and kill."""

import json
import signal
import subprocess
import threading
import time
from typing import Any, Literal

from pinel_desktop.robot import Twist2D
from tests.links.fastdds_peer.build import built_peer
from tests.links.unicycle import standstill_since_s

CommandType = Literal["twist", "twist_stamped"]
READY_WITHIN_S = 10.0


class FastDdsPeer:
    """A running robot.

    Attributes:
        received: all velocities that reached it, with the time (s, monotonic).
        commands: the same as the robot told them, with frame and stamp.
        endpoints: who publishes commands and subscribes to odometry, as its DDS discovered them.
    """

    def __init__(
        self, domain: int, command: CommandType = "twist", user_data: tuple[str, str] = ("", "")
    ) -> None:
        self.received: list[tuple[float, Twist2D]] = []
        self.commands: list[dict[str, Any]] = []
        self.endpoints: list[dict[str, Any]] = []
        self._is_mute = False
        self._ready = threading.Event()
        arguments = [str(domain), "rt/cmd_vel", "rt/odom", command, *user_data]
        self._process = subprocess.Popen(
            [built_peer(), *arguments],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1,
        )  # fmt: skip
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        if not self._ready.wait(READY_WITHIN_S):
            self.close()
            raise AssertionError("the robot on Fast DDS did not start")

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            report = json.loads(line)
            if "at" in report:
                self.commands.append(report)
                self.received.append(
                    (report["at"], Twist2D(float(report["v"]), float(report["omega"])))
                )
            elif "ready" in report:
                self._ready.set()
            else:
                self.endpoints.append(report)

    @property
    def is_mute(self) -> bool:
        """Reports nothing more; it still drives."""
        return self._is_mute

    @is_mute.setter
    def is_mute(self, is_mute: bool) -> None:
        self._is_mute = is_mute
        assert self._process.stdin is not None
        self._process.stdin.write("mute\n" if is_mute else "speak\n")

    def standstill_since_s(self) -> float | None:
        """Since when only zeros have come (monotonic); None if the last velocity was another one."""
        return standstill_since_s(list(self.received))

    def wait_until_driven(self) -> None:
        """Waits for velocities of a motion."""
        due_s = time.monotonic() + 20.0
        while not any(twist.v_mps > 0.1 for _, twist in self.received[-3:]):
            assert time.monotonic() < due_s, "the robot is not driven"
            time.sleep(0.01)

    def wait_for_endpoint(self, endpoint: dict[str, Any]) -> None:
        """Waits until its DDS has discovered a publisher or subscriber that says this of itself."""
        due_s = time.monotonic() + 10.0
        while endpoint not in self.endpoints:
            assert time.monotonic() < due_s, (endpoint, self.endpoints)
            time.sleep(0.01)

    def freeze(self) -> None:
        """It neither hears nor says anything more; its network still takes what comes."""
        self._process.send_signal(signal.SIGSTOP)

    def kill(self) -> None:
        """Ends it as the switch of a robot does."""
        self._process.kill()
        self._process.wait()

    def close(self) -> None:
        """Ends it in whatever state it is; safe to call twice."""
        self._process.kill()
        self._process.wait()
        self._reader.join()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()
