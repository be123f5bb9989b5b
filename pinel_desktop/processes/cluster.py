"""A Dask cluster for independent tasks, with the methods of `ProcessPool`. Dask schedules; nothing here does.

Whoever keeps the cluster starts it (docs/district.md). This process connects to its scheduler and listens on no port.
"""

import logging
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import CancelledError
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar
from urllib.parse import urlsplit

from pinel_desktop.errors import PinelError
from pinel_desktop.processes.pool import ProcessDied
from pinel_desktop.processes.versions import versions

if TYPE_CHECKING:
    from distributed import Client, Future

T = TypeVar("T")
R = TypeVar("R")
_CONNECT_S = 5  # until a cluster without scheduler or workers is named
_RESULT_TIMEOUT_S = 20  # without a result, until the cluster is asked whether it has workers
# Submitted batches: at least so many, and so many for each thread of the workers. None is idle while a result travels,
# and a million tasks need no memory.
_MIN_SUBMITTED, _SUBMITTED_PER_THREAD = 64, 8
# Dask needs about a millisecond for whatever it is given, so that short tasks come in batches of about this duration.
_BATCH_S, _MAX_BATCH = 0.2, 16


class _Results(NamedTuple, Generic[R]):
    """The results of a batch, and how long it took."""

    each: list[R]
    duration_s: float


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
        self._address = address
        self._client = _connected(address)
        try:
            self._require_same_versions()
            n_threads = sum(self._client.nthreads().values())
        except BaseException:
            self.end()
            raise
        self._call = partial(_call, function, versions())
        self._n_submitted = max(_MIN_SUBMITTED, _SUBMITTED_PER_THREAD * n_threads)
        self._batch_size = 1

    def _require_same_versions(self) -> None:
        try:
            self._client.wait_for_workers(1, timeout=_CONNECT_S)
        except TimeoutError as error:
            raise PinelError("cluster_without_workers", address=self._address) from error
        for worker, found in self._client.run(versions, on_error="return").items():
            # an earlier release has no such function
            _require_same(worker, versions(), {} if isinstance(found, Exception) else found)

    def results(self, tasks: Iterable[T]) -> Iterator[tuple[T, R | ProcessDied]]:
        """Yields each task with its result, in order of completion.

        Dask gives the tasks of a lost worker to others; a task that has lost several workers has died. Of a batch that
        has lost several, each task is tried alone. Closing the generator cancels the tasks that wait.

        Raises:
            PinelError: `cluster_lost`; `cluster_other_version` for a worker that joined later; `cluster_failed`.
        """
        waiting, lost = iter(tasks), deque[T]()
        submitted: dict[Future[_Results[R]], list[T]] = {}
        try:
            while True:
                while len(submitted) < self._n_submitted and (batch := self._batch(lost, waiting)):
                    submitted[self._client.submit(self._call, batch, pure=False)] = batch
                if not submitted:
                    return
                for future, results in self._done(list(submitted)):
                    batch = submitted.pop(future)
                    if not isinstance(results, ProcessDied):
                        self._batch_size = _batch_size(results)
                        yield from zip(batch, results.each, strict=True)
                    elif len(batch) == 1:
                        yield batch[0], results
                    else:
                        lost.extend(batch)
        except (OSError, CancelledError) as error:  # the scheduler has ended
            raise PinelError("cluster_lost", address=self._address) from error
        finally:
            for future in submitted:
                future.release()

    def end(self) -> None:
        """Ends the connection; tasks that wait are cancelled, the cluster goes on."""
        self._client.close(timeout=_CONNECT_S)

    def _batch(self, lost: deque[T], waiting: Iterator[T]) -> list[T]:
        """Returns the next tasks to submit together; none at the end."""
        return [lost.popleft()] if lost else list(islice(waiting, self._batch_size))

    def _done(
        self, futures: "list[Future[_Results[R]]]"
    ) -> "list[tuple[Future[_Results[R]], _Results[R] | ProcessDied]]":
        """Waits for results and returns those that exist; after a long time without any, returns none."""
        from distributed import wait  # noqa: PLC0415 - the extra `cluster`

        try:
            ready = wait(futures, timeout=_RESULT_TIMEOUT_S, return_when="FIRST_COMPLETED").done
            good = [future for future in ready if future.status == "finished"]
            gather = partial(self._client.gather, good, asynchronous=True)
            results = self._client.sync(gather, callback_timeout=_RESULT_TIMEOUT_S)
        except TimeoutError:
            if not self._client.nthreads():
                raise PinelError("cluster_lost", address=self._address) from None
            return []
        failed = [(future, _died(future)) for future in ready if future.status == "error"]
        return [*zip(good, results, strict=True), *failed]


def _connected(address: str) -> "Client":
    parts = urlsplit(address)
    try:
        is_address = parts.scheme in ("tcp", "tls") and parts.hostname and parts.port
    except ValueError:  # the port is no number
        is_address = False
    if not is_address:
        raise PinelError("cluster_address", value=address)
    try:
        from distributed import Client  # noqa: PLC0415 - the extra `cluster`
    except ImportError:
        raise PinelError("cluster_extra_missing") from None
    # its warnings are for who keeps the cluster; what matters here is an error of ours
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    try:
        return Client(address, timeout=_CONNECT_S)
    except (OSError, TimeoutError) as error:
        raise PinelError("cluster_unreachable", address=address) from error


def _call(
    function: Callable[[T], R], expected: Mapping[str, str], batch: Sequence[T]
) -> _Results[R]:
    """Runs on a worker, which may have joined after the versions were compared."""
    if versions() != expected:
        from distributed import get_worker  # noqa: PLC0415 - the extra `cluster`

        _require_same(get_worker().address, expected, versions())
    begin = time.perf_counter()
    each = [function(task) for task in batch]
    return _Results(each, time.perf_counter() - begin)


def _batch_size(results: _Results[R]) -> int:
    each_s = results.duration_s / len(results.each)
    return max(1, min(_MAX_BATCH, round(_BATCH_S / max(each_s, 1e-9))))


def _require_same(worker: str, own: Mapping[str, str], found: Mapping[str, str]) -> None:
    for part, version in own.items():
        if found.get(part) != version:
            raise PinelError(
                "cluster_other_version",
                worker=worker,
                part=part,
                own=version,
                found=found.get(part, "?"),
            )


def _died(future: "Future[_Results[R]]") -> ProcessDied:
    """Returns the result of a task that lost several workers; raises what failed otherwise."""
    from distributed import KilledWorker  # noqa: PLC0415 - the extra `cluster`

    error = future.exception()
    if isinstance(error, KilledWorker):
        return ProcessDied(None)
    if isinstance(error, PinelError):
        raise error
    raise PinelError("cluster_failed", detail=f"{type(error).__name__}: {error}") from error
