"""Disks that are full: nothing that was saved is lost, and what could not be is tried again."""

import contextlib
import errno
import os
import shutil
import subprocess
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from storage import RunRecorder, RunRow, RunStart, Store, StoreError, VersionRow, open_store
from storage.file.backups import make_backup
from storage.sqlite import sqlite3
from tests.storage.file.refusals import code_of
from tests.storage.sample_runs import ended, square

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)
IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


def limit_pages(store: Store, extra: int) -> None:
    """Makes the disk seem full after `extra` more pages."""
    store._database.write(
        lambda db: db.execute(
            f"PRAGMA max_page_count = {db.execute('PRAGMA page_count').fetchone()[0] + extra}"
        ).fetchone()
    )


def test_when_the_disk_is_full_nothing_that_was_saved_is_lost(
    store: Store, version: VersionRow, opened: Callable[..., Store]
) -> None:
    limit_pages(store, 0)
    big = {"blocks": "x" * 50_000}
    assert code_of(lambda: store.versions.save(version.program_id, big, None)) == "disk_full"
    assert opened().versions.newest(version.program_id) == version
    limit_pages(store, 10_000)
    assert store.versions.save(version.program_id, big, None).workspace == big


def test_a_run_goes_on_while_the_disk_is_full_and_is_kept_when_there_is_room_again(
    store: Store, start: RunStart
) -> None:
    run = store.runs.begin(start)
    problems: list[str | None] = []
    recorder = RunRecorder(
        store, lambda problem: problems.append(problem.code if problem else None)
    )
    limit_pages(store, 0)
    events = list(square(run.id, laps=3))
    recorder({**events[0], "type": "run_state", "state": "running", "text": "x" * 20_000})
    for event in events:
        recorder(event)
    with pytest.raises(StoreError, match="disk_full"):
        recorder.flush().result()
    assert recorder.problem is not None
    limit_pages(store, 10_000)
    recorder(ended(run.id, len(events), len(events)))
    assert recorder.problem is None
    assert problems == ["disk_full", None]
    assert store.runs.get(run.id).state == "finished"
    assert len(store.runs.telemetry(run.id).rows) == len(events)


class ManualTimer:
    """Calls when the test says so."""

    def __init__(self) -> None:
        self.waiting: list[tuple[float, Callable[[], None]]] = []

    def __call__(self, delay_s: float, call: Callable[[], None]) -> Callable[[], None]:
        entry = (delay_s, call)
        self.waiting.append(entry)
        return lambda: self.waiting.remove(entry)

    def elapse(self) -> float:
        delay_s, call = self.waiting.pop()
        call()
        return delay_s


def settle(store: Store, job: Callable[[sqlite3.Connection], object] = lambda db: None) -> None:
    """Waits for all that was handed to the writer before; no write that the recorder could hear of."""

    def fail(db: sqlite3.Connection) -> None:
        job(db)
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        store._database.write(fail)


@pytest.fixture
def timer() -> ManualTimer:
    return ManualTimer()


@pytest.fixture
def problems() -> list[str | None]:
    return []


@pytest.fixture
def recorder(store: Store, timer: ManualTimer, problems: list[str | None]) -> RunRecorder:
    def note(problem: StoreError | None) -> None:
        problems.append(problem.code if problem else None)

    return RunRecorder(store, note, schedule=timer)


def end_on_a_full_disk(store: Store, recorder: RunRecorder, run: RunRow) -> None:
    limit_pages(store, 0)
    recorder({**ended(run.id, 0, 60), "text": "x" * 20_000})
    settle(store)
    assert recorder.problem is not None


def test_the_end_of_a_run_is_written_by_itself_when_the_disk_has_room_again(
    store: Store,
    start: RunStart,
    recorder: RunRecorder,
    timer: ManualTimer,
    problems: list[str | None],
) -> None:
    run = store.runs.begin(start)
    assert timer.waiting == []
    end_on_a_full_disk(store, recorder, run)
    for _ in range(3):
        assert 1 <= timer.elapse() <= 2
        settle(store)
        assert (problems, len(timer.waiting)) == (["disk_full"], 1)
    settle(store, lambda db: db.execute("PRAGMA max_page_count = 10000").fetchone())
    assert store.runs.get(run.id).state == "running"
    timer.elapse()
    settle(store)
    assert store.runs.get(run.id).state == "finished"
    assert (problems, timer.waiting, recorder.problem) == (["disk_full", None], [], None)


def test_the_end_of_a_run_is_written_after_anything_else_that_could_be(
    store: Store, start: RunStart, recorder: RunRecorder, timer: ManualTimer
) -> None:
    run = store.runs.begin(start)
    end_on_a_full_disk(store, recorder, run)
    limit_pages(store, 10_000)
    settle(store)
    assert store.runs.get(run.id).state == "finished"
    assert timer.waiting == []


def test_a_run_that_could_be_written_late_only_ended_when_it_ended(
    opened: Callable[..., Store], start: RunStart, timer: ManualTimer
) -> None:
    now = [NOON]
    store = opened(clock=lambda: now[0])
    recorder = RunRecorder(store, schedule=timer)
    run = store.runs.begin(start)
    end_on_a_full_disk(store, recorder, run)
    now[0] += timedelta(hours=1)
    limit_pages(store, 10_000)
    settle(store)
    assert store.runs.get(run.id).ended_at == "2026-11-21T12:00:00.000000Z"


@pytest.mark.parametrize("end", ["recorder", "store"])
def test_nothing_is_tried_any_more_after_closing(
    store: Store, start: RunStart, recorder: RunRecorder, timer: ManualTimer, end: str
) -> None:
    end_on_a_full_disk(store, recorder, store.runs.begin(start))
    (recorder if end == "recorder" else store).close()
    while timer.waiting:
        assert end == "store"
        timer.elapse()


def test_a_run_that_was_cut_off_is_closed_later_when_the_disk_was_full_at_the_start(
    path: Path,
    store: Store,
    start: RunStart,
    opened: Callable[..., Store],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    run = store.runs.begin(start)

    def refuse(runs: object) -> None:
        raise StoreError("disk_full", path=str(path))

    with monkeypatch.context() as patch:
        patch.setattr("storage.runs.runs.Runs.close_interrupted", refuse)
        reopened = opened(close_interrupted=True)
    assert (reopened.unfinished, reopened.notice and reopened.notice.code) == (True, "disk_full")
    recorder = RunRecorder(reopened)
    recorder.flush()
    recorder.flush().result()
    assert reopened.runs.get(run.id).reason == "interrupted"
    assert [event["type"] for event in reopened.runs.events(run.id)] == ["run_ended"]
    assert (reopened.unfinished, reopened.notice) == (False, None)


@pytest.fixture
def tiny_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 1 MB, which a new file and its log half fill, where this user may make one."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=1000k", "tmpfs", str(folder)]
    if not IS_ROOT or subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("only root can make a small disk")
    yield folder
    subprocess.run(["umount", "-l", str(folder)], check=True)


def test_a_disk_that_is_really_full_is_told_and_keeps_what_was_saved(tiny_disk: Path) -> None:
    path = tiny_disk / "pinel.db"
    saved = []
    with open_store(path) as store:
        program = store.programs.create(store.groups.create("A").id, "P")

        def save_on_and_on() -> None:
            for n in range(1000):
                content = {"n": n, "text": "x" * 8000}
                saved.append(store.versions.save(program.id, content, None))

        assert code_of(save_on_and_on) == "disk_full"
        assert len(saved) > 5
        assert store.versions.newest(program.id) == saved[-1]
    with open_store(path, close_interrupted=True) as again:
        assert again.versions.newest(program.id) == saved[-1]


def test_a_run_that_ended_on_a_full_disk_is_kept_when_the_filler_is_gone(
    tiny_disk: Path, timer: ManualTimer
) -> None:
    start = RunStart(link="sim", world="w", world_document={}, seed=0, app_version="1")
    with open_store(tiny_disk / "pinel.db") as store:
        run = store.runs.begin(start)
        recorder = RunRecorder(store, schedule=timer)
        filler = tiny_disk / "film.mp4"
        with contextlib.suppress(OSError), filler.open("wb", buffering=0) as file:
            while True:
                file.write(b"x" * 1024)
        events = list(square(run.id, laps=3))
        for event in events:
            recorder(event)
        recorder({**ended(run.id, len(events), len(events)), "text": "x" * 100_000})
        settle(store)
        assert recorder.problem is not None
        assert recorder.problem.code == "disk_full"
        filler.unlink()
        timer.elapse()
        settle(store)
        assert recorder.problem is None
    with open_store(tiny_disk / "pinel.db") as again:
        assert again.runs.get(run.id).state == "finished"
        assert len(again.runs.telemetry(run.id).rows) == len(events)


def test_a_file_that_is_opened_on_a_full_disk_says_that_it_must_be_opened_again(
    tiny_disk: Path,
) -> None:
    path, filler = tiny_disk / "pinel.db", tiny_disk / "film.mp4"
    with open_store(path) as store:
        store.groups.create("A")
    with contextlib.suppress(OSError), filler.open("wb", buffering=0) as file:
        while True:
            file.write(b"x")
    with open_store(path) as full:
        assert full.notice is not None
        assert full.notice.code == "disk_full_at_start"
        filler.unlink()
        assert code_of(lambda: full.groups.create("B")) == "disk_full_at_start"
    with open_store(path) as again:
        assert [group.name for group in again.groups.all()] == ["A"]
        assert again.groups.create("B").name == "B"


def test_a_disk_without_any_room_is_told_when_the_file_is_made(tiny_disk: Path) -> None:
    (tiny_disk / "film.mp4").write_bytes(b"x" * 799 * 1024)
    assert code_of(lambda: open_store(tiny_disk / "pinel.db")) == "disk_full"


def test_the_run_found_running_is_closed_even_by_a_store_that_was_closed_badly(
    store: Store, start: RunStart, opened: Callable[..., Store]
) -> None:
    run: RunRow = store.runs.begin(start)
    assert opened(close_interrupted=True).runs.get(run.id).reason == "interrupted"


@pytest.mark.parametrize(
    ("number", "code"), [(errno.EDQUOT, "disk_full"), (errno.EIO, "database_failed")]
)
def test_a_quota_that_is_used_up_is_told_apart_from_a_broken_disk(
    store: Store, path: Path, monkeypatch: pytest.MonkeyPatch, number: int, code: str
) -> None:
    def refuse(**_: object) -> None:
        raise OSError(number, os.strerror(number))

    def fail(_db: sqlite3.Connection) -> None:
        error = sqlite3.OperationalError("disk I/O error")
        error.sqlite_errorname = "SQLITE_IOERR_WRITE"
        raise error

    monkeypatch.setattr("tempfile.TemporaryFile", refuse)
    assert code_of(lambda: store._database.write(fail)) == code


@contextlib.contextmanager
def file_size_limit(size_bytes: int) -> Iterator[None]:
    """The system lets no file of this process grow beyond that size."""
    resource = pytest.importorskip("resource", reason="this system has no such limit")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size_bytes, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_a_file_that_may_not_grow_is_told_as_a_full_disk_and_keeps_what_was_saved(
    path: Path, store: Store, version: VersionRow, opened: Callable[..., Store]
) -> None:
    big = {"blocks": "x" * 50_000}
    with file_size_limit(path.with_name(f"{path.name}-wal").stat().st_size):
        assert code_of(lambda: store.versions.save(version.program_id, big, None)) == "disk_full"
        assert code_of(lambda: store.groups.create("B")) == "disk_full"
    assert opened().versions.newest(version.program_id) == version
    assert store.versions.save(version.program_id, big, None).workspace == big


@pytest.mark.parametrize("size_bytes", [0, 4096, 30_000, 100_000, 250_000])
def test_a_new_file_that_may_not_become_large_enough_is_told_as_a_full_disk(
    path: Path, size_bytes: int
) -> None:
    with file_size_limit(size_bytes):
        assert code_of(lambda: open_store(path)) == "disk_full"
    with open_store(path) as store:
        assert store.groups.create("A").name == "A"


def test_a_backup_that_may_not_become_as_large_as_the_file_has_no_room(
    path: Path, store: Store, version: VersionRow
) -> None:
    store.versions.save(version.program_id, {"blocks": "x" * 500_000}, None)
    with file_size_limit(path.stat().st_size // 2):
        assert code_of(lambda: make_backup(path, NOON)) == "backup_no_room"
    assert make_backup(path, NOON) is not None


def test_an_io_error_on_a_disk_with_room_is_not_taken_for_a_full_one(store: Store) -> None:
    def fail(_db: sqlite3.Connection) -> None:
        error = sqlite3.OperationalError("disk I/O error")
        error.sqlite_errorname = "SQLITE_IOERR_READ"
        raise error

    assert code_of(lambda: store._database.write(fail)) == "database_failed"


@pytest.mark.parametrize("is_left_open", [False, True], ids=["closed", "wal_left"])
def test_a_disk_that_is_mounted_for_reading_only_shows_the_work(
    tiny_disk: Path, tmp_path: Path, *, is_left_open: bool
) -> None:
    """After a power cut too, which leaves the write-ahead log and its index."""
    path = tmp_path / "pinel.db"
    with open_store(path) as store:
        store.groups.create("A")
        if is_left_open:
            copy_with_log(path, tiny_disk)
    if not is_left_open:
        copy_with_log(path, tiny_disk)
    subprocess.run(["mount", "-o", "remount,ro", str(tiny_disk)], check=True)
    with open_store(tiny_disk / path.name) as store:
        assert (store.writable, [one.name for one in store.groups.all()]) == (False, ["A"])
        assert store.notice is not None
        assert store.notice.code == "database_read_only"


def copy_with_log(path: Path, folder: Path) -> None:
    for file in path.parent.glob(f"{path.name}*"):
        if file.is_file():
            shutil.copy(file, folder)
