"""Looks after the file while the app runs: a backup a day, none that holds what was deleted, and room on the disk."""

import contextlib
import threading
from collections.abc import Callable
from datetime import UTC, datetime

from storage.errors import StoreError
from storage.opening import Notice
from storage.places import Free, free_bytes
from storage.store import Store

NEARLY_FULL = 500 * 10**6
_ROOM_AGAIN = 550 * 10**6
_FIRST_S = 15.0  # the start is over, and a group's first edits are not in its way
_EVERY_S = 300.0
_LOOKS_PER_BACKUP = 12  # an hour


def _utc_now() -> datetime:
    return datetime.now(UTC)


class Caretaker:
    """Makes backups and watches the disk, on a thread of its own between `start` and `close`.

    Args:
        on_change: told when there is something else to know, or with None that all is well again; on the thread.
        free: bytes that are free where a folder lies.

    Attributes:
        notice: what a person should know now, None when all is well.
    """

    def __init__(
        self,
        store: Store,
        on_change: Callable[[Notice | None], None] = lambda notice: None,
        *,
        clock: Callable[[], datetime] = _utc_now,
        free: Free = free_bytes,
    ) -> None:
        self.notice: Notice | None = None
        self._store = store
        self._on_change = on_change
        self._clock = clock
        self._free = free
        self._space: Notice | None = None
        self._backup: Notice | None = None
        self._ended = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """Looks at the disk at once, at everything else later; does nothing for a file that cannot be written."""
        if self._store.can_write:
            self.look_at_disk()
            self._thread = threading.Thread(target=self._work, name="store-caretaker", daemon=True)
            self._thread.start()

    def close(self) -> None:
        """Ends soon, also in the middle of a backup, which then leaves nothing."""
        self._ended.set()
        if self._thread is not None:
            self._thread.join()

    def look_at_disk(self) -> None:
        """Finds out whether the disk is nearly full."""
        try:
            free = self._free(self._store.path.parent)
        except OSError:  # it says so itself when something is written
            return
        if free < (_ROOM_AGAIN if self._space else NEARLY_FULL):
            folder = str(self._store.path.parent)
            self._space = Notice("disk_nearly_full", {"free_mb": free // 10**6, "folder": folder})
        else:
            self._space = None
        self._tell()

    def back_up(self) -> None:
        """Makes a backup if it is time for one."""
        from storage.backups import folder_of, is_due, make_backup  # noqa: PLC0415 - after the start

        path, now = self._store.path, self._clock()
        if not is_due(path, now):
            return
        try:
            make_backup(path, now, free=self._free, stop=self._ended.is_set)
        except StoreError as error:
            self._backup = Notice(error.code, error.params)
        except (
            Exception
        ) as error:  # whatever it is, people are told, and the next is tried in an hour
            self._backup = Notice(
                "backup_failed", {"folder": str(folder_of(path)), "problem": str(error)}
            )
        else:
            self._backup = None
        self._tell()

    def look_at_file(self) -> None:
        """Finds damage that the start does not look for; what can be mended without loss is."""
        if problem := self._store.mend(self._ended.is_set):
            path = str(self._store.path)
            self._backup = Notice("backup_found_damage", {"path": path, "problem": problem})
            self._tell()

    def finish_removals(self) -> None:
        """Backups lose what was deleted for good, where that was cut off; what cannot be done now is tried again."""
        with contextlib.suppress(StoreError):
            self._store.exchange.finish_removals(self._ended.is_set)

    def _work(self) -> None:
        pause_s, n_looks = _FIRST_S, 0
        while not self._ended.wait(pause_s):
            self.look_at_disk()
            if n_looks == 0:
                self.look_at_file()
            if n_looks % _LOOKS_PER_BACKUP == 0:
                self.back_up()
            self.finish_removals()
            pause_s, n_looks = _EVERY_S, n_looks + 1

    def _tell(self) -> None:
        """A figure that changed is shown when somebody asks; only another notice is worth a word."""
        before, self.notice = self.notice, self._space or self._backup
        if (before and before.code) != (self.notice and self.notice.code):
            self._on_change(self.notice)
