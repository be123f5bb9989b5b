"""Generates `ui/src/studio/help/films.json`: animations of the simulated robot for each block, for the page's help."""

import json
import math
from itertools import pairwise
from typing import Any

from pinel_desktop.events.model import Event, Pen, Telemetry
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.execution.control import RunControl
from pinel_desktop.program.python_text import read_python
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start

Wall = dict[str, list[float]]

# Each program demonstrates the named block; a block without a film does not move the robot.
_PROGRAMS = {
    "move_forward": "robot.move_forward(1.0)",
    "move_backward": "robot.move_backward(1.0)",
    "turn": "robot.turn(90)",
    "stop": "robot.drive(0.4, 0.0)\nrobot.wait(3)\nrobot.stop()\nrobot.wait(1)",
    "arc": "robot.arc(1.0, 90)",
    "go_to": "robot.go_to(1.0, 1.0)",
    "set_speed_linear": "robot.move_forward(1.0)\nrobot.set_speed(linear=0.2)\nrobot.move_forward(0.6)",
    "set_speed_angular": "robot.turn(180)\nrobot.set_speed(angular=30)\nrobot.turn(180)",
    "set_speed": "robot.set_speed(linear=0.3, angular=45)\nrobot.move_forward(0.8)\nrobot.turn(90)",
    "drive": "robot.drive(0.4, 30.0)\nrobot.wait(5)",
    "repeat": "for _ in range(4):\n    robot.move_forward(1.0)\n    robot.turn(90)",
    "forever": "while True:\n    robot.move_forward(1.0)\n    robot.turn(120)",
    "while": 'while robot.distance("front") > 1:\n    robot.move_forward(0.3)',
    "until": 'while not robot.distance("front") < 0.5:\n    robot.move_forward(0.3)',
    "wait": "robot.move_forward(0.6)\nrobot.wait(1.5)\nrobot.move_forward(0.6)",
    "wait_until": 'robot.drive(0.4, 0.0)\nrobot.wait_until(robot.distance("front") < 0.6)\nrobot.stop()',
    "for": "for i in steps(1, 4):\n    robot.move_forward(i * 0.3)\n    robot.turn(90)",
    "if": 'robot.move_forward(1.0)\nif robot.distance("front") < 1.5:\n    robot.turn(90)\nrobot.move_forward(0.8)',
    "distance_sensor": 'while not robot.distance("front") < 0.8:\n    robot.move_forward(0.2)\nrobot.turn(180)',
    "bumper": "while not robot.bumper:\n    robot.drive(0.4, 0.0)\nrobot.move_backward(0.6)",
    "pen_down": 'robot.pen(down=True, color="blue")\nrobot.arc(0.6, 180)\nrobot.arc(0.6, -180)',
    "pen_up": (
        'for _ in range(2):\n    robot.pen(down=True, color="blue")\n    robot.move_forward(0.5)\n'
        "    robot.pen(down=False)\n    robot.move_forward(0.5)"
    ),
}
# blocks that measure are demonstrated in a room with a wall ahead
_BEFORE_A_WALL = {"while", "until", "wait_until", "if", "distance_sensor", "bumper"}
_WALL_AHEAD: list[Wall] = [{"from": [2.2, -1.0], "to": [2.2, 1.0]}]
_SIDE_M = 12.0
_MAX_DURATION_S = 16.0
_POSES_PER_S = 5


def films() -> str:
    """Returns the text of the file; one film a line."""
    lines = [f"{json.dumps(name)}: {json.dumps(_film(name))}" for name in _PROGRAMS]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _film(name: str) -> dict[str, Any]:
    reading = read_python(_PROGRAMS[name]).result
    if reading.document is None:
        raise SystemExit(f"the program of the film {name}: {reading.faults}")
    walls = _WALL_AHEAD if name in _BEFORE_A_WALL else []
    camera = _PoseSampler()
    start(RunSpec(reading.document, _world(walls)), camera.observe, camera.control)
    return {**camera.film(), "walls": walls}


def _world(walls: list[Wall]) -> dict[str, Any]:
    """Returns a room so large that its own walls are out of sight."""
    half = _SIDE_M / 2
    corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    around = [
        {"from": list(one), "to": list(next_one)}
        for one, next_one in pairwise([*corners, corners[0]])
    ]
    return {
        "pinel_world": 1,
        "name": "film",
        "title": "film",
        "size_m": [_SIDE_M, _SIDE_M],
        "start": {"x_m": 0, "y_m": 0, "heading_deg": 0},
        "walls": [*around, *walls],
        "boxes": [],
    }


class _PoseSampler:
    """Samples the poses of a run at equal time intervals, and records between which samples the pen was down."""

    def __init__(self) -> None:
        self.control = RunControl()
        self._poses: list[list[float]] = [[0.0, 0.0, 0]]
        self._pens: list[tuple[str | None, int]] = []
        self._degrees = 0.0  # unwrapped: without jumps from 180 to -180
        self._tick = 0

    def observe(self, tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            self._tick = tick
            turned = math.degrees(event.yaw_rad) - self._degrees
            self._degrees += (turned + 180) % 360 - 180
            if tick % (TICK_HZ // _POSES_PER_S) == 0:
                place = (event.x_m, event.y_m)
                self._poses.append([*(round(at, 2) + 0.0 for at in place), round(self._degrees)])
            if tick >= _MAX_DURATION_S * TICK_HZ:
                self.control.stop()
        elif type(event) is Pen:
            self._pens.append((event.color if event.down else None, len(self._poses)))

    def film(self) -> dict[str, Any]:
        """Returns duration in s, poses (x and y in m, heading in degrees), and strokes as ranges of poses."""
        ends = [*self._pens, (None, len(self._poses) - 1)]
        strokes = [
            {"color": color, "from": begin, "to": end}
            for (color, begin), (_, end) in pairwise(ends)
            if color
        ]
        return {
            "seconds": round(self._tick / TICK_HZ, 1),
            "poses": self._poses,
            "strokes": strokes,
        }
