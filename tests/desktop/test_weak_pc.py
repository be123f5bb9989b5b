"""A weak PC: 2 GB of memory, one core, no WebGL, a screen of 1024 x 600."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.desktop.screen import virtual_screen
from pinel_desktop.desktop.self_check import EXPECTED_SIGNS, MAX_CLOSING_ERROR_M
from tests.desktop.memory_limit import MemoryGroup, memory_limit

PROBE = Path(__file__).with_name("weak_pc_probe.py")
MEMORY_BYTES = 2 * 2**30
SCREEN = (1024, 600)
_WITHIN_S = 800


@pytest.mark.skipif(sys.platform != "linux", reason="the limits are Linux's")
def test_group_at_the_limit_loses_a_process() -> None:
    with memory_limit(64 * 2**20) as group:
        done = subprocess.run(
            group.command(sys.executable, "-c", "bytearray(200 * 2**20)"), check=False
        )
        assert done.returncode != 0
        assert group.n_killed == 1


@pytest.mark.nightly
@pytest.mark.timeout(_WITHIN_S + 60)
@pytest.mark.skipif(sys.platform != "linux", reason="the limits are Linux's")
def test_mission_capture_and_replay_on_a_weak_pc(tmp_path: Path) -> None:
    with virtual_screen(*SCREEN) as display, memory_limit(MEMORY_BYTES) as group:
        found = probed(group, display, tmp_path)
        peak_mb, n_killed = group.peak_bytes / 2**20, group.n_killed
    print(f"\npeak {peak_mb:.0f} MB of {MEMORY_BYTES / 2**20:.0f}, {found}")
    assert "error" not in found, found
    assert n_killed == 0
    assert found["webgl"] is False
    assert tuple(found["size"]) == SCREEN
    run = found["run"]
    assert (run["state"], run["passed"]) == ("finished", True)
    assert run["closing_error_m"] <= MAX_CLOSING_ERROR_M
    assert run["duration_s"] <= 17
    assert set(found["signs"]) == set(EXPECTED_SIGNS)
    assert peak_mb < MEMORY_BYTES / 2**20 / 2  # the other half is the desktop's


def probed(group: MemoryGroup, display: str, home: Path) -> dict[str, Any]:
    """Runs the probe on one core in the group; returns what it printed."""
    core = str(min(os.sched_getaffinity(0)))
    done = subprocess.run(
        group.command("taskset", "-c", core, sys.executable, str(PROBE), str(home / "pinel.db")),
        env=os.environ | {"DISPLAY": display, "PINEL_HOME": str(home)},
        capture_output=True,
        text=True,
        timeout=_WITHIN_S,
        check=False,
    )
    assert done.stdout, done.stderr
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found
