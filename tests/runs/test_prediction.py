"""Runs of a double of a real robot with hidden errors, beside their predictions."""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.robot import Pose2D, SimulationConfig
from pinel_desktop.robot.robot_profile import BridgeProfile
from pinel_desktop.runs.difference import Difference, difference
from pinel_desktop.runs.measured import Measured, measured_poses
from pinel_desktop.runs.outliers import MIN_OTHER_RUNS, unusual
from pinel_desktop.runs.prediction import Path, predict, steps_of
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from pinel_desktop.runs.truth import TAPE_SIGMA_M, TAPE_SIGMA_RAD, TruePose, Truth

Wire = dict[str, Any]
ROOM = {"width_m": 6.0, "depth_m": 6.0}
PROFILE = BridgeProfile.model_validate({"room": ROOM, "max_v_mps": 1.2, "max_omega_dps": 90.0})
TOLERANCE = (PROFILE.move_tolerance_m, PROFILE.turn_tolerance_deg)
AHEAD = {"action": "move_forward", "distance": 1, "block": "ahead"}
TURN = {"action": "turn", "angle": 90, "block": "turn"}
SIDE = [AHEAD, TURN]
SQUARE = {
    "pinel_ir": 1,
    "commands": [{"action": "repeat", "times": 4, "commands": SIDE, "block": "loop"}],
}


@dataclass
class Driven:
    """A run as it would be recorded: what the robot reported, and where it truly was."""

    spec: RunSpec
    events: list[Wire]
    odometry: Path
    true: Path

    def beside(self, measured: Measured, *, is_whole: bool = True) -> Difference:
        return difference(
            predict(self.spec, self.events),
            measured,
            steps_of(self.events),
            is_whole=is_whole,
            tolerance=TOLERANCE,
        )

    def by_odometry(self) -> Difference:
        return self.beside(measured_poses(self.odometry[1:], []))

    def by_camera(self, noise_m: float = 0.01, noise_deg: float = 1.0, seed: int = 1) -> Difference:
        draw = np.random.default_rng(seed)
        sigma = np.array([noise_m, noise_m, math.radians(noise_deg)])
        poses = self.true + draw.normal(size=self.true.shape) * sigma
        frames = range(0, len(poses), 2)  # the camera's rate
        seen = [TruePose(tick, Pose2D(*map(float, poses[tick])), *sigma[1:]) for tick in frames]
        return self.beside(measured_poses(self.odometry[1:], [Truth("camera", tuple(seen))]))

    def by_tape(self) -> Difference:
        end = TruePose(None, Pose2D(*map(float, self.true[-1])), TAPE_SIGMA_M, TAPE_SIGMA_RAD)
        return self.beside(measured_poses(self.odometry[1:], [Truth("tape", (end,))]))


def drive(
    document: Wire = SQUARE,
    *,
    turns: float = 1.0,
    rolls: float = 1.0,
    pushed: tuple[int, float] | None = None,
    answers: tuple[str, ...] = (),
    seed: int = 0,
) -> Driven:
    """Drives a double.

    Args:
        turns, rolls: its true turn and distance, as parts of what its wheels report.
        pushed: the step soon after whose start somebody turns it, and by how many degrees.
    """
    spec = RunSpec(document, PROFILE.room.as_world(), link="bridge", robot=PROFILE, seed=seed)
    stamp, events, poses = EventSequencer("run"), [], [(0.0, 0.0, 0.0)]

    def observe(tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            poses.append((event.x_m, event.y_m, event.yaw_rad))
        elif event.is_recorded:
            events.append(stamp.wire(tick, event))

    late = SimulationConfig(preset="realistic", feedback="odometry")
    start(replace(spec, link="sim", setting=late, inputs=ScriptedInputs(answers=answers)), observe)
    odometry = np.array(poses)
    steps = steps_of(events)
    push = None if pushed is None else (steps[pushed[0]].start + 10, math.radians(pushed[1]))
    return Driven(spec, events, odometry, _true_path(odometry, turns, rolls, push))


def _true_path(odometry: Path, turns: float, rolls: float, push: tuple[int, float] | None) -> Path:
    yaws = np.unwrap(odometry[:, 2])
    true = [np.zeros(3)]
    for tick in range(1, len(odometry)):
        dx, dy = odometry[tick, :2] - odometry[tick - 1, :2]
        middle = (yaws[tick] + yaws[tick - 1]) / 2
        rolled = rolls * (math.cos(middle) * dx + math.sin(middle) * dy)
        turned = turns * (yaws[tick] - yaws[tick - 1])
        if push is not None and tick == push[0]:
            turned += push[1]
        x, y, yaw = true[-1]
        ahead = yaw + turned / 2
        true.append(
            np.array([x + rolled * math.cos(ahead), y + rolled * math.sin(ahead), yaw + turned])
        )
    return np.array(true)


@pytest.mark.parametrize("less_deg", [3.1, -2.4])
def test_a_robot_that_turns_less_at_each_turn_is_found_by_the_camera(less_deg: float) -> None:
    found = drive(turns=1 - less_deg / 90).by_camera()
    first = found.findings[0]
    assert (first.kind, first.how, first.n, first.block) == ("turn", "each", 4, "turn")
    assert first.source == found.source == "camera"
    assert first.difference == pytest.approx(-less_deg, abs=0.3)
    assert found.at_end is not None
    assert found.at_end.source == "camera"
    assert found.at_end.heading_deg == pytest.approx(-4 * less_deg, abs=2.0)


def test_its_odometry_knows_nothing_of_it() -> None:
    found = drive(turns=1 - 3.1 / 90).by_odometry()
    assert found.source == "odometry"
    assert [one for one in found.findings if one.kind == "turn"] == []
    assert found.ate_m is not None
    assert found.ate_m < 0.05


def test_a_tape_measure_shares_the_heading_at_the_end_among_all_turns() -> None:
    first = drive(turns=1 - 3.1 / 90).by_tape().findings[0]
    assert (first.how, first.n, first.source, first.block) == ("average", 4, "tape", "turn")
    assert first.difference == pytest.approx(-3.1, abs=0.3)


def test_turns_to_both_sides_are_not_averaged_from_the_heading_at_the_end() -> None:
    zigzag = {"pinel_ir": 1, "commands": [*SIDE, AHEAD, {**TURN, "angle": -90}]}
    found = drive(zigzag, turns=0.9).by_tape()
    assert [one.how for one in found.findings if one.source == "tape"] == []


def test_a_robot_that_rolls_too_far_is_found() -> None:
    first = drive(rolls=1.05).by_camera().findings[0]
    assert (first.kind, first.how, first.block) == ("move", "each", "ahead")
    assert first.difference == pytest.approx(0.05, abs=0.01)


def test_the_path_error_is_that_of_poses_at_the_same_part_of_each_step() -> None:
    assert (drive().by_camera(noise_m=0, noise_deg=0).ate_m or 1) < 0.03
    found = drive(rolls=1.1).by_camera(noise_m=0, noise_deg=0)
    # a square of 1.1 m over one of 1 m, by hand
    part = np.linspace(0, 1, 1000)
    sides = [(part, 0 * part), (1 + 0 * part, part), (1 - part, 1 + 0 * part), (0 * part, 1 - part)]
    ideal = np.concatenate([np.stack(side, axis=1) for side in sides])
    assert found.ate_m == pytest.approx(0.1 * np.sqrt((ideal**2).sum(axis=1).mean()), abs=0.03)


def test_a_prediction_ends_where_an_answer_is_missing_and_goes_on_when_it_came() -> None:
    asks = {"action": "ask", "question": "?", "variable": "a", "block": "ask"}
    by_answer = {**TURN, "angle": {"var": "a"}}
    run = drive({"pinel_ir": 1, "commands": [AHEAD, asks, by_answer]}, answers=("45",))
    before = [event for event in run.events if event["type"] != "answered"]
    unanswered = predict(run.spec, before)
    assert unanswered.awaits_input
    assert [step.block for step in unanswered.steps] == ["ahead"]
    answered = predict(run.spec, run.events)
    assert not answered.awaits_input
    assert math.degrees(answered.path[-1][2]) == pytest.approx(45, abs=0.1)


def test_a_run_that_took_another_way_is_compared_up_to_there() -> None:
    near = {"op": "<", "args": [{"sensor": "distance", "direction": "front"}, 2.5]}
    branch = {
        "action": "conditional_execution",
        "condition": near,
        "commands": [TURN],
        "elif": [],
        "else": [AHEAD],
    }
    document = {"pinel_ir": 1, "commands": [AHEAD, branch]}
    run = drive(document)
    # somebody stood before the robot, whom the simulated room does not know
    turned = drive({"pinel_ir": 1, "commands": [AHEAD, TURN]})
    for event in turned.events:
        event["pointer"] = str(event.get("pointer", "")).replace("/commands/1", "/commands/1/x")
    run.events, run.odometry = turned.events, turned.odometry
    prediction = predict(run.spec, run.events)
    assert prediction.reads_sensors
    found = run.by_odometry()
    assert found.parted == "turn"
    assert [step.block for step in found.steps] == ["ahead"]


def test_a_stopped_run_is_compared_up_to_its_last_whole_step() -> None:
    run = drive()
    cut = steps_of(run.events)[3].start + 5
    run.events = [event for event in run.events if event["tick"] <= cut]
    run.odometry = run.odometry[: cut + 1]
    found = run.beside(measured_poses(run.odometry[1:], []), is_whole=False)
    assert len(found.steps) == 3
    assert found.at_end is not None
    assert found.at_end.distance_m < 0.05


def test_an_endless_program_is_predicted_for_ten_minutes_at_most() -> None:
    wait = {"action": "wait", "seconds": 60}
    spec = drive().spec
    endless = {"pinel_ir": 1, "commands": [{"action": "forever", "commands": [wait]}]}
    assert predict(replace(spec, document=endless), []).is_cut
    busy = {"action": "set_variable", "name": "n", "value": 1}
    counting = {"pinel_ir": 1, "commands": [{"action": "forever", "commands": [busy]}]}
    assert len(predict(replace(spec, document=counting), []).path) < 600 * 30


def test_a_malformed_record_is_named() -> None:
    with pytest.raises(PinelError) as caught:
        predict(drive().spec, [{"type": "answered"}])
    assert caught.value.code == "run_damaged"


def test_a_run_in_which_a_wheel_slipped_is_out_of_the_ordinary_for_its_robot() -> None:
    usual = [drive(turns=0.97, seed=seed).by_camera(seed=seed) for seed in range(MIN_OTHER_RUNS)]
    assert unusual(drive(turns=0.97, seed=9).by_camera(seed=9), usual) is None
    odd = unusual(drive(turns=0.97, seed=9, pushed=(3, -20.0)).by_camera(seed=9), usual)
    assert odd is not None
    assert odd.n_runs == MIN_OTHER_RUNS
    assert (odd.kind, odd.block) == ("turn", "turn")
    assert odd.usual == pytest.approx(-2.7, abs=0.5)
    assert odd.difference == pytest.approx(-22.7, abs=2.0)


def test_too_few_runs_or_runs_by_another_source_say_nothing() -> None:
    odd = drive(pushed=(3, -20.0)).by_camera()
    usual = [drive(seed=seed).by_camera(seed=seed) for seed in range(MIN_OTHER_RUNS)]
    assert unusual(odd, usual) is not None
    assert unusual(odd, usual[1:]) is None
    assert unusual(odd, [drive(seed=seed).by_odometry() for seed in range(MIN_OTHER_RUNS)]) is None
