"""The writer thread: each job is one transaction, and its caller may wait until the transaction is on disk."""

import contextlib
import queue
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import TypeVar

from storage.errors import StoreError, translated
from storage.file.commit_counter import CommitCounter, count_save
from storage.file.row_checksums import ChangedRows, repair_from
from storage.sql import checkpoint, is_text_damage, read_all_texts
from storage.sqlite import sqlite3

T = TypeVar("T")
_Task = Callable[[], None]
ATTACHED = "bundle"
_PAGES_IN_LOG = 1000  # then a commit moves them to the file, which is SQLite's default
_IDLE_S = 2.0  # then the log is emptied: a wrong bit in it would cut off all later commits
_MAX_LOG_AGE_S = 30.0  # without a pause of that length


class Writer:
    """Owns the writing connection. Only this class moves the write-ahead log into the file.

    Args:
        now: returns the time as text, for the commit counter.

    Attributes:
        on_written: called after each job that is on disk, on the writer's thread; must not raise or wait.
    """

    def __init__(self, connection: sqlite3.Connection, path: Path, now: Callable[[], str]) -> None:
        connection.execute(f"PRAGMA wal_autocheckpoint = {_PAGES_IN_LOG}")
        # deleted content is overwritten: a renamed group's old name must not stay in the file
        connection.execute("PRAGMA secure_delete = ON")
        self._changes = ChangedRows(connection)
        self._connection = connection
        self._path = path
        self._now = now
        self._commit_counter = CommitCounter(path)
        self._in_log_since: float | None = None
        self._tasks: queue.SimpleQueue[_Task | None] = queue.SimpleQueue()
        self.on_written: Callable[[], None] = lambda: None
        self._closed = False
        self._lock = threading.Lock()
        self._thread = threading.Thread(target=self._work, name="store-writer", daemon=True)
        self._thread.start()

    def submit(
        self, job: Callable[[sqlite3.Connection], T], attached: str | None = None
    ) -> "Future[T]":
        """Queues the job. The future gets its result once it is on disk, or a StoreError if nothing was written.

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
        """True if nothing more can be written."""
        return self._closed

    def close(self) -> None:
        """Finishes queued jobs, then closes the connection."""
        with self._lock:
            if not self._closed:
                self._closed = True
                self._tasks.put(None)
        self._thread.join()

    def checkpoint(self, *, waits_for_readers: bool = False) -> "Future[bool]":
        """Empties the write-ahead log; the future gets False if another connection still reads from it.

        Args:
            waits_for_readers: waits for them for some seconds.
        """
        future: Future[bool] = Future()
        with self._lock:
            if self._closed:
                future.set_result(False)
            else:
                self._tasks.put(
                    lambda: future.set_result(self._empty_log(waits_for_readers=waits_for_readers))
                )
        return future

    def _work(self) -> None:
        while (task := self._next()) is not None:
            task()
            if self._is_log_old():
                self._empty_log()
        self._empty_log()
        self._commit_counter.close()
        self._connection.close()

    def _next(self) -> _Task | None:
        """Returns the next task; empties the log if none comes for a while."""
        while True:
            try:
                return self._tasks.get(timeout=_IDLE_S if self._in_log_since else None)
            except queue.Empty:
                self._empty_log()

    def _is_log_old(self) -> bool:
        since = self._in_log_since
        return since is not None and time.monotonic() - since > _MAX_LOG_AGE_S

    def _empty_log(self, *, waits_for_readers: bool = False) -> bool:
        """Empties the log; pages that readers still need stay until the next time."""
        self._in_log_since = None
        try:
            with contextlib.nullcontext() if waits_for_readers else self._without_waiting():
                return checkpoint(self._connection)
        except sqlite3.Error:  # the next write reports the problem
            return False

    @contextlib.contextmanager
    def _without_waiting(self) -> Iterator[None]:
        wait_ms = self._connection.execute("PRAGMA busy_timeout").fetchone()[0]
        self._connection.execute("PRAGMA busy_timeout = 0")
        try:
            yield
        finally:
            self._connection.execute(f"PRAGMA busy_timeout = {wait_ms}")

    def _fulfil(
        self, future: "Future[T]", job: Callable[[sqlite3.Connection], T], attached: str | None
    ) -> None:
        try:
            with self._attaching(attached):
                result = self._of_readable_texts(job, has_attached=attached is not None)
        except sqlite3.Error as error:
            future.set_exception(translated(error, self._path))
        except Exception as error:
            future.set_exception(error)
        else:
            future.set_result(result)
            self.on_written()

    @contextlib.contextmanager
    def _attaching(self, address: str | None) -> Iterator[None]:
        """Attaches the file for one job, outside of the transaction, as SQLite requires."""
        if address is None:
            yield
            return
        self._connection.execute(f"ATTACH DATABASE ? AS {ATTACHED}", [address])
        try:
            yield
        finally:
            self._connection.execute(f"DETACH DATABASE {ATTACHED}")

    def _of_readable_texts(
        self, job: Callable[[sqlite3.Connection], T], *, has_attached: bool
    ) -> T:
        """Runs the job. If a damaged text stops it, runs it again with a tolerant decoder.

        Otherwise one damaged name would prevent all writing.
        """
        try:
            return self._in_transaction(job, has_attached=has_attached)
        except sqlite3.Error as error:
            if not is_text_damage(error):
                raise
        read_all_texts(self._connection)
        return self._in_transaction(job, has_attached=has_attached)

    def _in_transaction(self, job: Callable[[sqlite3.Connection], T], *, has_attached: bool) -> T:
        # IMMEDIATE: otherwise a job that reads first would fail if another process wrote in between
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            n_changes = self._connection.total_changes
            result = job(self._connection)
            if has_attached:
                repair_from(self._connection, ATTACHED)
            self._changes.update_checksums(self._connection)
            has_changed = self._connection.total_changes != n_changes
            n_saves = count_save(self._connection) if has_changed else None
            self._connection.execute("COMMIT")
        except BaseException:
            if self._connection.in_transaction:
                self._connection.execute("ROLLBACK")
            raise
        if n_saves is not None:
            self._in_log_since = self._in_log_since or time.monotonic()
            self._commit_counter.write(n_saves, self._now())
        return result
