"""Whatever happens to app and engine, a real robot stands soon: real processes, a robot in memory."""

import contextlib
import json
import os
import queue
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.engine.commands import Stop
from pinel_desktop.errors import PinelError
from tests.engine.memory_robot import FAR, engine_command

pytestmark = pytest.mark.waits

# 0.3 s on a PC at rest, measured by tests/benchmarks/bench_robot_stops.py; other tests may keep this one busy
MAX_STOPPING_TIME_S = 1.0


def received(log: Path) -> list[tuple[float, float]]:
    """What reached the robot: seconds and m/s."""
    if not log.exists():
        return []
    lines = log.read_text().splitlines(keepends=True)
    whole = [line.split() for line in lines if line.endswith("\n")]
    return [(float(at_s), float(v)) for at_s, v, _ in whole]


def wait_until_driving(log: Path, since: int = 0) -> None:
    """Waits for a velocity after the first `since` ones."""
    due_s = time.monotonic() + 30.0
    while not any(v > 0.3 for _, v in received(log)[since:]):
        assert time.monotonic() < due_s, "the robot does not drive"
        time.sleep(0.02)


def wait_until_left_alone(log: Path) -> None:
    """Waits until a robot has been sent nothing, not even zeros, for half a second: its run has ended."""
    n_received, changed_s = -1, time.monotonic()
    due_s = changed_s + 30.0
    while time.monotonic() - changed_s < 0.5:
        assert time.monotonic() < due_s, "the run goes on"
        if len(received(log)) != n_received:
            n_received, changed_s = len(received(log)), time.monotonic()
        time.sleep(0.02)


def stopping_time_s(log: Path, event_s: float) -> float:
    """How long after a moment the robot heard its first zero that no other velocity followed for a second."""
    time.sleep(1.5)
    after = [(at_s, v) for at_s, v in received(log) if at_s > event_s]
    moving = [at_s for at_s, v in after if v]
    zeros = [at_s for at_s, v in after if not v and at_s > max(moving, default=0.0)]
    assert zeros, "no zeros came"
    return min(zeros) - event_s


class Driving:
    """An app whose engine drives a robot."""

    def __init__(self, log: Path) -> None:
        self.log = log
        self.app = subprocess.Popen(
            [sys.executable, "-m", "tests.engine.memory_robot", "app", str(log)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def engine(self) -> psutil.Process:
        """The engine's process."""
        return psutil.Process(self.app.pid).children()[0]

    def ended(self) -> dict[str, Any]:
        """The closing event, as the app printed it."""
        printed, _ = self.app.communicate(timeout=30)
        event: dict[str, Any] = json.loads(printed)
        return event


@pytest.fixture
def driving(tmp_path: Path) -> Iterator[Driving]:
    it = Driving(tmp_path / "heard")
    wait_until_driving(it.log)
    with it.app:  # closes its pipes in the end
        yield it
        with contextlib.suppress(psutil.NoSuchProcess):
            for engine in psutil.Process(it.app.pid).children():
                engine.kill()
        it.app.kill()


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="Windows has no SIGSTOP")
class TestFrozenApp:
    def test_the_robot_waits_and_drives_on_when_the_app_is_back(self, driving: Driving) -> None:
        frozen_s = time.monotonic()
        driving.app.send_signal(signal.SIGSTOP)
        assert stopping_time_s(driving.log, frozen_s) < MAX_STOPPING_TIME_S
        n_received = len(received(driving.log))
        driving.app.send_signal(signal.SIGCONT)
        wait_until_driving(driving.log, since=n_received)

    def test_the_run_ends_when_the_app_stays_away(self, driving: Driving) -> None:
        driving.app.send_signal(signal.SIGSTOP)
        wait_until_left_alone(driving.log)
        driving.app.send_signal(signal.SIGCONT)
        ended = driving.ended()
        assert (ended["state"], ended["reason"]) == ("failed", "app_silent")


def test_a_robot_that_nobody_watches_any_more_stands_and_its_run_ends(tmp_path: Path) -> None:
    log, events = tmp_path / "heard", queue.Queue[dict[str, Any]]()
    watched = threading.Event()
    watched.set()
    client = EngineClient(events.put, engine_command(log), is_watched=watched.is_set)
    client.start()
    assert client.wait_until_ready(30.0)
    client.run("r1", FAR)
    wait_until_driving(log)
    closed_s = time.monotonic()
    watched.clear()  # the last page was closed
    assert stopping_time_s(log, closed_s) < MAX_STOPPING_TIME_S
    while (ended := events.get(timeout=30))["type"] != "run_ended":
        pass
    client.close()
    assert (ended["state"], ended["reason"]) == ("failed", "app_silent")


def test_an_app_that_is_killed_leaves_no_robot_driving(driving: Driving) -> None:
    engine = driving.engine()
    killed_s = time.monotonic()
    driving.app.kill()
    assert stopping_time_s(driving.log, killed_s) < MAX_STOPPING_TIME_S
    engine.wait(timeout=10)


def test_an_engine_that_is_told_to_end_stops_the_robot_first(driving: Driving) -> None:
    engine = driving.engine()
    terminated_s = time.monotonic()
    engine.send_signal(signal.SIGTERM)
    assert stopping_time_s(driving.log, terminated_s) < MAX_STOPPING_TIME_S
    assert driving.ended()["state"] == "stopped"


def test_an_app_that_closes_stops_the_robot_first(driving: Driving) -> None:
    closed_s = time.monotonic()
    assert driving.app.stdin is not None
    driving.app.stdin.close()
    assert stopping_time_s(driving.log, closed_s) < MAX_STOPPING_TIME_S
    driving.app.wait(timeout=10)


@pytest.mark.skipif(os.name == "nt", reason="Windows ends a process without a signal")
def test_an_engine_that_is_killed_is_told_and_the_robot_has_its_own_watchdog(
    driving: Driving,
) -> None:
    engine = driving.engine()
    engine.kill()
    engine.wait(timeout=10)
    ended = driving.ended()
    assert (ended["state"], ended["reason"]) == ("failed", "real_engine_lost")


def test_stop_at_an_engine_that_is_frozen_is_not_told_as_done(tmp_path: Path) -> None:
    log, events = tmp_path / "heard", queue.Queue[dict[str, Any]]()
    client = EngineClient(events.put, engine_command(log))
    client.start()
    assert client.wait_until_ready(30.0)
    client.run("r1", FAR)
    wait_until_driving(log)
    psutil.Process(client.pid).suspend()
    with pytest.raises(PinelError, match="real_stop_unconfirmed"):
        client.command("r1", Stop())
    while (ended := events.get(timeout=30))["type"] != "run_ended":
        pass
    client.close()
    assert (ended["state"], ended["reason"]) == ("failed", "real_engine_lost")


def test_contact_tells_where_the_robot_is_and_leaves_it_standing(tmp_path: Path) -> None:
    log, events = tmp_path / "heard", queue.Queue[dict[str, Any]]()
    client = EngineClient(events.put, engine_command(log))
    client.start()
    assert client.wait_until_ready(30.0)
    assert FAR.robot is not None
    found = client.contact(FAR.robot)
    client.close()
    assert (found["x_m"], found["y_m"], found["battery"]) == (0.0, 0.0, None)
    assert found["rate_hz"] > 10.0
    assert {v for _, v in received(log)} == {0.0}


def test_contact_is_refused_while_a_run_drives(tmp_path: Path) -> None:
    log, events = tmp_path / "heard", queue.Queue[dict[str, Any]]()
    client = EngineClient(events.put, engine_command(log))
    client.start()
    assert client.wait_until_ready(30.0)
    client.run("r1", FAR)
    assert FAR.robot is not None
    with pytest.raises(PinelError, match="run_in_progress"):
        client.contact(FAR.robot)
    client.close()
