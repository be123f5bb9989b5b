"""`pinel sweep` on the command line: the table, what goes on after a kill, and what is refused."""

import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from click.testing import Result

from pinel_desktop.robot import RobotParameters, SimulationConfig
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from pinel_desktop.sweep import Job, Row, run_job
from pinel_desktop.sweep.variation import ParameterRange
from sim.world import world_document
from tests.commands.typed import PROGRAMS, SQUARE, pinel, run_json

HIT = str(PROGRAMS / "into_the_wall.json")
COLUMNS = [
    "program", "world", "seed", "track_m", "state", "reason", "passed", "cause", "check",
    "n_collisions", "closing_error_m", "duration_s", "telemetry_sha256",
]  # fmt: skip
VARY = ("--vary", "track_m=0.32:0.34")


def sweep(out: Path, *arguments: str) -> Result:
    return pinel("sweep", *arguments, "--workers", "1", "--out", str(out))


def table(out: Path) -> list[dict[str, str]]:
    with out.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_table_has_a_line_for_each_run_in_a_fixed_order(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    worlds = ("--world", "empty_room", "--world", "obstacles")
    done = sweep(out, SQUARE, HIT, *worlds, "--seeds", "2", *VARY)
    assert done.exit_code == 0
    lines = table(out)
    assert list(lines[0]) == COLUMNS
    assert [(line["program"], line["world"], line["seed"]) for line in lines] == [
        (program, world, seed)
        for program in (SQUARE, HIT)
        for world in ("empty_room", "obstacles")
        for seed in ("0", "1")
    ]
    assert [path.name for path in tmp_path.iterdir()] == ["runs.csv"]


def test_line_of_the_table_is_the_run_of_its_seed_and_its_robot(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    sweep(out, SQUARE, "--seeds", "2", *VARY)
    line = table(out)[1]
    track = float(line["track_m"])
    assert track == ParameterRange("track_m", 0.32, 0.34).value(1)
    setting = SimulationConfig(preset="realistic", parameters=RobotParameters(track_m=track))
    document = json.loads(Path(SQUARE).read_text("utf-8"))
    ended = start(RunSpec(document, world_document("empty_room"), setting=setting, seed=1)).ended
    assert line["telemetry_sha256"] == ended.telemetry_sha256
    assert float(line["closing_error_m"]) == ended.closing_error_m
    assert line["state"] == "finished"


def test_summary_says_how_many_went_well_and_where_the_others_did_not(tmp_path: Path) -> None:
    done = sweep(tmp_path / "runs.csv", SQUARE, HIT, "--seeds", "2", "--json")
    summary = json.loads(done.stdout)
    assert (summary["n_runs"], summary["success"], summary["n_collided"]) == (4, 0.5, 2)
    assert [one["success"] for one in summary["groups"]] == [1.0, 0.0]
    assert summary["reasons"][0]["cause"] == "collision"
    printed = sweep(tmp_path / "again.csv", SQUARE, HIT, "--seeds", "2").stdout
    assert "went well       50.0% (2)" in printed
    assert "not well        2 times: collision" in printed


def test_activity_judges_each_run_in_its_world(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    back = str(PROGRAMS / "there_and_back.json")
    done = sweep(out, SQUARE, back, "--activity", "square", "--seeds", "2")
    assert done.exit_code == 0
    assert [line["passed"] for line in table(out)] == ["true", "true", "false", "false"]
    assert [line["cause"] for line in table(out)] == ["", "", "check", "check"]


def test_every_run_reads_the_signs_and_answers_that_were_typed(tmp_path: Path) -> None:
    asks = tmp_path / "asks.json"
    ask = {"action": "ask", "question": "?", "variable": "d"}
    sign = {"action": "classify_gestures", "timeout": 1}
    drive = {"action": "move_forward", "distance": {"var": "d"}}
    asks.write_text(json.dumps([ask, drive, sign]), "utf-8")
    typed = ("--answers", "0.5", "--gestures", "B")
    out = tmp_path / "runs.csv"
    sweep(out, str(asks), "--seeds", "2", *typed)
    alone = run_json(str(asks), "--preset", "realistic", "--seed", "1", "--no-store", *typed)[1]
    assert [line["state"] for line in table(out)] == ["finished", "finished"]
    assert table(out)[1]["telemetry_sha256"] == alone["telemetry_sha256"]
    sweep(tmp_path / "fewer.csv", str(asks), "--seeds", "2", "--answers", "0.5")
    assert [line["reason"] for line in table(tmp_path / "fewer.csv")] == ["no_more_gestures"] * 2


def test_runs_without_movement_are_lines_too(tmp_path: Path) -> None:
    still = tmp_path / "still.json"
    still.write_text('[{"action": "wait", "seconds": 0}]', "utf-8")
    out = tmp_path / "runs.csv"
    assert sweep(out, str(still), "--seeds", "2").exit_code == 0
    assert [line["closing_error_m"] for line in table(out)] == ["0.0", "0.0"]


def test_parquet_has_the_same_values(tmp_path: Path) -> None:
    for name in ("runs.csv", "runs.parquet"):
        assert sweep(tmp_path / name, SQUARE, "--seeds", "2", *VARY).exit_code == 0
    lines = pq.read_table(tmp_path / "runs.parquet").to_pylist()
    assert list(lines[0]) == COLUMNS
    for line, texts in zip(lines, table(tmp_path / "runs.csv"), strict=True):
        assert {name: "" if value is None else str(value) for name, value in line.items()} == texts


def test_seed_has_the_same_robot_everywhere_and_each_parameter_its_own_draw() -> None:
    track, lag = ParameterRange("track_m", 0.3, 0.4), ParameterRange("lag_s", 0.3, 0.4)
    drawn = [track.value(seed) for seed in range(1000)]
    assert drawn == [track.value(seed) for seed in range(1000)]
    assert all(0.3 <= value <= 0.4 for value in drawn)
    assert sum(drawn) / 1000 == pytest.approx(0.35, abs=0.005)
    assert drawn[:10] != [lag.value(seed) for seed in range(10)]
    assert track.value(1) == 0.33873534376592057


def n_rows(out: Path) -> int:
    """Returns how many runs the journal of a sweep has."""
    journal = out.with_name(f"{out.name}.rows")
    return max(0, journal.read_bytes().count(b"\n") - 1) if journal.exists() else 0


def killed_sweep(out: Path, *arguments: str) -> int:
    """Kills a sweep while it runs; returns how many runs its journal has."""
    options = [*arguments, "--workers", "1", "--out", str(out)]
    process = subprocess.Popen(
        [sys.executable, "-m", "pinel_desktop", "sweep", *options], stderr=subprocess.DEVNULL
    )
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline and process.poll() is None:
        if n_rows(out) > 1:
            break
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    return n_rows(out)


def test_killed_sweep_goes_on_without_a_run_twice(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, whole = tmp_path / "runs.csv", tmp_path / "whole.csv"
    arguments = (SQUARE, "--seeds", "100", *VARY)
    n_done = killed_sweep(out, *arguments)
    assert 2 <= n_done < 100
    with (tmp_path / "runs.csv.rows").open("ab") as journal:
        journal.write(b'{"index": 99, "program": "torn by the ki')
    started: list[int] = []
    count_jobs(monkeypatch, started)
    assert sweep(out, *arguments).exit_code == 0
    assert len(started) == 100 - n_done
    assert sweep(whole, *arguments).exit_code == 0
    assert out.read_bytes() == whole.read_bytes()


def count_jobs(monkeypatch: pytest.MonkeyPatch, started: list[int]) -> None:
    def counted(job: Job) -> Row:
        started.append(job.index)
        return run_job(job)

    monkeypatch.setattr("pinel_desktop.sweep.executors.run_job", counted)


def test_ctrl_c_says_how_to_go_on(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    # a shell makes its background commands ignore Ctrl-C
    program = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler);"
        "from pinel_desktop.__main__ import main; main()"
    )
    options = [SQUARE, "--seeds", "300", "--workers", "2", "--out", str(out)]
    process = subprocess.Popen(
        [sys.executable, "-c", program, "sweep", *options], stderr=subprocess.PIPE, text=True
    )
    while process.poll() is None and n_rows(out) < 3:  # while processes start, it is ignored
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "of 300 runs are done" in said
    assert "The same command goes on from there." in said


def test_line_that_a_disk_damaged_is_done_again(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    killed_sweep(out, SQUARE, "--seeds", "20")
    journal = tmp_path / "runs.csv.rows"
    lines = journal.read_bytes().splitlines(keepends=True)
    journal.write_bytes(
        b"".join([lines[0], b"\x00\xff{\n", b"[]\n", b'{"index": 3}\n', *lines[2:]])
    )
    assert sweep(out, SQUARE, "--seeds", "20").exit_code == 0
    assert [line["seed"] for line in table(out)] == [str(seed) for seed in range(20)]


@pytest.mark.parametrize(
    "other",
    [("--seeds", "21"), ("--seeds", "20", *VARY), ("--seeds", "20", "--robot", "small_robot")],
)
def test_journal_of_another_sweep_is_refused_and_stays(
    tmp_path: Path, other: tuple[str, ...]
) -> None:
    out, journal = tmp_path / "runs.csv", tmp_path / "runs.csv.rows"
    killed_sweep(out, SQUARE, "--seeds", "20")
    before = journal.read_bytes()
    done = sweep(out, SQUARE, *other)
    assert done.exit_code == 2
    assert "runs of other programs, options or versions" in done.stderr
    assert journal.read_bytes() == before


def test_full_disk_is_named_and_the_same_command_goes_on(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    limited = (
        "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000));"
        "from pinel_desktop.__main__ import main; main()"
    )
    options = ["sweep", SQUARE, "--seeds", "20", "--workers", "1", "--out", str(out)]
    done = subprocess.run(
        [sys.executable, "-c", limited, *options], capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert f"{out}.rows cannot be written" in done.stderr
    assert "The same command goes on from there." in done.stderr
    assert not out.exists()
    assert sweep(out, SQUARE, "--seeds", "20").exit_code == 0
    assert len(table(out)) == 20


def test_worker_that_dies_costs_no_run(tmp_path: Path) -> None:
    out, whole = tmp_path / "runs.csv", tmp_path / "whole.csv"
    arguments = [SQUARE, "--seeds", "30"]
    process = subprocess.Popen(
        [
            sys.executable,
            "-m",
            "pinel_desktop",
            "sweep",
            *arguments,
            "--workers",
            "2",
            "--out",
            out,
        ],
        stderr=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
    )
    while process.poll() is None and n_rows(out) < 2:
        time.sleep(0.01)
    killed = [int(pid) for pid in children_of(process.pid)]
    for pid in killed[:1]:
        os.kill(pid, signal.SIGKILL)
    assert process.wait(timeout=100) == 0
    sweep(whole, *arguments)
    assert killed
    assert out.read_bytes() == whole.read_bytes()


def children_of(pid: int) -> list[str]:
    import psutil  # noqa: PLC0415

    return [
        str(one.pid)
        for one in psutil.Process(pid).children()
        if "spawn_main" in "".join(one.cmdline())
    ]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--vary", "wings=1:2"], "has no parameter “wings”"),
        (["--vary", "track_m=0.3"], "does not say which parameter of the robot varies"),
        (["--vary", "track_m=0.4:0.3"], "does not say which parameter of the robot varies"),
        (["--vary", "track_m=0.3:9"], "cannot be 9"),
        (["--vary", "track_m=0.3:nan"], "cannot be nan"),
        ([*VARY, *VARY], "each name only once"),
        ([*VARY, "--set", "track_m=0.33"], "each name only once"),
        ([*VARY, "--preset", "ideal"], "An ideal robot has no errors"),
        (["--world", "mars"], "mars"),
        (["--activity", "dance"], "There is no activity called"),
        (["--dask", "nowhere"], "no address of a Dask cluster"),
    ],
)
def test_what_cannot_be_run_is_named_and_leaves_no_file(
    tmp_path: Path, arguments: list[str], said: str
) -> None:
    out = tmp_path / "runs.csv"
    done = pinel("sweep", SQUARE, "--seeds", "2", "--out", str(out), *arguments)
    assert done.exit_code == 2
    assert said in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_program_with_faults_is_named_with_them(tmp_path: Path) -> None:
    broken = tmp_path / "broken.json"
    broken.write_text('[{"action": "fly"}]', "utf-8")
    done = sweep(tmp_path / "runs.csv", SQUARE, str(broken), "--seeds", "2")
    assert done.exit_code == 2
    assert "broken.json cannot run: it has 1 fault." in done.stderr
    assert "\n/0: " in done.stderr


def test_file_that_exists_stays(tmp_path: Path) -> None:
    out = tmp_path / "runs.csv"
    out.write_text("mine", "utf-8")
    done = sweep(out, SQUARE, "--seeds", "2")
    assert (done.exit_code, out.read_text("utf-8")) == (2, "mine")
    assert "exists already" in done.stderr


def test_file_of_another_kind_or_without_a_folder_is_refused(tmp_path: Path) -> None:
    assert (
        "ends in one of these: .csv, .parquet"
        in sweep(tmp_path / "a.xls", SQUARE, "--seeds", "2").stderr
    )
    done = sweep(tmp_path / "missing" / "a.csv", SQUARE, "--seeds", "2")
    assert (done.exit_code, "cannot be written" in done.stderr) == (2, True)


def test_workers_and_a_cluster_are_a_contradiction(tmp_path: Path) -> None:
    done = sweep(tmp_path / "a.csv", SQUARE, "--seeds", "2", "--dask", "tcp://a:1")
    assert done.exit_code == 2
    assert "cannot be combined" in done.stderr
