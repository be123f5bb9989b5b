"""A robot simulator that knows of PINEL what the original tells its clients, and no more: a unicycle at 30 Hz.

    python aurora_double.py URL [--key KEY] [--fixed-step]

It asks `/bridge/cmd_vel`, integrates, posts `/bridge/pose`, asks `/bridge/status`, and stops when the status is not
active and it has moved. While nobody listens it goes on asking. Standard output has a line for each velocity,
`TIME V OMEGA` (monotonic time); the line `mute` on standard input ends the posting of poses, the end of input the
program.
"""

import argparse
import json
import math
import sys
import threading
import time
import urllib.request

PERIOD_S = 1 / 30
PATIENCE_S = 2.0
LONGEST_STEP_S = 0.1


class Client:
    """The three requests of the loop."""

    def __init__(self, url: str, key: str) -> None:
        self._url, self._headers = url, {"Content-Type": "application/json"}
        if key:
            self._headers["X-PINEL-Key"] = key

    def get(self, path: str) -> dict[str, float]:
        return self._ask(urllib.request.Request(self._url + path, headers=self._headers))

    def post(self, path: str, document: object) -> dict[str, float]:
        body = json.dumps(document).encode()
        return self._ask(urllib.request.Request(self._url + path, body, self._headers))

    def _ask(self, request: urllib.request.Request) -> dict[str, float]:
        with urllib.request.urlopen(request, timeout=PATIENCE_S) as answer:
            found: dict[str, float] = json.load(answer)
            return found


class Robot:
    """A unicycle."""

    def __init__(self) -> None:
        self.x = self.y = self.yaw = 0.0
        self.has_moved = False

    def integrate(self, v: float, omega: float, dt_s: float) -> None:
        middle = self.yaw + omega * dt_s / 2
        self.x += v * dt_s * math.cos(middle)
        self.y += v * dt_s * math.sin(middle)
        self.yaw = math.remainder(self.yaw + omega * dt_s, math.tau)
        self.has_moved = self.has_moved or v != 0.0 or omega != 0.0


class Loop:
    """30 times a second; a step takes the time that has passed, or always the same."""

    def __init__(self, client: Client, fixed_step: bool) -> None:
        self._client, self._fixed_step = client, fixed_step
        self._robot = Robot()
        self.is_mute = self.is_ending = False

    def run(self) -> None:
        due_s = at_s = time.monotonic()
        while not self.is_ending:
            now_s = time.monotonic()
            passed_s, at_s = min(now_s - at_s, LONGEST_STEP_S), now_s
            try:
                if self._step(PERIOD_S if self._fixed_step else passed_s):
                    return
            except OSError:  # nobody listens yet, or no more
                pass
            due_s = max(due_s + PERIOD_S, time.monotonic() - PERIOD_S)
            time.sleep(max(due_s - time.monotonic(), 0.0))

    def _step(self, dt_s: float) -> bool:
        """True when the run is over."""
        command, robot = self._client.get("/bridge/cmd_vel"), self._robot
        v, omega = command["linear_x"], command["angular_z"]
        print(time.monotonic(), v, omega, flush=True)
        robot.integrate(v, omega, dt_s)
        if not self.is_mute:
            self._client.post("/bridge/pose", {"x": robot.x, "y": robot.y, "yaw": robot.yaw})
        is_active = self._client.get("/bridge/status")["active"]
        return not is_active and robot.has_moved


def listen(loop: Loop) -> None:
    for line in sys.stdin:
        loop.is_mute = line.strip() == "mute"
    loop.is_ending = True


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("url")
    parser.add_argument("--key", default="")
    parser.add_argument("--fixed-step", action="store_true")
    chosen = parser.parse_args()
    loop = Loop(Client(chosen.url, chosen.key), chosen.fixed_step)
    threading.Thread(target=listen, args=(loop,), daemon=True).start()
    loop.run()


if __name__ == "__main__":
    main()
