"""Memory of all processes (proportional set size, PSS), beside a bare pywebview window with the same editor.

The bare window is that of bench_startup. PSS counts a page that processes share in equal parts, so the sum over all
processes is what the PC lacks for others.
"""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import psutil
import pytest

from pinel_desktop.desktop.screen import virtual_screen
from pinel_desktop.desktop.self_check import Client, show_signs
from pinel_desktop.paths import DATABASE_NAME
from tests.benchmarks.bench_startup import BARE_PAGE, HERE, build_bare_page, make_database

# the engine has started, and the page has loaded what it loads after the first drawing
REST_S = 15.0
PERIOD_S = 0.5
MAX_IDLE_RATIO = 1.25
_OWN = ("engine", "camera", "judge", "app")  # subcommands


class RunningWindow:
    """A window that stays open, with its processes.

    Attributes:
        address: what the program printed in its second line; "" for the bare window.
    """

    def __init__(self, process: "subprocess.Popen[str]", *, has_address: bool) -> None:
        assert process.stdout is not None
        self._root = psutil.Process(process.pid)
        assert process.stdout.readline(), "the window did not open"
        self.address = process.stdout.readline().strip() if has_address else ""

    def memory_mb(self) -> dict[str, float]:
        """Returns the PSS of each process by its name, in MB."""
        sizes: dict[str, float] = {}
        for process in [self._root, *self._root.children(recursive=True)]:
            try:
                name, size = _name(process), process.memory_full_info().pss / 2**20
            except psutil.Error:  # it has just ended
                continue
            sizes[name] = sizes.get(name, 0.0) + size
        return sizes


def _name(process: psutil.Process) -> str:
    arguments = process.cmdline()
    own = [one for one in arguments if one in _OWN]
    if own:
        return own[0]
    return process.name() if "WebKit" in process.name() else "window"


@contextmanager
def opened(
    display: str, home: Path, *arguments: str, has_address: bool = False
) -> Iterator[RunningWindow]:
    environment = os.environ | {"DISPLAY": display, "PINEL_HOME": str(home)}
    with subprocess.Popen(
        [sys.executable, *arguments],
        env=environment,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            yield RunningWindow(process, has_address=has_address)
            assert process.stdin is not None
            process.stdin.close()
            process.wait(60)
        finally:
            process.kill()


def peak_mb(window: RunningWindow, stop: threading.Event) -> dict[str, float]:
    """Samples until `stop`; returns the sample with the largest sum."""
    peak: dict[str, float] = {}
    while not stop.wait(PERIOD_S):
        now = window.memory_mb()
        if sum(now.values()) > sum(peak.values()):
            peak = now
    return peak


def in_a_capture(window: RunningWindow, program: str) -> dict[str, float]:
    """Runs a program that waits for two recorded signs; returns its peak."""
    over, signs = threading.Event(), list[str]()

    def work() -> None:
        try:
            signs.extend(show_signs(Client(window.address), program))
        finally:
            over.set()

    worker = threading.Thread(target=work)
    worker.start()
    peak = peak_mb(window, over)
    worker.join()
    assert signs == ["B", "A"]
    return peak


def told(what: str, sizes: dict[str, float], bare_mb: float) -> str:
    total = sum(sizes.values())
    parts = ", ".join(f"{name} {size:.0f}" for name, size in sorted(sizes.items()))
    return f"{what} {total:.0f} MB, ratio {total / bare_mb:.2f} ({parts})"


@pytest.mark.skipif(sys.platform != "linux", reason="measured with GTK under Xvfb")
def test_an_idle_program_takes_at_most_1_25_times_the_memory_of_a_bare_window(
    tmp_path: Path,
) -> None:
    build_bare_page()
    program = make_database(tmp_path / DATABASE_NAME)
    with virtual_screen() as display:
        with opened(display, tmp_path, str(HERE / "window_bare.py"), str(BARE_PAGE)) as window:
            time.sleep(REST_S)
            bare = window.memory_mb()
        with opened(
            display, tmp_path, str(HERE / "window_app.py"), program, has_address=True
        ) as window:
            time.sleep(REST_S)
            idle = window.memory_mb()
            capture = in_a_capture(window, program)
    bare_mb = sum(bare.values())
    print()
    print(told("bare window", bare, bare_mb))
    print(told("idle", idle, bare_mb))
    print(told("in a capture", capture, bare_mb))
    assert sum(idle.values()) <= MAX_IDLE_RATIO * bare_mb
