"""Log files of real processes: what they receive, and that they never hold up or fail a process."""

import os
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

from pinel_desktop.processes.log_file import PROCESSES, read_log

START = """
import logging, os, sys, threading
from pathlib import Path
from pinel_desktop.processes.log_file import close_log, start_log
start_log("app", Path(sys.argv[1]))
log = logging.getLogger("pinel_desktop.test")
"""
NO_ROOM = """
import resource, signal
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
"""


@pytest.fixture
def database(tmp_path: Path) -> Path:
    path = tmp_path / "data" / "pinel.db"
    path.parent.mkdir(0o700)
    path.touch(0o600)
    return path


def run(database: Path, script: str) -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-c", START + script, str(database)]
    return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)


def test_messages_of_a_process_are_in_its_file(database: Path) -> None:
    done = run(database, "log.info('the robot has stopped')\nlog.warning('the disk is slow')")
    assert (done.returncode, done.stderr) == (0, "the disk is slow\n")
    head, first, second = read_log("app", database, 99)
    assert head.startswith("PINEL ")
    assert first.endswith("INFO pinel_desktop.test: the robot has stopped")
    assert second.endswith("WARNING pinel_desktop.test: the disk is slow")
    assert read_log("app", database, 1) == [second]


@pytest.mark.parametrize(
    "script",
    [
        "raise ValueError('Joana')",
        "thread = threading.Thread(target=int, args=['Joana']); thread.start(); thread.join()",
    ],
    ids=["main thread", "other thread"],
)
def test_an_uncaught_exception_is_logged_without_its_values_and_printed_as_before(
    script: str, database: Path
) -> None:
    done = run(database, script)
    assert "Joana" in done.stderr
    text = "\n".join(read_log("app", database, 99))
    assert "CRITICAL" in text
    assert "  ValueError\n" in text
    assert "Joana" not in text


@pytest.mark.skipif(sys.platform == "win32", reason="not on Windows")
def test_a_crash_of_a_library_leaves_the_stack_in_the_file(database: Path) -> None:
    wait = "import faulthandler, time\nwhile not faulthandler.is_enabled(): time.sleep(0.01)\n"
    done = run(database, f"log.info('starts')\n{wait}os.abort()")
    assert done.returncode == -signal.SIGABRT
    lines = read_log("app", database, 99)
    assert "Fatal Python error: Aborted" in lines


def test_an_end_without_clean_up_loses_nothing_after_close(database: Path) -> None:
    run(database, "log.error('the last line'); close_log(); os._exit(1)")
    assert read_log("app", database, 99)[-1].endswith("the last line")


def test_the_files_of_a_process_stay_below_a_megabyte(database: Path) -> None:
    run(
        database,
        "for n in range(30):\n"
        "    for m in range(800): log.info('x' * 100)\n"
        "    close_log(); start_log('app', Path(sys.argv[1]))",
    )
    files = list((database.parent / "logs").iterdir())
    assert sorted(file.name for file in files) == ["pinel-app.log", "pinel-app.log.1"]
    assert 500_000 < sum(file.stat().st_size for file in files) < 1_000_000


@pytest.mark.skipif(sys.platform == "win32", reason="accounts of Linux")
@pytest.mark.parametrize(("folder", "modes"), [(0o700, (0o700, 0o600)), (0o755, (0o755, 0o644))])
def test_the_files_are_as_private_as_the_folder(
    folder: int, modes: tuple[int, int], database: Path
) -> None:
    database.parent.chmod(folder)
    run(database, "log.error('a line')")
    logs = database.parent / "logs"
    found = [stat.S_IMODE(path.stat().st_mode) for path in (logs, logs / "pinel-app.log")]
    assert tuple(found) == modes


def test_nothing_is_created_where_there_is_no_database(database: Path) -> None:
    database.unlink()
    assert run(database, "log.error('a line')").returncode == 0
    assert not list(database.parent.iterdir())


def test_a_folder_that_cannot_be_made_fails_nothing(database: Path) -> None:
    (database.parent / "logs").write_text("a file")
    done = run(database, "log.error('a line')")
    assert (done.returncode, done.stderr) == (0, "a line\n")


@pytest.mark.skipif(sys.platform == "win32", reason="limits of Linux")
def test_a_full_disk_fails_nothing(database: Path) -> None:
    done = run(database, NO_ROOM + "for n in range(100): log.info('x' * 100)\nprint('done')")
    assert (done.returncode, done.stdout, done.stderr) == (0, "done\n", "")
    assert (database.parent / "logs" / "pinel-app.log").stat().st_size <= 2000


@pytest.mark.skipif(sys.platform == "win32", reason="pipes of Linux")
def test_a_disk_that_hangs_holds_up_neither_work_nor_end(database: Path) -> None:
    logs = database.parent / "logs"
    logs.mkdir()
    os.mkfifo(logs / "pinel-app.log")  # opening it for writing waits for a reader
    begin = time.monotonic()
    done = run(database, "for n in range(5000): log.info('x' * 100)\nprint('done')")
    assert (done.returncode, done.stdout) == (0, "done\n")
    assert time.monotonic() - begin < 20
    assert read_log("app", database, 99) == []


@pytest.mark.parametrize("process", [name for name in PROCESSES if name not in ("window", "app")])
def test_each_supervised_process_writes_its_own_file(
    process: str, database: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PINEL_LOG_BESIDE", str(database))
    command = [sys.executable, "-m", "pinel_desktop", process]
    subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=60, check=True)
    head, line = read_log(process, database, 99)
    assert f": {process}, process " in head
    assert line.endswith("the process starts")
