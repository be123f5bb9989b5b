"""The square in MuJoCo, with steps as long as ours.

Three ways: as its documentation builds a car, on two driven wheels and casters, step by step, a `rangefinder` for each
beam; with the argument `planar` a cylinder on planar joints with velocity actuators, which is nearest to our model;
with `tuned` that as fast as it could be made, eight steps in one call and all beams in one `mj_multiRay` a tick.
"""

import math
import sys
from collections.abc import Callable
from typing import Any

import mujoco
import numpy as np
from loop import (
    BEAMS_RAD,
    BOXES_M,
    HALF_M,
    MASS_KG,
    RADIUS_M,
    RANGE_M,
    SUBSTEPS,
    TICK_S,
    WALL_RADIUS_M,
    Drive,
    Twists,
    answer,
)

Ranges = np.ndarray[Any, Any]
Measure = Callable[[Ranges], None]
WALLS = "".join(
    f'<geom type="box" pos="{x} {y} 0.2" size="{sx} {sy} 0.2"/>'
    for x, y, sx, sy in (
        (0, -HALF_M, HALF_M, WALL_RADIUS_M),
        (0, HALF_M, HALF_M, WALL_RADIUS_M),
        (-HALF_M, 0, WALL_RADIUS_M, HALF_M),
        (HALF_M, 0, WALL_RADIUS_M, HALF_M),
        *((x, y, side / 2, side / 2) for x, y, side in BOXES_M),
    )
)
TUNED = "tuned" in sys.argv
PLANAR = TUNED or "planar" in sys.argv
HALF_TRACK_M, WHEEL_M = 0.165, 0.0975
SITES = "".join(
    f'<site name="s{i}" zaxis="{math.cos(beam)} {math.sin(beam)} 0"/>'
    for i, beam in enumerate(BEAMS_RAD)
)
SENSORS = "".join(
    f'<rangefinder site="s{i}" cutoff="{RADIUS_M + RANGE_M}"/>' for i in range(len(BEAMS_RAD))
)
PLANAR_BODY = f"""
    <body name="robot" pos="0 0 0.2">
      <joint name="x" type="slide" axis="1 0 0"/>
      <joint name="y" type="slide" axis="0 1 0"/>
      <joint name="yaw" type="hinge" axis="0 0 1"/>
      <geom type="cylinder" size="{RADIUS_M} 0.1" mass="{MASS_KG}"/>
      {"" if TUNED else SITES}
    </body>"""
PLANAR_ACTUATORS = """
    <velocity joint="x" kv="2000" forcerange="-80 80"/>
    <velocity joint="y" kv="2000" forcerange="-80 80"/>
    <velocity joint="yaw" kv="50" forcerange="-25 25"/>"""
WHEELS = "".join(
    f"""
      <body name="{side}" pos="0 {y} {WHEEL_M - 0.2}">
        <joint name="{side}" type="hinge" axis="0 1 0"/>
        <geom type="cylinder" size="{WHEEL_M} 0.02" zaxis="0 1 0" mass="0.5" friction="1"/>
      </body>"""
    for side, y in (("left", HALF_TRACK_M), ("right", -HALF_TRACK_M))
)
CAR_BODY = f"""
    <geom type="plane" size="{HALF_M} {HALF_M} 0.1"/>
    <body name="robot" pos="0 0 0.2">
      <freejoint/>
      <geom type="cylinder" size="{RADIUS_M} 0.06" mass="{MASS_KG - 1.0}"/>
      <geom type="sphere" size="0.03" pos="-0.17 0 -0.17" mass="0.1" condim="1"/>
      <geom type="sphere" size="0.03" pos="0.17 0 -0.17" mass="0.1" condim="1"/>
      {WHEELS}
      {SITES}
    </body>"""
CAR_ACTUATORS = """
    <velocity joint="left" kv="5" forcerange="-4 4"/>
    <velocity joint="right" kv="5" forcerange="-4 4"/>"""
MODEL = f"""
<mujoco>
  <option timestep="{TICK_S / SUBSTEPS!r}" gravity="0 0 {0 if PLANAR else -9.81}"/>
  <worldbody>
    {WALLS}
    {PLANAR_BODY if PLANAR else CAR_BODY}
  </worldbody>
  <actuator>{PLANAR_ACTUATORS if PLANAR else CAR_ACTUATORS}</actuator>
  <sensor>{"" if TUNED else SENSORS}</sensor>
</mujoco>
"""


def prepare(twists: Twists) -> Drive:
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    record = np.zeros((len(twists), 3 + len(BEAMS_RAD)))
    measure = _rays(model, data) if TUNED else _sensors(data)
    command = _on_joints(data) if PLANAR else _on_wheels(data)

    def drive() -> tuple[list[float], list[float]]:
        qpos = data.qpos
        for tick, (v, omega) in enumerate(twists):
            command(v, omega)
            if TUNED:
                mujoco.mj_step(model, data, SUBSTEPS)
            else:
                for _ in range(SUBSTEPS):
                    mujoco.mj_step(model, data)
            record[tick, :3] = qpos[:3]
            measure(record[tick, 3:])
        return list(record[-1, :3]), list(record[-1, 3:])

    return drive


def _on_joints(data: Any) -> Callable[[float, float], None]:
    qpos, ctrl = data.qpos, data.ctrl

    def command(v: float, omega: float) -> None:
        heading = qpos[2] + omega * TICK_S / 2.0
        ctrl[0], ctrl[1], ctrl[2] = v * math.cos(heading), v * math.sin(heading), omega

    return command


def _on_wheels(data: Any) -> Callable[[float, float], None]:
    ctrl = data.ctrl

    def command(v: float, omega: float) -> None:
        turn = omega * HALF_TRACK_M
        ctrl[0], ctrl[1] = (v - turn) / WHEEL_M, (v + turn) / WHEEL_M

    return command


def _sensors(data: Any) -> Measure:
    def measure(ranges: Ranges) -> None:
        ranges[:] = data.sensordata

    return measure


def _rays(model: Any, data: Any) -> Measure:
    robot, n_beams = model.body("robot").id, len(BEAMS_RAD)
    local = np.array([(math.cos(beam), math.sin(beam)) for beam in BEAMS_RAD])
    rays, hits = np.zeros((n_beams, 3)), np.zeros(n_beams, dtype=np.int32)
    flat, reach = rays.reshape(-1), RADIUS_M + RANGE_M

    def measure(ranges: Ranges) -> None:
        cos, sin = math.cos(data.qpos[2]), math.sin(data.qpos[2])
        rays[:, :2] = local @ ((cos, sin), (-sin, cos))
        here = data.xpos[robot]
        mujoco.mj_multiRay(
            model, data, here, flat, None, 1, robot, hits, ranges, None, n_beams, reach
        )

    return measure


if __name__ == "__main__":
    answer(prepare)
