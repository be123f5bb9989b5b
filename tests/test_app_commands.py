"""`pinel serve` and `pinel runs` as a person types them."""

import ctypes
import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from pinel_desktop.cli import main
from storage import RunRecorder, RunStart, open_store
from storage.tables.ddl import MIGRATIONS
from tests.in_time import in_time
from tests.storage.sample_runs import ended
from tests.web.browser import Browser

START = RunStart(
    link="sim", world="empty_room", world_document={}, seed=3, app_version="1", document={}
)


@pytest.fixture
def database(tmp_path: Path) -> Path:
    return tmp_path / "pinel.db"


@pytest.fixture
def run_ids(database: Path) -> list[str]:
    """Three runs, the oldest first; the last was blocked."""
    with open_store(database) as store:
        ids = [store.runs.begin(START).id for _ in range(3)]
        recorder = RunRecorder(store)
        for run_id in ids[:2]:
            recorder(ended(run_id, 0, 60))
        recorder(ended(ids[2], 0, 60, state="failed", reason="blocked"))
    return ids


def pinel(*arguments: str) -> Result:
    return CliRunner().invoke(main, arguments, env={"PINEL_LANG": "en"})


def test_runs_are_listed_newest_first(database: Path, run_ids: list[str]) -> None:
    lines = pinel("--db", str(database), "runs", "list").output.splitlines()
    assert [line.split()[0] for line in lines] == run_ids[::-1]
    assert "failed blocked" in lines[0]
    assert "2.0 s" in lines[0]


def test_a_limit_is_kept_and_json_is_one_object_per_line(
    database: Path, run_ids: list[str]
) -> None:
    output = pinel("runs", "--db", str(database), "list", "--limit", "2", "--json").output
    rows = [json.loads(line) for line in output.splitlines()]
    assert [row["id"] for row in rows] == run_ids[:0:-1]
    assert (rows[0]["reason"], rows[0]["seed"]) == ("blocked", 3)
    assert rows[0]["message"]


def test_a_run_is_shown_with_the_reason_in_words(database: Path, run_ids: list[str]) -> None:
    result = pinel("--db", str(database), "runs", "show", run_ids[2])
    assert result.exit_code == 0
    assert "world: empty_room" in result.output
    assert "blocked: " in result.output


def test_the_beginning_of_an_id_is_enough_where_only_one_run_has_it(
    database: Path, run_ids: list[str]
) -> None:
    unique = next(
        run_ids[1][:n]
        for n in range(36)
        if sum(run.startswith(run_ids[1][:n]) for run in run_ids) == 1
    )
    shown = json.loads(
        pinel("--db", str(database), "runs", "show", unique.upper(), "--json").output
    )
    assert (shown["id"], shown["n_events"]) == (run_ids[1], 1)


def test_a_beginning_that_several_runs_share_is_an_error_with_a_remedy(
    database: Path, run_ids: list[str]
) -> None:
    result = pinel("--db", str(database), "runs", "show", "01")
    assert result.exit_code == 1
    assert "More than one run" in result.output


@pytest.mark.parametrize("run", ["ffff", "", " ", "-", "%", "\udcff"])
def test_an_unknown_run_is_an_error_with_a_remedy(
    database: Path, run_ids: list[str], run: str
) -> None:
    result = pinel("--db", str(database), "runs", "show", "--", run)
    assert result.exit_code == 1
    assert result.output == "This run was not found.\nChoose a run from the list.\n"


def test_nothing_stands_for_no_run_even_where_there_is_only_one(database: Path) -> None:
    with open_store(database) as store:
        store.runs.begin(START)
    assert pinel("--db", str(database), "runs", "show", "").exit_code == 1


def folder_content(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in folder.iterdir()}


@pytest.mark.parametrize("command", [["list"], ["show", "01"]])
def test_looking_at_a_damaged_file_tells_what_to_do_and_touches_nothing(
    database: Path, command: list[str]
) -> None:
    database.write_bytes(random.Random(1).randbytes(9000))
    before = folder_content(database.parent)
    result = CliRunner().invoke(
        main, ["--db", str(database), "runs", *command], env={"PINEL_LANG": "pt"}
    )
    assert result.exit_code == 1
    assert result.stdout == ""
    message, remedy = result.stderr.splitlines()
    assert message.startswith("O arquivo com os trabalhos (")
    assert message.endswith(") está danificado.")
    assert remedy.startswith("Abra o PINEL")
    assert folder_content(database.parent) == before


def test_looking_at_runs_writes_nothing_and_makes_no_file(
    database: Path, run_ids: list[str]
) -> None:
    before = folder_content(database.parent)
    assert pinel("--db", str(database), "runs", "list").exit_code == 0
    assert pinel("--db", str(database), "runs", "show", run_ids[0]).exit_code == 0
    assert folder_content(database.parent) == before


def test_runs_are_listed_while_another_program_has_the_file_open(database: Path) -> None:
    with open_store(database) as store:
        run = store.runs.begin(START)
        output = pinel("--db", str(database), "runs", "list").output
    assert output.startswith(f"{run.id}  ")


def test_an_empty_file_holds_no_work(database: Path) -> None:
    database.touch()
    result = pinel("--db", str(database), "runs", "list")
    assert (result.exit_code, database.stat().st_size) == (1, 0)
    assert result.output.startswith("No work has been saved yet")


def test_a_file_that_an_older_program_left_is_told_with_a_remedy(
    database: Path, run_ids: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(MIGRATIONS, "a_step_of_the_next_release", ())
    result = pinel("--db", str(database), "runs", "list")
    assert result.exit_code == 1
    assert "Start PINEL once" in result.output


def test_listing_where_nothing_was_kept_makes_no_file(database: Path) -> None:
    result = pinel("--db", str(database), "runs", "list")
    assert result.exit_code == 1
    assert str(database)[:40] in result.output
    assert not database.exists()


@pytest.mark.parametrize("command", [["serve"], ["runs"], ["runs", "list"], ["runs", "show"]])
def test_every_command_helps(command: list[str]) -> None:
    result = pinel(*command, "--help")
    assert result.exit_code == 0
    assert "Usage:" in result.output


@contextmanager
def serving(database: Path, *options: str) -> Iterator["subprocess.Popen[str]"]:
    command = [sys.executable, "-m", "pinel_desktop", "--db", str(database), "serve", *options]
    environment = {**os.environ, "PINEL_LANG": "en"}
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
    ) as process:
        try:
            yield process
        finally:
            if process.poll() is None:
                process.kill()


def address_of(process: "subprocess.Popen[str]") -> str:
    assert process.stdout is not None
    return process.stdout.readline().strip()


def wait_for_engine(browser: Browser) -> None:
    deadline = time.monotonic() + 30
    while browser.get("/api/status").data["engine"] != "ready":
        assert time.monotonic() < deadline


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_serve_prints_an_address_and_ends_cleanly(database: Path, number: signal.Signals) -> None:
    with serving(database) as process:
        browser = Browser.signed_in(address_of(process))
        wait_for_engine(browser)
        start_s = time.perf_counter()
        process.send_signal(number)
        _, errors = process.communicate(timeout=60)
        took_s = time.perf_counter() - start_s
        print(f"serve ended {took_s:.2f} s after the signal")
        assert in_time(took_s, 2.0)
    assert process.returncode == 0
    assert "Traceback" not in errors
    assert not database.with_name("pinel.instance.json").exists()


@pytest.mark.skipif(sys.platform != "linux", reason="a thread is told as Linux does it")
def test_serve_ends_when_another_thread_is_handed_the_signal(database: Path) -> None:
    with serving(database) as process:
        wait_for_engine(Browser.signed_in(address_of(process)))
        threads = [int(task.name) for task in Path(f"/proc/{process.pid}/task").iterdir()]
        other = min(task for task in threads if task != process.pid)  # one that lasts
        tgkill = ctypes.CDLL(None, use_errno=True).tgkill
        assert tgkill(process.pid, other, signal.SIGTERM) == 0, os.strerror(ctypes.get_errno())
        process.communicate(timeout=30)
    assert process.returncode == 0


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9")
def test_a_second_serve_prints_a_fresh_address_of_the_first_even_after_a_crash(
    database: Path,
) -> None:
    with serving(database) as first:
        address_of(first)
        first.kill()
        first.wait()
    with serving(database) as second:
        own = address_of(second)
        with serving(database) as third:
            other = address_of(third)
            assert third.wait(timeout=10) == 0
        assert other.partition("?")[0] == own.partition("?")[0]
        assert other != own
        assert Browser.signed_in(other).get("/api/status").status == 200


def test_serve_on_a_taken_port_says_so(database: Path, tmp_path: Path) -> None:
    with serving(database) as first:
        port = str(Browser.at(address_of(first)).port)
        with serving(tmp_path / "other.db", "--port", port) as second:
            output, errors = second.communicate(timeout=20)
    assert (second.returncode, output) == (1, "")
    assert f"Port {port}" in errors
    assert "--port" in errors
