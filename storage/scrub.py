"""Reading every version and every run once a day, slowly: what is not as it was written is mended, or told.

It takes a twentieth of one processor and of the disk: after each piece it rests for nineteen times as long as the
piece took.
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
_FIRST_S = 60.0  # after the start, when the group is at work
_EVERY_S = 86_400.0
_PIECE_S = 0.02
_REST = 19.0  # times as long as a piece took
_AT_ONCE = 50  # keys that are looked up together
_Key = tuple[str, str]


class Scrubber:
    """Checks and mends on a thread of its own between `start` and `close`.

    Args:
        on_found: called on the thread with what a person should know.
        pause: waits so many s; True when it is to end.

    Attributes:
        notice: what a person should know of damage that was found since the start, None when there was none.
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
        """Begins a minute later; does nothing for a file that cannot be written."""
        if self._database.can_write:
            self._thread = threading.Thread(target=self._work, name="content-check", daemon=True)
            self._thread.start()

    def close(self) -> None:
        """Ends at once, wherever it is."""
        self._ended.set()
        if self._thread is not None:
            self._thread.join()

    def check_all(self) -> tuple[int, int]:
        """Checks everything once; returns how many rows were mended, and how many are left damaged."""
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
            except StoreError as error:  # the disk is full, the file is locked: tomorrow again
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
        """Places and keys of the next rows, by place: a key may be what is damaged."""
        home = "versions" if table == "versions" else "runs"
        ended = "" if table == "versions" else "AND state <> 'running'"
        query = f"SELECT rowid, id FROM {home} WHERE rowid > ? {ended} ORDER BY rowid LIMIT ?"
        with self._database.read_connection() as db:
            return [(place, key) for place, key in rows_of(db, query, [after, _AT_ONCE])]

    def _missing(self, table: str) -> list[_Key]:
        """Keys whose row is gone, though nobody deleted it."""
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
        if unseen:  # of an earlier release: what is there now is taken as right
            self._database.write(lambda db: add_missing_checksums(db, unseen))

    def _state_of(self, table: str, key: str) -> str:
        with self._database.read_connection() as db:
            if stored_checksum(db, table, key) is None:
                return "unseen"
            return "sound" if is_intact(db, table, key) else "damaged"
