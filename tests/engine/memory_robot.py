"""An engine whose robot is a unicycle in its memory (`engine`), and an app that lets it drive (`app`), or moves it by
a held key (`jog`).

    python -m tests.engine.memory_robot engine FILE
    python -m tests.engine.memory_robot app FILE
    python -m tests.engine.memory_robot jog FILE

Each velocity that the robot hears is a line of FILE: seconds (monotonic, the same clock in all processes), m/s,
rad/s. The app prints the closing event of the run.
"""

import functools
import json
import os
import queue
import sys
import threading
import time
from pathlib import Path
from typing import Any

from pinel_desktop import links
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.links.real import RealLink, real_link
from pinel_desktop.robot import SimulationConfig, Twist2D
from pinel_desktop.robot.robot_profile import BridgeProfile, RobotProfile, Room
from pinel_desktop.runs.spec import RunSpec
from tests.links.unicycle import MemoryTransport, Unicycle

PROFILE = BridgeProfile(
    host=f"memory-{os.getpid()}",  # a robot of its own: other tests drive theirs at the same time
    max_v_mps=1.2,
    max_omega_dps=300.0,
    room=Room(width_m=40.0, depth_m=40.0),
)
FAR = RunSpec(
    [{"action": "move_forward", "distance": 10}], "empty_room", link="bridge", robot=PROFILE
)


class LoggedUnicycle(Unicycle):
    """Writes what it hears."""

    log: Path

    def receive(self, twist: Twist2D) -> None:
        super().receive(twist)
        with self.log.open("a") as log:
            log.write(f"{self.received[-1][0]} {twist.v_mps} {twist.omega_radps}\n")


def memory_link(
    *, world: Any, setting: SimulationConfig, seed: int, robot: RobotProfile | None
) -> RealLink:
    """The link `bridge`, over memory."""
    return real_link(lambda record: MemoryTransport(_unicycle()), setting, robot)


@functools.cache
def _unicycle() -> LoggedUnicycle:
    """The engine's only robot, which stays where a link has left it."""
    unicycle = LoggedUnicycle()
    unicycle.log = Path(sys.argv[2])
    return unicycle


def engine_command(file: Path) -> list[str]:
    """Starts the engine."""
    return [sys.executable, "-m", "tests.engine.memory_robot", "engine", str(file)]


def engine() -> None:
    """The engine's process with its link `bridge` replaced."""
    from pinel_desktop.commands.owned.engine import command  # noqa: PLC0415 - reads sys.argv

    links._BACKENDS["bridge"] = (__name__, "memory_link")
    command.main(args=[], prog_name="engine")


def app() -> None:
    """Lets the robot drive far, and prints how it ended."""
    events: queue.Queue[dict[str, Any]] = queue.Queue()
    client = EngineClient(events.put, engine_command(Path(sys.argv[2])))
    client.start()
    assert client.wait_until_ready(20.0)
    client.run("r1", FAR)
    threading.Thread(target=_close_at_end_of_input, args=(client,), daemon=True).start()
    while (event := events.get())["type"] != "run_ended":
        pass
    print(json.dumps(event), flush=True)
    client.close()


def jog() -> None:
    """Holds a key for good."""
    client = EngineClient(lambda event: None, engine_command(Path(sys.argv[2])))
    client.start()
    assert client.wait_until_ready(20.0)
    while True:
        client.jog(PROFILE, 1.0, 0.0, time.time())
        time.sleep(0.1)


def _close_at_end_of_input(client: EngineClient) -> None:
    sys.stdin.read()
    client.close()


if __name__ == "__main__":
    {"engine": engine, "app": app, "jog": jog}[sys.argv[1]]()
