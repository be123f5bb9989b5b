"""`pinel sweep`, process and all: 1,000 squares, beside one process after another and beside Dask.

PINEL_SWEEP_RUNS makes fewer runs of it, for a try on a busy PC.
"""

import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.commands.typed import SQUARE
from tests.sweep.dask_cluster import DaskCluster, dask_cluster

N_RUNS = int(os.environ.get("PINEL_SWEEP_RUNS", "1000"))
MAX_S = 25.0 * N_RUNS / 1000
MIN_SPEEDUP = 1.8
MAX_DASK_RATIO = 1.3
N_PROCESSES = 4  # of the comparison with Dask


def sweep_s(out: Path, *options: str) -> float:
    """Returns how long a whole sweep of squares takes, from nothing to the end of the process."""
    command = [sys.executable, "-m", "pinel_desktop", "sweep", SQUARE, "--seeds", str(N_RUNS)]
    started = time.perf_counter()
    subprocess.run(
        [*command, "--out", str(out), *options],
        check=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    return time.perf_counter() - started


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[DaskCluster]:
    with dask_cluster(tmp_path, N_PROCESSES) as found:
        yield found


def test_a_thousand_squares_and_how_much_faster_than_one_process(tmp_path: Path) -> None:
    both = sweep_s(tmp_path / "both.csv")
    alone = sweep_s(tmp_path / "alone.csv", "--workers", "1")
    print(
        f"\n{N_RUNS} squares: {both:.1f} s on {os.cpu_count()} cores, {alone:.1f} s in one process "
        f"({alone / both:.2f} times faster, {1000 * both / N_RUNS:.1f} ms for each)"
    )
    assert (tmp_path / "both.csv").read_bytes() == (tmp_path / "alone.csv").read_bytes()
    if os.cpu_count() == 2:
        assert both <= MAX_S
        assert alone / both >= MIN_SPEEDUP


def test_dask_adds_little_to_each_run(tmp_path: Path, cluster: DaskCluster) -> None:
    sweep_s(tmp_path / "warm.csv", "--dask", cluster.address)  # its workers import the simulator
    dask = sweep_s(tmp_path / "dask.csv", "--dask", cluster.address)
    local = sweep_s(tmp_path / "local.csv", "--workers", str(N_PROCESSES))
    print(
        f"\n{N_RUNS} squares on {N_PROCESSES} processes: {local:.1f} s here, {dask:.1f} s by Dask"
    )
    print(
        f"  {dask / local:.2f} times as long, {1000 * (dask - local) / N_RUNS:+.2f} ms for each run"
    )
    assert (tmp_path / "dask.csv").read_bytes() == (tmp_path / "local.csv").read_bytes()
    assert dask <= MAX_DASK_RATIO * local
