"""Files that are damaged, foreign, newer, locked or read-only, and disks that are full."""

import contextlib
import errno
import os
import sqlite3
import subprocess
import sys
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from storage import Recorder, RunRow, RunStart, Store, StoreError, VersionRow, open_store, schema
from tests.storage.sample_runs import ended, square

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)
IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


def code_of(attempt: Callable[[], object]) -> str:
    with pytest.raises(StoreError) as caught:
        attempt()
    return caught.value.code


def filled(path: Path, n_groups: int = 200) -> bytes:
    with open_store(path) as store:
        for n in range(n_groups):
            store.groups.create(f"Grupo {n}")
    return path.read_bytes()


def garbled_header(content: bytes) -> bytes:
    return b"this is no database" + content[19:]


def garbled_middle(content: bytes) -> bytes:
    middle = len(content) // 2 // 4096 * 4096
    return content[:middle] + os.urandom(4096 * 3) + content[middle + 4096 * 3 :]


def cut_short(content: bytes) -> bytes:
    return content[: len(content) * 2 // 3]


@pytest.mark.parametrize("damage", [garbled_header, garbled_middle, cut_short])
def test_a_damaged_file_is_set_aside_untouched_and_a_new_one_begun(
    path: Path, opened: Callable[..., Store], damage: Callable[[bytes], bytes]
) -> None:
    damaged = damage(filled(path))
    path.write_bytes(damaged)
    store = opened(clock=lambda: NOON)
    assert store.notice is not None
    assert store.notice.code == "database_set_aside"
    aside = path.with_name("pinel.damaged-20261121-120000.db")
    assert store.notice.params["name"] == aside.name
    assert aside.read_bytes() == damaged
    assert store.groups.all() == []
    assert store.groups.create("A").name == "A"


def test_two_files_damaged_in_the_same_second_are_both_kept(path: Path) -> None:
    for _ in range(2):
        path.write_bytes(b"no database, but long enough to be taken for one" * 99)
        open_store(path, clock=lambda: NOON).close()
    assert len(list(path.parent.glob("pinel.damaged-*.db"))) == 2


def test_an_empty_file_is_a_new_database(path: Path, opened: Callable[..., Store]) -> None:
    path.touch()
    assert opened().notice is None


def test_a_file_of_a_newer_program_is_refused_and_not_touched(path: Path) -> None:
    filled(path, 1)
    with sqlite3.connect(path) as db:
        db.execute(
            "INSERT INTO _sqlite_migrations (migration_set, name, applied_at) VALUES ('pinel', 'lessons', '2031')"
        )
    db.close()
    before = path.read_bytes()
    assert code_of(lambda: open_store(path)) == "database_newer"
    assert path.read_bytes() == before


def test_a_file_of_another_program_is_refused_and_not_touched(path: Path) -> None:
    with sqlite3.connect(path) as db:
        db.execute("CREATE TABLE recipes (name TEXT)")
    db.close()
    before = path.read_bytes()
    assert code_of(lambda: open_store(path)) == "database_foreign"
    assert path.read_bytes() == before
    assert os.listdir(path.parent) == ["pinel.db"]


def test_a_file_whose_making_was_cut_off_is_made_to_its_end(
    path: Path, opened: Callable[..., Store], monkeypatch: pytest.MonkeyPatch
) -> None:
    def cut_off(_db: object) -> None:
        raise KeyboardInterrupt

    for n in range(len(schema._MIGRATIONS)):
        with monkeypatch.context() as patch:
            patch.setattr(cut_off, "__name__", schema._MIGRATIONS[n].__name__)
            patch.setattr(schema, "_MIGRATIONS", (*schema._MIGRATIONS[:n], cut_off))
            with pytest.raises(KeyboardInterrupt):
                open_store(path)
    assert opened().groups.create("A").name == "A"


def test_a_folder_in_place_of_the_file_is_an_error_with_a_code(path: Path) -> None:
    path.mkdir()
    assert code_of(lambda: open_store(path)) in ("database_read_only", "database_failed")


def test_a_file_in_place_of_the_folder_is_an_error_with_a_code(tmp_path: Path) -> None:
    (tmp_path / "data").write_text("not a folder")
    assert code_of(lambda: open_store(tmp_path / "data" / "pinel.db")) == "database_read_only"


def test_without_a_file_there_is_nothing_to_read_and_every_write_says_why(path: Path) -> None:
    refusal = StoreError("database_newer", path=str(path))
    with Store.without_file(path, refusal) as store:
        assert store.groups.all() == []
        assert store.settings.get("language") is None
        assert code_of(lambda: store.groups.create("A")) == "database_newer"
        assert (store.writable, store.notice and store.notice.code) == (False, "database_newer")


def test_a_file_that_another_program_holds_is_locked_and_free_again_later(
    store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    store._access.submit(lambda db: db.execute("PRAGMA busy_timeout = 50").fetchone()).result()
    other = sqlite3.connect(path, isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    assert code_of(lambda: store.groups.create("A")) == "database_locked"
    other.execute("ROLLBACK")
    other.close()
    assert store.groups.create("A").name == "A"


READ_ONLY_SCRIPT = """
import os, sys
from pathlib import Path
sys.path[:0] = {import_path!r}
path, user = Path(sys.argv[1]), 65534
import storage, numpy
if os.geteuid() == 0:
    os.setgroups([]); os.setgid(user); os.setuid(user)
store = storage.open_store(path, close_interrupted=True)
print(store.writable, store.notice and store.notice.code)
print([group.name for group in store.groups.all()])
try:
    store.groups.create("B")
except storage.StoreError as error:
    print(error.code)
store.close()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")
@pytest.mark.parametrize("mode_of_folder", [0o755, 0o555])
def test_a_read_only_file_can_be_read_and_says_that_it_cannot_be_written(
    path: Path, mode_of_folder: int
) -> None:
    filled(path, 1)
    for folder in (path.parent, *path.parent.parents):
        if folder.owner() and folder != Path("/tmp") and str(folder).startswith("/tmp/"):
            folder.chmod(0o755)
    path.chmod(0o444)
    path.parent.chmod(mode_of_folder)
    try:
        result = subprocess.run(
            [sys.executable, "-c", READ_ONLY_SCRIPT.format(import_path=sys.path), str(path)],
            capture_output=True,
            text=True,
            check=False,
        )
    finally:
        path.parent.chmod(0o755)
    assert result.stderr == ""
    assert result.stdout.splitlines() == [
        "False database_read_only",
        "['Grupo 0']",
        "database_read_only",
    ]


def limit_pages(store: Store, extra: int) -> None:
    """Makes the disk seem full after `extra` more pages."""
    store._access.write(
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
    recorder = Recorder(store, lambda problem: problems.append(problem.code if problem else None))
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
        store._access.write(fail)


@pytest.fixture
def timer() -> ManualTimer:
    return ManualTimer()


@pytest.fixture
def problems() -> list[str | None]:
    return []


@pytest.fixture
def recorder(store: Store, timer: ManualTimer, problems: list[str | None]) -> Recorder:
    def note(problem: StoreError | None) -> None:
        problems.append(problem.code if problem else None)

    return Recorder(store, note, later=timer)


def end_on_a_full_disk(store: Store, recorder: Recorder, run: RunRow) -> None:
    limit_pages(store, 0)
    recorder({**ended(run.id, 0, 60), "text": "x" * 20_000})
    settle(store)
    assert recorder.problem is not None


def test_the_end_of_a_run_is_written_by_itself_when_the_disk_has_room_again(
    store: Store,
    start: RunStart,
    recorder: Recorder,
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
    store: Store, start: RunStart, recorder: Recorder, timer: ManualTimer
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
    recorder = Recorder(store, later=timer)
    run = store.runs.begin(start)
    end_on_a_full_disk(store, recorder, run)
    now[0] += timedelta(hours=1)
    limit_pages(store, 10_000)
    settle(store)
    assert store.runs.get(run.id).ended_at == "2026-11-21T12:00:00.000000Z"


@pytest.mark.parametrize("end", ["recorder", "store"])
def test_nothing_is_tried_any_more_after_closing(
    store: Store, start: RunStart, recorder: Recorder, timer: ManualTimer, end: str
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
        patch.setattr("storage.runs.Runs.close_interrupted", refuse)
        later = opened(close_interrupted=True)
    assert (later.unfinished, later.notice and later.notice.code) == (True, "disk_full")
    recorder = Recorder(later)
    recorder.flush()
    recorder.flush().result()
    assert later.runs.get(run.id).reason == "interrupted"
    assert [event["type"] for event in later.runs.events(run.id)] == ["run_ended"]
    assert (later.unfinished, later.notice) == (False, None)


@pytest.fixture
def tiny_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 600 KB, where this user may make one."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=600k", "tmpfs", str(folder)]
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
        recorder = Recorder(store, later=timer)
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


def test_a_disk_without_any_room_is_told_when_the_file_is_made(tiny_disk: Path) -> None:
    (tiny_disk / "film.mp4").write_bytes(b"x" * 599 * 1024)
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
    assert code_of(lambda: store._access.write(fail)) == code


def test_an_io_error_on_a_disk_with_room_is_not_taken_for_a_full_one(store: Store) -> None:
    def fail(_db: sqlite3.Connection) -> None:
        error = sqlite3.OperationalError("disk I/O error")
        error.sqlite_errorname = "SQLITE_IOERR_READ"
        raise error

    assert code_of(lambda: store._access.write(fail)) == "database_failed"
