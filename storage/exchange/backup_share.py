"""Copies the backups to the school's shared folder, on a thread of its own.

A network folder may be slow, full, read-only or disconnected, and a call to it may block for ever. So no other thread
waits for it without a time limit. One thread at a time works there, and the next one starts when it has ended.
"""

import errno
import os
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from storage.file.connection import Database
from storage.file.notices import Notice
from storage.work.computers import Computers
from storage.work.settings import Settings

if TYPE_CHECKING:  # few PCs make copies
    from storage.file.share_copies import ShareCopies

SHARED_FOLDER = "shared_folder"
COPIES_BACKUPS = "shared_folder_takes_backups"
_CLEAN_TIMEOUT_S = 5.0  # limit for a deletion for good
_SLOW_S = 600.0


@dataclass(frozen=True, slots=True)
class _Task:
    """The shared folder, None for none, and the keys of rows that no copy may hold."""

    copies: "ShareCopies"
    shared: Path | None
    tombstoned: frozenset[str]


class BackupShare:
    """The copies of one database's backups in the shared folder. Thread-safe.

    Attributes:
        problem: why the folder lacks the newest backup, None if it has it.
        on_change: called, on any thread, after `problem` may have changed.
    """

    def __init__(self, database: Database) -> None:
        self.problem: Notice | None = None
        self.on_change: Callable[[], None] = lambda: None
        self._database = database
        self._changed = threading.Condition()
        self._task: _Task | None = None
        self._n_requested = self._n_cleaned = self._n_done = 0
        self._left: tuple[Path, ...] = ()
        self._start_s: float | None = None  # start of the current round of work, None if idle

    def update(self, wait_s: float = 0.0) -> bool:
        """Updates the copies in the folder; returns True if that was done within `wait_s` seconds."""
        return self._ask(wait_s, lambda n_requested: self._n_done >= n_requested)

    def resume(self) -> None:
        """Tries again to delete the copies that the last attempt could not delete."""
        if self._left:
            self.update()

    def clean(self) -> tuple[Path, ...]:
        """Deletes copies that hold deleted rows, and copies the newest backup again. Waits for 5 s at most.

        Returns:
            Copies that may still hold deleted rows.
        """
        is_in_time = self._ask(_CLEAN_TIMEOUT_S, lambda n_requested: self._n_cleaned >= n_requested)
        if not is_in_time and self._task is not None:
            self._left = self._task.copies.manifest.copies
        return self._left

    def _ask(self, wait_s: float, is_over: Callable[[int], bool]) -> bool:
        task = self._next_task()
        with self._changed:
            if task is None:
                self.problem, self._left = None, ()
                is_in_time = True
            else:
                self._task = task
                self._n_requested += 1
                n_requested, waited_s = self._n_requested, self._start(task)
                is_in_time = self._changed.wait_for(
                    lambda: is_over(n_requested), max(0.0, wait_s - waited_s)
                )
        self.on_change()
        return is_in_time

    def _next_task(self) -> _Task | None:
        """Returns the task, None if there is nothing to do. Raises StoreError."""
        from storage.exchange.deleting.deletion import tombstoned_keys  # noqa: PLC0415 - few PCs need it
        from storage.file.share_copies import ShareCopies, read_manifest  # noqa: PLC0415 - few PCs need it

        settings, path = Settings(self._database), self._database.path
        shared = settings.get(COPIES_BACKUPS) and settings.get(SHARED_FOLDER)
        if not shared and not read_manifest(path):
            return None
        with self._database.read_connection() as db:
            tombstoned = frozenset(tombstoned_keys(db))
        copies = ShareCopies(path, Computers(self._database).this())
        if shared:
            return _Task(copies, Path(shared), tombstoned)
        return _Task(copies, None, tombstoned) if tombstoned and copies.manifest.copies else None

    def _start(self, task: _Task) -> float:
        """Starts the thread unless it runs; returns for how long it has been working, in s."""
        now_s = time.monotonic()
        if self._start_s is None:
            self._start_s = now_s
            threading.Thread(target=self._work, name="backup-share", daemon=True).start()
        elif task.shared and now_s - self._start_s > _SLOW_S:
            self.problem = _notice(task.shared, os.strerror(errno.ETIMEDOUT))
        return now_s - self._start_s

    def _work(self) -> None:
        is_pending = True
        while is_pending:
            with self._changed:
                n_requested, task = self._n_requested, self._task
            problem = self._do(task, n_requested) if task else None
            with self._changed:
                self.problem, self._n_cleaned, self._n_done = problem, n_requested, n_requested
                is_pending = n_requested < self._n_requested
                self._start_s = time.monotonic() if is_pending else None
                self._changed.notify_all()
            self.on_change()

    def _do(self, task: _Task, n_requested: int) -> Notice | None:
        self._left = task.copies.manifest.copies  # until `clean` has inspected them
        try:
            left = task.copies.clean(task.shared, task.tombstoned)
            with self._changed:
                self._left, self._n_cleaned = left, n_requested
                self._changed.notify_all()
            if task.shared:
                task.copies.copy_newest(task.shared, task.tombstoned)
        except Exception as error:  # any failure is shown; the next attempt is in an hour
            problem = getattr(error, "strerror", None) or str(error)
            return _notice(task.shared, problem) if task.shared else None
        return None


def _notice(shared: Path, problem: str) -> Notice:
    return Notice("backup_share_failed", {"folder": str(shared), "problem": problem})
