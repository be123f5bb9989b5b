"""The length of the way that a run tells: what the robot drove, not what its sensors made of it."""

import numpy as np
import pytest

from pinel_desktop.activities.run_log import RunLogBuilder
from pinel_desktop.execution.recorder import TelemetryRecorder
from pinel_desktop.robot import PIONEER_3DX, Feedback, Preset, SimulationConfig
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from sim.world import world_document

SIDE = [{"action": "move_forward", "distance": 1}, {"action": "turn", "angle": 90}]
SQUARE = {
    "pinel_ir": 1,
    "name": "",
    "functions": [],
    "commands": [{"action": "repeat", "times": 4, "commands": SIDE}],
}


def path_lengths_m(preset: Preset, feedback: Feedback) -> tuple[float, float]:
    """What the run tells, and how far the robot truly drove."""
    setting = SimulationConfig(PIONEER_3DX.name, preset, feedback)
    world = world_document("empty_room")
    writer = RunLogBuilder()
    spec = RunSpec(SQUARE, world, setting=setting)
    result = start(spec, writer.observe)
    steps = np.diff(writer.log().poses[:, :2], axis=0)
    return result.ended.path_length_m, float(np.hypot(*steps.T).sum())


@pytest.mark.parametrize(("preset", "feedback"), [("ideal", "pose"), ("realistic", "pose")])
def test_a_square_of_a_metre_is_four_metres_of_way(preset: Preset, feedback: Feedback) -> None:
    reported_m, true_m = path_lengths_m(preset, feedback)
    assert reported_m == pytest.approx(4.0, abs=0.06)
    assert reported_m == pytest.approx(true_m, abs=0.06)


def test_a_robot_whose_true_pose_nobody_knows_tells_its_own_path() -> None:
    recorder = TelemetryRecorder()
    for tick in range(1, 101):
        recorder.add((tick, 0.01 * tick, 0.0, 0.0, 0.3, 0.0, 0.3, 0.0))
    assert recorder.true_path_length_m() == recorder.path_length_m() == pytest.approx(1.0)


def test_standing_still_is_no_way() -> None:
    recorder = TelemetryRecorder()
    for tick in range(1, 301):
        recorder.add((tick, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
        recorder.add_true((2.0 + 0.0005 * (tick % 2), 1.0))
    assert recorder.true_path_length_m() == pytest.approx(0.0, abs=0.001)


def test_a_real_robot_tells_its_way_without_the_noise_of_its_poses() -> None:
    rng = np.random.default_rng(0)
    there = np.linspace(0.0, 4.0, 801)
    lengths_m = []
    for xs in (np.concatenate([there, there[::-1]]), np.zeros(900)):
        recorder = TelemetryRecorder()
        for tick, (x, y) in enumerate(rng.normal(0.0, 0.001, (len(xs), 2)), start=1):
            recorder.add((tick, xs[tick - 1] + x, y, 0.0, 0.3, 0.0, 0.3, 0.0))
        assert recorder.path_length_m() > recorder.measured_path_length_m()
        lengths_m.append(recorder.measured_path_length_m())
    assert lengths_m == pytest.approx([8.0, 0.0], abs=0.08)
