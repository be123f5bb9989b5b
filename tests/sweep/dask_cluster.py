"""A Dask cluster of separate processes on the loopback interface, for tests and benchmarks."""

import contextlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

_START_S = 60.0
# the workers of a test are quiet, and find its modules
_ENVIRONMENT = {"DASK_DISTRIBUTED__LOGGING__DISTRIBUTED": "critical", "PYTHONPATH": os.getcwd()}
# without an address, the server of the dashboard that is off listens on all networks
_NO_PAGE = ("--no-dashboard", "--dashboard-address", "127.0.0.1:0")
_WORKER = "from distributed.cli.dask_worker import main; main()"


class DaskCluster(SimpleNamespace):
    """A scheduler and its workers.

    Attributes:
        address: of the scheduler.
        scheduler, workers: their processes.
    """

    address: str
    scheduler: subprocess.Popen[bytes]
    workers: list[subprocess.Popen[bytes]]

    @property
    def processes(self) -> list[subprocess.Popen[bytes]]:
        return [self.scheduler, *self.workers]

    def kill_a_worker(self) -> None:
        worker = self.workers.pop()
        worker.kill()
        worker.wait()


@contextlib.contextmanager
def dask_cluster(folder: Path, n_workers: int, *, before: str = "") -> Iterator[DaskCluster]:
    """Starts a cluster without a dashboard.

    Args:
        folder: for the scheduler's file.
        before: code that each worker runs first.
    """
    file = folder / "scheduler.json"
    scheduler = _python(
        "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0",
        *_NO_PAGE, "--scheduler-file", str(file),
    )  # fmt: skip
    workers: list[subprocess.Popen[bytes]] = []
    try:
        address = _address(file)
        workers += (
            _python(
                "-c", f"{before}\n{_WORKER}", address, "--host", "127.0.0.1", "--nthreads", "1",
                *_NO_PAGE, "--no-nanny", "--local-directory", str(folder),
            )
            for _ in range(n_workers)
        )  # fmt: skip
        yield DaskCluster(address=address, scheduler=scheduler, workers=workers)
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()


def _python(*arguments: str) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, *arguments],
        env={**os.environ, **_ENVIRONMENT},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def _address(file: Path) -> str:
    deadline = time.monotonic() + _START_S
    while time.monotonic() < deadline:
        with contextlib.suppress(OSError, ValueError):  # the file is not complete
            address: str = json.loads(file.read_text("utf-8"))["address"]
            return address
        time.sleep(0.05)
    raise TimeoutError("the scheduler did not start")
