"""How soon a real robot stands: Stop, a frozen or killed app, an engine that is told to end, a key that is let go.

Real processes and a robot in memory. Each figure may be later by what a bare sleeper of the same run is late.
"""

import contextlib
import queue
import signal
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.engine.commands import Stop
from pinel_desktop.judge.client import JudgeClient
from pinel_desktop.judge.messages import PredictionRequest
from tests.engine.memory_robot import FAR, engine_command
from tests.engine.test_real_robot import Driving, stopping_time_s, wait_until_driving
from tests.engine.test_robots import Teacher
from tests.runs.hidden_errors import drive

REPEATS = 10
STOP_WITHIN_S = 0.1
STANDSTILL_WITHIN_S = 0.3
PERIOD_S = 0.01


@contextlib.contextmanager
def lateness() -> Iterator[list[float]]:
    """How late a thread wakes that only sleeps, meanwhile."""
    late: list[float] = []
    ending = threading.Event()

    def sleep() -> None:
        while not ending.is_set():
            due_s = time.monotonic() + PERIOD_S
            time.sleep(PERIOD_S)
            late.append(time.monotonic() - due_s)

    thread = threading.Thread(target=sleep)
    thread.start()
    yield late
    ending.set()
    thread.join()


def p95(values: list[float]) -> float:
    return sorted(values)[round(0.95 * (len(values) - 1))]


def freeze(driving: Driving) -> None:
    driving.app.send_signal(signal.SIGSTOP)


def kill(driving: Driving) -> None:
    driving.app.kill()


def end_engine(driving: Driving) -> None:
    driving.engine().terminate()


def end(driving: Driving) -> None:
    """Ends app and engine, whatever became of them."""
    with driving.app, contextlib.suppress(psutil.NoSuchProcess):
        for engine in psutil.Process(driving.app.pid).children():
            engine.kill()
        driving.app.kill()


def after_trouble(log: Path, trouble: Callable[[Driving], None]) -> float:
    driving = Driving(log)
    try:
        wait_until_driving(log)
        moment_s = time.monotonic()
        trouble(driving)
        return stopping_time_s(log, moment_s)
    finally:
        end(driving)


def report(what: str, durations_s: list[float], late: list[float], bound_s: float) -> None:
    middle = sorted(durations_s)[len(durations_s) // 2]
    print(f"\n{what}: median {middle * 1000:.0f} ms, p95 {p95(durations_s) * 1000:.0f} ms", end=" ")
    print(
        f"(wanted {bound_s * 1000:.0f} ms; a sleeper is late by {max(late) * 1000:.0f} ms at most)"
    )
    assert p95(durations_s) <= bound_s + max(late)


@pytest.mark.timeout(300)
@pytest.mark.parametrize("trouble", [freeze, kill, end_engine])
def test_a_robot_stands_soon_after(trouble: Callable[[Driving], None], tmp_path: Path) -> None:
    with lateness() as late:
        durations_s = [after_trouble(tmp_path / f"heard{n}", trouble) for n in range(REPEATS)]
    report(trouble.__name__, durations_s, late, STANDSTILL_WITHIN_S)


@contextlib.contextmanager
def predicting() -> Iterator[None]:
    """Meanwhile the judge's process predicts a run each second; the page asks once, and once for each answer."""
    run, judge, ending = drive(), JudgeClient(), threading.Event()
    poses = dict(zip(("x_m", "y_m", "yaw_rad"), run.odometry[1:].T, strict=True))
    request = PredictionRequest(run.spec.as_message(), None, run.events, poses, [], is_whole=True)
    judge.predict(request)

    def ask() -> None:
        while not ending.wait(1.0):
            judge.predict(request)

    thread = threading.Thread(target=ask)
    thread.start()
    yield
    ending.set()
    thread.join()
    judge.close()


@pytest.mark.timeout(300)
@pytest.mark.parametrize("is_predicted", [False, True], ids=["alone", "with its ghost"])
def test_stop_reaches_the_robot(is_predicted: bool, tmp_path: Path) -> None:
    log, events = tmp_path / "heard", queue.Queue[dict[str, Any]]()
    client = EngineClient(events.put, engine_command(log))
    client.start()
    assert client.wait_until_ready(30.0)
    durations_s = []
    with predicting() if is_predicted else contextlib.nullcontext(), lateness() as late:
        for n in range(REPEATS):
            log.unlink(missing_ok=True)
            client.run(f"r{n}", FAR)
            wait_until_driving(log)
            moment_s = time.monotonic()
            client.command(f"r{n}", Stop())
            durations_s.append(stopping_time_s(log, moment_s))
            while events.get(timeout=30)["type"] != "run_ended":
                pass
    client.close()
    report("stop with its ghost" if is_predicted else "stop", durations_s, late, STOP_WITHIN_S)


@pytest.mark.timeout(300)
@pytest.mark.parametrize("is_released", [True, False], ids=["key let go", "page silent"])
def test_a_robot_that_is_moved_by_keys_stands_soon_after(is_released: bool, tmp_path: Path) -> None:
    """The page says that the key was let go; or it says nothing any more, because it was closed, frozen or killed."""
    teacher, durations_s = Teacher(tmp_path / "heard"), []
    with lateness() as late:
        for _ in range(REPEATS):
            teacher.drive_until_moving()
            moment_s = time.monotonic()
            teacher.hold()
            if is_released:
                teacher.client.jog(teacher.robot, 0.0, 0.0, time.time())
            durations_s.append(stopping_time_s(teacher.log, moment_s))
    teacher.client.close()
    report("key let go" if is_released else "page silent", durations_s, late, STANDSTILL_WITHIN_S)
