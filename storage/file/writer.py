"""The writer thread: each job is one transaction, and its caller may wait until it is on disk."""

import contextlib
import queue
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import TypeVar

from storage.errors import StoreError, translated
from storage.file.sums import Changes, mend_from
from storage.sqlite import sqlite3

T = TypeVar("T")
_Task = Callable[[], None]
ATTACHED = "bundle"


class Writer:
    """Owns the writing connection.

    Attributes:
        on_written: called after each job that is on disk, on the writer's thread; must not raise or wait.
    """

    def __init__(self, connection: sqlite3.Connection, path: Path) -> None:
        # deleted content is overwritten: a renamed group's old name must not stay in the file
        connection.execute("PRAGMA secure_delete = ON")
        self._changes = Changes(connection)
        self._connection = connection
        self._path = path
        self._tasks: queue.SimpleQueue[_Task | None] = queue.SimpleQueue()
        self.on_written: Callable[[], None] = lambda: None
        self._closed = False
        self._lock = threading.Lock()
        self._thread = threading.Thread(target=self._work, name="store-writer", daemon=True)
        self._thread.start()

    def submit(
        self, job: Callable[[sqlite3.Connection], T], attached: str | None = None
    ) -> "Future[T]":
        """Queues the job. The future has its result once it is on disk, or a StoreError where nothing was written.

        Args:
            attached: address of a file that is the schema `bundle` during the job.
        """
        future: Future[T] = Future()
        with self._lock:
            if self._closed:
                future.set_exception(
                    StoreError("database_failed", path=str(self._path), problem="closed")
                )
            else:
                self._tasks.put(lambda: self._fulfil(future, job, attached))
        return future

    @property
    def closed(self) -> bool:
        """True when nothing more can be written."""
        return self._closed

    def close(self) -> None:
        """Finishes what is queued, then closes the connection."""
        with self._lock:
            if not self._closed:
                self._closed = True
                self._tasks.put(None)
        self._thread.join()

    def _work(self) -> None:
        while (task := self._tasks.get()) is not None:
            task()
        self._connection.close()

    def _fulfil(
        self, future: "Future[T]", job: Callable[[sqlite3.Connection], T], attached: str | None
    ) -> None:
        try:
            with self._attaching(attached):
                result = self._in_transaction(job, has_attached=attached is not None)
        except sqlite3.Error as error:
            future.set_exception(translated(error, self._path))
        except Exception as error:
            future.set_exception(error)
        else:
            future.set_result(result)
            self.on_written()

    @contextlib.contextmanager
    def _attaching(self, address: str | None) -> Iterator[None]:
        """SQLite attaches and detaches outside of transactions only."""
        if address is None:
            yield
            return
        self._connection.execute(f"ATTACH DATABASE ? AS {ATTACHED}", [address])
        try:
            yield
        finally:
            self._connection.execute(f"DETACH DATABASE {ATTACHED}")

    def _in_transaction(self, job: Callable[[sqlite3.Connection], T], *, has_attached: bool) -> T:
        # IMMEDIATE: a job that reads first must not lose to another process that wrote in between
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            result = job(self._connection)
            if has_attached:
                mend_from(self._connection, ATTACHED)
            self._changes.renew(self._connection)
            self._connection.execute("COMMIT")
        except BaseException:
            if self._connection.in_transaction:
                self._connection.execute("ROLLBACK")
            raise
        return result
