"""What runs jobs on this machine: processes of a pool. A cluster maps `run_job` over the same jobs."""

import os
from collections.abc import Iterable, Iterator
from dataclasses import replace

from pinel_desktop.processes.pool import ProcessDied, ProcessPool
from pinel_desktop.sweep.jobs import Job, run_job
from pinel_desktop.sweep.rows import LOST, Row

ATTEMPTS = 2  # a job whose process was killed is tried once more


def new_pool(n_workers: int) -> ProcessPool[Job, Row]:
    """Returns a pool whose processes run jobs."""
    return ProcessPool(run_job, n_workers, ATTEMPTS)


def run_jobs(jobs: Iterable[Job], n_workers: int | None = None) -> Iterator[Row]:
    """Runs jobs on processes of this machine; yields rows in order of completion.

    Closing the generator ends the processes.

    Args:
        n_workers: number of processes; None is one per core. With 1, the jobs run in this process.
    """
    n_workers = n_workers or os.cpu_count() or 1
    if n_workers == 1:
        yield from map(run_job, jobs)
        return
    pool = new_pool(n_workers)
    try:
        yield from rows_of(pool, jobs)
    finally:
        pool.end()


def rows_of(pool: ProcessPool[Job, Row], jobs: Iterable[Job]) -> Iterator[Row]:
    """Runs jobs on a pool; yields rows in order of completion.

    A job that kills its processes has a row that says so.
    """
    for job, result in pool.results(jobs):
        yield lost_row(job, result.exit_code) if isinstance(result, ProcessDied) else result


def lost_row(job: Job, exit_code: int | None) -> Row:
    """Returns the row of a job whose process has died."""
    params = {"value": exit_code}
    row = Row(job.index, job.program, job.world, job.seed, reason=LOST, params=params)
    return replace(row, cause="failure")
