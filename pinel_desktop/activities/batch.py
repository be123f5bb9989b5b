"""Checks many programs in parallel processes."""

import contextlib
import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator, Sequence
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnContext

from pinel_desktop.activities.checking import Report, check_program
from pinel_desktop.activities.faults import require_fulfillable
from pinel_desktop.activities.model import Activity
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.reading import ParseResult
from pinel_desktop.program.sources import read_source


def check_files(
    activity: Activity, files: Sequence[str], *, n_processes: int | None = None
) -> Iterator[tuple[int, Report]]:
    """Checks program files (documents, bare lists, Python texts) in several processes.

    Yields (index of the file, report) in order of completion. An error in one program, even a crash of its process,
    appears in the program's report and does not affect the other programs. Closing the generator kills all
    processes.

    Args:
        n_processes: number of processes; None is one per core.

    Raises:
        ActivityError: no program could pass the activity.
    """
    require_fulfillable(activity)  # before any process starts
    n_requested = n_processes or os.cpu_count() or 1
    if len(files) == 1 or n_requested == 1:
        for i, file in enumerate(files):
            yield i, _check_file(activity, file)
        return
    workers = _Workers(activity, files, n_requested)
    try:
        yield from workers.reports()
    finally:
        workers.end()


class _Workers:
    """A pool of processes. Each one is a fresh interpreter, which inherits no threads or files."""

    def __init__(self, activity: Activity, files: Sequence[str], n_requested: int) -> None:
        self._activity, self._files = activity, files
        self._waiting = list(reversed(range(len(files))))
        self._context = multiprocessing.get_context("spawn")
        self._busy: dict[_Worker, int] = {}
        for _ in range(min(n_requested, len(files))):
            self._assign(_Worker(self._context, self._activity))

    def reports(self) -> Iterator[tuple[int, Report]]:
        """Yields (index of the file, report) in order of completion."""
        while self._busy:
            for worker in self._ready():
                index = self._busy.pop(worker)
                report = worker.report()
                if report is not None:
                    self._assign(worker)
                    yield index, report
                    continue
                worker.end()
                if self._waiting:
                    self._assign(_Worker(self._context, self._activity))
                yield index, _lost_process_report(self._files[index], worker.exit_code)

    def _assign(self, worker: "_Worker") -> None:
        if not self._waiting:
            worker.end()
            return
        index = self._waiting.pop()
        self._busy[worker] = index
        worker.begin(self._files[index])

    def _ready(self) -> "list[_Worker]":
        """Waits until a process has finished a program or has exited; returns all such processes."""
        ready = wait([worker.connection for worker in self._busy])
        return [worker for worker in self._busy if worker.connection in ready]

    def end(self) -> None:
        """Kills the busy processes."""
        for worker in self._busy:
            worker.end()


class _Worker:
    """One process of the pool and the pipe to it."""

    def __init__(self, context: SpawnContext, activity: Activity) -> None:
        self.connection, theirs = context.Pipe()
        self._process = context.Process(target=_work, args=(theirs, activity), daemon=True)
        with _ignoring_interrupts():
            self._process.start()
        theirs.close()

    @property
    def exit_code(self) -> int | None:
        return self._process.exitcode

    def begin(self, file: str) -> None:
        with contextlib.suppress(OSError):  # the process has exited: `report` will return None
            self.connection.send(file)

    def report(self) -> Report | None:
        """Waits for the report; returns None if the process has exited."""
        try:
            report = self.connection.recv()
        except (EOFError, OSError):
            return None
        assert isinstance(report, Report)
        return report

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


def _work(connection: Connection, activity: Activity) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with contextlib.suppress(EOFError, OSError):  # the parent has exited
        while True:
            connection.send(_check_file(activity, connection.recv()))


def _lost_process_report(file: str, exit_code: int | None) -> Report:
    """Returns the report of a program whose process has exited, for example for lack of memory."""
    return Report(file, (Fault("check_process_lost", params={"value": exit_code}),), ())


def _check_file(activity: Activity, file: str) -> Report:
    try:
        with open(file, "rb") as opened:
            reading = read_source(opened.read(MAX_BYTES + 1), file)
    except (OSError, ValueError):  # ValueError: a null byte in the name
        reading = ParseResult(None, (Fault("file_unreadable", params={"path": file}),))
    return check_program(activity, reading, file)
