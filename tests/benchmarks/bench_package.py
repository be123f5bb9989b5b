"""Start and memory of the package beside a bare pywebview window, and its start beside the source folder.

The program is dist/pinel-desktop/pinel, or the one that PINEL_PACKAGE names, such as an installed /usr/bin/pinel.
It has nothing that helps to measure. So a start is over when the screen shows the block, and ours the Run button, in
their colours. It is opened as the watchdog of kiosk mode does, because that names a program. Captures are those of its
self-check.
"""

import mmap
import os
import statistics
import struct
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import psutil
import pytest

from pinel_desktop.paths import DATABASE_NAME
from tests.benchmarks.bench_memory import MAX_IDLE_RATIO, memory_mb, peak_mb, text_of
from tests.benchmarks.bench_memory import REST_S as IDLE_AFTER_S
from tests.benchmarks.bench_startup import (
    BARE_PAGE,
    HERE,
    MAX_RATIO,
    REST_S,
    ROOT,
    build_bare_page,
    make_database,
)

PACKAGE = os.environ.get("PINEL_PACKAGE") or str(ROOT / "dist" / "pinel-desktop" / "pinel")
N_STARTS = 10
MAX_SOURCE_RATIO = 1.1
N_MEMORY = 3
_SOURCE = (sys.executable, "-m", "pinel_desktop")
_BARE = (sys.executable, str(HERE / "window_bare.py"), str(BARE_PAGE))
# pixels of a colour once it is drawn: the block "quando rodar", the Run button
_BLOCK, _RUN = {0x5B5446: 5_000}, {0x0A7A60: 10_000}
_PERIOD_S = 0.01
_TIMEOUT_S = 120.0

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="measured with GTK under Xvfb"),
    pytest.mark.skipif(not Path(PACKAGE).is_file(), reason="there is no package: make package"),
]


class Screen:
    """A virtual screen that writes its picture to a file."""

    def __init__(self, name: str, file: Path) -> None:
        self.name = name
        with file.open("rb") as opened:
            self._mapped = mmap.mmap(opened.fileno(), 0, prot=mmap.PROT_READ)
        header = self._mapped[:100]  # of the format XWD
        start = struct.unpack_from(">I", header)[0] + 12 * struct.unpack_from(">I", header, 76)[0]
        self._pixels = np.frombuffer(self._mapped, "<u4", offset=start)

    def shows(self, colours: Mapping[int, int]) -> bool:
        """Whether each colour has so many pixels."""
        pixels = self._pixels & 0xFFFFFF
        return all(np.count_nonzero(pixels == one) >= least for one, least in colours.items())


@contextmanager
def screen(folder: Path) -> Iterator[Screen]:
    reading, writing = os.pipe()
    options = ("-displayfd", str(writing), "-screen", "0", "1366x768x24", "-fbdir", str(folder))
    command = ["Xvfb", *options, "-nolisten", "tcp"]
    with subprocess.Popen(command, pass_fds=[writing], stderr=subprocess.DEVNULL) as process:
        os.close(writing)
        try:
            with os.fdopen(reading) as answer:
                name = f":{answer.readline().strip()}"
            yield Screen(name, folder / "Xvfb_screen0")
        finally:
            process.terminate()


@contextmanager
def opened(
    shown: Screen, home: Path, colours: Mapping[int, int], *command: str
) -> Iterator[tuple[psutil.Process, float]]:
    """Opens a window; yields its process, and the seconds until it had drawn the colours."""
    environment = os.environ | {"DISPLAY": shown.name, "PINEL_HOME": str(home)}
    environment |= {"PINEL_LANG": "pt-BR", "PYTHONDONTWRITEBYTECODE": ""}
    assert not shown.shows(colours)
    started = time.monotonic()
    with subprocess.Popen(
        command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL
    ) as process:
        while not shown.shows(colours):
            assert process.poll() is None, "it has ended"
            assert time.monotonic() < started + _TIMEOUT_S, "it has drawn nothing"
            time.sleep(_PERIOD_S)
        seconds = time.monotonic() - started
        root = psutil.Process(process.pid)
        yield root, seconds
        family = root.children(recursive=True)
        process.terminate()
        process.wait(60)
    psutil.wait_procs(family, 20)


def ours(database: Path, program: str) -> tuple[str, ...]:
    place = f"/program/{program}"
    return (PACKAGE, "--db", str(database), "kiosk", "--reason", "command", "--place", place)


def test_the_package_starts_in_at_most_1_3_times_the_time_of_a_bare_window(tmp_path: Path) -> None:
    build_bare_page()
    database = tmp_path / DATABASE_NAME
    arguments = ours(database, make_database(database))[1:]
    windows = {
        "bare window": (_BLOCK, _BARE),
        "source folder": (_BLOCK | _RUN, (*_SOURCE, *arguments)),
        "package": (_BLOCK | _RUN, (PACKAGE, *arguments)),
    }
    times: dict[str, list[float]] = {name: [] for name in windows}
    with screen(tmp_path) as shown:
        for one in range(N_STARTS + 1):
            for name in sorted(windows, reverse=one % 2 == 0):
                time.sleep(REST_S)
                colours, command = windows[name]
                with opened(shown, tmp_path, colours, *command) as (_, seconds):
                    times[name].append(seconds)
    print(f"\nstart to usable workspace, median of {N_STARTS}; load {os.getloadavg()[0]:.1f}")
    medians = dict[str, float]()
    for name, all_of_it in times.items():
        rest = all_of_it[1:]  # the first reads everything from the disk
        medians[name] = statistics.median(rest)
        print(f"{name}: {medians[name]:.2f} s ({min(rest):.2f} to {max(rest):.2f})")
    to_bare = medians["package"] / medians["bare window"]
    to_source = medians["package"] / medians["source folder"]
    print(f"package: {to_bare:.2f} times the bare window, {to_source:.2f} times the source folder")
    assert to_bare <= MAX_RATIO
    assert to_source <= MAX_SOURCE_RATIO


def test_an_idle_package_takes_at_most_1_25_times_the_memory_of_a_bare_window(
    tmp_path: Path,
) -> None:
    build_bare_page()
    database = tmp_path / DATABASE_NAME
    command = ours(database, make_database(database))
    ratios = list[float]()
    print()
    with screen(tmp_path) as shown:
        for _ in range(N_MEMORY):
            with opened(shown, tmp_path, _BLOCK, *_BARE) as (window, _):
                time.sleep(IDLE_AFTER_S)
                bare = memory_mb(window)
            with opened(shown, tmp_path, _BLOCK | _RUN, *command) as (window, _):
                time.sleep(IDLE_AFTER_S)
                idle = memory_mb(window)
            ratios.append(sum(idle.values()) / sum(bare.values()))
            print(f"bare window {text_of(bare)}\npackage, idle {text_of(idle)}")
        print(f"package, in captures and judging: {text_of(in_captures(shown))}")
    ratio = statistics.median(ratios)
    print(f"median of {N_MEMORY}: idle {ratio:.2f} times the bare window, at most {MAX_IDLE_RATIO}")
    assert ratio <= MAX_IDLE_RATIO


def in_captures(shown: Screen) -> dict[str, float]:
    """Returns the peak of the package's self-check."""
    environment = os.environ | {"DISPLAY": shown.name}
    pipe = subprocess.PIPE
    with subprocess.Popen([PACKAGE, "--self-check"], env=environment, stdout=pipe) as check:
        root = psutil.Process(check.pid)

        def is_over(seconds: float) -> bool:
            time.sleep(seconds)
            return check.poll() is not None

        peak = peak_mb(lambda: memory_mb(root), is_over)
    assert check.returncode == 0
    return peak
