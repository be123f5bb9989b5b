"""The error that a calibrated robot states for a prediction."""

import json
import math
import random
from typing import Any

import pytest

from pinel_desktop.calibration import calibrate
from pinel_desktop.calibration.stated_error import CalibratedWheels, end_radius_m
from pinel_desktop.calibration.wheels import predicted_end
from pinel_desktop.robot import PIONEER_3DX
from tests.calibration.hidden_robot import LINE, PATTERN, driven, hidden_errors

_TRACK_M = PIONEER_3DX.track_m
# on none of the runs of the pattern
FOURTH = "for i in range(4):\n    robot.move_forward(0.8)\n    robot.turn(90)\n"


def _calibrated(seed: int, by: str = "tape") -> CalibratedWheels:
    hidden = hidden_errors(random.Random(seed))
    drives = [driven(text, hidden, 10 * seed + i, by=by) for i, text in enumerate(PATTERN)]
    return CalibratedWheels(calibrate(drives, PIONEER_3DX).wheels, _TRACK_M)


def _is_inside(seed: int, by: str) -> bool:
    robot = _calibrated(seed, by)
    fourth = driven(FOURTH, hidden_errors(random.Random(seed)), 10 * seed + 9, by="tape")
    assert fourth.end is not None
    predicted, _ = predicted_end(fourth.wheel_distances(_TRACK_M), robot.wheels)
    off_m = math.dist(predicted[:2].tolist(), fourth.end.pose[:2])
    return off_m <= end_radius_m(fourth.odometry, robot)


def test_a_fourth_run_ends_within_it() -> None:
    assert sum(_is_inside(seed, "tape") for seed in range(20)) >= 17


@pytest.mark.nightly
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("by", ["tape", "camera"])
def test_it_holds_in_at_least_90_of_100(by: str) -> None:
    n = sum(_is_inside(seed, by) for seed in range(100))
    print(by, n)
    assert n >= 90


def test_it_is_some_centimetres_and_grows_with_the_way() -> None:
    robot = _calibrated(1)
    hidden = hidden_errors(random.Random(1))
    square, line = (end_radius_m(driven(one, hidden, 1).odometry, robot) for one in (FOURTH, LINE))
    assert line > 0.03
    assert 0.03 < square < 0.2
    near = end_radius_m(driven("robot.move_forward(0.3)\n", hidden, 1).odometry, robot)
    assert 0.02 < near < line


def test_it_is_the_same_after_the_store() -> None:
    robot = _calibrated(2)
    record = json.loads(json.dumps(robot.as_record()))
    again = CalibratedWheels.from_record(record)
    odometry = driven(FOURTH, hidden_errors(random.Random(2)), 3).odometry
    assert again is not None
    assert end_radius_m(odometry, again) == pytest.approx(end_radius_m(odometry, robot))


def test_runs_that_do_not_tell_the_wheels_state_nothing() -> None:
    lines = [driven(LINE, hidden_errors(random.Random(3)), i, by="tape") for i in range(3)]
    wheels = calibrate(lines, PIONEER_3DX).wheels
    assert CalibratedWheels(wheels, _TRACK_M).as_record() is None


@pytest.mark.parametrize(
    "change",
    [
        {"parameters": [1.0, 0.0]},
        {"parameters": [1.0, 0.0, 0.0]},
        {"covariance": [[1.0]]},
        {"covariance": "x"},
        {"wheel_noise": float("nan")},
        {"n_poses": None},
    ],
)
def test_a_record_of_a_file_that_cannot_be_used_states_nothing(change: dict[str, Any]) -> None:
    record = _calibrated(4).as_record()
    assert record is not None
    assert CalibratedWheels.from_record({**record, **change}) is None
    assert CalibratedWheels.from_record({}) is None
