"""The lock on a robot: one process has it, whatever happens at the moment when another lets go, and no file stays."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.links.robot_lock import RobotLock
from pinel_desktop.robot.robot_profile import BridgeProfile

pytestmark = pytest.mark.waits

RECORD = BridgeProfile(host="robot-lock-test")
WAIT_S = 60.0
HOLD = """
import sys
from pinel_desktop.links.robot_lock import RobotLock
from pinel_desktop.robot.robot_profile import BridgeProfile
lock = RobotLock(BridgeProfile(host="robot-lock-test"))
lock.acquire()
print("locked", flush=True)
sys.stdin.read()
"""
# Each takes the lock so many times; a file beside it is there while somebody has it, and must not be there already.
RACE = """
import os, sys
from pinel_desktop.errors import PinelError
from pinel_desktop.links.robot_lock import RobotLock
from pinel_desktop.robot.robot_profile import BridgeProfile
n_left = 150
while n_left:
    lock = RobotLock(BridgeProfile(host="robot-lock-test"))
    try:
        lock.acquire()
    except PinelError:
        continue
    os.close(os.open("driver", os.O_CREAT | os.O_EXCL))
    os.unlink("driver")
    lock.release()
    n_left -= 1
"""


@pytest.fixture(autouse=True)
def folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    return tmp_path


def start(code: str, folder: Path) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-c", code],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
    )


def require_locked() -> None:
    with pytest.raises(PinelError, match="robot_busy_here"):
        RobotLock(RECORD).acquire()


def test_the_file_is_there_only_while_the_robot_is_driven(folder: Path) -> None:
    lock = RobotLock(RECORD)
    assert list(folder.iterdir()) == []
    lock.acquire()
    assert len(list(folder.iterdir())) == 1
    lock.release()
    lock.release()
    assert list(folder.iterdir()) == []


def test_who_was_refused_leaves_the_file_to_who_drives(folder: Path) -> None:
    first, second = RobotLock(RECORD), RobotLock(RECORD)
    first.acquire()
    with pytest.raises(PinelError, match="robot_busy_here"):
        second.acquire()
    second.release()
    require_locked()
    first.release()
    second.acquire()
    second.release()
    assert list(folder.iterdir()) == []


def test_a_file_that_a_crash_left_is_no_obstacle_and_removed_by_the_next(folder: Path) -> None:
    with start(HOLD, folder) as crashing:
        assert crashing.stdout is not None
        assert crashing.stdout.readline() == "locked\n"
        require_locked()
        crashing.kill()
    assert len(list(folder.iterdir())) == 1
    lock = RobotLock(RECORD)
    lock.acquire()
    lock.release()
    assert list(folder.iterdir()) == []


def test_a_file_that_is_removed_between_opening_and_locking_is_not_what_is_locked(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As when the one who drove lets go at this very moment."""
    fcntl = pytest.importorskip("fcntl")
    flock, n_removed = fcntl.flock, 0

    def lock_too_late(descriptor: int, operation: int) -> Any:
        nonlocal n_removed
        if operation & fcntl.LOCK_EX and n_removed < 2:
            n_removed += 1
            for file in folder.iterdir():
                file.unlink()
        return flock(descriptor, operation)

    lock = RobotLock(RECORD)
    with monkeypatch.context() as racing:
        racing.setattr(fcntl, "flock", lock_too_late)
        lock.acquire()
    assert n_removed == 2
    require_locked()
    lock.release()


def test_of_many_processes_that_lock_and_let_go_one_has_it_at_a_time(folder: Path) -> None:
    racing = [start(RACE, folder) for _ in range(4)]
    for each in racing:
        with each:
            assert each.wait(WAIT_S) == 0
    assert list(folder.iterdir()) == []
