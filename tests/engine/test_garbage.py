"""Runs leave nothing behind in the engine's process, however many there are."""

import json
import queue
import subprocess
import sys
from typing import Any

import psutil
import pytest

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.engine.commands import SetSpeed
from pinel_desktop.runs.spec import RunSpec

WAIT_S = 30.0
N_RUNS = 30
PROGRAM = {
    "pinel_ir": 1,
    "commands": [
        {"action": "say", "text": "a", "block": "s"},
        {"action": "move_forward", "distance": 0.1, "block": "m"},
    ],
}
# in a process of its own, where nothing else collects garbage
COUNT = """
import gc, io, json, sys
from pinel_desktop.engine.server import Engine, _LiveRun
from pinel_desktop.execution.control import RunControl
engine = Engine(io.BytesIO(), io.BytesIO())
for message in map(json.loads, sys.stdin):
    run = _LiveRun(message, engine, None)
    run.thread.start()
    run.thread.join()
print(sum(type(thing) is RunControl for thing in gc.get_objects()))
"""


def test_a_run_is_forgotten_when_it_has_ended() -> None:
    spec = RunSpec({"pinel_ir": 1, "commands": []}, "empty_room", pace="live").as_message()
    messages = "".join(json.dumps({"run": f"r{n}", "spec": spec}) + "\n" for n in range(N_RUNS))
    counted = subprocess.run(
        [sys.executable, "-c", COUNT], input=messages, capture_output=True, text=True, check=True
    )
    assert int(counted.stdout) <= 2  # the last one, which this process still has


class Soak:
    """One engine process that executes run after run."""

    def __init__(self) -> None:
        self._events: queue.Queue[dict[str, Any]] = queue.Queue()
        self.client = EngineClient(self._events.put)
        self.client.start()
        assert self.client.wait_until_ready(WAIT_S)
        self._process = psutil.Process(self.client.pid)

    def run(self, n: int) -> None:
        for _ in range(n):
            self.client.run("r", RunSpec(PROGRAM, "empty_room", pace="live"), [SetSpeed(factor=10)])
            while (event := self._events.get(timeout=WAIT_S))["type"] != "run_ended":
                pass
            assert event["state"] == "finished"

    @property
    def rss_mb(self) -> float:
        return float(self._process.memory_info().rss / 1e6)


@pytest.mark.nightly
@pytest.mark.timeout(1_200)
def test_two_thousand_runs_need_no_more_memory_than_two_hundred() -> None:
    soak = Soak()
    try:
        soak.run(200)
        after_200_mb = soak.rss_mb
        soak.run(1_800)
        print(f"{after_200_mb:.1f} MB after 200 runs, {soak.rss_mb:.1f} MB after 2,000")
        assert soak.rss_mb - after_200_mb < 5.0
    finally:
        soak.client.close()
