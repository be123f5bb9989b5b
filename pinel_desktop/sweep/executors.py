"""What runs jobs: processes of this machine, or a cluster."""

from collections.abc import Generator, Iterable, Iterator
from dataclasses import replace

from pinel_desktop.processes.pool import ProcessDied, ProcessPool
from pinel_desktop.processes.workers import Workers, results_of
from pinel_desktop.sweep.jobs import Job, run_job
from pinel_desktop.sweep.rows import LOST, Row

ATTEMPTS = 2  # a job whose process was killed is tried once more
_ONE_PER_CORE = Workers()


def new_pool(n_workers: int) -> ProcessPool[Job, Row]:
    """Returns a pool whose processes run jobs."""
    return ProcessPool(run_job, n_workers, ATTEMPTS)


def run_jobs(jobs: Iterable[Job], workers: Workers = _ONE_PER_CORE) -> Generator[Row, None, None]:
    """Runs jobs; yields rows in order of completion.

    Closing the generator ends the processes of this machine.

    Raises:
        PinelError: a cluster cannot be used.
    """
    return _rows(results_of(run_job, jobs, workers, attempts=ATTEMPTS))


def rows_of(pool: ProcessPool[Job, Row], jobs: Iterable[Job]) -> Iterator[Row]:
    """Runs jobs on a pool; yields rows in order of completion.

    A job that kills its processes has a row that says so.
    """
    return _rows(pool.results(jobs))


def _rows(results: Iterator[tuple[Job, Row | ProcessDied]]) -> Generator[Row, None, None]:
    for job, result in results:
        yield lost_row(job, result.exit_code) if isinstance(result, ProcessDied) else result


def lost_row(job: Job, exit_code: int | None) -> Row:
    """Returns the row of a job whose process has died."""
    params = {"value": exit_code}
    row = Row(job.index, job.program, job.world, job.seed, reason=LOST, params=params)
    return replace(row, cause="failure")
