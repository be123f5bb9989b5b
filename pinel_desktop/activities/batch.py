"""Many programs at once, on all cores."""

import multiprocessing
import os
import signal
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed

from pinel_desktop.activities.checking import Report, check_program, world_of
from pinel_desktop.activities.model import Activity
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.reading import Reading
from pinel_desktop.program.sources import read_source


def check_files(
    activity: Activity, files: Sequence[str], *, n_processes: int | None = None
) -> Iterator[tuple[int, Report]]:
    """Checks program files (documents, bare lists, Python texts), each in one of several processes.

    Gives (index of the file, report) as they become ready. What goes wrong with one program stands in its report.

    Args:
        n_processes: how many work at once; as many as this PC has cores when not told.

    Raises:
        PinelError: the activity cannot be used.
    """
    world_of(activity)  # before anybody begins
    n_wanted = n_processes or os.cpu_count() or 1
    if len(files) == 1 or n_wanted == 1:
        for i, file in enumerate(files):
            yield i, _check_file(activity, file)
        return
    # a fresh interpreter each: what this process holds, such as threads and files, is not copied
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(
        min(n_wanted, len(files)), mp_context=context, initializer=_leave_interrupts_to_the_parent
    ) as pool:
        waiting: dict[Future[Report], int] = {
            pool.submit(_check_file, activity, file): i for i, file in enumerate(files)
        }
        try:
            for done in as_completed(waiting):
                yield waiting[done], done.result()
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


def _leave_interrupts_to_the_parent() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _check_file(activity: Activity, file: str) -> Report:
    try:
        with open(file, "rb") as opened:
            reading = read_source(opened.read(MAX_BYTES + 1), file)
    except (OSError, ValueError):  # ValueError: a null byte in the name
        reading = Reading(None, (Fault("file_unreadable", params={"path": file}),))
    return check_program(activity, reading, file)
