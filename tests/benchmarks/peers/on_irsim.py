"""The square in ir-sim: a differential robot with a lidar of 16 beams in a room of lines, one step a tick."""

import contextlib
import io
import math
import os
import tempfile
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")

with contextlib.redirect_stdout(io.StringIO()):
    import irsim
import numpy as np
from loop import BOXES_M, HALF_M, RADIUS_M, RANGE_M, TICK_S, Drive, Twists, answer

CORNERS = [
    [-HALF_M, -HALF_M],
    [HALF_M, -HALF_M],
    [HALF_M, HALF_M],
    [-HALF_M, HALF_M],
    [-HALF_M, -HALF_M],
]
BOXES = "\n".join(
    f"  - shape: {{name: 'rectangle', length: {side}, width: {side}}}\n    state: [{x}, {y}, 0]"
    for x, y, side in BOXES_M
)
SIDE = 2 * HALF_M
WORLD = f"""
world:
  height: {SIDE}
  width: {SIDE}
  offset: [{-HALF_M}, {-HALF_M}]
  step_time: {TICK_S!r}
  sample_time: {TICK_S!r}
  collision_mode: 'stop'
robot:
  - kinematics: {{name: 'diff'}}
    shape: {{name: 'circle', radius: {RADIUS_M}}}
    state: [0, 0, 0]
    goal: [100, 100, 0]
    vel_min: [-2, -6]
    vel_max: [2, 6]
    acce: [1000, 1000]
    sensors:
      - name: 'lidar2d'
        range_min: 0
        range_max: {RADIUS_M + RANGE_M}
        angle_range: {math.tau!r}
        number: 16
obstacle:
  - shape: {{name: 'linestring', vertices: {CORNERS}}}
    state: [0, 0, 0]
{BOXES}
"""


def prepare(twists: Twists) -> Drive:
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        path = Path(folder) / "room.yaml"
        path.write_text(WORLD, "utf-8")
        env = irsim.make(str(path), headless=True, disable_all_plot=True, log_level="ERROR")
    actions = [np.array([[v], [omega]]) for v, omega in twists]
    record = np.zeros((len(twists), 3 + 16))

    def drive() -> tuple[list[float], list[float]]:
        robot = env.robot
        for tick, action in enumerate(actions):
            env.step(action)
            record[tick, :3] = robot.state[:3, 0]
            record[tick, 3:] = env.get_lidar_scan()["ranges"]
        return list(record[-1, :3]), list(record[-1, 3:])

    return drive


if __name__ == "__main__":
    answer(prepare)
