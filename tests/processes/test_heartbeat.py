"""A process that hangs is ended; one that computes, one that a debugger holds, and a PC that sleeps are left alone."""

import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from pinel_desktop.processes import heartbeat
from pinel_desktop.processes.heartbeat import (
    TIMEOUTS,
    HangTimeouts,
    ProcessSampler,
    ResponseTimer,
    is_hung,
)
from pinel_desktop.processes.supervisor import Supervisor

BEAT_S = 0.5
WAIT_S = 30.0
# it computes for as long as its file is missing, then answers as usual
BUSY = """import json, pathlib, sys
print('{"type": "some_ready"}', flush=True)
sys.stdin.readline()
while not pathlib.Path(sys.argv[1]).exists(): sum(range(10_000))
for line in sys.stdin: print('{"type": "pong"}', flush=True); print('{"type": "heard"}', flush=True)
"""


def response_times(beats: list[tuple[float, int, bool]]) -> list[float]:
    """The silence at each beat of (s, messages heard, whether the app is busy)."""
    response_timer = ResponseTimer(BEAT_S, now_s=0.0)
    return [response_timer.beat(now_s, n, is_app_busy=busy) for now_s, n, busy in beats]


def test_silence_is_counted_in_beats_and_ends_with_any_message() -> None:
    beats = [(0.5, 7, False), (1.0, 7, False), (1.5, 7, False), (2.0, 8, False), (2.5, 8, False)]
    assert response_times(beats) == [0.0, 0.5, 1.0, 0.0, 0.5]


def test_a_pc_that_slept_counts_no_silence() -> None:
    beats = [(0.5, 7, False), (1.0, 7, False), (9_000.0, 7, False), (9_000.5, 7, False)]
    assert response_times(beats) == [0.0, 0.5, 0.0, 0.5]


def test_an_app_that_has_not_read_what_was_said_counts_no_silence() -> None:
    assert response_times([(0.5, 7, True), (1.0, 7, True), (1.5, 7, False)]) == [0.0, 0.0, 0.5]


@pytest.mark.parametrize(
    ("unresponsive_s", "is_ready", "doing", "is_ended"),
    [
        (1.5, True, "nothing", False),
        (2.0, True, "nothing", True),
        (9.5, True, "something", False),
        (10.0, True, "something", True),
        (3_600.0, True, "traced", False),
        (59.5, False, "nothing", False),
        (60.0, False, "something", True),
    ],
)
def test_time_out_depends_on_what_the_process_does(
    unresponsive_s: float, is_ready: bool, doing: str, is_ended: bool
) -> None:
    assert is_hung(unresponsive_s, TIMEOUTS, is_ready=is_ready, doing=doing) == is_ended  # type: ignore[arg-type] # a table


@pytest.mark.parametrize(("has_status", "expected"), [(True, "something"), (False, "nothing")])
def test_on_windows_the_status_of_a_process_says_nothing(
    has_status: bool, expected: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # there every process that is not suspended is "running", also one that waits for ever
    monkeypatch.setattr(heartbeat, "_HAS_STATUS", has_status)
    monkeypatch.setattr(psutil.Process, "status", lambda process: psutil.STATUS_RUNNING)
    with subprocess.Popen(["sleep", "60"]) as process:
        sampler = ProcessSampler()
        sampler.sample(process.pid)
        found = sampler.sample(process.pid)
        process.kill()
    assert found == expected


def test_a_process_that_computes_and_answers_late_is_the_same_afterwards(tmp_path: Path) -> None:
    received: list[object] = []
    free = tmp_path / "free"
    supervisor = Supervisor(
        "some",
        [sys.executable, "-c", BUSY, str(free)],
        "some_lost",
        on_message=received.append,
        timeouts=HangTimeouts(hang_timeout_s=0.4, busy_timeout_s=600.0, beat_s=0.1),
    )
    supervisor.start()
    assert supervisor.wait_until_ready(WAIT_S)
    first, due_s = supervisor.pid, time.monotonic() + WAIT_S
    time.sleep(1.5)  # several times what a process that does nothing is given
    free.touch()
    while not received:
        assert time.monotonic() < due_s
        time.sleep(0.02)
    supervisor.close()
    assert supervisor.pid == first
