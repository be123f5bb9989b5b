"""What runs many independent tasks: this process, processes of this machine, or a cluster."""

import os
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from pinel_desktop.processes.pool import ProcessDied, ProcessPool

if TYPE_CHECKING:
    from pinel_desktop.processes.cluster import Cluster

T = TypeVar("T")
R = TypeVar("R")


class Workers(NamedTuple):
    """A choice of workers.

    Attributes:
        n: number of processes of this machine; None is one per core. With 1, tasks run in this process.
        cluster: address of a Dask scheduler, which has workers of its own; None for processes of this machine.
    """

    n: int | None = None
    cluster: str | None = None


def results_of(
    function: Callable[[T], R], tasks: Iterable[T], workers: Workers, *, attempts: int = 1
) -> Iterator[tuple[T, R | ProcessDied]]:
    """Yields each task with its result, in order of completion. Closing the generator ends the workers' tasks.

    Args:
        function: a function of a module, called with each task; it never raises.
        attempts: how often a process may die with the same task; a cluster has its own limit.

    Raises:
        PinelError: what `Cluster` raises.
    """
    n_processes = workers.n or os.cpu_count() or 1
    if workers.cluster is None and n_processes == 1:
        yield from ((task, function(task)) for task in tasks)
        return
    pool = _pool(function, workers, n_processes, attempts)
    try:
        yield from pool.results(tasks)
    finally:
        pool.end()


def _pool(
    function: Callable[[T], R], workers: Workers, n_processes: int, attempts: int
) -> "ProcessPool[T, R] | Cluster[T, R]":
    if workers.cluster is None:
        return ProcessPool(function, n_processes, attempts)
    from pinel_desktop.processes.cluster import Cluster  # noqa: PLC0415 - seldom used

    return Cluster(function, workers.cluster)
