"""`pinel serve --bridge ... --robot bridge` as a process: AuRoRA is the robot of /execute, on one port."""

import contextlib
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.links.aurora import Aurora, free_port
from tests.test_app_legacy import CORNER, FAR, SIDE, WAIT_S, Bridged, Client, until

pytestmark = pytest.mark.waits

# 0.3 s on a PC at rest, measured by tests/benchmarks/bench_robot_stops.py; other tests may keep this one busy
STANDSTILL_WITHIN_S = 1.5


class Served:
    """The process, AuRoRA beside it, and a client."""

    def __init__(self, home: Path) -> None:
        port = free_port()
        self.aurora = Aurora(port)  # before anybody listens
        self.app = subprocess.Popen(
            [
                *(sys.executable, "-m", "pinel_desktop", "serve"),
                *("--bridge", f"127.0.0.1:{port}", "--robot", "bridge"),
            ],
            env={**os.environ, "PINEL_HOME": str(home), "LANG": "en_US.UTF-8"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.address = f"http://127.0.0.1:{port}"
        self.client = Client(self.address)

    def address_line(self) -> str:
        """The line that says where the bridge stands."""
        assert self.app.stderr is not None
        return next(line for line in self.app.stderr if self.address in line)

    def close(self) -> None:
        with contextlib.suppress(ProcessLookupError):
            self.app.send_signal(signal.SIGCONT)
        self.app.terminate()
        self.app.communicate(timeout=WAIT_S)
        self.aurora.close()


@pytest.fixture
def served(tmp_path: Path) -> Iterator[Served]:
    it = Served(tmp_path)
    yield it
    it.close()


def test_aurora_drives_a_corner_in_calls_and_stands_when_the_app_freezes(served: Served) -> None:
    assert "robot here: bridge" in served.address_line()
    for one in (SIDE, CORNER):
        assert served.client.execute(one) == {"status": "ok", "n_executed": 1}
    assert max(twist.v_mps for _, twist in served.aurora.received) > 0.05
    assert min(twist.omega_radps for _, twist in served.aurora.received) < -0.5

    thread, answers = Bridged.in_background(lambda: served.client.post("/execute", FAR))
    n_received = len(served.aurora.received)
    until(lambda: any(twist.v_mps > 0.1 for _, twist in served.aurora.received[n_received:]))
    frozen_s = time.monotonic()
    served.app.send_signal(signal.SIGSTOP)
    until(lambda: (served.aurora.standstill_since_s() or 0.0) > frozen_s)
    standstill_s = served.aurora.standstill_since_s()
    assert standstill_s is not None
    assert standstill_s - frozen_s < STANDSTILL_WITHIN_S
    thread.join()
    ((status, answer),) = answers
    assert (status, answer["error"]["code"]) == (504, "bridge_app_silent")
    assert served.aurora.standstill_since_s() == standstill_s
