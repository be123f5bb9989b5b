"""How true the simulator is: where programs end, how deep things sink into each other, what memory it takes.

These are no ratios: the figures do not depend on the PC. Only the memory does a little.
"""

import math
import subprocess
import sys
from pathlib import Path

import pytest

from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import PIONEER_3DX, Pose2D, RobotLink, SimulationConfig
from sim.simulator import Simulator
from tests.sim.rooms import box, boxes_depth_m, boxes_now, robot_depth_m, room

PROGRAMS = Path(__file__).parents[1] / "programs"
SEEDS = range(20)


def true_pose(link: RobotLink) -> Pose2D:
    pose = link.read().true_pose
    assert pose is not None
    return pose


def closing(name: str, setting: SimulationConfig, seed: int = 0) -> tuple[float, float]:
    """Where a closed figure truly ends: distance from its start in mm, heading in degrees."""
    program = read_document((PROGRAMS / f"{name}.json").read_bytes()).program
    assert program is not None
    link = open_link("sim", world="empty_room", setting=setting, seed=seed)
    start = true_pose(link)
    result = execute(program, link, RunOptions(seed=seed, robot=setting.robot))
    assert result.ended.state == "finished"
    end = true_pose(link).relative_to(start)
    return math.hypot(end.x_m, end.y_m) * 1e3, abs(math.degrees(end.yaw_rad))


def p95(values: list[float]) -> float:
    return sorted(values)[math.ceil(0.95 * len(values)) - 1]


def test_figures_close() -> None:
    print(
        "\nclosing errors                     ideal             realistic, p95 of 20 seeds (mm, degrees)"
    )
    print(f"  {'':<12}{'mm':>10}{'degrees':>10}{'pose by camera':>22}{'knows its wheels':>22}")
    for name in ("square", "triangle", "lemniscate"):
        mm, degrees = closing(name, SimulationConfig())
        cells = f"  {name:<12}{mm:10.4f}{degrees:10.5f}"
        for feedback in ("pose", "odometry"):
            setting = SimulationConfig(preset="realistic", feedback=feedback)
            ends = [closing(name, setting, seed) for seed in SEEDS]
            spread = p95([end[0] for end in ends]), p95([end[1] for end in ends])
            cells += f"{spread[0]:14.1f}{spread[1]:8.2f}"
            if feedback == "pose":
                assert spread[0] < 5.0
                assert spread[1] < 0.3
            else:
                assert spread[0] > 20.0  # it must be seen
        print(cells)
        assert mm < 0.1
        assert degrees < 0.02
    print("  bounds          < 0.1    < 0.02         < 5.0   < 0.3          > 20")


BOXES = {
    "a wall": (),
    "a fixed box": (box(1.2, 0.1),),
    "a box of 0.1 kg, then a wall": (box(0.8, 0.0, movable=True, mass_kg=0.1),),
    "a box of 2 kg, then a wall": (box(0.8, 0.0, movable=True, mass_kg=2.0),),
    "a box of 15 kg, then a wall": (box(0.8, 0.0, movable=True, mass_kg=15.0),),
    "two boxes, then a wall": (box(0.7, 0.0, movable=True), box(1.2, 0.0, movable=True)),
}


@pytest.mark.parametrize("obstacle", BOXES)
def test_little_sinks_into_anything(obstacle: str) -> None:
    world = room(*BOXES[obstacle])
    sim, deepest, resting = Simulator(world, PIONEER_3DX), 0.0, 0.0
    for _ in range(300):
        sim.tick(1.2, 0.0)
        resting = max(robot_depth_m(world, sim), boxes_depth_m(boxes_now(world, sim)))
        deepest = max(deepest, resting)
    print(
        f"\ndriven at 1.2 m/s against {obstacle:<30} impact {deepest * 1e3:5.2f} mm (< 6), "
        f"resting {resting * 1e3:5.2f} mm (< 0.6)"
    )
    assert deepest < 0.006
    assert resting < 0.0006


PEAK = """
for line in open("/proc/self/status"):
    if line.startswith("VmHWM"):
        print(line.split()[1])
"""
BARE = "import numpy"
SIMULATES = f"""
import numpy
from pathlib import Path
import pinel_desktop.engine.server
from pinel_desktop.execution.executor import execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
link = open_link("sim", world="empty_room")
execute(read_document(Path({str(PROGRAMS / "lemniscate.json")!r}).read_bytes()).program, link)
link.sensors.scan()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="reads the peak as Linux tells it")
def test_simulator_takes_little_memory() -> None:
    def peak_mb(code: str) -> float:
        command = [sys.executable, "-c", f"{code}\n{PEAK}"]
        output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        return int(output.split()[-1]) / 1024.0

    bare, ours = peak_mb(BARE), peak_mb(SIMULATES)
    print(
        f"\nmemory at most: Python with numpy {bare:.0f} MB, the engine's process after a run {ours:.0f} MB"
    )
    print(f"  that is {ours - bare:.0f} MB more; at most 60")
    assert ours - bare < 60.0
