"""The event stream."""

from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.web.api import stream
from storage import StoreError
from tests.storage.sample_runs import block_started, ended, sample
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine


def test_the_stream_says_hello_with_the_live_run(browser: Browser, run: dict[str, Any]) -> None:
    with browser.stream() as events:
        assert (events.status, events.type) == (200, "text/event-stream; charset=utf-8")
        assert events.next() == {"type": "hello", "run": run["id"]}


def test_every_reader_gets_every_event_as_it_was_sent(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    sent = [
        block_started(run["id"], 0),
        *(sample(run["id"], n + 1) for n in range(50)),
        ended(run["id"], 51, 51),
    ]
    with browser.stream() as first, browser.stream() as second:
        assert first.next()["type"] == second.next()["type"] == "hello"
        for event in sent:
            engine.send(event)
        assert first.until("run_ended") == second.until("run_ended") == sent


def test_when_the_page_hears_of_the_end_the_run_has_ended(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    with browser.stream() as events:
        events.next()
        engine.send(ended(run["id"], 0, 0))
        events.until("run_ended")
        assert browser.get(f"/api/runs/{run['id']}").data["state"] == "finished"


def test_a_silent_stream_is_kept_alive_by_comments(
    browser: Browser, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(stream, "HEARTBEAT_INTERVAL_S", 0.01)
    with browser.stream() as events:
        lines = events.lines()
        assert next(lines).startswith("data: ")
        assert [next(lines), next(lines)] == ["", ": still here"]


def test_when_the_disk_is_full_the_page_is_told_and_told_again_when_there_is_room(
    app: App,
    browser: Browser,
    engine: FakeEngine,
    run: dict[str, Any],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def limit(pages: int) -> None:
        app._store._database.write(
            lambda db: db.execute(f"PRAGMA max_page_count = {pages}").fetchone()
        )

    with browser.stream() as events:
        events.next()
        limit(1)  # less than the present size: the database file cannot grow
        state = {"v": 1, "type": "run_state", "run": run["id"], "tick": 0, "state": "running"}
        engine.send({**state, "seq": 0, "filler": "x" * 20_000})
        notice = events.until("notice")[-1]
        assert notice["code"] == "disk_full"
        assert notice["remedy"]
        database = browser.get("/api/status").data["database"]
        assert (database["writable"], database["notice"]["code"]) == (False, "disk_full")
        limit(100_000)
        engine.send(ended(run["id"], 1, 1))
        assert events.until("run_ended")[-2]["code"] == "recording_resumed"
    assert browser.get("/api/status").data["database"]["writable"] is True
    assert len(browser.get(f"/api/runs/{run['id']}/events").data["events"]) == 2


def test_a_store_that_refuses_everything_does_not_stop_the_stream(
    app: App,
    browser: Browser,
    engine: FakeEngine,
    run: dict[str, Any],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refuse(job: object) -> object:
        raise StoreError("database_failed", path="x", problem="gone")

    with browser.stream() as events:
        events.next()
        writer = app._store._database._writer
        assert writer is not None
        monkeypatch.setattr(writer, "_in_transaction", refuse)
        engine.send(ended(run["id"], 0, 0))
        assert events.until("run_ended")[-1]["type"] == "run_ended"
        monkeypatch.undo()


def test_the_stream_ends_with_the_app(app: App, browser: Browser) -> None:
    with browser.stream() as events:
        events.next()
        app.close()
        assert list(events.events()) == []
