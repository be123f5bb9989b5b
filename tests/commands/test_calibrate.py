"""`pinel calibrate` as a person types it."""

import json
from pathlib import Path

import pytest

from storage import open_store
from tests.calibration.recorded_runs import measured_pattern, real_run
from tests.commands.typed import pinel


@pytest.fixture
def database(tmp_path: Path) -> Path:
    return tmp_path / "pinel.db"


def test_the_table_says_what_is_known_by_which_source(database: Path) -> None:
    with open_store(database) as store:
        runs = measured_pattern(store)
        unmeasured, _ = real_run(store, "robot.move_forward(1)\n")
    result = pinel("--db", str(database), "calibrate", *runs)
    assert result.exit_code == 0, result.output
    lines = result.output.splitlines()
    assert lines[1].startswith("track_m")
    assert lines[1].endswith("0.3300  tape")
    assert "drive each program again" in lines[-2]
    assert "UMBmark" in lines[-1]
    alone = pinel("--db", str(database), "calibrate", unmeasured).output
    assert alone.count("these runs do not tell") == 4
    assert "no run was held out" in alone
    report = json.loads(pinel("--db", str(database), "calibrate", "--json", *runs).output)
    assert report["runs"] == runs
    assert report["values"]["track_m"] == pytest.approx(0.345, rel=0.02)


def test_a_run_that_is_not_there_is_refused(database: Path) -> None:
    with open_store(database):
        pass
    result = pinel("--db", str(database), "calibrate", "abc")
    assert result.exit_code != 0
    assert "not found" in result.output
