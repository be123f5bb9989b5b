"""A Dask cluster for independent tasks, with the methods of `ProcessPool`. Dask schedules; nothing here does.

The cluster is started by whoever keeps it (docs/district.md). This process only connects to its scheduler, and listens
on no port.
"""

import logging
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, Any, Generic, TypeVar
from urllib.parse import urlsplit

from pinel_desktop.errors import PinelError
from pinel_desktop.processes.pool import ProcessDied
from pinel_desktop.processes.versions import versions

if TYPE_CHECKING:
    from distributed import Client, Future

T = TypeVar("T")
R = TypeVar("R")
_SCHEMES = ("tcp", "tls")
_CONNECT_S = 5  # until a cluster without scheduler or workers is named
_SILENT_S = 10  # without a result, until the cluster is asked for its workers
# Tasks that wait at each thread of the workers, so that none is idle while a result travels; few, so that
# a million tasks need no memory.
_QUEUED = 8


class Cluster(Generic[T, R]):
    """A connection to a Dask scheduler whose workers call one function.

    Args:
        function: a function of a module, called with each task; it never raises.
        address: `tcp://HOST:PORT` or `tls://HOST:PORT` of the scheduler.

    Raises:
        PinelError: `cluster_address`, `cluster_extra_missing`, `cluster_unreachable`, `cluster_without_workers`,
            `cluster_other_version`.
    """

    def __init__(self, function: Callable[[T], R], address: str) -> None:
        self._address = _checked(address)
        self._client = _connected(address)
        try:
            self._require_workers()
            self._call = partial(_call, function, versions())
        except BaseException:
            self.end()
            raise

    def _require_workers(self) -> None:
        try:
            self._client.wait_for_workers(1, timeout=_CONNECT_S)
        except TimeoutError as error:
            raise PinelError("cluster_without_workers", address=self._address) from error
        own = versions()
        for worker, found in self._client.run(versions, on_error="return").items():
            _require_same(worker, own, found)

    def results(self, tasks: Iterable[T]) -> Iterator[tuple[T, R | ProcessDied]]:
        """Yields each task with its result, in order of completion.

        Dask gives the tasks of a lost worker to others; a task that has lost several workers has died. Closing the
        generator cancels the tasks that wait.

        Raises:
            PinelError: `cluster_lost`, `cluster_other_version` for a worker that joined later, `cluster_failed`.
        """
        waiting, submitted = iter(tasks), dict[Future[Any], T]()
        try:
            while True:
                n_free = self._n_threads * _QUEUED - len(submitted)
                for task in islice(waiting, n_free):
                    submitted[self._client.submit(self._call, task, pure=False)] = task
                if not submitted:
                    return
                for future, result in self._done(list(submitted)):
                    yield submitted.pop(future), result
        finally:
            self._client.cancel(list(submitted))

    def end(self) -> None:
        """Ends the connection. The cluster goes on."""
        self._client.close(timeout=_CONNECT_S)

    def _done(self, futures: list[Future[Any]]) -> list[tuple[Future[Any], R | ProcessDied]]:
        """Waits for results; returns those that are there, none after a while without any."""
        try:
            ready, _ = wait(futures, timeout=_SILENT_S, return_when="FIRST_COMPLETED")
            good = [future for future in ready if future.status == "finished"]
            gather = partial(self._client.gather, good, asynchronous=True)
            results = self._client.sync(gather, callback_timeout=_SILENT_S)
        except TimeoutError:
            self._require_any_worker()
            return []
        except (OSError, CancelledError) as error:
            raise PinelError("cluster_lost", address=self._address) from error
        failed = [(future, self._failure(future)) for future in ready if future.status == "error"]
        return [*zip(good, results, strict=True), *failed]
