"""Connections to the file: one writer thread, and a pool of reading connections."""

import contextlib
import queue
import sys
import time
import uuid
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import NamedTuple, TypeVar

from storage.errors import StoreError, translated
from storage.file.opening import connect
from storage.file.writer import Writer
from storage.sql import is_text_damage, read_all_texts
from storage.sqlite import sqlite3
from storage.text import time_text

T = TypeVar("T")
_MAX_IDLE = 8


class Timestamp(NamedTuple):
    """A time by two clocks.

    Attributes:
        text: the time by the PC's clock, which may be set.
        app: identifies the running app.
        uptime_s: monotonic time in s; comparable within one app only.
    """

    text: str
    app: str
    uptime_s: float


def uptime_s() -> float:
    """Returns the time of a monotonic clock in s that also runs while the PC sleeps."""
    if sys.platform == "linux":
        return time.clock_gettime(time.CLOCK_BOOTTIME)
    return time.monotonic()


class Database:
    """Reads and writes one file.

    Args:
        address: SQLite's URI of the file.
        refusal: raised by every attempt to write; None if the file can be written.
        uptime: a monotonic clock in s.
    """

    def __init__(
        self,
        path: Path,
        address: str,
        refusal: StoreError | None,
        clock: Callable[[], datetime],
        uptime: Callable[[], float] = uptime_s,
    ) -> None:
        self.path = path
        self.address = address
        self._refusal = refusal
        self._clock = clock
        self._uptime = uptime
        self._app = uuid.uuid4().hex
        self._has_damaged_texts = False
        self._idle: queue.LifoQueue[sqlite3.Connection] = queue.LifoQueue(_MAX_IDLE)
        self._writer = None if refusal else Writer(connect(address), path, self.now)

    def now(self) -> str:
        """Returns the time as text."""
        return time_text(self._clock())

    def timestamp(self) -> Timestamp:
        """Returns the time by both clocks, so that pauses are measured correctly when the clock is set."""
        return Timestamp(self.now(), self._app, self._uptime())

    @contextmanager
    def read_connection(self) -> Iterator[sqlite3.Connection]:
        """Yields a connection for this thread alone, which reads all that was committed. Raises StoreError."""
        connection: sqlite3.Connection | None = None
        try:
            connection = self._acquire()
            yield connection
        except sqlite3.Error as error:
            if is_text_damage(error):  # in a name; later connections can read it
                self._has_damaged_texts = True
            raise translated(error, self.path) from error
        finally:
            if connection is not None:
                self._release(connection)

    def write(self, job: Callable[[sqlite3.Connection], T], *, attached: str | None = None) -> T:
        """Runs the job in a transaction of the writer. The transaction is on disk when this returns.

        Args:
            attached: address of another file, which is the schema `bundle` during the job.

        Raises:
            StoreError: nothing was written.
        """
        return self.submit(job, attached=attached).result()

    def submit(
        self, job: Callable[[sqlite3.Connection], T], *, attached: str | None = None
    ) -> "Future[T]":
        """Queues the job for the writer without waiting; see `write`."""
        if self._writer is not None:
            return self._writer.submit(job, attached)
        future: Future[T] = Future()
        future.set_exception(self._refusal or StoreError("database_read_only", path=str(self.path)))
        return future

    def checkpoint(self, *, waits_for_readers: bool = False) -> bool:
        """Empties the write-ahead log; returns False if another connection still reads from it.

        Args:
            waits_for_readers: waits some seconds for readers; writers wait too.
        """
        if self._writer is None:
            return False
        return self._writer.checkpoint(waits_for_readers=waits_for_readers).result()

    def listen(self, on_written: Callable[[], None]) -> None:
        """Calls `on_written` after each write that is on disk, on the writer's thread; it must not raise or wait."""
        if self._writer is not None:
            self._writer.on_written = on_written

    @property
    def can_write(self) -> bool:
        """False for a file that cannot be written, and after closing."""
        return self._writer is not None and not self._writer.closed

    def close(self) -> None:
        """Finishes queued jobs and closes every connection, the writer last, as it empties the write-ahead log."""
        with contextlib.suppress(queue.Empty):
            while True:
                self._idle.get_nowait().close()
        if self._writer is not None:
            self._writer.close()

    def _acquire(self) -> sqlite3.Connection:
        try:
            connection = self._idle.get_nowait()
        except queue.Empty:
            connection = connect(self.address)
        if self._has_damaged_texts:
            read_all_texts(connection)
        return connection

    def _release(self, connection: sqlite3.Connection) -> None:
        try:
            self._idle.put_nowait(connection)
        except queue.Full:
            connection.close()
