"""The real judge's process behind its client."""

import math
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from typing import Any

import psutil
import pytest

from pinel_desktop.activities import activity_names, shipped_activity, solution_of, world_of
from pinel_desktop.activities.model import Activity
from pinel_desktop.errors import PinelError
from pinel_desktop.judge.client import JudgeClient
from pinel_desktop.judge.messages import JudgeRequest
from pinel_desktop.judge.server import N_PATH_POSES, verdict_on
from pinel_desktop.processes.heartbeat import HangTimeouts
from pinel_desktop.program.python_text import read_python

ENDLESS = read_python("while True:\n    n = 1\n").result.document or {}
UNRESPONSIVE = 'import sys,time; print(\'{"type":"judge_ready"}\', flush=True); time.sleep(600)'


def judge_request(name: str = "square", **changes: Any) -> JudgeRequest:
    given = {
        "activity": shipped_activity(name).model_dump_json(),
        "document": solution_of(name) or {},
        "world": str(shipped_activity(name).world),
        "observed": None,
        "language": "en",
    }
    return JudgeRequest(**{**given, **changes})


@pytest.fixture
def judge() -> Iterator[JudgeClient]:
    client = JudgeClient()
    yield client
    client.close()


def code_of(client: JudgeClient, asked: JudgeRequest) -> str:
    with pytest.raises(PinelError) as caught:
        client.judge(asked)
    return caught.value.code


@pytest.mark.parametrize("name", activity_names())
def test_an_activity_comes_through_the_pipe_unchanged(name: str) -> None:
    activity = shipped_activity(name)
    assert Activity.model_validate_json(activity.model_dump_json()) == activity


def test_verdicts_of_the_process_are_those_of_the_checker(judge: JudgeClient) -> None:
    one_side = {"pinel_ir": 1, "commands": [{"action": "move_forward", "distance": 1}]}
    for asked in (judge_request(), judge_request(document=one_side), judge_request("polygon")):
        given, found = judge.judge(asked), verdict_on(asked)
        assert (given.passed, given.missing) == (found.passed, found.missing)
        assert [case["checks"] != [] for case in given.cases] == [True] * len(found.cases)
    assert judge.judge(judge_request()).passed is True


def test_a_verdict_has_the_path_of_each_case_that_the_group_did_not_watch(
    judge: JudgeClient,
) -> None:
    ahead = {"pinel_ir": 1, "commands": [{"action": "move_forward", "distance": 1}]}
    activity = shipped_activity("to_the_red")
    tried = judge.judge(judge_request("to_the_red", document=ahead)).tried
    for case, one in zip(activity.cases, tried, strict=True):
        start = world_of(activity, case)["start"]
        yaw = math.radians(start["heading_deg"])
        first, last = one["path"][0], one["path"][-1]
        assert first == pytest.approx((start["x_m"], start["y_m"], yaw), abs=0.001)
        assert math.dist(first[:2], last[:2]) == pytest.approx(1, abs=0.01)
        assert len(one["path"]) <= N_PATH_POSES


def test_an_endless_calculation_is_told_and_ends_within_seconds(judge: JudgeClient) -> None:
    judge.judge(judge_request())  # warm
    verdict = judge.judge(judge_request("polygon", document=ENDLESS))  # three cases
    assert verdict.passed is False
    assert verdict.missing is not None
    assert "steps without driving or waiting" in verdict.missing
    assert [case["reason"] for case in verdict.cases] == ["too_busy"]


def test_what_cannot_be_judged_is_refused_and_the_next_program_is_judged(
    judge: JudgeClient,
) -> None:
    assert code_of(judge, judge_request(activity='{"pinel_activity": 9}')) == "internal_error"
    lost_world = shipped_activity("square").model_copy(update={"world": "no_such_world"})
    assert code_of(judge, judge_request(activity=lost_world.model_dump_json())) == "unknown_world"
    assert judge.judge(judge_request()).passed is True


def test_a_judge_that_is_killed_is_told_and_replaced(judge: JudgeClient) -> None:
    judge.judge(judge_request())
    first = judge.pid
    assert first is not None
    psutil.Process(first).suspend()
    threading.Timer(0.3, os.kill, (first, signal.SIGKILL)).start()
    assert code_of(judge, judge_request()) == "judge_lost"
    assert judge.judge(judge_request()).passed is True
    assert judge.pid != first


def test_a_judge_that_hangs_is_ended() -> None:
    quick = HangTimeouts(hang_timeout_s=0.3, busy_timeout_s=0.3, beat_s=0.1)
    client = JudgeClient([sys.executable, "-c", UNRESPONSIVE], quick)
    try:
        client.start()
        pid = client.pid
        assert code_of(client, judge_request()) == "judge_lost"
        deadline = time.monotonic() + 20
        while client.pid == pid and time.monotonic() < deadline:
            time.sleep(0.02)
        assert client.pid != pid
    finally:
        client.close()


def test_a_judge_that_does_not_start_is_told() -> None:
    client = JudgeClient(["/no/such/program"])
    assert code_of(client, judge_request()) == "judge_lost"
    client.close()


def test_closing_frees_who_waits_and_ends_the_process() -> None:
    client = JudgeClient()
    client.judge(judge_request())
    pid = client.pid
    assert pid is not None
    psutil.Process(pid).suspend()
    codes: list[str] = []
    asking = threading.Thread(target=lambda: codes.append(code_of(client, judge_request())))
    asking.start()
    time.sleep(0.2)
    psutil.Process(pid).resume()
    client.close()
    asking.join(10)
    assert codes in (["judge_lost"], [])
    assert not asking.is_alive()
    assert not psutil.pid_exists(pid)
    assert code_of(client, judge_request()) == "judge_lost"


def test_the_process_ends_after_its_last_request_and_the_next_request_starts_it() -> None:
    client = JudgeClient(idle_end_s=1.0)
    for _ in range(2):
        assert client.judge(judge_request()).passed is True
        due_s = time.monotonic() + 60
        while client.pid is not None:
            assert time.monotonic() < due_s
            threading.Event().wait(0.05)
    client.close()
