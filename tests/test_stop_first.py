"""Commands reach a live run whatever has become of the database: real store, web, and engine process."""

import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, closing, contextmanager
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.engine.client import EngineClient
from storage.file import opening
from storage.sqlite import sqlite3
from tests.web.browser import ApiResponse, Browser, Stream

READY_S = 30.0
FLUSH_TIMEOUT_S = 2.0  # the recorder gives the disk a moment before the end is told
SOON_S = 2.0  # the robot has to be measured at rest, too
# each question and capture keeps the program waiting until it is answered
TALK: dict[str, Any] = {
    "pinel_ir": 1,
    "name": "talk",
    "commands": [
        {"action": "ask", "question": "Name?", "variable": "name", "block": "a"},
        {"action": "classify_gestures", "timeout": 60, "block": "c"},
        {"action": "say", "text": {"op": "join", "args": [{"var": "name"}, {"gesture": "result"}]}},
        {"action": "move_forward", "distance": 3, "block": "m"},
    ],
}
Trouble = Callable[[App, Path, str], AbstractContextManager[None]]


@contextmanager
def damaged_row(app: App, database: Path, run: str) -> Iterator[None]:
    with closing(sqlite3.connect(database)) as db, db:
        db.execute("UPDATE runs SET parameters = '{' WHERE id = ?", (run,))
    yield


@contextmanager
def locked(app: App, database: Path, run: str) -> Iterator[None]:
    """Another process writes for as long as it likes. On a share, which has no WAL, that keeps readers out too."""
    with closing(sqlite3.connect(database, isolation_level=None)) as other:
        other.execute("PRAGMA busy_timeout = 20000")
        other.execute("BEGIN EXCLUSIVE")
        yield
        other.execute("ROLLBACK")


@contextmanager
def full_disk(app: App, database: Path, run: str) -> Iterator[None]:
    app._store._database.write(lambda db: db.execute("PRAGMA max_page_count = 1").fetchone())
    yield


@contextmanager
def removed_drive(app: App, database: Path, run: str) -> Iterator[None]:
    """The stick with the file was pulled out: what was open is closed, and there is nothing to open again."""
    idle = app._store._database._idle
    while not idle.empty():
        idle.get().close()
    for part in database.parent.glob(f"{database.name}*"):
        part.rename(part.with_name(f"away-{part.name}"))
    yield
    for part in database.parent.glob(f"away-{database.name}*"):
        part.rename(part.with_name(part.name.removeprefix("away-")))


@pytest.fixture
def database(tmp_path: Path) -> Path:
    return tmp_path / "pinel.db"


@pytest.fixture
def app(database: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[App]:
    monkeypatch.setattr(opening, "is_on_share", lambda folder: True)
    with App(database) as running:
        engine = running._engine
        assert isinstance(engine, EngineClient)
        assert engine.wait_until_ready(READY_S)
        yield running


@pytest.fixture
def browser(app: App) -> Browser:
    return Browser.signed_in(app.address)


def start_run(browser: Browser, document: dict[str, Any]) -> str:
    group = browser.post("/api/groups", {"name": "A"}).data
    program = browser.post(f"/api/groups/{group['id']}/programs", {"name": "P"}).data
    content = {"workspace": {"blocks": {}}, "document": document}
    version = browser.post(f"/api/programs/{program['id']}/versions", content).data
    start = {"version_id": version["id"], "world": "empty_room"}
    run: str = browser.post("/api/runs", start).data["id"]
    return run


def command(browser: Browser, run: str, do: str, **more: Any) -> ApiResponse:
    return browser.post(f"/api/runs/{run}/commands", {"do": do, **more})


def check_that_every_command_arrives(browser: Browser, stream: Stream, run: str) -> None:
    def send(do: str, **more: Any) -> Any:
        answer = command(browser, run, do, **more)
        assert answer.status == 200, answer.body
        return answer.data

    send("answer", value="Ana")
    stream.until("capture_started")
    send("answer_capture", result="B")
    assert stream.until("said")[-1]["text"] == "AnaB"
    stream.until("telemetry")
    send("pause")
    assert stream.until("run_state")[-1]["state"] == "paused"
    assert send("evaluate", expression={"var": "name"}) == {"value": "Ana", "problem": None}
    send("resume")
    assert stream.until("run_state")[-1]["state"] == "running"
    pressed = time.monotonic()
    send("stop")
    end = stream.until("run_ended")[-1]
    assert (end["state"], end["reason"]) == ("stopped", "stopped_by_person")
    assert time.monotonic() - pressed < SOON_S + FLUSH_TIMEOUT_S


@pytest.mark.parametrize("trouble", [damaged_row, locked, full_disk, removed_drive])
def test_stop_pause_and_answers_reach_the_robot_whatever_becomes_of_the_database(
    app: App, browser: Browser, database: Path, trouble: Trouble
) -> None:
    with browser.stream() as stream:
        assert stream.next()["type"] == "hello"
        run = start_run(browser, TALK)
        stream.until("asked")
        with trouble(app, database, run):
            check_that_every_command_arrives(browser, stream, run)


@pytest.mark.parametrize("trouble", [damaged_row, locked, full_disk, removed_drive])
def test_a_run_that_is_not_live_is_told_as_that_whatever_becomes_of_the_database(
    app: App, browser: Browser, database: Path, trouble: Trouble
) -> None:
    with browser.stream() as stream:
        assert stream.next()["type"] == "hello"
        run = start_run(browser, {**TALK, "commands": []})
        stream.until("run_ended")
        with trouble(app, database, run):
            answer = command(browser, run, "stop")
    assert (answer.status, answer.error["code"]) == (409, "run_not_live")
