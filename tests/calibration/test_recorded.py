"""Calibration of recorded runs: from the store to parameters, with refusals in words."""

import math
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.calibration.recorded import calibrate_runs, drive_of
from pinel_desktop.calibration.report import CalibrationReport
from pinel_desktop.errors import PinelError
from pinel_desktop.runs.truth import truths_of
from storage import RunStart, Store, open_store
from tests.calibration.hidden_robot import LINE, PATTERN
from tests.calibration.recorded_runs import measured_pattern, measured_run, real_run
from tests.storage.sample_documents import SQUARE, WORLD


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    with open_store(tmp_path / "pinel.db") as opened:
        yield opened


def report_of(store: Store, *runs: str) -> CalibrationReport:
    return calibrate_runs(store, [store.runs.get(run) for run in runs])


def test_three_measured_runs_tell_the_robot_but_not_one_another(store: Store) -> None:
    runs = measured_pattern(store)
    report = report_of(store, *runs)
    assert report.runs == tuple(runs)
    assert report.values["track_m"] == pytest.approx(0.345, rel=0.02)
    assert report.values["wheel_bias_left"] == pytest.approx(0.012, abs=0.012)
    by = {one.name: one.sources for one in report.parameters if one.is_known}
    assert by["track_m"] == by["wheel_bias_right"] == ("tape",)
    assert by["lag_s"] == ("odometry",)
    assert report.held_out == ()  # no other run has turned to the same side
    assert report.robot == ("dds", "domain 0 cmd_vel")
    assert report.squares
    assert report.squares.left_over_m is None
    assert report.squares.track_ratio == pytest.approx(0.345 / 0.33, abs=0.03)


def test_a_fourth_run_ends_within_the_stated_error(store: Store) -> None:
    errors, floors = [], []
    for seed in range(10, 14):
        runs = [measured_run(store, one, seed + 100 * i) for i, one in enumerate(PATTERN)]
        path = "robot.move_forward(1)\nrobot.turn(90)\nrobot.move_forward(1)\nrobot.turn(-45)\n"
        fourth = report_of(store, *runs, measured_run(store, path, seed)).held_out[-1]
        assert fourth.place == 3
        errors.append(fourth.error_m**2)
        floors.append(fourth.expected_m**2)
    assert math.sqrt(sum(errors)) <= 1.3 * math.sqrt(sum(floors))


def test_without_a_source_of_truth_wheels_and_track_stay_unknown(store: Store) -> None:
    runs = [real_run(store, one, seed=i)[0] for i, one in enumerate(PATTERN)]
    report = report_of(store, *runs)
    known = {one.name for one in report.parameters if one.is_known}
    assert known == set(report.values) == {"lag_s", "latency_s"}
    assert report.held_out == ()
    track = next(one for one in report.parameters if one.name == "track_m")
    assert (track.value, track.sources) == (track.nominal, ())


def test_one_run_is_enough_but_nothing_is_held_out(store: Store) -> None:
    report = report_of(store, measured_run(store, LINE, 1))
    assert report.held_out == ()


def test_a_camera_during_run_is_used_with_the_tape_at_the_end(store: Store) -> None:
    run, rows = real_run(store, LINE)
    way = [
        (i + 1, one.true_x_m or 0.0, one.true_y_m or 0.0, one.true_yaw_rad or 0.0, 0.01, 0.02)
        for i, one in enumerate(rows)
    ]
    store.truths.record(run, "camera", list(way))
    store.truths.record(run, "tape", [(None, 1.8, 0.0, 0.0, 0.01, 0.03)])
    drive = drive_of(store, store.runs.get(run), truths_of(store.truths.of_run(run)))
    ticks = [one.tick for one in drive.truth]
    assert ticks == [*range(15, len(rows), 15), len(rows), None]
    assert len(drive.odometry) == len(rows) + 1
    assert drive.odometry[-1, 0] == pytest.approx(1.8, abs=0.01)
    assert {one.sources for one in report_of(store, run).parameters if one.is_known} == {
        ("camera", "tape"),
        ("odometry",),
    }


def test_runs_that_cannot_calibrate_are_refused_in_words(store: Store) -> None:
    line = measured_run(store, LINE, 1)
    simulated = store.runs.begin(RunStart("sim", "w", WORLD, 1, "0.3", document=SQUARE)).id
    old = store.runs.begin(RunStart("dds", "w", WORLD, 1, "0.3", document=SQUARE)).id
    other = measured_run(store, LINE, 1, domain=3)
    still = measured_run(store, "robot.wait(1)\n", 1)
    empty = store.runs.begin(
        RunStart(
            "dds", "w", WORLD, 1, "0.3", document=SQUARE, parameters={"robot": {"link": "dds"}}
        )
    ).id
    refused = {
        "calibration_without_runs": [],
        "calibration_of_simulator": [line, simulated],
        "calibration_run_old": [line, old],
        "calibration_two_robots": [line, other],
        "calibration_without_motion": [still],
    }
    for code, runs in refused.items():
        with pytest.raises(PinelError, match=code):
            report_of(store, *runs)
    with pytest.raises(PinelError, match="calibration_run_old"):
        report_of(store, line, empty)


def test_an_absurd_result_is_refused(store: Store) -> None:
    """As of a tape that was read in other units: the robot drove 1.8 m, 1.2 m were measured."""
    runs = []
    for seed in range(5):
        run, _ = real_run(store, LINE, seed=seed)
        store.truths.record(run, "tape", [(None, 1.2, 0.0, 0.0, 0.0001, 0.0001)])
        runs.append(run)
    with pytest.raises(PinelError, match="robot_parameter_range"):
        report_of(store, *runs)


def test_the_report_is_plain_json(store: Store) -> None:
    record = report_of(store, measured_run(store, LINE, 1)).as_record()
    assert record["model"] == "pioneer_3dx"
    assert record["parameters"][0]["name"] == "track_m"
    assert isinstance(record["held_out"], list)
