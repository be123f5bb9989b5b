"""A Dask cluster gives the rows that one process gives, and names what is wrong with it."""

import os
import signal
import socket
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import psutil
import pytest

from pinel_desktop.activities import check_files, choose_activity
from pinel_desktop.errors import PinelError
from pinel_desktop.processes import cluster
from pinel_desktop.processes.cluster import Cluster
from pinel_desktop.processes.pool import ProcessDied
from pinel_desktop.processes.versions import versions
from pinel_desktop.processes.workers import Workers
from pinel_desktop.sweep import Job, Row, run_jobs
from tests.commands.typed import pinel
from tests.sweep.dask_cluster import DaskCluster, dask_cluster
from tests.sweep.test_sweep import PROGRAMS, in_order, jobs_of

pytest.importorskip("distributed")
pytestmark = [pytest.mark.waits, pytest.mark.timeout(300)]


@pytest.fixture(scope="module")
def three(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DaskCluster]:
    """A cluster of three worker processes; tests may kill some, but not all."""
    with dask_cluster(tmp_path_factory.mktemp("dask"), 3) as found:
        with_all_workers(found)
        yield found


def with_all_workers(found: DaskCluster) -> None:
    connected = Cluster(run_nothing, found.address)
    try:
        connected._client.wait_for_workers(len(found.workers), timeout=60)
    finally:
        connected.end()


def run_nothing(job: object) -> None:
    """A task of tests."""


def refusal(address: str) -> PinelError:
    with pytest.raises(PinelError) as caught:
        list(run_jobs(jobs(1), Workers(cluster=address)))
    return caught.value


def jobs(n_seeds: int) -> list[Job]:
    return jobs_of("square", "empty_room", n_seeds)


def test_rows_are_the_same_in_one_process_in_four_and_on_a_cluster_that_loses_a_worker(
    three: DaskCluster,
) -> None:
    some = jobs(40)
    alone = in_order(run_jobs(some, Workers(1)))
    assert in_order(run_jobs(some, Workers(4))) == alone
    found: list[Row] = []
    for row in run_jobs(some, Workers(cluster=three.address)):
        found.append(row)
        if len(found) == 5:
            three.kill_a_worker()
    assert in_order(iter(found)) == alone


def test_programs_are_checked_on_a_cluster(three: DaskCluster) -> None:
    files = [str(PROGRAMS / f"{name}.json") for name in ("square", "triangle", "missing")]
    workers = Workers(cluster=three.address)
    reports = dict(check_files(choose_activity("square"), files, workers))
    assert [reports[i].passed for i in range(3)] == [True, False, False]
    assert reports[2].faults[0].code == "file_unreadable"
    here = dict(check_files(choose_activity("square"), files, Workers(1)))
    assert here == reports


def test_sweep_and_verification_give_the_same_on_a_cluster(
    three: DaskCluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path))
    square, here, there = (
        str(PROGRAMS / "square.json"),
        tmp_path / "here.csv",
        tmp_path / "there.csv",
    )
    sweep = ("sweep", square, "--seeds", "6", "--vary", "track_m=0.32:0.34")
    assert pinel(*sweep, "--workers", "1", "--out", str(here)).exit_code == 0
    assert pinel(*sweep, "--dask", three.address, "--out", str(there)).exit_code == 0
    assert here.read_bytes() == there.read_bytes()
    for seed in ("1", "2"):
        pinel("run", square, "--preset", "realistic", "--seed", seed)
    verify = ("runs", "verify", "--all", "--json")
    alone, many = (pinel(*verify, *on) for on in (("--workers", "1"), ("--dask", three.address)))
    assert (alone.exit_code, many.exit_code) == (0, 0)
    assert alone.stdout == many.stdout
    assert alone.stdout.count("identical") == 2


def test_closing_leaves_the_cluster_free_for_others(three: DaskCluster) -> None:
    rows = run_jobs(jobs(200), Workers(cluster=three.address))
    next(rows)
    rows.close()
    assert len(list(run_jobs(jobs(2), Workers(cluster=three.address)))) == 2


def test_no_port_is_opened_here_and_none_of_the_cluster_beyond_loopback(three: DaskCluster) -> None:
    connected = Cluster(run_nothing, three.address)
    try:
        here, *there = map(listening, [os.getpid(), *(one.pid for one in three.processes)])
    finally:
        connected.end()
    assert here == set()
    assert there == [{"127.0.0.1"}] * len(three.processes)


def listening(pid: int) -> set[str]:
    """Returns the addresses on which a process listens."""
    connections = psutil.Process(pid).net_connections()
    return {one.laddr.ip for one in connections if one.status == psutil.CONN_LISTEN}


@pytest.mark.parametrize("address", ["10.0.0.5", "tcp://host", "http://host:1", "tcp://host:x", ""])
def test_no_address_is_named(address: str) -> None:
    assert refusal(address).code == "cluster_address"


def test_cluster_that_does_not_exist_is_named_within_seconds() -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    started = time.monotonic()
    assert refusal(address).code == "cluster_unreachable"
    assert time.monotonic() - started < 20.0


def test_cluster_without_workers_is_named(tmp_path: Path) -> None:
    with dask_cluster(tmp_path, 0) as empty:
        assert refusal(empty.address).code == "cluster_without_workers"


def test_worker_of_another_release_is_refused_before_work(tmp_path: Path) -> None:
    other = "import pinel_desktop; pinel_desktop.__version__ = '0.0.1'"
    with dask_cluster(tmp_path, 1, before=other) as other_release:
        error = refusal(other_release.address)
    assert error.code == "cluster_other_version"
    assert (error.params["part"], error.params["found"]) == ("pinel", "0.0.1")
    assert str(error.params["worker"]).startswith("tcp://127.0.0.1:")


def test_worker_without_pinel_is_refused_before_work(tmp_path: Path) -> None:
    without = "import sys; sys.modules['pinel_desktop'] = None"
    with dask_cluster(tmp_path, 1, before=without) as other_release:
        error = refusal(other_release.address)
    assert (error.code, error.params["found"]) == ("cluster_other_version", "?")


def test_worker_of_another_release_that_joins_later_is_refused(
    three: DaskCluster,
) -> None:
    connected = Cluster(run_nothing, three.address)
    try:
        expected = {**versions(), "pymunk": "1.0"}
        connected._call = partial(cluster._call, run_nothing, expected)
        with pytest.raises(PinelError) as caught:
            list(connected.results([1]))
    finally:
        connected.end()
    assert (caught.value.code, caught.value.params["own"]) == ("cluster_other_version", "1.0")


def test_task_that_kills_its_workers_has_died_and_the_others_are_done(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES", "0")  # 3 by default
    with dask_cluster(tmp_path, 2) as brief:
        with_all_workers(brief)
        connected = Cluster(kill_this_worker, brief.address)
        try:
            assert list(connected.results(["kill"])) == [("kill", ProcessDied(None))]
            assert list(connected.results(["other"])) == [("other", "other")]
        finally:
            connected.end()


def test_of_a_batch_only_the_task_that_kills_its_workers_has_died(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES", "0")
    with dask_cluster(tmp_path, 4) as brief:
        with_all_workers(brief)
        connected = Cluster(kill_this_worker, brief.address)
        connected._batch_size = 3
        try:
            found = dict(connected.results(["a", "kill", "b"]))
        finally:
            connected.end()
    assert found == {"a": "a", "kill": ProcessDied(None), "b": "b"}


def test_short_tasks_come_in_batches_and_long_ones_alone() -> None:
    def size(each_s: float) -> int:
        return cluster._batch_size(cluster._Results([None] * 4, 4 * each_s))

    assert [size(each_s) for each_s in (0.0, 0.02, 0.1, 5.0)] == [16, 10, 2, 1]


def kill_this_worker(task: str) -> str:
    """A task of tests."""
    if task == "kill":
        os.kill(os.getpid(), signal.SIGKILL)
    return task


def test_defect_of_a_task_is_named(three: DaskCluster) -> None:
    connected = Cluster(fail, three.address)
    try:
        with pytest.raises(PinelError) as caught:
            list(connected.results([1, 2]))
    finally:
        connected.end()
    assert (caught.value.code, caught.value.params["detail"]) == ("cluster_failed", "ValueError: 1")


def fail(task: int) -> None:
    """A task of tests."""
    raise ValueError(1)


def test_cluster_that_loses_all_its_workers_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(cluster, "_RESULT_TIMEOUT_S", 2)
    with dask_cluster(tmp_path, 1) as brief:
        rows = run_jobs(jobs(400), Workers(cluster=brief.address))
        next(rows)
        brief.kill_a_worker()
        with pytest.raises(PinelError) as caught:
            list(rows)
    assert caught.value.code == "cluster_lost"


def test_cluster_whose_scheduler_ends_is_named(tmp_path: Path) -> None:
    with dask_cluster(tmp_path, 1) as brief:
        rows = run_jobs(jobs(400), Workers(cluster=brief.address))
        next(rows)
        brief.scheduler.kill()
        with pytest.raises(PinelError) as caught:
            list(rows)
    assert caught.value.code == "cluster_lost"
