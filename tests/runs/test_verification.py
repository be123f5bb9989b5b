"""Every program, run and kept and run again: the same to the bit, here, elsewhere, and beside other runs."""

import itertools
import json
import os
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

from pinel_desktop.cli import main
from pinel_desktop.robot.models import ROBOTS
from pinel_desktop.runs.verification import verify_run
from storage import open_for_reading, open_store
from storage.runs.telemetry import COLUMNS, Rows, pack
from storage.sqlite import sqlite3
from tests.test_programs import NAMES, PROGRAMS, values_of


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path))
    monkeypatch.setenv("PINEL_LANG", "en")
    return tmp_path


def record_run(name: str, db: Path, *options: str) -> str:
    values = values_of(name)
    arguments = ["--db", str(db), "run", str(PROGRAMS / f"{name}.json"), "--json", *options]
    arguments += ["--world", values.get("world", "empty_room")]
    if "gestures" in values:
        arguments += ["--gestures", ",".join(values["gestures"])]
    done = CliRunner().invoke(main, arguments)
    run_id: str = json.loads(done.stdout)["run_id"]
    return run_id


def verify(run_id: str, db: Path) -> tuple[int, dict[str, Any]]:
    done = CliRunner().invoke(main, ["--db", str(db), "runs", "verify", run_id, "--json"])
    return done.exit_code, json.loads(done.stdout)


# by odometry alone a robot that slips loses the line, and searches it for the hour that a run may last
SEARCHES_FOR_AN_HOUR = ("realistic", "follow_the_line")


@pytest.mark.parametrize(
    ("preset", "name"),
    [
        pytest.param(*one, marks=pytest.mark.nightly if one == SEARCHES_FOR_AN_HOUR else ())
        for one in itertools.product(("ideal", "realistic"), NAMES)
    ],
)
def test_every_program_comes_out_the_same(name: str, preset: str, tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run(name, db, "--seed", "7", "--preset", preset, "--feedback", "odometry")
    status, verdict = verify(run_id, db)
    assert (status, verdict["outcome"], verdict["whole"]) == (0, "identical", True)


@pytest.mark.parametrize("model", ROBOTS)
@pytest.mark.parametrize("preset", ["ideal", "realistic"])
def test_every_robot_comes_out_the_same(model: str, preset: str, tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("square", db, "--seed", "7", "--preset", preset, "--model", model)
    status, verdict = verify(run_id, db)
    assert (status, verdict["outcome"], verdict["whole"]) == (0, "identical", True)
    with open_for_reading(db) as store:
        assert store.runs.get(run_id).model == model


def test_robot_with_parameters_of_its_own_comes_out_the_same(tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    options = [
        "--seed",
        "7",
        "--preset",
        "realistic",
        "--set",
        "track_m=0.35",
        "--set",
        "lag_s=0.1",
    ]
    changed, plain = record_run("square", db, *options), record_run("square", db, *options[:4])
    status, verdict = verify(changed, db)
    assert (status, verdict["outcome"], verdict["whole"]) == (0, "identical", True)
    with open_for_reading(db) as store:
        rows = [store.runs.get(one) for one in (changed, plain)]
    assert rows[0].parameters["robot_parameters"] == {"track_m": 0.35, "lag_s": 0.1}
    assert rows[0].telemetry_sha256 != rows[1].telemetry_sha256


def test_another_process_and_another_hash_seed_change_nothing(tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("tic_tac_toe", db, "--preset", "realistic")
    for seed in ("0", "1", "4242"):
        done = subprocess.run(
            [sys.executable, "-m", "pinel_desktop", "--db", str(db), "runs", "verify", run_id],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        assert "identical" in done.stdout


def test_other_runs_beside_it_change_nothing(tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("lemniscate", db)
    with open_for_reading(db) as store:
        row = store.runs.get(run_id)
        with ThreadPoolExecutor(4) as pool:
            verdicts = list(pool.map(lambda _: verify_run(store, row), range(4)))
    assert {verdict.outcome for verdict in verdicts} == {"identical"}


def test_where_it_first_differs_is_told(tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("square", db)
    _change(db, "UPDATE runs SET document = replace(document, '90', '91')")
    status, verdict = verify(run_id, db)
    assert (status, verdict["outcome"]) == (1, "different")
    assert 60 < verdict["difference"]["tick"] < 160  # in the first turn, after 1 m
    done = CliRunner().invoke(main, ["--db", str(db), "runs", "verify", run_id])
    assert f"Different from tick {verdict['difference']['tick']}" in done.stdout


def test_what_differs_in_the_last_digits_only_is_equal(tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("square", db)
    of_another_platform = "telemetry_sha256', '" + "0" * 64 + "')"
    _change(
        db,
        f"UPDATE runs SET telemetry_sha256 = '{'0' * 64}', summary = json_set(summary, '$.{of_another_platform}",
        f"UPDATE events SET data = json_set(data, '$.{of_another_platform} WHERE type = 'run_ended'",
    )
    status, verdict = verify(run_id, db)
    assert (status, verdict["outcome"], verdict["difference"]) == (0, "equal", None)
    done = CliRunner().invoke(main, ["--db", str(db), "runs", "verify", run_id])
    assert "telemetry_sha256 that is kept is not the repetition's" in done.stdout


def test_a_run_that_was_cut_off_is_compared_as_far_as_it_goes(tmp_path: Path) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("square", db)
    with open_for_reading(db) as store:
        rows = store.runs.telemetry(run_id).rows[:150]
    _change(
        db,
        "UPDATE runs SET reason = 'interrupted', state = 'failed', telemetry_sha256 = NULL",
        "DELETE FROM telemetry WHERE chunk > 0",
        f"UPDATE telemetry SET n_rows = 150, data = x'{pack(rows).hex()}'",
        "DELETE FROM events WHERE type = 'run_ended'",
    )
    status, verdict = verify(run_id, db)
    assert (status, verdict["outcome"], verdict["whole"]) == (0, "equal", False)
    assert verdict["n_ticks"] == 150


def _bumped(column: int) -> Callable[[Rows], Rows]:
    def bump(rows: Rows) -> Rows:
        rows[100, column] += 0.0002
        return rows

    return bump


@pytest.mark.parametrize(
    ("change", "part"),
    [
        (_bumped(1), "x_m is"),
        (_bumped(13), "true_x_m is"),
        (lambda rows: rows[:-1], "rows instead of"),
        (lambda rows: np.delete(rows, 100, axis=0), "rows instead of"),
        (lambda rows: rows[:, :13], "true_x_m is"),
        ("DELETE FROM telemetry", "0 rows instead of"),
        ("DELETE FROM events", "0 kept"),
        ("DELETE FROM events WHERE type = 'block_ended' AND tick > 200", "(block_ended, tick"),
        ("DELETE FROM events WHERE type = 'run_ended'", "run_ended, tick"),
        ("UPDATE events SET data = '{}' WHERE type = 'block_started'", "number 2 (block_started"),
        (
            "UPDATE runs SET state = 'failed', reason = 'blocked'",
            "state: failed instead of finished",
        ),
        ("UPDATE runs SET duration_s = 1", "duration_s: 1 instead of"),
        ("UPDATE runs SET path_length_m = 1", "path_length_m: 1 instead of"),
        ("UPDATE runs SET closing_error_m = 0", "closing_error_m: 0 instead of"),
        ("UPDATE runs SET n_executed = 999", "n_executed: 999 instead of"),
        ("UPDATE runs SET summary = '{}'", "summary"),
        ("UPDATE runs SET telemetry_sha256 = NULL", "telemetry_sha256"),
        ("UPDATE runs SET telemetry_sha256 = hex(zeroblob(32))", "telemetry_sha256"),
    ],
)
def test_what_was_changed_of_a_record_is_named(
    change: str | Callable[[Rows], Rows], part: str, tmp_path: Path
) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("square", db)
    _change(db, change if isinstance(change, str) else _repacked(run_id, db, change))
    status, verdict = verify(run_id, db)
    assert (status, verdict["outcome"]) == (1, "altered")
    done = CliRunner().invoke(main, ["--db", str(db), "runs", "verify", run_id])
    assert done.exit_code == 1
    assert "was changed or is incomplete" in done.stdout
    assert part in done.stdout


def _repacked(run_id: str, db: Path, change: Callable[[Rows], Rows]) -> str:
    with open_for_reading(db) as store:
        rows = change(store.runs.telemetry(run_id).rows)
    padded = np.full((len(rows), len(COLUMNS)), np.nan)
    padded[:, : rows.shape[1]] = rows
    return f"UPDATE telemetry SET n_rows = {len(rows)}, data = x'{pack(padded).hex()}'"


@pytest.mark.parametrize(
    ("change", "part"),
    [
        ("UPDATE telemetry SET data = x'00112233'", "telemetry"),
        ("UPDATE telemetry SET n_rows = 9999", "telemetry"),
        ("UPDATE telemetry SET n_rows = -1", "telemetry"),
        ("UPDATE events SET data = '{' WHERE type = 'run_ended'", "events"),
        ("UPDATE events SET data = '[1]' WHERE type = 'said'", "events"),
        ("UPDATE events SET data = '{}' WHERE type = 'run_ended'", "events"),
        ("UPDATE runs SET parameters = '{'", "parameters"),
        ("UPDATE runs SET parameters = '[]'", "parameters"),
        ("""UPDATE runs SET parameters = '{"preset": 5}'""", "parameters"),
        ("""UPDATE runs SET parameters = '{"model": []}'""", "parameters"),
        ("""UPDATE runs SET parameters = '{"semantics": "3"}'""", "parameters"),
        ("""UPDATE runs SET parameters = '{"semantics": 2}'""", "parameters"),
        ("UPDATE runs SET parameters = '{}'", "parameters"),
        ("UPDATE runs SET world_document = '[]'", "world_document"),
        ("UPDATE runs SET world_document = 'x'", "world_document"),
        ("UPDATE runs SET world_document = '{}'", "world"),
        ("""UPDATE runs SET world_document = json_set(world_document, '$.boxes', 5)""", "world"),
        ("""UPDATE runs SET world_document = json_set(world_document, '$.walls[0]', 5)""", "world"),
        (
            """UPDATE runs SET world_document = json_set(world_document, '$.start.x_m', 1e308)""",
            "world",
        ),
        ("UPDATE runs SET document = '['", "document"),
        ("UPDATE runs SET document = '{}'", "program"),
    ],
)
def test_a_record_that_cannot_be_read_is_said_in_words(
    change: str, part: str, tmp_path: Path
) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("push_the_boxes", db)
    _change(db, change)
    done = CliRunner().invoke(main, ["--db", str(db), "runs", "verify", run_id])
    assert done.exit_code == 1
    assert part in done.stderr + done.stdout
    assert isinstance(done.exception, SystemExit)
    for command in (["show", run_id], ["list"], ["list", "--json"]):
        done = CliRunner().invoke(main, ["--db", str(db), "runs", *command])
        assert done.exception is None or isinstance(done.exception, SystemExit)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ("UPDATE runs SET link = 'ros2'", "real robot"),
        ("UPDATE runs SET state = 'running'", "has not ended"),
        ("UPDATE runs SET document = NULL", "cannot be repeated"),
        ("""UPDATE runs SET parameters = '{"semantics": 99}'""", "newer release"),
    ],
)
def test_what_cannot_be_repeated_is_said_in_words(
    change: str, message: str, tmp_path: Path
) -> None:
    db = tmp_path / "pinel.db"
    run_id = record_run("square", db)
    _change(db, change)
    done = CliRunner().invoke(main, ["--db", str(db), "runs", "verify", run_id])
    assert done.exit_code == 1
    assert message in done.stderr


def _change(db: Path, *statements: str) -> None:
    """As somebody would who knows that the store keeps sums of what it has written."""
    open_store(db).close()
    connection = sqlite3.connect(db)
    with connection:
        for statement in (*statements, "DELETE FROM content_sums"):
            connection.execute(statement)
    connection.close()
