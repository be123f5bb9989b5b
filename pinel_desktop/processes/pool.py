"""A pool of processes for independent tasks: `pinel check`, sweeps, and the clouds of the page.

The standard library's executor gives up all its tasks when one process dies, and does not tell which task killed it.
This pool knows the task of each process, so one program that needs all the memory costs its own result only.
"""

import contextlib
import multiprocessing
import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from multiprocessing.connection import Connection, wait
from typing import Generic, NamedTuple, TypeVar

T = TypeVar("T")
R = TypeVar("R")


class ProcessDied(NamedTuple):
    """The result of a task whose process has exited, for example for lack of memory."""

    exit_code: int | None


class ProcessPool(Generic[T, R]):
    """Processes that call one function. Each one is a fresh interpreter, which inherits no threads or files.

    Args:
        function: a function of a module, called with each task; it never raises.
        n_processes: the most processes; `start` starts them all at once, `results` those that it needs.
        attempts: how often a task is tried whose process dies.
    """

    def __init__(self, function: Callable[[T], R], n_processes: int, attempts: int = 1) -> None:
        self._function, self._n_processes, self._attempts = function, n_processes, attempts
        self._idle: list[_Worker[T, R]] = []
        self._busy: dict[_Worker[T, R], tuple[T, int]] = {}
        self._is_cancelled = False

    def start(self) -> None:
        """Starts all processes, so that the first tasks need not wait for the interpreter's imports.

        After `cancel` and the end of `results`, it makes the pool ready for the next tasks.
        """
        self._is_cancelled = False
        while len(self._idle) + len(self._busy) < self._n_processes:
            self._idle.append(_Worker(self._function))

    def results(self, tasks: Iterable[T]) -> Iterator[tuple[T, R | ProcessDied]]:
        """Yields each task with its result, in order of completion; takes a task only when a process is free.

        Closing the generator kills the processes that are busy; the others wait for the next tasks.
        """
        waiting = iter(tasks)
        try:
            while not self._is_cancelled and (self._assign(waiting) or self._busy):
                for worker in self._ready():
                    task, attempt = self._busy.pop(worker)
                    result = worker.result()
                    if self._is_cancelled:
                        return
                    if not isinstance(result, ProcessDied):
                        self._idle.append(worker)
                    elif attempt < self._attempts:
                        self._begin(task, attempt + 1)
                        continue
                    yield task, result
        finally:
            for worker in self._busy:
                worker.end()
            self._busy.clear()

    def cancel(self) -> None:
        """Ends `results`, which runs on another thread or is about to, and kills the processes that are busy."""
        self._is_cancelled = True
        for worker in tuple(self._busy):
            worker.kill()

    def end(self) -> None:
        """Kills all processes."""
        for worker in (*self._idle, *self._busy):
            worker.end()
        self._idle.clear()
        self._busy.clear()

    def _assign(self, waiting: Iterator[T]) -> bool:
        """Gives a task to each free process; returns whether it gave any."""
        has_assigned = False
        while len(self._busy) < self._n_processes:
            try:
                task = next(waiting)
            except StopIteration:
                return has_assigned
            self._begin(task, 1)
            has_assigned = True
        return has_assigned

    def _begin(self, task: T, attempt: int) -> None:
        worker = self._idle.pop() if self._idle else _Worker(self._function)
        self._busy[worker] = task, attempt
        worker.begin(task)
        if self._is_cancelled:  # `cancel` may have looked for busy processes a moment ago
            worker.kill()

    def _ready(self) -> "list[_Worker[T, R]]":
        """Waits until a process has finished a task or has exited; returns all such processes."""
        ready = wait([worker.connection for worker in self._busy])
        return [worker for worker in self._busy if worker.connection in ready]


class _Worker(Generic[T, R]):
    """One process of the pool and the pipe to it."""

    def __init__(self, function: Callable[[T], R]) -> None:
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self._process = context.Process(target=_work, args=(theirs, function), daemon=True)
        with _ignoring_interrupts():
            self._process.start()
        theirs.close()

    def begin(self, task: T) -> None:
        with contextlib.suppress(OSError):  # the process has exited: `result` will say so
            self.connection.send(task)

    def result(self) -> R | ProcessDied:
        """Waits for the result of the task, or for the end of the process."""
        try:
            result: R = self.connection.recv()
        except (EOFError, OSError):
            self.end()
            return ProcessDied(self._process.exitcode)
        return result

    def kill(self) -> None:
        self._process.kill()

    def end(self) -> None:
        self.connection.close()
        self._process.kill()
        self._process.join()


@contextlib.contextmanager
def _ignoring_interrupts() -> Iterator[None]:
    """Makes a process that is started in this context ignore Ctrl-C from its start; its parent ends it."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _work(connection: Connection, function: Callable[[T], R]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with contextlib.suppress(EOFError, OSError):  # the parent has exited
        while True:
            connection.send(function(connection.recv()))
