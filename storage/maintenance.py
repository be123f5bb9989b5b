"""Maintenance while the app runs: backups and their copies, deletion from them, integrity check, free space."""

import contextlib
import threading
import time
from collections.abc import Callable
from datetime import datetime

from storage.errors import StoreError
from storage.file.filesystems import Free, free_bytes
from storage.file.notices import Notice
from storage.sqlite import sqlite3
from storage.store import Store
from storage.text import utc_now

NEARLY_FULL = 500 * 10**6  # bytes
_ENOUGH_FREE = 550 * 10**6  # bytes; ends the notice
_FIRST_S = 15.0  # after the start, and after a group's first edits
_EVERY_S = 300.0
_CLOSING_S = 3.0
_CHECKS_PER_BACKUP = 12  # an hour


class Maintenance:
    """Makes backups and watches the disk, on a thread of its own between `start` and `close`.

    Args:
        on_change: called with another notice, or with None when there is none any more; never twice at a time.
        free: returns the free bytes on the disk of a folder.

    Attributes:
        notice: the present notice to people, None for none.
    """

    def __init__(
        self,
        store: Store,
        on_change: Callable[[Notice | None], None] = lambda notice: None,
        *,
        clock: Callable[[], datetime] = utc_now,
        free: Free = free_bytes,
    ) -> None:
        self.notice: Notice | None = None
        self._store = store
        self._on_change = on_change
        self._clock = clock
        self._free = free
        self._space: Notice | None = None
        self._backup: Notice | None = None
        self._share = store.backup_share
        self._share.on_change = self._notify
        self._notify_lock = threading.Lock()
        self._ended = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """Checks the free space at once, everything else later; does nothing if the file cannot be written."""
        if self._store.can_write:
            self.check_space()
            self._thread = threading.Thread(
                target=self._work, name="store-maintenance", daemon=True
            )
            self._thread.start()

    def close(self) -> None:
        """Ends soon, even during a backup, which then leaves no file."""
        self._ended.set()
        if self._thread is not None:
            self._thread.join()

    def check_space(self) -> None:
        """Updates the notice that the disk is nearly full."""
        try:
            free = self._free(self._store.path.parent)
        except OSError:  # the next write reports it
            return
        if free < (_ENOUGH_FREE if self._space else NEARLY_FULL):
            folder = str(self._store.path.parent)
            self._space = Notice("disk_nearly_full", {"free_mb": free // 10**6, "folder": folder})
        else:
            self._space = None
        self._notify()

    def back_up(self) -> None:
        """Makes a backup if one is due."""
        from storage.file.backups import folder_of, is_due, make_backup  # noqa: PLC0415 - after the start

        path, now = self._store.path, self._clock()
        try:
            if not is_due(path, now, self._store.n_saves()):
                return
            make_backup(path, now, free=self._free, stop=self._ended.is_set)
        except StoreError as error:
            self._backup = Notice(error.code, error.params)
        except Exception as error:  # any failure is shown; the next attempt is in an hour
            self._backup = Notice(
                "backup_failed", {"folder": str(folder_of(path)), "problem": str(error)}
            )
        else:
            self._backup = None
        self._notify()

    def back_up_at_the_end(self) -> None:
        """Makes a backup if the last one lacks work; stops after 3 s, and then leaves no file.

        For the end of the app, when nothing is written any more. The next start meets a failure again and reports it.
        """
        from storage.file.backups import lacks_work, list_backups, make_backup  # noqa: PLC0415 - after the start

        if not self._store.can_write:
            return
        path, deadline = self._store.path, time.monotonic() + _CLOSING_S
        newest = next(iter(list_backups(path)), None)
        with contextlib.suppress(StoreError, OSError, sqlite3.Error):
            n_saves = self._store.n_saves()
            if n_saves and (newest is None or lacks_work(newest, n_saves)):
                make_backup(
                    path, self._clock(), free=self._free, stop=lambda: time.monotonic() > deadline
                )
                self._share.update(deadline - time.monotonic())

    def copy_to_share(self) -> None:
        """Starts the copying of the newest backup to the school's shared folder, if it is enabled; does not wait."""
        with contextlib.suppress(StoreError):
            self._share.update()

    def check_integrity(self) -> None:
        """Finds damage that the start does not check for, and rebuilds indexes that do not match their tables."""
        if problem := self._store.check_and_reindex(self._ended.is_set):
            path = str(self._store.path)
            self._backup = Notice("backup_found_damage", {"path": path, "problem": problem})
            self._notify()

    def finish_removals(self) -> None:
        """Completes interrupted deletions for good in the backups; a failure is tried again later."""
        with contextlib.suppress(StoreError):
            self._store.exchange.finish_removals(self._ended.is_set)

    def _work(self) -> None:
        pause_s, n_checks = _FIRST_S, 0
        while not self._ended.wait(pause_s):
            self.check_space()
            if n_checks == 0:
                self.check_integrity()
            if n_checks % _CHECKS_PER_BACKUP == 0:
                self.back_up()
                self.copy_to_share()
            self.finish_removals()
            pause_s, n_checks = _EVERY_S, n_checks + 1

    def _notify(self) -> None:
        """Reports another notice. A new number within the same notice is read when the notice is shown."""
        with self._notify_lock:  # `BackupShare` calls it on another thread
            before, self.notice = self.notice, self._space or self._backup or self._share.problem
            is_another = (before and before.code) != (self.notice and self.notice.code)
            if is_another and not self._ended.is_set():
                self._on_change(self.notice)
