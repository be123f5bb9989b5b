"""The real engine process behind its client."""

import os
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import psutil
import pytest

from pinel_desktop.engine import client
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.engine.commands import (
    Answer,
    AnswerCapture,
    Command,
    Evaluate,
    Pause,
    Resume,
    SetBreakpoints,
    SetSpeed,
    Step,
    Stop,
    Subscribe,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.events.types import RUN_EVENTS
from pinel_desktop.processes import supervisor
from pinel_desktop.runs.spec import RunSpec
from tests.in_time import in_time

pytestmark = pytest.mark.waits

WAIT_S = 20.0
SHORT = {"pinel_ir": 1, "commands": [{"action": "move_forward", "distance": 0.1, "block": "m"}]}
LONG = {"pinel_ir": 1, "commands": [{"action": "move_forward", "distance": 3, "block": "m"}]}


class Harness:
    """A client with its events in a queue."""

    def __init__(self, command: list[str] | None = None) -> None:
        self.events: queue.Queue[dict[str, Any]] = queue.Queue()
        self.client = EngineClient(self.events.put, command)
        self.client.start()

    def until(self, kind: str, **fields: Any) -> list[dict[str, Any]]:
        """All events up to the first of that type with those fields."""
        received = []
        while True:
            event = self.events.get(timeout=WAIT_S)
            received.append(event)
            if event["type"] == kind and fields.items() <= event.items():
                return received


@pytest.fixture
def engine() -> Iterator[Harness]:
    harness = Harness()
    assert harness.client.wait_until_ready(WAIT_S)
    yield harness
    harness.client.close()


def test_live_run_reports_every_event_in_order_without_gaps(engine: Harness) -> None:
    engine.client.run("r", RunSpec(SHORT, "empty_room", pace="live"))
    events = engine.until("run_ended")
    assert [event["seq"] for event in events] == list(range(len(events)))
    assert {event["run"] for event in events} == {"r"}
    assert {event["type"] for event in events} <= set(RUN_EVENTS)
    assert events[-1]["state"] == "finished"
    assert events[-1]["pose"]["x_m"] == pytest.approx(0.1, abs=1e-4)
    assert engine.client.live_run is None


def test_live_run_gives_the_same_telemetry_as_one_in_this_process(
    engine: Harness, execute_here: Any
) -> None:
    engine.client.run("r", RunSpec(SHORT, "empty_room", pace="live"))
    assert engine.until("run_ended")[-1]["telemetry_sha256"] == execute_here(SHORT)


@pytest.fixture
def execute_here() -> Any:
    from pinel_desktop.execution.executor import execute  # noqa: PLC0415
    from pinel_desktop.links import open_link  # noqa: PLC0415
    from pinel_desktop.program.reading import read_document  # noqa: PLC0415

    def run(document: dict[str, Any]) -> str:
        program = read_document(document).program
        assert program is not None
        return execute(program, open_link("sim", world="empty_room")).ended.telemetry_sha256

    return run


def test_pause_resume_and_stop_reach_the_run(engine: Harness) -> None:
    engine.client.run("r", RunSpec(LONG, "empty_room", pace="live"))
    engine.until("telemetry")
    engine.client.command("r", Pause())
    engine.until("run_state", state="paused")
    engine.client.command("r", Resume())
    engine.until("run_state", state="running")
    engine.client.command("r", Stop())
    assert engine.until("run_ended")[-1]["state"] == "stopped"


def test_run_begins_held_is_stepped_looked_into_and_hastened(engine: Harness) -> None:
    first: list[Command] = [Step(mode="into"), SetSpeed(factor=10.0), SetBreakpoints(blocks=["m"])]
    document = {
        "pinel_ir": 1,
        "commands": [
            {"action": "set_variable", "name": "n", "value": 7, "block": "s"},
            {"action": "move_forward", "distance": 3, "block": "m"},
        ],
    }
    engine.client.run("r", RunSpec(document, "empty_room", pace="live"), first)
    held = engine.until("run_state", state="paused")[-1]
    assert (held["cause"], held["block"]) == ("step", "s")
    with pytest.raises(PinelError, match="unset_variable"):
        engine.client.command("r", Evaluate(expression={"var": "n"}))
    engine.client.command("r", Step(mode="over"))
    held = engine.until("run_state", state="paused")[-1]
    assert (held["cause"], held["block"]) == ("breakpoint", "m")
    assert (
        engine.client.command("r", Evaluate(expression={"op": "+", "args": [{"var": "n"}, 1]})) == 8
    )
    engine.client.command("r", Resume())
    started_s = time.monotonic()
    engine.until("run_ended", state="finished")
    assert in_time(time.monotonic() - started_s, 4.0)  # six seconds of robot time
    with pytest.raises(PinelError, match="run_not_live"):
        engine.client.command("r", Evaluate(expression=1))


def test_who_looks_is_told_what_the_sensors_measure_until_nobody_looks(engine: Harness) -> None:
    engine.client.run("r", RunSpec(LONG, "empty_room", pace="live"))
    engine.client.command("r", Subscribe(sensors=["sonar"]))
    ranges = engine.until("ranges")[-1]
    assert ranges["lidar"] is None
    assert len(ranges["sonar"]) == 16
    engine.client.command("r", Subscribe(sensors=[]))
    engine.client.command("r", Stop())
    engine.until("run_ended", state="stopped")


def test_capture_is_answered_by_hand(engine: Harness) -> None:
    document = {"pinel_ir": 1, "commands": [{"action": "classify_gestures"}]}
    engine.client.run("r", RunSpec(document, "empty_room", pace="live"))
    engine.until("capture_started")
    engine.client.command("r", AnswerCapture(result="B"))
    assert engine.until("gesture_result")[-1]["result"] == "B"
    engine.until("run_ended", state="finished")


def test_question_is_answered_by_hand_and_the_seed_reaches_the_run(engine: Harness) -> None:
    draw = {"op": "random_int", "args": [1, 1_000_000]}
    document = {
        "pinel_ir": 1,
        "commands": [
            {"action": "ask", "question": "Name?", "variable": "name", "block": "a"},
            {"action": "say", "text": {"op": "join", "args": [{"var": "name"}, " ", draw]}},
        ],
    }
    texts = []
    for run, seed in (("r", 1), ("s", 1), ("t", 2)):
        engine.client.run(run, RunSpec(document, "empty_room", seed=seed, pace="live"))
        assert engine.until("asked")[-1]["question"] == "Name?"
        engine.client.command(run, Answer(value="Ana"))
        texts.append(engine.until("said", run=run)[-1]["text"])
        engine.until("run_ended", run=run, state="finished")
    assert texts[0].startswith("Ana ")
    assert texts[0] == texts[1] != texts[2]


def test_loop_without_motion_leaves_stop_its_100_ms(engine: Harness) -> None:
    loop = {"action": "forever", "commands": [{"action": "set_variable", "name": "a", "value": 1}]}
    engine.client.run("r", RunSpec({"pinel_ir": 1, "commands": [loop]}, "empty_room", pace="live"))
    engine.until("telemetry", tick=30)
    pressed = time.monotonic()
    engine.client.command("r", Stop())
    engine.until("run_ended", state="stopped")
    # the robot has to be measured at rest too: a few ticks more
    assert in_time(time.monotonic() - pressed, 0.5)


def test_second_run_is_refused_while_one_is_live(engine: Harness) -> None:
    engine.client.run("r", RunSpec(LONG, "empty_room", pace="live"))
    with pytest.raises(PinelError, match="run_in_progress"):
        engine.client.run("s", RunSpec(SHORT, "empty_room", pace="live"))
    with pytest.raises(PinelError, match="run_not_live"):
        engine.client.command("s", Stop())
    engine.client.command("r", Stop())
    engine.until("run_ended")
    engine.client.run("s", RunSpec(SHORT, "empty_room", pace="live"))
    assert engine.until("run_ended")[-1]["run"] == "s"


@pytest.mark.parametrize(
    ("document", "world", "reason"),
    [
        (SHORT, "nowhere", "unknown_world"),
        ({"pinel_ir": 1, "commands": [{"action": "fly"}]}, "empty_room", "invalid_program"),
    ],
)
def test_run_that_cannot_begin_ends_with_its_reason(
    engine: Harness, document: Any, world: str, reason: str
) -> None:
    engine.client.run("r", RunSpec(document, world, pace="live"))
    (ended,) = engine.until("run_ended")
    assert (ended["state"], ended["reason"]) == ("failed", reason)


def test_killed_engine_fails_the_run_and_a_new_engine_takes_its_place(engine: Harness) -> None:
    engine.client.run("r", RunSpec(LONG, "empty_room", pace="live"))
    # it has to have lived for a while, or it counts as one that cannot start
    engine.until("telemetry", tick=100)
    before = engine.client.pid
    assert before is not None
    os.kill(before, signal.SIGKILL)
    ended = engine.until("run_ended")[-1]
    assert (ended["state"], ended["reason"]) == ("failed", "engine_lost")
    assert engine.client.wait_until_ready(WAIT_S)
    assert engine.client.pid != before
    engine.client.run("s", RunSpec(SHORT, "empty_room", pace="live"))
    assert engine.until("run_ended", run="s")[-1]["state"] == "finished"


def test_engine_stops_its_robot_and_goes_when_the_app_is_gone() -> None:
    harness = Harness()
    assert harness.client.wait_until_ready(WAIT_S)
    harness.client.run("r", RunSpec(LONG, "empty_room", pace="live"))
    harness.until("telemetry")
    assert harness.client.pid is not None
    process = psutil.Process(harness.client.pid)
    harness.client.close()
    assert not process.is_running()
    events = harness.until("run_ended")
    assert events[-1]["state"] == "stopped"
    last = [event for event in events if event["type"] == "telemetry"][-1]
    assert last["command_v_mps"] == 0.0


def test_engine_that_cannot_start_is_lost_and_runs_are_refused() -> None:
    for command in (["/nonexistent/engine"], [sys.executable, "-c", "raise SystemExit(1)"]):
        harness = Harness(command)
        assert not harness.client.wait_until_ready(WAIT_S)
        assert harness.client.state == "lost"
        with pytest.raises(PinelError, match="engine_not_ready"):
            harness.client.run("r", RunSpec(SHORT, "empty_room", pace="live"))
        harness.client.close()


def test_noise_on_the_pipe_is_passed_over() -> None:
    noise = "print('warning: a library says hello'); print('[1]'); print('{\"type\":\"engine_ready\"}', flush=True)"
    noise += "; input()"
    harness = Harness([sys.executable, "-c", noise])
    assert harness.client.wait_until_ready(WAIT_S)
    harness.client.close()


def test_engine_that_is_still_starting_does_not_keep_the_app_from_closing() -> None:
    harness = Harness([sys.executable, "-c", "import signal; signal.sigwait([signal.SIGUSR1])"])
    harness.client.close()
    assert not harness.client.wait_until_ready(0)


def test_engine_that_dies_soon_is_started_again_and_a_lost_one_when_somebody_wants_to_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        supervisor, "_MIN_UPTIME_S", WAIT_S
    )  # on a busy PC the start alone takes long
    harness = Harness()
    try:
        for _ in range(3):
            assert harness.client.wait_until_ready(WAIT_S)
            assert harness.client.pid is not None
            process = psutil.Process(harness.client.pid)
            process.kill()
            process.wait(WAIT_S)
            _until(partial(_replaced_or_lost, harness.client, process.pid))
        assert harness.client.state == "lost"
        monkeypatch.setattr(client, "_READY_S", WAIT_S)
        harness.client.run("r", RunSpec(SHORT, "empty_room", pace="live"))
        assert harness.until("run_ended")[-1]["state"] == "finished"
    finally:
        harness.client.close()


def _replaced_or_lost(client: EngineClient, pid: int) -> bool:
    return client.pid != pid or client.state == "lost"


def _until(true: Callable[[], bool]) -> None:
    deadline = time.monotonic() + WAIT_S
    while not true():
        assert time.monotonic() < deadline
        threading.Event().wait(0.01)
