"""The logs of a real app: they tell what happened to its processes, and nothing of the work of its groups."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import psutil

from pinel_desktop.doctor.report import write_report
from pinel_desktop.processes.log_file import PROCESSES, read_log
from tests.attacks.disks import Served, served
from tests.live_runs import start_run

SECRETS = ("Joana", "Tatus", "segredo", "mensagem")
PROGRAM = {"pinel_ir": 1, "commands": [{"action": "say", "text": "mensagem"}]}


def logs(database: Path) -> str:
    return "\n".join(line for name in PROCESSES for line in read_log(name, database, 999))


def engine_pid() -> int:
    """The process of the engine; 0 between two of them."""
    for child in psutil.Process().children(recursive=True):
        with contextlib.suppress(psutil.Error):  # it has just ended
            if child.cmdline()[-1:] == ["engine"]:
                return child.pid
    return 0


def await_engine(app: Served, except_pid: int = 0) -> int:
    deadline = time.monotonic() + 30
    while (found := engine_pid()) in (0, except_pid) or not is_ready(app):
        assert time.monotonic() < deadline
    return found


def is_ready(app: Served) -> bool:
    return bool(app.browser.get("/api/status").data["engine"] == "ready")


def begin_work(app: Served) -> Any:
    group = app.browser.post("/api/groups", {"name": "Joana e os Tatus"}).data
    path = f"/api/groups/{group['id']}/programs"
    program = app.browser.post(path, {"name": "Nosso segredo"}).data
    content = {"workspace": {"blocks": {}}, "document": PROGRAM, "world": None}
    version = app.browser.post(f"/api/programs/{program['id']}/versions", content)
    assert version.status == 200, version.body
    return start_run(app.browser, version.data["id"])


def test_the_logs_tell_of_a_lost_engine_and_hold_no_work(tmp_path: Path) -> None:
    database = tmp_path / "pinel.db"
    with served(database) as app:
        engine = await_engine(app)
        begin_work(app)
        os.kill(engine, signal.SIGKILL)
        await_engine(app, except_pid=engine)
        assert app.end() == 0
    of_app = [line.partition(": ")[2] for line in read_log("app", database, 99)[1:]]
    assert of_app == [
        "the app has started; notice: None",
        "the engine died with status -9",
        "the app ends",
    ]
    assert len(read_log("engine", database, 99)) == 4  # a head and a line of each engine
    assert not any(secret in logs(database) for secret in SECRETS)


def test_the_log_of_the_window_names_a_lost_app(tmp_path: Path) -> None:
    """On a PC without a screen the address is printed, and the process is the same."""
    database = tmp_path / "pinel.db"
    screen = ("DISPLAY", "WAYLAND_DISPLAY")
    environment = {name: value for name, value in os.environ.items() if name not in screen}
    command = [sys.executable, "-m", "pinel_desktop", "--db", str(database)]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=environment
    ) as window:
        assert window.stdout is not None
        assert window.stdout.readline().startswith("http://")
        (app,) = psutil.Process(window.pid).children()
        app.kill()
        assert window.wait(60) == 1
    lines = [line.partition(": ")[2] for line in read_log("window", database, 99)[1:]]
    assert lines == ["the page is shown by address", "the app died with status -9"]


def test_a_report_for_support_has_the_last_part_of_the_logs(tmp_path: Path) -> None:
    database, file = tmp_path / "pinel.db", tmp_path / "report.json"
    with served(database) as app:
        await_engine(app)
        app.end()
    write_report(file, database, [])
    report = json.loads(file.read_text("utf-8"))
    assert list(report["logs"]) == ["app", "engine"]
    assert report["logs"]["app"][-1].endswith("the app ends")
    assert "logs/pinel-app.log" in [one["name"] for one in report["files"]]
