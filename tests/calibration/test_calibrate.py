"""Calibration of robots with hidden errors, driven by the simulator's physics."""

import math
import random

import pytest

from pinel_desktop.calibration import Calibration, calibrate, umbmark
from pinel_desktop.errors import PinelError
from pinel_desktop.robot import PIONEER_3DX, RobotParameters
from tests.calibration.hidden_robot import (
    LINE,
    PATTERN,
    SQUARE_LEFT,
    SQUARE_RIGHT,
    driven,
    hidden_errors,
    rows_of,
)

_KNOWN_BY_TRUTH = ("track_m", "wheel_bias_left", "wheel_bias_right")
_KNOWN_BY_ODOMETRY = ("lag_s", "latency_s")


def _calibrated(parameters: RobotParameters, seed: int, by: str) -> Calibration:
    drives = [driven(text, parameters, seed + i, by=by) for i, text in enumerate(PATTERN)]
    return calibrate(drives, PIONEER_3DX)


@pytest.mark.parametrize(
    ("by", "seed"),
    [
        *(("tape", seed) for seed in (10, 20, 30)),
        ("camera", 10),  # 2 s each
        *(pytest.param("camera", seed, marks=pytest.mark.nightly) for seed in (20, 30)),
    ],
)
def test_the_hidden_errors_are_found(by: str, seed: int) -> None:
    hidden = hidden_errors(random.Random(seed))
    found = _calibrated(hidden, seed, by).estimates
    true = hidden.changes
    assert set(found) == {*_KNOWN_BY_TRUTH, *_KNOWN_BY_ODOMETRY}
    for side in ("wheel_bias_left", "wheel_bias_right"):
        assert found[side].value == pytest.approx(true[side], abs=0.012)
    assert found["track_m"].value == pytest.approx(true["track_m"], rel=0.02)
    assert found["lag_s"].value == pytest.approx(true["lag_s"], rel=0.1)
    assert found["latency_s"].value == pytest.approx(true["latency_s"], abs=0.006)


@pytest.mark.nightly
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("by", ["camera", "tape"])
def test_intervals_cover_the_truth_in_at_least_90_of_100(by: str) -> None:
    covered = dict.fromkeys(_KNOWN_BY_TRUTH, 0)
    for seed in range(0, 1000, 10):
        hidden = hidden_errors(random.Random(seed))
        found = _calibrated(hidden, seed, by).estimates
        for name in _KNOWN_BY_TRUTH:
            covered[name] += found[name].low <= hidden.changes[name] <= found[name].high
    print(by, covered)
    assert min(covered.values()) >= 90


def test_without_true_poses_only_the_response_is_known() -> None:
    found = _calibrated(hidden_errors(random.Random(1)), 1, by="")
    assert set(found.estimates) == set(_KNOWN_BY_ODOMETRY)
    assert set(found.parameters.changes) == set(_KNOWN_BY_ODOMETRY)


def test_ends_of_squares_alone_do_not_tell_how_far_the_robot_drives() -> None:
    hidden = hidden_errors(random.Random(2))
    drives = [
        driven(text, hidden, i, by="tape") for i, text in enumerate((SQUARE_LEFT, SQUARE_RIGHT))
    ]
    found = calibrate(drives, PIONEER_3DX)
    assert found.wheels.difference.is_known
    assert not found.wheels.scale.is_known
    assert "wheel_bias_left" not in found.estimates


def test_a_line_alone_does_not_tell_the_track() -> None:
    hidden = hidden_errors(random.Random(3))
    found = calibrate([driven(LINE, hidden, i, by="tape") for i in range(3)], PIONEER_3DX)
    assert found.wheels.scale.is_known
    assert not found.wheels.track_m.is_known


def test_the_learned_robot_drives_like_the_hidden_one() -> None:
    """On a path that it has not seen; the noise of the wheels differs."""
    path = "robot.move_forward(1)\nrobot.turn(90)\nrobot.move_forward(1)\nrobot.turn(-45)\n"
    hidden = RobotParameters(
        track_m=0.345, wheel_bias_left=0.02, wheel_bias_right=-0.01, wheel_bias_sd=0.0
    )
    learned = _calibrated(hidden, 5, by="camera").parameters
    believed = RobotParameters(wheel_bias_sd=0.0)
    real, predicted, nominal = (_mean_end(path, one) for one in (hidden, learned, believed))
    assert math.dist(predicted, real) < 0.03
    assert math.dist(nominal, real) > 0.1


def _mean_end(path: str, parameters: RobotParameters) -> tuple[float, float]:
    ends = []
    for seed in range(40, 50):
        end = rows_of(path, parameters, seed)[-1]
        assert end.true_x_m is not None
        assert end.true_y_m is not None
        ends.append((end.true_x_m, end.true_y_m))
    return sum(x for x, _ in ends) / len(ends), sum(y for _, y in ends) / len(ends)


def test_umbmark_agrees() -> None:
    """The formulas by Borenstein and Feng, from the exact ends of five squares in each direction."""
    hidden = RobotParameters(
        track_m=0.34, wheel_bias_left=0.006, wheel_bias_right=-0.006, wheel_bias_sd=0.0
    )
    ends = {}
    for name, text in (("left", SQUARE_LEFT), ("right", SQUARE_RIGHT)):
        rows = [rows_of(text, hidden, seed)[-1] for seed in range(5)]
        ends[name] = [(row.true_x_m or 0.0, row.true_y_m or 0.0) for row in rows]
    by_ends = umbmark(ends["left"], ends["right"], 1.2, PIONEER_3DX.track_m)
    assert by_ends.difference == pytest.approx(-0.012, abs=0.002)
    assert by_ends.track_ratio * PIONEER_3DX.track_m == pytest.approx(0.34, abs=0.003)
    found = _calibrated(hidden, 7, by="camera").wheels
    assert found.difference.value == pytest.approx(by_ends.difference, abs=0.004)
    assert found.track_m.value == pytest.approx(by_ends.track_ratio * 0.33, abs=0.004)


def test_runs_without_motion_are_refused() -> None:
    with pytest.raises(PinelError, match="calibration_without_motion"):
        calibrate([driven("robot.wait(1)\n", RobotParameters(), 0)], PIONEER_3DX)


def test_the_same_runs_give_the_same_robot() -> None:
    hidden = hidden_errors(random.Random(4))
    first, second = (_calibrated(hidden, 4, by="tape").parameters for _ in range(2))
    assert first == second
