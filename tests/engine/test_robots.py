"""A real robot outside of runs: watched, moved by held keys, let go; real processes, a robot in memory."""

import contextlib
import os
import queue
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.errors import PinelError
from tests.engine.memory_robot import FAR, engine_command
from tests.engine.test_real_robot import MAX_STOPPING_TIME_S, received, stopping_time_s

pytestmark = pytest.mark.waits

SOON_S = 30.0
SLOW_MPS = 0.15


class Teacher:
    """An engine, and the states that it tells."""

    def __init__(self, log: Path) -> None:
        assert FAR.robot is not None
        self.log, self.robot = log, FAR.robot
        self.events, self.states = queue.Queue[Any](), queue.Queue[dict[str, Any]]()
        self.client = EngineClient(self.events.put, engine_command(log), on_robot=self.states.put)
        self.client.start()
        assert self.client.wait_until_ready(SOON_S)

    def watch_until(self, is_it: Callable[[dict[str, Any]], bool]) -> Any:
        """Renews the watch, as a page does, until such a state is told."""
        return self._until(is_it, lambda: self.client.watch(self.robot))

    def hold_until(self, is_it: Callable[[dict[str, Any]], bool], drive: float = 1.0) -> Any:
        """Holds a key, ten times a second, until such a state is told."""
        return self._until(is_it, lambda: self.hold(drive))

    def hold(self, drive: float = 1.0) -> None:
        self.client.watch(self.robot)
        self.client.jog(self.robot, drive, 0.0, time.time())

    def _until(self, is_it: Callable[[dict[str, Any]], bool], ask: Callable[[], None]) -> Any:
        due_s = time.monotonic() + SOON_S
        while time.monotonic() < due_s:
            ask()
            with contextlib.suppress(queue.Empty):
                while not is_it(state := self.states.get(timeout=0.1)):
                    pass
                return state
        raise AssertionError("such a state was not told")

    def drive_until_moving(self) -> None:
        n_received = len(received(self.log))
        self.hold_until(lambda state: state["use"] == "jog" and state["state"] == "connected")
        due_s = time.monotonic() + SOON_S
        while not any(v for _, v in received(self.log)[n_received:]):
            assert time.monotonic() < due_s, "the robot does not move"
            self.hold()
            time.sleep(0.05)


def is_connected(state: dict[str, Any]) -> bool:
    return bool(state["state"] == "connected" and state["use"] == "watch")


@pytest.fixture
def teacher(tmp_path: Path) -> Iterator[Teacher]:
    it = Teacher(tmp_path / "heard")
    yield it
    it.client.close()


def test_watched_robot_is_told_of_and_hears_nothing(teacher: Teacher) -> None:
    state = teacher.watch_until(lambda state: is_connected(state) and state["rate_hz"])
    assert (state["x_m"], state["y_m"], state["code"]) == (0.0, 0.0, None)
    assert state["rate_hz"] > 10.0
    assert received(teacher.log) == []


def test_run_takes_the_watched_robot_and_gives_it_back(teacher: Teacher) -> None:
    teacher.watch_until(is_connected)
    teacher.client.run("r1", FAR)
    teacher.watch_until(lambda state: state["use"] == "run" and state["state"] == "connected")
    with pytest.raises(PinelError, match="run_in_progress"):
        teacher.hold()
    teacher.client.command("r1", _stop())
    teacher.watch_until(is_connected)


def _stop() -> Any:
    from pinel_desktop.engine.commands import Stop  # noqa: PLC0415 - heavy

    return Stop()


def test_held_key_moves_slowly_and_a_key_that_is_let_go_stops(teacher: Teacher) -> None:
    teacher.drive_until_moving()
    assert 0.0 < max(v for _, v in received(teacher.log)) <= SLOW_MPS
    let_go_s = time.monotonic()
    teacher.client.jog(teacher.robot, 0.0, 0.0, time.time())
    assert stopping_time_s(teacher.log, let_go_s) < MAX_STOPPING_TIME_S
    state = teacher.watch_until(is_connected)  # let go by itself
    assert state["x_m"] > 0.0


def test_silence_of_the_page_stops(teacher: Teacher) -> None:
    teacher.drive_until_moving()
    last_hold_s = time.monotonic()
    assert stopping_time_s(teacher.log, last_hold_s) < MAX_STOPPING_TIME_S


def test_command_that_was_long_on_its_way_moves_nothing(teacher: Teacher) -> None:
    teacher.drive_until_moving()
    teacher.client.jog(teacher.robot, 0.0, 0.0, time.time())
    time.sleep(0.5)
    n_received = len(received(teacher.log))
    teacher.client.jog(teacher.robot, 1.0, 0.0, time.time() - 1.0)
    time.sleep(0.5)
    velocities = [v for _, v in received(teacher.log)[n_received:]]
    assert velocities
    assert not any(velocities)


def test_emergency_stop_ends_a_key_that_is_still_held(teacher: Teacher) -> None:
    teacher.drive_until_moving()
    halted_s = time.monotonic()
    teacher.client.halt(teacher.robot)
    until_s = halted_s + 1.0
    while time.monotonic() < until_s:
        teacher.hold()
        time.sleep(0.1)
    assert stopping_time_s(teacher.log, halted_s) < MAX_STOPPING_TIME_S
    teacher.drive_until_moving()  # pressed anew


def test_run_does_not_begin_while_a_key_is_held_and_takes_the_robot_soon_after(
    teacher: Teacher,
) -> None:
    teacher.drive_until_moving()
    teacher.hold()
    with pytest.raises(PinelError, match="robot_held_by_keys"):
        teacher.client.run("r1", FAR)
    time.sleep(0.6)
    teacher.client.run("r1", FAR)
    teacher.watch_until(lambda state: state["use"] == "run" and state["state"] == "connected")
    assert teacher.client.live_run == "r1"


def test_place_is_counted_from_where_somebody_said_that_it_stands_at_the_start(
    teacher: Teacher,
) -> None:
    teacher.drive_until_moving()
    teacher.client.jog(teacher.robot, 0.0, 0.0, time.time())
    moved = teacher.watch_until(lambda state: is_connected(state) and state["x_m"] > 0.0)
    teacher.client.set_start_here(teacher.robot)
    state = teacher.watch_until(lambda state: is_connected(state) and state != moved)
    assert (state["x_m"], state["y_m"]) == (0.0, 0.0)


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="Windows has no SIGSTOP")
@pytest.mark.parametrize("how", ["SIGSTOP", "SIGKILL"])
def test_frozen_or_killed_app_leaves_no_robot_moving_by_keys(tmp_path: Path, how: str) -> None:
    log = tmp_path / "heard"
    app = subprocess.Popen(
        [sys.executable, "-m", "tests.engine.memory_robot", "jog", str(log)],
        stdin=subprocess.PIPE,
    )
    with app:
        due_s = time.monotonic() + SOON_S
        while not any(v for _, v in received(log)):
            assert time.monotonic() < due_s, "the robot does not move"
            time.sleep(0.02)
        engines = psutil.Process(app.pid).children()
        signalled_s = time.monotonic()
        os.kill(app.pid, getattr(signal, how))
        assert stopping_time_s(log, signalled_s) < MAX_STOPPING_TIME_S
        app.kill()
        psutil.wait_procs(engines, timeout=10)
