"""The store as a whole."""

import sqlite3
from collections.abc import Callable
from concurrent.futures import Future
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType

from sqlite_utils import Database

from storage.connection import Access
from storage.errors import StoreError
from storage.groups import Groups
from storage.opening import Notice, connect, prepare
from storage.programs import Programs
from storage.runs import Batch, Runs, write_batch
from storage.schema import migrations
from storage.settings import Settings
from storage.text import new_id
from storage.versions import Versions

Clock = Callable[[], datetime]


def _utc_now() -> datetime:
    return datetime.now(UTC)


class Store:
    """One open file. Thread-safe; close it, or use it as a context manager.

    Attributes:
        notice: what a person should know about the file since it was opened, None when all is well.
    """

    def __init__(self, access: Access, *, writable: bool, notice: Notice | None = None) -> None:
        self._access = access
        self.path = access.path
        self.writable = writable
        self.notice = notice
        self.groups = Groups(access)
        self.programs = Programs(access)
        self.versions = Versions(access)
        self.runs = Runs(access)
        self.settings = Settings(access)
        self._keep_alive: sqlite3.Connection | None = None

    def record(self, waiting: Callable[[], list[Batch]]) -> "Future[list[Batch]]":
        """Writes what is waiting when its turn comes, in one transaction; the future gives what is on disk."""
        now = self._access.now()

        def write(db: sqlite3.Connection) -> list[Batch]:
            batches = waiting()
            for batch in batches:
                write_batch(db, batch, now)
            return batches

        return self._access.submit(write)

    def close(self) -> None:
        """Finishes what is queued and closes the file."""
        self._access.close()
        if self._keep_alive is not None:
            self._keep_alive.close()

    def __enter__(self) -> "Store":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    @classmethod
    def without_file(cls, path: Path, refusal: StoreError) -> "Store":
        """Stands in for a file that cannot be opened: empty to read, and every write says why."""
        address = f"file:{new_id()}?mode=memory&cache=shared"
        keep_alive = connect(address)
        migrations.apply(Database(keep_alive, execute_plugins=False))
        store = cls(
            Access(path, address, refusal, _utc_now),
            writable=False,
            notice=Notice(refusal.code, refusal.params),
        )
        store._keep_alive = keep_alive
        return store


def open_store(path: Path, *, close_interrupted: bool = False, clock: Clock = _utc_now) -> Store:
    """Opens the file, making it and its folder where there is none.

    A damaged file is set aside and a new one begun; a file that can only be read is opened for reading. Both
    are told by `notice`.

    Args:
        close_interrupted: ends runs that are still `running`. Only for the one program that holds the lock of
            the data folder: another may be running one.

    Raises:
        StoreError: the file cannot be used at all; it is untouched.
    """
    opened = prepare(path, clock())
    refusal = None if opened.writable else StoreError("database_read_only", path=str(path))
    store = Store(
        Access(path, opened.address, refusal, clock), writable=opened.writable, notice=opened.notice
    )
    if close_interrupted and opened.writable:
        try:
            store.runs.close_interrupted()
        except StoreError as error:  # a full disk must not keep what is there from being read
            store.notice = store.notice or Notice(error.code, error.params)
    return store
