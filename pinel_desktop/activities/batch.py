"""Checks many program files, in parallel processes where there is more than one."""

import os
from collections.abc import Iterator, Sequence
from functools import partial

from pinel_desktop.activities.checking import Report, check_program
from pinel_desktop.activities.faults import require_fulfillable
from pinel_desktop.activities.model import Activity
from pinel_desktop.processes.pool import ProcessDied, ProcessPool
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
    tasks = list(enumerate(files))
    if len(files) == 1 or n_requested == 1:
        for i, file in tasks:
            yield i, _check_file(activity, file)
        return
    pool = ProcessPool(partial(_check_task, activity), n_requested)
    try:
        for (i, file), report in pool.results(tasks):
            yield i, _lost(file, report) if isinstance(report, ProcessDied) else report
    finally:
        pool.end()


def _check_task(activity: Activity, task: tuple[int, str]) -> Report:
    return _check_file(activity, task[1])


def _lost(file: str, died: ProcessDied) -> Report:
    """Returns the report of a program whose process has exited, for example for lack of memory."""
    return Report(file, (Fault("check_process_lost", params={"value": died.exit_code}),), ())


def _check_file(activity: Activity, file: str) -> Report:
    try:
        with open(file, "rb") as opened:
            reading = read_source(opened.read(MAX_BYTES + 1), file)
    except (OSError, ValueError):  # ValueError: a null byte in the name
        reading = ParseResult(None, (Fault("file_unreadable", params={"path": file}),))
    return check_program(activity, reading, file)
