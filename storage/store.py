"""The store: opens the file and has all repositories."""

import contextlib
from collections.abc import Callable
from concurrent.futures import Future
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from storage.errors import StoreError
from storage.exchange.backup_share import BackupShare
from storage.file.commit_counter import commit_count
from storage.file.connection import Database, uptime_s
from storage.file.notices import Notice, SalvageResult
from storage.file.opening import connect, prepare, prepare_reading
from storage.runs.album_runs import AlbumRuns
from storage.runs.confirmation import Unconfirmed
from storage.runs.grading import GradingResults
from storage.runs.history import RunHistory
from storage.runs.runs import Batch, Runs, close_runs, write_batch
from storage.runs.truths import Truths
from storage.sql import Stop, exists
from storage.sqlite import sqlite3
from storage.tables.migrations import migrate
from storage.text import new_id, utc_now
from storage.work.calibrated_robots import CalibratedRobots
from storage.work.class_presets import ClassPresets
from storage.work.classrooms import Classrooms
from storage.work.computers import Computers
from storage.work.groups import Groups
from storage.work.lesson_history import LessonHistories
from storage.work.lessons import Lessons
from storage.work.notes import Notes
from storage.work.own_activities import OwnActivities
from storage.work.programs import Programs
from storage.work.settings import Settings
from storage.work.taught_signs import TaughtSigns
from storage.work.versions import Versions

if TYPE_CHECKING:
    from storage.exchange.exchange import Exchange
    from storage.scrub import Scrubber

Clock = Callable[[], datetime]


class Store:
    """One open file. Thread-safe; close it, or use it as a context manager.

    Attributes:
        notice: a notice to people about the file since it was opened, None for none.
    """

    def __init__(self, database: Database, *, writable: bool, notice: Notice | None = None) -> None:
        self._database = database
        self.path = database.path
        self.writable = writable
        self.notice = notice
        self.computers = Computers(database)
        self.classrooms = Classrooms(database)
        self.class_presets = ClassPresets(database)
        self.own_activities = OwnActivities(database)
        self.calibrated_robots = CalibratedRobots(database)
        self.groups = Groups(database)
        self.lessons = Lessons(database)
        self.taught_signs = TaughtSigns(database)
        self.programs = Programs(database)
        self.versions = Versions(database)
        self.runs = Runs(database)
        self.grading_results = GradingResults(database)
        self.album_runs = AlbumRuns(database)
        self.unconfirmed = Unconfirmed(database)
        self.notes = Notes(database)
        self.truths = Truths(database)
        self.history = RunHistory(database)
        self.lesson_histories = LessonHistories(database)
        self.settings = Settings(database)
        self.backup_share = BackupShare(database)
        self._interrupted: list[str] = []
        self._memory_connection: sqlite3.Connection | None = None

    def now(self) -> str:
        """Returns the time as text."""
        return self._database.now()

    @property
    def can_write(self) -> bool:
        """False for a file that cannot be written, and after closing."""
        return self._database.can_write

    @property
    def unfinished(self) -> bool:
        """True if interrupted runs could not be closed at the start; `record` closes them."""
        return bool(self._interrupted)

    def is_interrupted(self, run_id: str) -> bool:
        """Returns True for an interrupted run that is still `running` in the file, which cannot be written."""
        return run_id in self._interrupted or not self.can_write

    @property
    def exchange(self) -> "Exchange":
        """Export, merge, and deletion for good."""
        from storage.exchange.exchange import Exchange  # noqa: PLC0415 - few starts need it

        return Exchange(self._database, self.backup_share)

    def check_and_reindex(self, stop: Stop = lambda: False) -> str | None:
        """Checks the whole file, which takes long, and rebuilds indexes if needed; see `integrity`."""
        from storage.file.integrity import check_and_reindex  # noqa: PLC0415 - after the start

        return check_and_reindex(self._database, stop)

    def scrubber(self, on_found: Callable[[Notice], None]) -> "Scrubber":
        """Returns the daily check of versions and runs."""
        from storage.scrub import Scrubber  # noqa: PLC0415 - after the start

        return Scrubber(self._database, on_found)

    def n_saves(self) -> int:
        """Returns the commit count of the file."""
        with self._database.read_connection() as db:
            return commit_count(db)

    def salvage(self, file: Path) -> SalvageResult:
        """Merges the readable rows of a damaged file, without time limit; only reads that file.

        Raises:
            StoreError, OSError, sqlite3.Error: nothing was merged.
        """
        from storage.salvage.salvage import salvage  # noqa: PLC0415 - rarely needed

        return salvage(self._database, file)

    def listen(self, on_written: Callable[[], None]) -> None:
        """Calls `on_written` after each write that is on disk, on the writer's thread; it must not raise or wait."""
        self._database.listen(on_written)

    def record(self, waiting: Callable[[], list[Batch]]) -> "Future[list[Batch]]":
        """Writes the batches that `waiting` returns when the writer is free, in one transaction.

        The future gets the batches that are on disk. Batches of a deleted run count as written, so that they do not
        hold up the others.
        """
        now, interrupted = self._database.now(), self._interrupted

        def write(db: sqlite3.Connection) -> list[Batch]:
            close_runs(db, interrupted, now)
            batches = waiting()
            for batch in batches:
                if exists(db, "runs", batch.run_id):
                    write_batch(db, batch)
            return batches

        written = self._database.submit(write)
        if interrupted:
            written.add_done_callback(self._forget_interrupted)
        return written

    def close_interrupted(self) -> None:
        """Ends the runs that the previous process left `running`. If the disk is full, `record` ends them later."""
        try:
            self.runs.close_interrupted()
        except StoreError as error:  # the file can still be read
            self.notice = self.notice or Notice(error.code, error.params)
            with contextlib.suppress(StoreError):
                self._interrupted = self.runs.running()

    def _forget_interrupted(self, written: "Future[list[Batch]]") -> None:
        if written.exception() is None:
            self._interrupted, self.notice = [], None

    def close(self) -> None:
        """Finishes queued jobs and closes the file."""
        self._database.close()
        if self._memory_connection is not None:
            self._memory_connection.close()

    def __enter__(self) -> "Store":
        return self

    def __exit__(self, *_error: object) -> None:
        self.close()

    @classmethod
    def without_file(cls, path: Path, refusal: StoreError) -> "Store":
        """Returns a placeholder for a file that cannot be opened: empty; every write raises the refusal."""
        address = f"file:{new_id()}?mode=memory&cache=shared"
        memory_connection = connect(address)
        migrate(memory_connection)
        store = cls(
            Database(path, address, refusal, utc_now),
            writable=False,
            notice=Notice(refusal.code, refusal.params),
        )
        store._memory_connection = memory_connection
        return store


def open_store(
    path: Path,
    *,
    close_interrupted: bool = False,
    clock: Clock = utc_now,
    uptime: Callable[[], float] = uptime_s,
) -> Store:
    """Opens the file; creates it and its folder if there is none.

    A damaged file is set aside, and its last intact backup or a new file replaces it. A read-only file is opened for
    reading. `notice` describes either case.

    Args:
        close_interrupted: ends runs that are still `running`. Only for the one process that holds the lock of the data
            folder, as another process may be running one.
        uptime: a monotonic clock in s.

    Raises:
        StoreError: the file cannot be used at all; it is untouched.
    """
    opened = prepare(path, clock(), _salvage_into)
    is_full = opened.notice is not None and opened.notice.code == "disk_full_at_start"
    refusal = StoreError("disk_full_at_start" if is_full else "database_read_only", path=str(path))
    store = Store(
        Database(path, opened.address, None if opened.writable else refusal, clock, uptime),
        writable=opened.writable,
        notice=opened.notice,
    )
    if close_interrupted and opened.writable:
        store.close_interrupted()
    return store


def _salvage_into(file: Path, target: Path, now: str) -> SalvageResult:
    from storage.salvage.salvage import salvage_into  # noqa: PLC0415 - few starts need it

    return salvage_into(file, target, now)


def open_for_reading(path: Path) -> Store:
    """Opens the file as it is, without changing anything, also while another program has it open; refuses writes.

    Raises:
        StoreError: the file cannot be read: `database_damaged`, `database_older`, `database_newer` and others.
    """
    opened = prepare_reading(path)
    refusal = StoreError("database_read_only", path=str(path))
    return Store(Database(path, opened.address, refusal, utc_now), writable=False)
