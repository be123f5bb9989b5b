"""From blocks to a recorded run through every real part: store, web, stream and the engine's process."""

import json
import struct
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest

from pinel_desktop.app import App
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.web.models.events import StreamEvent
from tests.in_time import in_time
from tests.live_runs import command, saved, start_run
from tests.web.browser import Browser, Stream

pytestmark = pytest.mark.waits

SQUARE = json.loads((Path(__file__).parent / "programs" / "square.json").read_text("utf-8"))
READY_S = 30.0
OLD_ENOUGH_TICKS = 100  # an engine that dies in its first seconds is not started again


@pytest.fixture(scope="module")
def app(tmp_path_factory: pytest.TempPathFactory) -> Iterator[App]:
    with App(tmp_path_factory.mktemp("data") / "pinel.db") as running:
        engine = running._engine
        assert isinstance(engine, EngineClient)
        assert engine.wait_until_ready(READY_S)
        yield running


@pytest.fixture
def browser(app: App) -> Browser:
    return Browser.signed_in(app.address)


def events_of(
    stream: Stream, browser: Browser, version_id: str
) -> tuple[str, list[dict[str, Any]]]:
    """Runs a version to its end; its id and every event of the stream."""
    assert stream.next()["type"] == "hello"
    run = start_run(browser, version_id)
    return run, stream.until("run_ended")


def test_a_square_is_built_driven_kept_and_read_back(browser: Browser) -> None:
    small = {**SQUARE, "commands": [{**SQUARE["commands"][0], "commands": shortened(SQUARE, 0.2)}]}
    version_id = saved(browser, small)
    with browser.stream() as stream:
        run, events = events_of(stream, browser, version_id)
    for event in events:
        StreamEvent.model_validate(event)
    assert {event["run"] for event in events} == {run}
    assert [event["seq"] for event in events] == list(range(len(events)))
    read = browser.get(f"/api/runs/{run}").data
    assert (read["state"], read["reason"]) == ("finished", None)
    assert read["n_executed"] == 8
    assert read["path_length_m"] == pytest.approx(0.8, abs=0.001)
    assert read["closing_error_m"] < 0.0001
    assert read["telemetry_sha256"] == events[-1]["telemetry_sha256"]
    assert len(read["path"]) == 5
    check_replay(browser, run, events)


def test_a_group_s_own_world_is_driven_in(browser: Browser) -> None:
    world = {
        "pinel_world": 1,
        "name": "own",
        "title": "A nossa sala",
        "size_m": [4, 2],
        "start": {"x_m": -1, "y_m": 0, "heading_deg": 0},
        "walls": [],
        "zones": [{"name": "nosso lugar", "center": [-0.8, 0], "size": [0.1, 1]}],
    }
    speech = {"action": "say", "text": {"sensor": "cell"}}
    there = {"action": "move_forward", "distance": 0.2}
    version_id = saved(
        browser, {"pinel_ir": 1, "name": "n", "commands": [speech, there, speech]}, world
    )
    with browser.stream() as stream:
        assert stream.next()["type"] == "hello"
        run = start_run(browser, version_id, "own")
        events = stream.until("run_ended")
    assert [event["text"] for event in events if event["type"] == "said"] == ["", "nosso lugar"]
    assert browser.get(f"/api/runs/{run}").data["world_document"]["title"] == "A nossa sala"


def shortened(document: dict[str, Any], distance_m: float) -> list[dict[str, Any]]:
    """The square's commands with shorter sides: live runs take their time."""
    commands = document["commands"][0]["commands"]
    return [
        {**command, "distance": distance_m} if "distance" in command else command
        for command in commands
    ]


def check_replay(browser: Browser, run: str, live: list[dict[str, Any]]) -> None:
    """What is read back is what was on the stream."""
    events = browser.get(f"/api/runs/{run}/events").data["events"]
    assert events == [event for event in live if event["type"] != "telemetry"]
    samples = [event for event in live if event["type"] == "telemetry"]
    body = browser.get(f"/api/runs/{run}/telemetry").body
    (length,) = struct.unpack_from("<I", body)
    header = json.loads(body[4 : 4 + length])
    columns = np.frombuffer(body, "<f4", offset=4 + length).reshape(
        len(header["columns"]), header["rows"]
    )
    assert header["rows"] == len(samples)
    for name, column in zip(header["columns"], columns, strict=True):
        expected = np.array(
            [np.nan if event[name] is None else event[name] for event in samples], float
        )
        tolerance = 0.0006 if name == "done" else 0.0001
        assert np.allclose(column, expected, rtol=1e-6, atol=tolerance, equal_nan=True), name


def test_a_stopped_run_is_kept_as_stopped(browser: Browser) -> None:
    version_id = saved(browser, SQUARE)
    with browser.stream() as stream:
        stream.next()
        run = start_run(browser, version_id)
        stream.until("telemetry")
        assert command(browser, run, "stop").status == 200
        end = stream.until("run_ended")[-1]
    assert end["state"] == "stopped"
    assert browser.get(f"/api/runs/{run}").data["state"] == "stopped"


def test_a_paused_run_waits_and_goes_on(browser: Browser) -> None:
    version_id = saved(browser, SQUARE)
    with browser.stream() as stream:
        stream.next()
        run = start_run(browser, version_id)
        stream.until("telemetry")
        command(browser, run, "pause")
        while stream.until("run_state")[-1]["state"] != "paused":
            pass
        command(browser, run, "resume")
        while stream.until("run_state")[-1]["state"] != "running":
            pass
        command(browser, run, "stop")
        stream.until("run_ended")


def test_a_capture_is_answered_by_hand(browser: Browser) -> None:
    document = {
        "pinel_ir": 1,
        "name": "sign",
        "commands": [{"action": "classify_gestures", "block": "c"}],
    }
    version_id = saved(browser, document)
    with browser.stream() as stream:
        stream.next()
        run = start_run(browser, version_id)
        stream.until("capture_started")
        assert command(browser, run, "answer_capture", result="B").status == 200
        events = stream.until("run_ended")
    (result,) = [event for event in events if event["type"] == "gesture_result"]
    assert (result["result"], result["source"], result["by"]) == ("B", "capture", "person")


def test_an_engine_that_dies_ends_the_run_in_words_and_the_next_run_works(
    app: App, browser: Browser
) -> None:
    version_id = saved(browser, SQUARE)
    engine = app._engine
    assert isinstance(engine, EngineClient)
    with browser.stream() as stream:
        stream.next()
        run = start_run(browser, version_id)
        while stream.until("telemetry")[-1]["tick"] < OLD_ENOUGH_TICKS:
            pass
        assert engine.pid is not None
        psutil.Process(engine.pid).kill()
        end = stream.until("run_ended")[-1]
        assert (end["state"], end["reason"]) == ("failed", "engine_lost")
        read = browser.get(f"/api/runs/{run}").data
        assert (read["state"], read["reason"]) == ("failed", "engine_lost")
        assert read["message"]
    assert engine.wait_until_ready(READY_S)
    with browser.stream() as stream:
        _, events = events_of(stream, browser, saved(browser, {**SQUARE, "commands": []}))
    assert events[-1]["state"] == "finished"


def test_closing_in_the_middle_of_a_live_run_takes_less_than_two_seconds(tmp_path: Path) -> None:
    app = App(tmp_path / "pinel.db")
    with app:
        engine = app._engine
        assert isinstance(engine, EngineClient)
        assert engine.wait_until_ready(READY_S)
        browser = Browser.signed_in(app.address)
        with browser.stream() as stream:
            stream.next()
            run = start_run(browser, saved(browser, SQUARE))
            stream.until("telemetry")
            start_s = time.perf_counter()
            app.close()
            elapsed_s = time.perf_counter() - start_s
    print(f"closing during a live run took {elapsed_s:.3f} s")
    assert in_time(elapsed_s, 2.0)
    with App(tmp_path / "pinel.db") as again:
        read = Browser.signed_in(again.address).get(f"/api/runs/{run}").data
    assert read["state"] in ("stopped", "failed")
