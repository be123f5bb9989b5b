"""A robot simulator that knows of PINEL what the original tells its clients, and no more: a unicycle.

    python aurora_double.py URL [--key KEY] [--fixed-step] [--rate HZ] [--jitter S] [--lost PART] [--turns PART]

It asks `/bridge/cmd_vel`, integrates, posts `/bridge/pose`, asks `/bridge/status`, and stops when the status is not
active and it has moved. While nobody listens it goes on asking. With `--turns` it truly turns
that part of what it reports. Standard output has a line for each velocity, `TIME V OMEGA X Y` (monotonic time, and
where the robot truly is). Lines on standard input say what goes wrong:

    mute         it posts no pose any more, and says so: a line `mute`
    pause S      it does nothing for so long
    restart S    the same, and its pose is zero again, as of a program that began anew
    jump M       its pose is suddenly so far ahead
    turn RAD     its yaw is suddenly another one
    nonsense     from now on its poses are impossible values

The end of input ends the program.
"""

import argparse
import json
import math
import queue
import random
import sys
import threading
import time
import urllib.request

REQUEST_TIMEOUT_S = 2.0
MAX_STEP_S = 0.1


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
        with urllib.request.urlopen(request, timeout=REQUEST_TIMEOUT_S) as answer:
            found: dict[str, float] = json.load(answer)
            return found


class Robot:
    """A unicycle, and what it says of itself.

    Attributes:
        x, y, yaw: the pose that it reports.
        true_x, true_y: where it is, counted from where it was switched on.
    """

    def __init__(self, turns: float) -> None:
        self._turns = turns
        self.x = self.y = self.yaw = 0.0
        self.true_x = self.true_y = self._true_yaw = 0.0
        self.has_moved = False

    def integrate(self, v: float, omega: float, dt_s: float) -> None:
        middle, true_middle = (
            self.yaw + omega * dt_s / 2,
            self._true_yaw + self._turns * omega * dt_s / 2,
        )
        self.x += v * dt_s * math.cos(middle)
        self.y += v * dt_s * math.sin(middle)
        self.true_x += v * dt_s * math.cos(true_middle)
        self.true_y += v * dt_s * math.sin(true_middle)
        self.yaw = math.remainder(self.yaw + omega * dt_s, math.tau)
        self._true_yaw = math.remainder(self._true_yaw + self._turns * omega * dt_s, math.tau)
        self.has_moved = self.has_moved or v != 0.0 or omega != 0.0

    def restart(self) -> None:
        self.x = self.y = self.yaw = 0.0

    def jump(self, ahead_m: float) -> None:
        self.x += ahead_m * math.cos(self.yaw)
        self.y += ahead_m * math.sin(self.yaw)

    def turn(self, angle_rad: float) -> None:
        self.yaw = math.remainder(self.yaw + angle_rad, math.tau)


class Loop:
    """So many times a second; a step takes the time that has passed, or always the same."""

    def __init__(self, client: Client, chosen: argparse.Namespace) -> None:
        self._client, self._chosen = client, chosen
        self._period_s = 1 / chosen.rate
        self._robot, self._draw = Robot(chosen.turns), random.Random(chosen.seed)
        self._is_mute = self._is_nonsense = self.is_ending = False
        self.orders: queue.SimpleQueue[tuple[str, float]] = queue.SimpleQueue()

    def run(self) -> None:
        due_s = at_s = time.monotonic()
        while not self.is_ending:
            while not self.orders.empty():
                self._obey(*self.orders.get())
                at_s = time.monotonic()
            now_s = time.monotonic()
            passed_s, at_s = min(now_s - at_s, MAX_STEP_S + self._period_s), now_s
            try:
                if self._step(self._period_s if self._chosen.fixed_step else passed_s):
                    return
            except OSError:  # nobody listens yet, or no more
                pass
            due_s = max(due_s + self._period_s, time.monotonic() - self._period_s)
            time.sleep(max(due_s - time.monotonic(), 0.0))

    def _obey(self, order: str, amount: float) -> None:
        match order:
            case "mute":
                self._is_mute = True
                print("mute", flush=True)
            case "pause":
                time.sleep(amount)
            case "restart":
                time.sleep(amount)
                self._robot.restart()
            case "jump":
                self._robot.jump(amount)
            case "turn":
                self._robot.turn(amount)
            case "nonsense":
                self._is_nonsense = True

    def _step(self, dt_s: float) -> bool:
        """True when the run is over."""
        command, robot = self._client.get("/bridge/cmd_vel"), self._robot
        v, omega = command["linear_x"], command["angular_z"]
        robot.integrate(v, omega, dt_s)
        print(time.monotonic(), v, omega, robot.true_x, robot.true_y, flush=True)
        if not self._is_mute and self._draw.random() >= self._chosen.lost:
            self._post()
        is_active = self._client.get("/bridge/status")["active"]
        return not is_active and robot.has_moved

    def _post(self) -> None:
        """A pose; one that is late was measured before."""
        pose: dict[str, float] = {"x": self._robot.x, "y": self._robot.y, "yaw": self._robot.yaw}
        if self._is_nonsense:
            pose = dict.fromkeys(pose, math.nan)
        time.sleep(self._chosen.jitter * self._draw.random())
        self._client.post("/bridge/pose", pose)


def listen(loop: Loop) -> None:
    for line in sys.stdin:
        order, _, amount = line.strip().partition(" ")
        loop.orders.put((order, float(amount or 0.0)))
    loop.is_ending = True


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("url")
    parser.add_argument("--key", default="")
    parser.add_argument("--fixed-step", action="store_true")
    parser.add_argument("--rate", type=float, default=30.0)
    parser.add_argument("--jitter", type=float, default=0.0)
    parser.add_argument("--lost", type=float, default=0.0)
    parser.add_argument("--turns", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    loop = Loop(Client(chosen.url, chosen.key), chosen)
    threading.Thread(target=listen, args=(loop,), daemon=True).start()
    loop.run()


if __name__ == "__main__":
    main()
