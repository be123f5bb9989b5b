"""Runs of a double of a real robot with hidden errors, beside their predictions."""

import math
from dataclasses import replace

import numpy as np
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.runs.measured import measured_poses
from pinel_desktop.runs.outliers import MIN_OTHER_RUNS, unusual
from pinel_desktop.runs.prediction import predict, steps_of
from tests.runs.hidden_errors import AHEAD, SIDE, TURN, drive


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


def test_a_heading_that_is_only_roughly_known_is_no_finding() -> None:
    run = drive(turns=1 - 1.5 / 90)
    assert run.by_tape().findings[0].how == "average"
    assert run.by_tape(sigma_rad=math.radians(4.3)).findings == []


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
    outlier = unusual(drive(turns=0.97, seed=9, pushed=(3, -20.0)).by_camera(seed=9), usual)
    assert outlier is not None
    assert outlier.n_runs == MIN_OTHER_RUNS
    assert (outlier.kind, outlier.block) == ("turn", "turn")
    assert outlier.usual == pytest.approx(-2.7, abs=0.5)
    assert outlier.difference == pytest.approx(-22.7, abs=2.0)


def test_too_few_runs_or_runs_by_another_source_say_nothing() -> None:
    outlier = drive(pushed=(3, -20.0)).by_camera()
    usual = [drive(seed=seed).by_camera(seed=seed) for seed in range(MIN_OTHER_RUNS)]
    assert unusual(outlier, usual) is not None
    assert unusual(outlier, usual[1:]) is None
    assert (
        unusual(outlier, [drive(seed=seed).by_odometry() for seed in range(MIN_OTHER_RUNS)]) is None
    )
