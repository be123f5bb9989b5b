"""The scrubber: verifies the checksums of all versions and runs once a day, and repairs or reports damaged ones.

It uses a twentieth of one processor and of the disk: after each piece of work it pauses for 19 times its duration.
"""

import logging
import threading
import time
from collections.abc import Callable, Iterator

from storage.errors import StoreError
from storage.file.connection import Database
from storage.file.notices import Notice
from storage.file.row_checksums import KEYS, add_missing_checksums, is_intact, stored_checksum
from storage.file.row_repair import try_repair
from storage.sql import rows_of

_log = logging.getLogger(__name__)
_FIRST_S = 60.0  # after the start, when the group works
_EVERY_S = 86_400.0
_PIECE_S = 0.02
_REST = 19.0  # ratio of the pause to the duration of a piece
_BATCH_SIZE = 50  # keys that are queried together
_Key = tuple[str, str]


class Scrubber:
    """Checks and repairs on a thread of its own between `start` and `close`.

    Args:
        on_found: called on that thread with a notice to people.
        pause: waits for so many seconds; returns True to end the thread.

    Attributes:
        notice: the notice of damage found since the start, None for none.
    """

    def __init__(
        self,
        database: Database,
        on_found: Callable[[Notice], None] = lambda notice: None,
        *,
        pause: Callable[[float], bool] | None = None,
    ) -> None:
        self.notice: Notice | None = None
        self._database = database
        self._on_found = on_found
        self._ended = threading.Event()
        self._pause = pause or self._ended.wait
        self._thread: threading.Thread | None = None

    def start(self) -> None:
        """Starts the thread, whose first check is a minute later; does nothing if the file cannot be written."""
        if self._database.can_write:
            self._thread = threading.Thread(target=self._work, name="content-check", daemon=True)
            self._thread.start()

    def close(self) -> None:
        """Stops the thread at once, even during a check."""
        self._ended.set()
        if self._thread is not None:
            self._thread.join()

    def check_all(self) -> tuple[int, int]:
        """Checks everything once; returns how many rows were repaired, and how many stay damaged."""
        n_repaired = n_damaged = 0
        for table, key in self._found_damaged():
            if try_repair(self._database, table, key):
                n_repaired += 1
            else:
                n_damaged += 1
        self._notify(n_repaired, n_damaged)
        return n_repaired, n_damaged

    def _work(self) -> None:
        pause_s = _FIRST_S
        while not self._pause(pause_s):
            try:
                self.check_all()
            except StoreError as error:  # a full disk or a locked file: tries again tomorrow
                _log.warning("the content was not checked to its end: %s", error)
            pause_s = _EVERY_S

    def _notify(self, n_repaired: int, n_damaged: int) -> None:
        if n_damaged:
            self.notice = Notice("values_damaged", {"n": n_damaged})
        elif n_repaired:
            self.notice = Notice("values_mended", {"n": n_repaired})
        else:
            return
        self._on_found(self.notice)

    def _found_damaged(self) -> Iterator[_Key]:
        for table in KEYS:
            after = 0
            while (rows := self._rows(table, after)) and not self._ended.is_set():
                after = rows[-1][0]
                yield from self._damaged_of(table, [str(key) for _, key in rows])
            yield from self._missing(table)

    def _rows(self, table: str, after: int) -> list[tuple[int, str]]:
        """Returns row numbers and keys of the next rows, by row number, as a key may be damaged."""
        home = "versions" if table == "versions" else "runs"
        ended = "" if table == "versions" else "AND state <> 'running'"
        query = f"SELECT rowid, id FROM {home} WHERE rowid > ? {ended} ORDER BY rowid LIMIT ?"
        with self._database.read_connection() as db:
            return [(place, key) for place, key in rows_of(db, query, [after, _BATCH_SIZE])]

    def _missing(self, table: str) -> list[_Key]:
        """Returns the keys with a checksum whose row is missing though nobody deleted it."""
        query = f"""SELECT row_id FROM content_sums WHERE table_name = ?
            AND row_id NOT IN (SELECT {KEYS[table]} FROM {table})
            AND row_id NOT IN (SELECT id FROM tombstones)"""
        with self._database.read_connection() as db:
            keys = [str(key) for (key,) in db.execute(query, [table])]
            return [(table, key) for key in keys if not is_intact(db, table, key)]

    def _damaged_of(self, table: str, keys: list[str]) -> Iterator[_Key]:
        unseen: list[_Key] = []
        start_s = time.monotonic()
        for key in keys:
            match self._state_of(table, key):
                case "unseen":
                    unseen.append((table, key))
                case "damaged":
                    yield table, key
            if (spent := time.monotonic() - start_s) > _PIECE_S:
                if self._pause(spent * _REST):
                    self._ended.set()
                    return
                start_s = time.monotonic()
        if unseen:  # rows of an earlier release: their present content counts as right
            self._database.write(lambda db: add_missing_checksums(db, unseen))

    def _state_of(self, table: str, key: str) -> str:
        with self._database.read_connection() as db:
            if stored_checksum(db, table, key) is None:
                return "unseen"
            return "sound" if is_intact(db, table, key) else "damaged"
