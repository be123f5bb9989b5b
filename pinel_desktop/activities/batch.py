"""Many programs at once, on all cores."""

import contextlib
import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator, Sequence
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnContext

from pinel_desktop.activities.checking import Report, check_program
from pinel_desktop.activities.faults import make_sure
from pinel_desktop.activities.model import Activity
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.reading import Reading
from pinel_desktop.program.sources import read_source


def check_files(
    activity: Activity, files: Sequence[str], *, n_processes: int | None = None
) -> Iterator[tuple[int, Report]]:
    """Checks program files (documents, bare lists, Python texts), each in one of several processes.

    Gives (index of the file, report) as they become ready. What goes wrong with one program stands in its report, also
    when its process dies; the others go on. When the caller stops asking, all processes end at once.

    Args:
        n_processes: how many work at once; as many as this PC has cores when not told.

    Raises:
        PinelError: the activity cannot be used.
    """
    make_sure(activity)  # before anybody begins
    n_wanted = n_processes or os.cpu_count() or 1
    if len(files) == 1 or n_wanted == 1:
        for i, file in enumerate(files):
            yield i, _check_file(activity, file)
        return
    workers = _Workers(activity, files, n_wanted)
    try:
        yield from workers.reports()
    finally:
        workers.end()


class _Workers:
    """Processes that are given one file after the other.

    A fresh interpreter each: what this process holds, such as threads and files, is not copied.
    """

    def __init__(self, activity: Activity, files: Sequence[str], n_wanted: int) -> None:
        self._activity, self._files = activity, files
        self._waiting = list(reversed(range(len(files))))
        self._context = multiprocessing.get_context("spawn")
        self._at_work: dict[Connection, tuple[_Worker, int]] = {}
        for _ in range(min(n_wanted, len(files))):
            self._give(_Worker(self._context, self._activity))

    def reports(self) -> Iterator[tuple[int, Report]]:
        """All of them, whoever is ready first."""
        while self._at_work:
            for ready in wait(list(self._at_work)):
                assert isinstance(ready, Connection)
                worker, index = self._at_work.pop(ready)
                report = worker.report()
                if report is None:
                    worker.end()
                    report = _lost(self._files[index], worker.exit_code)
                    if self._waiting:
                        worker = _Worker(self._context, self._activity)
                self._give(worker)
                yield index, report

    def _give(self, worker: "_Worker") -> None:
        if not self._waiting:
            worker.end()
            return
        index = self._waiting.pop()
        self._at_work[worker.connection] = worker, index
        worker.begin(self._files[index])

    def end(self) -> None:
        """Ends those that still work."""
        for worker, _ in self._at_work.values():
            worker.end()


class _Worker:
    """One process and the way to talk to it."""

    def __init__(self, context: SpawnContext, activity: Activity) -> None:
        self.connection, theirs = context.Pipe()
        self._process = context.Process(target=_work, args=(theirs, activity), daemon=True)
        with _deaf_to_interrupts():
            self._process.start()
        theirs.close()

    @property
    def exit_code(self) -> int | None:
        return self._process.exitcode

    def begin(self, file: str) -> None:
        with contextlib.suppress(OSError):  # it has died: told by what it does not report
            self.connection.send(file)

    def report(self) -> Report | None:
        """None when it has died."""
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
def _deaf_to_interrupts() -> Iterator[None]:
    """A process that is started meanwhile never hears of Ctrl-C, not even while it is loading: its parent ends it."""
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
    with contextlib.suppress(EOFError, OSError):  # the parent has ended
        while True:
            connection.send(_check_file(activity, connection.recv()))


def _lost(file: str, exit_code: int | None) -> Report:
    """The report of a program whose process has died: killed by the system for memory, say, or by a person."""
    return Report(file, (Fault("check_process_lost", params={"value": exit_code}),), ())


def _check_file(activity: Activity, file: str) -> Report:
    try:
        with open(file, "rb") as opened:
            reading = read_source(opened.read(MAX_BYTES + 1), file)
    except (OSError, ValueError):  # ValueError: a null byte in the name
        reading = Reading(None, (Fault("file_unreadable", params={"path": file}),))
    return check_program(activity, reading, file)
