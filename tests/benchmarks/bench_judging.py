"""Judging in a process of its own, beside the same checks in this process: right programs, and endless ones."""

import time
from collections.abc import Callable, Iterator
from functools import partial

import pytest

from pinel_desktop.activities import activity_names, shipped_activity, solution_of
from pinel_desktop.judge.client import JudgeClient
from pinel_desktop.judge.messages import JudgeRequest
from pinel_desktop.judge.server import verdict_on
from pinel_desktop.program.python_text import read_python

REPEATS = 3
MAX_RATIO = 1.5
ENDLESS = {
    "calculates": "n = 0\nwhile True:\n    n = n + 1\n",
    "drives in a circle and calculates": "robot.drive(0.1, 30)\nn = 0\nwhile True:\n    n = n + 1\n",
    "turns": "while True:\n    robot.turn(90)\n",
}


@pytest.fixture
def judge() -> Iterator[JudgeClient]:
    client = JudgeClient()
    yield client
    client.close()


def question(name: str, program: str | None = None) -> JudgeRequest:
    activity = shipped_activity(name)
    document = read_python(program).result.document if program else solution_of(name)
    return JudgeRequest(activity.model_dump_json(), document or {}, "", None, "pt-BR")


def seconds(call: Callable[[], object]) -> float:
    """The shortest of a few."""
    durations_s = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        call()
        durations_s.append(time.perf_counter() - begin)
    return min(durations_s)


def test_a_process_of_its_own_adds_little(judge: JudgeClient) -> None:
    begin = time.perf_counter()
    judge.judge(question("square"))
    print(f"\nfrom no process to the first verdict: {time.perf_counter() - begin:.2f} s")
    outside, inside = {}, {}
    for name in activity_names():
        asked = question(name)
        inside[name] = seconds(partial(verdict_on, asked))
        outside[name] = seconds(partial(judge.judge, asked))
    costliest = max(outside, key=lambda name: outside[name])
    ratio = sum(outside.values()) / sum(inside.values())
    print(f"slowest activity: {costliest}, {outside[costliest]:.2f} s; process / here: {ratio:.2f}")
    assert ratio <= MAX_RATIO


@pytest.mark.parametrize("kind", ENDLESS)
def test_an_endless_program_is_judged_within_seconds(judge: JudgeClient, kind: str) -> None:
    judge.judge(question("square"))
    asked = question("polygon", ENDLESS[kind])
    inside, outside = seconds(lambda: verdict_on(asked)), seconds(lambda: judge.judge(asked))
    print(f"\n{kind}: {outside:.2f} s; process / here: {outside / inside:.2f}")
    assert outside / inside <= MAX_RATIO
