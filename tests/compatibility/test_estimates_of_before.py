"""Runs of commit a15e9a7d, whose `closing_error_m` is the robot's own estimate, in the present program."""

import json
from pathlib import Path

import pytest

from pinel_desktop.activities import RecordedRun, RunLog, check_program
from pinel_desktop.program.reading import read_document
from storage import open_for_reading, open_store
from tests.activities.test_checks import activity
from tests.compatibility import archived_files as kept
from tests.compatibility.archived_files import DATABASE

ESTIMATE_M = 1.1589980098775377e-06  # truly 0.050 m


@pytest.fixture
def database(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("PINEL_LANG", "en")
    database = kept.unpack("estimates", tmp_path) / DATABASE
    open_store(database).close()  # as the app does at its first start after the update
    return database


@pytest.fixture
def on_wheels(database: Path) -> str:
    """The square of a realistic robot that knows its wheels only, seed 1."""
    with open_for_reading(database) as store:
        (run,) = [run for run in store.runs.newest(9) if run.parameters["preset"] == "realistic"]
    return run.id


def test_they_come_out_the_same_again(database: Path) -> None:
    with open_for_reading(database) as store:
        runs = [run.id for run in store.runs.newest(9)]
    outcomes = {kept.verdict(database, run)["outcome"] for run in runs}
    assert len(runs) == 2
    assert outcomes <= {"identical", "equal"}


def test_what_was_added_to_such_a_record_is_named(database: Path, on_wheels: str) -> None:
    added = "json_set(data, '$.estimated_closing_error_m', 0.0)"
    kept.changed(database, f"UPDATE events SET data = {added} WHERE type = 'run_ended'")
    assert kept.verdict(database, on_wheels)["outcome"] == "altered"


def test_a_person_reads_that_it_is_an_estimate(database: Path, on_wheels: str) -> None:
    status, text = kept.pinel("--db", database, "runs", "show", on_wheels)
    labels = [line.split(":")[0].strip() for line in text.splitlines()]
    assert status == 0
    assert "estimated_closing_error_m" in labels
    assert "closing_error_m" not in labels


def test_the_record_itself_stays_as_it_was(database: Path, on_wheels: str) -> None:
    _, text = kept.pinel("--db", database, "runs", "show", on_wheels, "--json")
    shown = json.loads(text)
    assert shown["closing_error_m"] == ESTIMATE_M
    assert shown["estimated_closing_error_m"] is None


@pytest.mark.parametrize(("within_m", "passed"), [(0.04, False), (0.06, True)])
def test_they_are_judged_by_where_the_robot_truly_stood(
    database: Path, on_wheels: str, within_m: float, passed: bool
) -> None:
    with open_for_reading(database) as store:
        telemetry, events = store.runs.telemetry(on_wheels), store.runs.events(on_wheels)
        document = store.runs.get(on_wheels).document
    back = {"check": "ends_at", "x_m": 0.0, "y_m": 0.0, "within_m": within_m}
    recorded = RecordedRun(RunLog.of_columns(telemetry.column, events), 1)
    report = check_program(activity(back), read_document(document or {}), recorded=recorded)
    assert report.passed is passed
