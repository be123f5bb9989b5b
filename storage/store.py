"""The store as a whole."""

import contextlib
import sqlite3
from collections.abc import Callable
from concurrent.futures import Future
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

from storage.checks import Checks
from storage.classrooms import Classrooms
from storage.computers import Computers
from storage.connection import Access, uptime_s
from storage.errors import StoreError
from storage.groups import Groups
from storage.history import History
from storage.lessons import Lessons
from storage.lessons_read import LessonRecords
from storage.notes import Notes
from storage.opening import Notice, connect, prepare, prepare_reading
from storage.programs import Programs
from storage.runs import Batch, Runs, close_runs, is_there, write_batch
from storage.schema import migrate
from storage.settings import Settings
from storage.text import new_id
from storage.versions import Versions

if TYPE_CHECKING:
    from storage.exchange import Exchange

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
        self.computers = Computers(access)
        self.classrooms = Classrooms(access)
        self.groups = Groups(access)
        self.lessons = Lessons(access)
        self.programs = Programs(access)
        self.versions = Versions(access)
        self.runs = Runs(access)
        self.checks = Checks(access)
        self.notes = Notes(access)
        self.history = History(access)
        self.lesson_records = LessonRecords(access)
        self.settings = Settings(access)
        self._interrupted: list[str] = []
        self._keep_alive: sqlite3.Connection | None = None

    def now(self) -> str:
        """The time as text."""
        return self._access.now()

    @property
    def can_write(self) -> bool:
        """False for a file that cannot be written, and after closing."""
        return self._access.can_write

    @property
    def unfinished(self) -> bool:
        """True when runs that were cut off could not be closed at the start; `record` closes them."""
        return bool(self._interrupted)

    @property
    def exchange(self) -> "Exchange":
        """What goes from this file to others and comes from them."""
        from storage.exchange import Exchange  # noqa: PLC0415 - most starts need none of it

        return Exchange(self._access)

    def mend(self, stop: Callable[[], bool] = lambda: False) -> str | None:
        """Looks at the whole file, which takes long; indexes that do not fit are made anew. What is wrong then."""
        from storage.mending import mend  # noqa: PLC0415 - after the start

        return mend(self._access, stop)

    def listen(self, on_written: Callable[[], None]) -> None:
        """Has it called after each write that is on disk, on the writer's thread; it must not raise or wait."""
        self._access.listen(on_written)

    def record(self, waiting: Callable[[], list[Batch]]) -> "Future[list[Batch]]":
        """Writes what is waiting when its turn comes, in one transaction; the future gives what is on disk.

        Batches of a run that is no longer there are done with too: they must not keep the others waiting.
        """
        now, interrupted = self._access.now(), self._interrupted

        def write(db: sqlite3.Connection) -> list[Batch]:
            close_runs(db, interrupted, now)
            batches = waiting()
            for batch in batches:
                if is_there(db, batch.run_id):
                    write_batch(db, batch)
            return batches

        written = self._access.submit(write)
        if interrupted:
            written.add_done_callback(self._forget_interrupted)
        return written

    def close_interrupted(self) -> None:
        """Ends the runs that the program before left `running`; later, with `record`, where the disk is full."""
        try:
            self.runs.close_interrupted()
        except StoreError as error:  # must not keep what is there from being read
            self.notice = self.notice or Notice(error.code, error.params)
            with contextlib.suppress(StoreError):
                self._interrupted = self.runs.running()

    def _forget_interrupted(self, written: "Future[list[Batch]]") -> None:
        if written.exception() is None:
            self._interrupted, self.notice = [], None

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
        migrate(keep_alive)
        store = cls(
            Access(path, address, refusal, _utc_now),
            writable=False,
            notice=Notice(refusal.code, refusal.params),
        )
        store._keep_alive = keep_alive
        return store


def open_store(
    path: Path,
    *,
    close_interrupted: bool = False,
    clock: Clock = _utc_now,
    uptime: Callable[[], float] = uptime_s,
) -> Store:
    """Opens the file, making it and its folder where there is none.

    A damaged file is set aside and its last good backup takes its place, or a new one is begun; a file that can
    only be read is opened for reading. Both are told by `notice`.

    Args:
        close_interrupted: ends runs that are still `running`. Only for the one program that holds the lock of
            the data folder: another may be running one.
        uptime: a clock in s that nobody sets.

    Raises:
        StoreError: the file cannot be used at all; it is untouched.
    """
    opened = prepare(path, clock())
    refusal = None if opened.writable else StoreError("database_read_only", path=str(path))
    store = Store(
        Access(path, opened.address, refusal, clock, uptime),
        writable=opened.writable,
        notice=opened.notice,
    )
    if close_interrupted and opened.writable:
        store.close_interrupted()
    return store


def open_for_reading(path: Path) -> Store:
    """Opens the file as it is, touching nothing, also while another program has it open; every write is refused.

    Raises:
        StoreError: the file cannot be read: `database_damaged`, `database_older`, `database_newer` and others.
    """
    opened = prepare_reading(path)
    refusal = StoreError("database_read_only", path=str(path))
    return Store(Access(path, opened.address, refusal, _utc_now), writable=False)
