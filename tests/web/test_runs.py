"""Runs over HTTP, with a fake engine."""

import contextlib
import json
import struct
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.engine import commands
from pinel_desktop.engine.commands import (
    AnswerCapture,
    Command,
    Pause,
    Resume,
    SetBreakpoints,
    SetSpeed,
    Step,
    Stop,
    Subscribe,
)
from pinel_desktop.runs.fixed_inputs import FixedInputs
from storage.sqlite import sqlite3
from tests.storage.sample_runs import block_started, ended, sample, square
from tests.web.browser import ApiResponse, Browser
from tests.web.fake_engine import FakeEngine

ASKS = {"pinel_ir": 1, "commands": [{"action": "ask", "question": "?", "variable": "n"}]}


def test_a_run_begins_in_the_engine_and_in_the_list(
    browser: Browser,
    engine: FakeEngine,
    group: dict[str, Any],
    program: dict[str, Any],
    version: dict[str, Any],
    run: dict[str, Any],
) -> None:
    assert run["state"] == "running"
    assert (run["group_id"], run["program_id"]) == (group["id"], program["id"])
    assert (run["version_id"], run["program_name"]) == (version["id"], "Quadrado")
    assert engine.start_spec["run"] == run["id"]
    assert (engine.start_spec["world"]["name"], engine.start_spec["seed"]) == ("empty_room", 0)
    assert engine.start_spec["setting"] == {
        "model": "pioneer_3dx",
        "preset": "ideal",
        "feedback": "pose",
    }
    assert engine.start_spec["document"]["commands"][0]["action"] == "repeat"
    assert browser.get(f"/api/groups/{group['id']}/runs").data == {"runs": [run], "next": None}
    assert browser.get("/api/status").data["run"] == run["id"]


def test_a_run_may_begin_elsewhere_and_with_another_setting(
    browser: Browser, engine: FakeEngine, version: dict[str, Any]
) -> None:
    start = {"x_m": 1.0, "y_m": -2.0, "heading_deg": 90.0}
    options = {"start": start, "preset": "realistic", "feedback": "odometry"}
    answer = browser.post(
        "/api/runs", {"version_id": version["id"], "world": "empty_room", **options}
    )
    assert engine.start_spec["world"]["start"] == start
    assert engine.start_spec["setting"]["preset"] == "realistic"
    assert engine.start_spec["setting"]["feedback"] == "odometry"
    recorded = browser.get(f"/api/runs/{answer.data['id']}").data
    assert recorded["world_document"]["start"] == start


def test_one_of_the_50_robots_starts_and_reads_as_they_did(
    browser: Browser, engine: FakeEngine, group: dict[str, Any], program: dict[str, Any]
) -> None:
    version = {
        "workspace": {},
        "document": ASKS,
        "setup": {"world": "empty_room", "activity": "polygon"},
    }
    saved = browser.post(f"/api/programs/{program['id']}/versions", version).data
    request = {"version_id": saved["id"], "world": "empty_room", "seed": 7, "preset": "realistic"}
    browser.post("/api/runs", {**request, "cloud": {"case": 3}})
    assert engine.inputs == FixedInputs(answers=("8",))
    assert engine.start_spec["setting"]["preset"] == "realistic"
    engine.live_run = None
    browser.post("/api/runs", request)
    assert engine.inputs is None


def test_an_unknown_robot_is_refused_with_those_there_are(
    browser: Browser, group: dict[str, Any], version: dict[str, Any]
) -> None:
    request = {"version_id": version["id"], "world": "empty_room", "model": "r2d2"}
    answer = browser.post("/api/runs", request)
    assert (answer.status, answer.error["code"]) == (422, "unknown_robot")
    assert browser.get(f"/api/groups/{group['id']}/runs").data["runs"] == []


@pytest.mark.parametrize("seed", [True, "1", 1.5])
def test_a_seed_is_a_whole_number(browser: Browser, version: dict[str, Any], seed: Any) -> None:
    request = {"version_id": version["id"], "world": "empty_room", "seed": seed}
    answer = browser.post("/api/runs", request)
    assert (answer.status, answer.error["code"]) == (422, "invalid_request")


def test_a_second_run_waits_for_the_first(
    browser: Browser, version: dict[str, Any], run: dict[str, Any]
) -> None:
    answer = browser.post("/api/runs", {"version_id": version["id"], "world": "empty_room"})
    assert (answer.status, answer.error["code"]) == (409, "run_in_progress")


def test_a_version_with_faults_does_not_run_and_says_which(
    browser: Browser, program: dict[str, Any]
) -> None:
    document = {
        "pinel_ir": 1,
        "name": "x",
        "commands": [{"action": "turn", "block": "b", "angle": 9999}],
    }
    saved = browser.post(
        f"/api/programs/{program['id']}/versions", {"workspace": {}, "document": document}
    ).data
    answer = browser.post("/api/runs", {"version_id": saved["id"], "world": "empty_room"})
    assert (answer.status, answer.error["code"]) == (422, "invalid_program")
    assert answer.error["faults"] == saved["faults"]
    assert answer.error["faults"][0]["block"] == "b"


def test_an_unknown_world_is_refused_with_those_there_are(
    browser: Browser, version: dict[str, Any]
) -> None:
    answer = browser.post("/api/runs", {"version_id": version["id"], "world": "mars"})
    assert (answer.status, answer.error["code"]) == (422, "unknown_world")
    assert "empty_room" in answer.error["remedy"]


def command(browser: Browser, run: dict[str, Any], do: str, **more: Any) -> ApiResponse:
    return browser.post(f"/api/runs/{run['id']}/commands", {"do": do, **more})


@pytest.mark.parametrize(
    ("do", "sent"), [("pause", Pause()), ("resume", Resume()), ("stop", Stop())]
)
def test_the_live_run_is_steered(
    browser: Browser, engine: FakeEngine, run: dict[str, Any], do: str, sent: Command
) -> None:
    answer = command(browser, run, do)
    assert (answer.status, answer.data) == (200, {"value": None, "problem": None})
    assert engine.commands == [sent]


def test_a_capture_is_answered_by_hand(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    assert command(browser, run, "answer_capture", result="B").status == 200
    assert command(browser, run, "answer", value="3").status == 200
    assert engine.commands == [AnswerCapture(result="B"), commands.Answer(value="3")]


def test_the_live_run_is_debugged(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    assert command(browser, run, "step", mode="over").status == 200
    assert command(browser, run, "breakpoints", blocks=["a", "b"]).status == 200
    assert command(browser, run, "speed", factor=0.5).status == 200
    assert command(browser, run, "subscribe", sensors=["sonar", "lidar"]).status == 200
    assert engine.commands == [
        Step(mode="over"),
        SetBreakpoints(blocks=["a", "b"]),
        SetSpeed(factor=0.5),
        Subscribe(sensors=["sonar", "lidar"]),
    ]


@pytest.mark.parametrize(
    ("sent", "parts"),
    [
        ({"do": "step", "mode": "back"}, ["“mode”", "into, over, out"]),
        ({"do": "breakpoints", "blocks": [1]}, ["“blocks”"]),
        ({"do": "speed", "factor": 100}, ["“factor”", "0.1", "10"]),
        ({"do": "speed"}, ["“factor”"]),
        ({"do": "subscribe", "sensors": ["camera"]}, ["“sensors”"]),
        ({"do": "stop", "now": True}, ["“now”"]),
        ({"do": "fly"}, ["“do”", "pause, resume, stop"]),
        ({}, ["“do”", "pause, resume, stop"]),
        ([], ["JSON object"]),
    ],
)
def test_a_command_that_does_not_fit_is_told_in_words(
    browser: Browser, engine: FakeEngine, run: dict[str, Any], sent: Any, parts: list[str]
) -> None:
    answer = browser.post(f"/api/runs/{run['id']}/commands", sent)
    assert (answer.status, answer.error["code"]) == (422, "invalid_request")
    text = f"{answer.error['message']} {answer.error['remedy']}"
    assert [part for part in parts if part not in text] == []
    assert engine.commands == []


def test_an_expression_is_evaluated_while_the_run_is_paused(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    asked = command(browser, run, "evaluate", expression={"var": "x"})
    assert asked.data == {"value": 42, "problem": None}
    answer = command(browser, run, "evaluate", expression={"call": "f"}).data
    assert answer["value"] is None
    assert answer["problem"]
    engine.send(ended(run["id"], 0, 0))
    assert command(browser, run, "evaluate", expression=1).error["code"] == "run_not_live"


def test_a_run_may_begin_with_breakpoints_in_slow_motion_and_held(
    browser: Browser, engine: FakeEngine, version: dict[str, Any]
) -> None:
    options = {"breakpoints": ["b1"], "speed": 0.25, "paused": True}
    start = {"version_id": version["id"], "world": "empty_room", **options}
    assert browser.post("/api/runs", start).status == 200
    assert engine.first == [
        SetBreakpoints(blocks=["b1"]),
        SetSpeed(factor=0.25),
        Step(mode="into"),
    ]


@pytest.mark.parametrize(
    ("do", "more"), [("pause", {}), ("stop", {}), ("answer_capture", {"result": "B"})]
)
def test_a_run_that_has_ended_cannot_be_steered(
    browser: Browser, engine: FakeEngine, run: dict[str, Any], do: str, more: dict[str, Any]
) -> None:
    engine.send(ended(run["id"], 0, 0))
    answer = command(browser, run, do, **more)
    assert (answer.status, answer.error["code"]) == (409, "run_not_live")


def test_a_page_that_comes_in_the_middle_is_told_everything_up_to_now(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    sample = next(iter(square(run["id"])))
    for seq in range(3):
        engine.send(block_started(run["id"], seq=seq))
    engine.send({**sample, "seq": 3})
    events = browser.get(f"/api/runs/{run['id']}/events").data["events"]
    assert [event["seq"] for event in events] == [0, 1, 2]
    assert browser.send("GET", f"/api/runs/{run['id']}/telemetry").status == 200


def test_a_recorded_run_reads_back_with_version_and_world(
    browser: Browser, engine: FakeEngine, version: dict[str, Any], run: dict[str, Any]
) -> None:
    samples = list(square(run["id"]))
    engine.send(block_started(run["id"], seq=0))
    for event in samples:
        engine.send({**event, "seq": event["tick"] + 1})
    end = ended(run["id"], len(samples) + 1, len(samples))
    engine.send(end)
    read = browser.get(f"/api/runs/{run['id']}").data
    assert (read["state"], read["reason"], read["message"]) == ("finished", None, None)
    assert read["duration_s"] == end["duration_s"]
    assert len(read["path"]) == 5
    assert read["version"]["id"] == version["id"]
    assert read["world_document"]["name"] == "empty_room"
    events = browser.get(f"/api/runs/{run['id']}/events").data["events"]
    assert events == [block_started(run["id"], seq=0), end]


def test_a_run_that_failed_says_why_in_words(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    engine.send(ended(run["id"], 0, 0, state="failed", reason="blocked", block="m"))
    read = browser.get(f"/api/runs/{run['id']}").data
    assert (read["state"], read["reason"], read["block"]) == ("failed", "blocked", "m")
    assert read["message"]
    assert read["remedy"]


def test_telemetry_is_an_aligned_header_and_float_columns(
    browser: Browser, engine: FakeEngine, run: dict[str, Any]
) -> None:
    for tick in range(3):
        engine.send(sample(run["id"], tick))
    engine.send(ended(run["id"], 3, 3))
    answer = browser.get(f"/api/runs/{run['id']}/telemetry")
    assert answer.headers["Content-Type"] == "application/octet-stream"
    (length,) = struct.unpack_from("<I", answer.body)
    header = json.loads(answer.body[4 : 4 + length])
    assert header["rows"] == 3
    assert len(answer.body) == 4 + length + 4 * 3 * len(header["columns"])


def test_runs_come_in_pages(
    browser: Browser, engine: FakeEngine, group: dict[str, Any], version: dict[str, Any]
) -> None:
    ids = []
    for _ in range(3):
        run = browser.post(
            "/api/runs", {"version_id": version["id"], "world": "obstacles", "seed": 5}
        ).data
        engine.send(ended(run["id"], 0, 0))
        ids.append(run["id"])
    path = f"/api/groups/{group['id']}/runs?limit=2"
    first = browser.get(path).data
    second = browser.get(f"{path}&before={first['next']}").data
    assert [run["id"] for run in first["runs"] + second["runs"]] == ids[::-1]
    assert second["next"] is None


@pytest.mark.parametrize(
    ("change", "address"),
    [
        ("UPDATE telemetry SET data = x'0011'", "/telemetry"),
        ("UPDATE events SET data = '{'", "/events"),
        ("UPDATE runs SET parameters = '{'", ""),
        ("UPDATE runs SET world_document = '[]'", ""),
        ("UPDATE runs SET world_document = '{}'", ""),
    ],
)
def test_a_damaged_record_is_one_error_in_words(
    change: str,
    address: str,
    browser: Browser,
    engine: FakeEngine,
    database: Path,
    group: dict[str, Any],
    run: dict[str, Any],
) -> None:
    engine.send(block_started(run["id"], 0))
    for event in square(run["id"]):
        engine.send(event)
    engine.send(ended(run["id"], 9999, 9999))
    with contextlib.closing(sqlite3.connect(database)) as db, db:
        db.execute(change)
    answer = browser.get(f"/api/runs/{run['id']}{address}")
    assert (answer.status, answer.error["code"]) == (409, "run_damaged")
    assert "damaged" in answer.error["message"]
    runs = browser.get(f"/api/groups/{group['id']}/runs").data["runs"]
    assert [one["id"] for one in runs] == [run["id"]]
