"""Log files: `logs/` beside the database has one for each process, with its messages and uncaught exceptions.

Several processes cannot rotate one file safely (docs.python.org/3/howto/logging-cookbook.html), hence a file for each.
A thread writes, so that nothing waits for a disk that hangs: not the start, and not the commands to a robot. While the
file cannot be written, such as on a full disk, records are dropped. Nothing is created where there is no database.
"""

import atexit
import contextlib
import faulthandler
import logging
import os
import queue
import sys
import threading
from pathlib import Path
from types import TracebackType

from pinel_desktop import __version__
from pinel_desktop.paths import read_regular
from pinel_desktop.processes.log_text import OWN_PACKAGES, PlainFormatter

PROCESSES = ("window", "app", "engine", "camera", "judge", "cloud")
# tells a process that this one starts where the database is
_VARIABLE = "PINEL_LOG_BESIDE"
_MAX_BYTES = 500_000
_MAX_WAITING = 1000
_CLOSE_TIMEOUT_S = 1.0
_log_writers: list["_LogWriter"] = []


def start_log(process: str, database: Path) -> None:
    """Writes the log of this process from now on, and lets the processes that it starts write theirs."""
    os.environ[_VARIABLE] = str(database)
    start_child_log(process)


def start_child_log(process: str) -> None:
    """Writes the log of this process if the process that started it writes one. Warnings also reach the terminal."""
    terminal = logging.StreamHandler(sys.stderr)
    terminal.setLevel(logging.WARNING)
    logging.getLogger().addHandler(terminal)
    if database := os.environ.get(_VARIABLE):
        _start(process, Path(database))


def close_log() -> None:
    """Writes what is pending; waits no longer than a second. Call it before `os._exit`."""
    while _log_writers:
        _log_writers.pop().finish()


def folder_of(database: Path) -> Path:
    """Returns the folder of the log files."""
    return database.parent / "logs"


def read_log(process: str, database: Path, max_lines: int) -> list[str]:
    """Returns the last lines of a process's log, oldest first; empty without a log."""
    file = _file_of(process, database)
    lines: list[str] = []
    for part in (_rotated(file), file):
        with contextlib.suppress(OSError):
            lines += read_regular(part).decode("utf-8", "replace").splitlines()
    return lines[-max_lines:]


class _RotatingFile:
    """The file: private like the folder that it is in. Receives crashes of libraries too, except on Windows.

    On Windows, `faulthandler` also reports exceptions that a library handles. Not a handler of `logging`, which flushes
    all handlers when the process ends, and would wait for a disk that hangs.
    """

    def __init__(self, file: Path, database: Path, first_line: str) -> None:
        self._file, self._database = file, database
        self._first_line = first_line
        self._descriptor: int | None = None

    def write(self, line: str) -> None:
        """Appends a line; drops it if the file cannot be written."""
        try:
            if self._descriptor is None:
                self._descriptor = self._open()
                self._append(self._first_line)
            self._append(line)
            if os.fstat(self._descriptor).st_size > _MAX_BYTES:
                self.close()
                os.replace(self._file, _rotated(self._file))
        except OSError:
            self.close()

    def close(self) -> None:
        if self._descriptor is not None:
            faulthandler.disable()
            os.close(self._descriptor)
            self._descriptor = None

    def _open(self) -> int:
        if not self._database.exists():
            raise FileNotFoundError(self._database)
        is_private = not self._database.parent.stat().st_mode & 0o077
        with contextlib.suppress(FileExistsError):
            self._file.parent.mkdir(0o700 if is_private else 0o777)
        no_link = getattr(os, "O_NOFOLLOW", 0)
        flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | no_link
        descriptor = os.open(self._file, flags, 0o600 if is_private else 0o666)
        if sys.platform != "win32":
            faulthandler.enable(descriptor)
        return descriptor

    def _append(self, line: str) -> None:
        if self._descriptor is not None:
            os.write(self._descriptor, f"{line}\n".encode("utf-8", "backslashreplace"))


class _LogWriter(logging.Handler):
    """Passes formatted records to a thread, which writes them; drops them while too many wait."""

    def __init__(self, file: _RotatingFile) -> None:
        super().__init__()
        self._file = file
        self._lines: queue.Queue[str | None] = queue.Queue(_MAX_WAITING)
        self._thread = threading.Thread(target=self._write, name="log-writer", daemon=True)
        self._thread.start()

    def emit(self, record: logging.LogRecord) -> None:
        with contextlib.suppress(queue.Full):
            self._lines.put_nowait(self.format(record))

    def finish(self) -> None:
        with contextlib.suppress(queue.Full):
            self._lines.put_nowait(None)
        self._thread.join(_CLOSE_TIMEOUT_S)

    def _write(self) -> None:
        while (line := self._lines.get()) is not None:
            self._file.write(line)
        self._file.close()


def _start(process: str, database: Path) -> None:
    first_line = f"PINEL {__version__}: {process}, process {os.getpid()}"
    writer = _LogWriter(_RotatingFile(_file_of(process, database), database, first_line))
    writer.setFormatter(PlainFormatter())
    logging.getLogger().addHandler(writer)
    for package in OWN_PACKAGES:
        logging.getLogger(package).setLevel(logging.INFO)
    _log_uncaught(writer)
    _log_writers.append(writer)
    atexit.register(close_log)


def _log_uncaught(writer: _LogWriter) -> None:
    """Logs exceptions that nobody catches, in all threads, besides printing them as before."""
    log = logging.getLogger(f"{__name__}.uncaught")
    log.propagate = False
    log.addHandler(writer)
    print_uncaught, print_in_thread = sys.excepthook, threading.excepthook

    def uncaught(
        kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        if issubclass(kind, Exception):
            log.critical("uncaught exception", exc_info=error)
        print_uncaught(kind, error, trace)

    def uncaught_in_thread(args: threading.ExceptHookArgs) -> None:
        if args.exc_value is not None and issubclass(args.exc_type, Exception):
            log.critical("uncaught exception in a thread", exc_info=args.exc_value)
        print_in_thread(args)

    sys.excepthook, threading.excepthook = uncaught, uncaught_in_thread


def _rotated(file: Path) -> Path:
    """Returns where the lines before those of the file are."""
    return file.with_name(f"{file.name}.1")


def _file_of(process: str, database: Path) -> Path:
    return folder_of(database) / f"{database.stem}-{process}.log"
