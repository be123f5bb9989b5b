"""Checks many program files, in parallel where there is more than one."""

from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

from pinel_desktop.activities.checking import Report, check_program
from pinel_desktop.activities.faults import require_fulfillable
from pinel_desktop.activities.model import Activity
from pinel_desktop.processes.pool import ProcessDied
from pinel_desktop.processes.workers import Workers, results_of
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.reading import ParseResult
from pinel_desktop.program.sources import read_source

_ONE_PER_CORE = Workers()


class _File(NamedTuple):
    """A file to check, read here: the workers of a cluster have other disks. None if it cannot be read."""

    number: int
    name: str
    content: bytes | None


def check_files(
    activity: Activity, files: Sequence[str], workers: Workers = _ONE_PER_CORE
) -> Iterator[tuple[int, Report]]:
    """Checks program files (documents, bare lists, Python texts).

    Yields (index of the file, report) in order of completion. An error in one program, even a crash of its process,
    appears in the program's report and does not affect the other programs. Closing the generator kills all
    processes.

    Raises:
        ActivityError: no program could pass the activity.
        PinelError: a cluster cannot be used.
    """
    require_fulfillable(activity)  # before any process starts
    if len(files) == 1 and workers.cluster is None:
        workers = Workers(1)
    tasks = (_File(number, name, _content(name)) for number, name in enumerate(files))
    for file, report in results_of(partial(_check, activity), tasks, workers):
        yield file.number, _lost(file.name, report) if isinstance(report, ProcessDied) else report


def _content(file: str) -> bytes | None:
    try:
        with open(file, "rb") as opened:
            return opened.read(MAX_BYTES + 1)
    except (OSError, ValueError):  # ValueError: a null byte in the name
        return None


def _check(activity: Activity, file: _File) -> Report:
    if file.content is None:
        reading = ParseResult(None, (Fault("file_unreadable", params={"path": file.name}),))
    else:
        reading = read_source(file.content, file.name)
    return check_program(activity, reading, file.name)


def _lost(file: str, died: ProcessDied) -> Report:
    """Returns the report of a program whose process has exited, for example for lack of memory."""
    return Report(file, (Fault("check_process_lost", params={"value": died.exit_code}),), ())
