"""The camera's process: how late its answer is, what it costs the control loop beside it, how much memory it takes."""

import json
import queue
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import psutil

from pinel_desktop.camera.client import CameraClient, CameraState
from pinel_desktop.desktop.self_check import RECORDED_SIGNS
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.execution.clock import TICK_S
from pinel_desktop.execution.inputs import Capture
from pinel_desktop.runs.spec import RunSpec
from tests.gestures.drawn import drawn_hand, on_wall

WAIT_S = 60.0
RUN_S = 10.0
# One run measures what else the PC does at that moment: its ratio lies between 0.4 and 4 on one and the same code.
N_RUNS = 5
N_CAPTURES = 40
MAX_JITTER_RATIO = 2.0
DRIVE = {
    "pinel_ir": 1,
    "commands": [
        {"action": "drive", "linear": 0.1, "angular": 20},
        {"action": "wait", "seconds": RUN_S},
    ],
}
# sleeps until each tick of 1/30 s and prints how late it woke up, in ms
SLEEPER = f"""
import json, time
began, late = time.perf_counter(), []
for i in range(1, int({RUN_S} * 30)):
    due = began + i / 30
    time.sleep(max(0.0, due - time.perf_counter()))
    late.append(1000 * (time.perf_counter() - due))
print(json.dumps(late))
"""


class CameraProbe:
    """A camera with its answers and states in queues."""

    def __init__(self, source: str) -> None:
        self.answers: queue.Queue[Capture] = queue.Queue()
        self.states: queue.Queue[CameraState] = queue.Queue()
        self.camera = CameraClient(
            source,
            lambda event: None,
            self.states.put,
            lambda run, capture: self.answers.put(capture),
        )
        self.camera.switch_on()
        while self.states.get(timeout=WAIT_S).mode != "on":
            pass

    def capture(self) -> float:
        """Captures once; how long that took, in s."""
        start_s = time.perf_counter()
        self.camera.observe({"type": "capture_started", "run": "r"})
        self.answers.get(timeout=WAIT_S)
        self.camera.observe({"type": "gesture_result", "run": "r"})
        return time.perf_counter() - start_s


@contextmanager
def looking_at(source: Path) -> Iterator[CameraProbe]:
    probe = CameraProbe(str(source))
    yield probe
    probe.camera.close()


def test_answer_comes_soon_after_a_sign_is_held() -> None:
    """The recording holds each sign for 1.6 s and shows no hand for 0.8 s, in which captures may begin as well."""
    with looking_at(RECORDED_SIGNS) as probe:
        _print_answers(probe)


def _print_answers(probe: CameraProbe) -> None:
    times_s = sorted(probe.capture() for _ in range(N_CAPTURES))
    median_s, p95_s = statistics.median(times_s), times_s[int(0.95 * N_CAPTURES)]
    print(
        f"\n{N_CAPTURES} captures: median {median_s:.2f} s, at most 1; 95 % within {p95_s:.2f} s, at most 2"
    )
    assert median_s <= 1.0
    assert p95_s <= 2.0


def test_control_loop_is_as_punctual_as_a_sleeper(tmp_path: Path) -> None:
    """Beside a camera whose networks look at a drawn hand, 15 times a second."""
    frame = on_wall(drawn_hand(size=320), 1280, 720, 300, 100)
    cv2.imwrite(str(tmp_path / "hand.png"), cv2.cvtColor(frame, cv2.COLOR_RGB2BGR))
    with looking_at(tmp_path) as probe:
        ratio = statistics.median(_ratio(probe) for _ in range(N_RUNS))
        memory_mb = psutil.Process(probe.camera.pid).memory_info().rss / 2**20
    print(
        f"median of {N_RUNS}: {ratio:.2f}, at most {MAX_JITTER_RATIO}\nthe camera's process takes {memory_mb:.0f} MB"
    )
    assert ratio <= MAX_JITTER_RATIO


def _ratio(probe: CameraProbe) -> float:
    """How late 95 % of the ticks of a run come at most, beside a bare sleeper at the same time."""
    arrived: list[float] = []
    ended: queue.Queue[dict[str, Any]] = queue.Queue()

    def on_event(event: dict[str, Any]) -> None:
        if event["type"] == "telemetry":
            arrived.append(time.perf_counter())
        elif event["type"] == "run_ended":
            ended.put(event)

    engine = EngineClient(on_event)
    engine.start()
    assert engine.wait_until_ready(WAIT_S)
    probe.camera.observe({"type": "capture_started", "run": "other"})
    with subprocess.Popen([sys.executable, "-c", SLEEPER], stdout=subprocess.PIPE) as sleeper:
        engine.run("r", RunSpec(DRIVE, "empty_room", pace="live"))
        ended.get(timeout=WAIT_S)
        late_ms = json.loads(sleeper.communicate(timeout=WAIT_S)[0])
    engine.close()
    ours_ms, sleeper_ms = _spread_ms(arrived), _percentile_of(late_ms)
    print(
        f"\ncontrol loop beside a capture: 95 % of ticks within {ours_ms:.2f} ms, a bare sleeper {sleeper_ms:.2f} ms, "
        f"ratio {ours_ms / sleeper_ms:.2f}"
    )
    return ours_ms / sleeper_ms


def _spread_ms(arrived: list[float]) -> float:
    """How late ticks come, by the line through all of them that is early for none of the first half of a percent."""
    late = np.array(arrived) - TICK_S * np.arange(len(arrived))
    return _percentile_of(list(1000 * (late - np.percentile(late, 0.5))))


def _percentile_of(late_ms: list[float]) -> float:
    return float(np.percentile(late_ms, 95))
