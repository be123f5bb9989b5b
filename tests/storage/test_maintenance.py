"""A backup a day and room on the disk, looked after while the app runs."""

import shutil
import threading
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from storage import Notice, Store, StoreError, maintenance
from storage.file.backups import list_backups, make_backup
from storage.maintenance import NEARLY_FULL, Maintenance

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)
HOUR = timedelta(hours=1)
MUCH = 10**12


class Disk:
    """A disk with as much room as the test says."""

    def __init__(self) -> None:
        self.free = MUCH

    def __call__(self, _folder: Path) -> int:
        return self.free


class MaintenanceHarness:
    """A maintenance on a clock and a disk of the test's own."""

    def __init__(self, store: Store) -> None:
        self.now = NOON
        self.disk = Disk()
        self.reported: list[str | None] = []
        self.maintenance = Maintenance(
            store, self._on_notice, clock=lambda: self.now, free=self.disk
        )

    def _on_notice(self, notice: Notice | None) -> None:
        self.reported.append(notice.code if notice else None)

    @property
    def code(self) -> str | None:
        return self.maintenance.notice.code if self.maintenance.notice else None


@pytest.fixture
def harness(store: Store) -> Iterator[MaintenanceHarness]:
    harness = MaintenanceHarness(store)
    yield harness
    harness.maintenance.close()


def test_a_day_of_hours_makes_one_backup(harness: MaintenanceHarness, path: Path) -> None:
    for _ in range(24):
        harness.maintenance.back_up()
        harness.now += HOUR
    assert [backup.made_at for backup in list_backups(path)] == [NOON]
    harness.maintenance.back_up()
    assert [backup.made_at for backup in list_backups(path)] == [NOON + 24 * HOUR, NOON]
    assert harness.reported == []


def test_a_clock_that_was_set_back_does_not_put_backups_off(
    harness: MaintenanceHarness, path: Path
) -> None:
    harness.maintenance.back_up()
    harness.now -= timedelta(days=3000)
    for _ in range(5):
        harness.maintenance.back_up()
        harness.now += HOUR
    assert [backup.number for backup in list_backups(path)] == [2, 1]
    assert list_backups(path)[0].made_at == NOON - timedelta(days=3000)


def test_a_disk_that_is_nearly_full_is_told_once_and_taken_back_when_there_is_room(
    harness: MaintenanceHarness,
) -> None:
    for free in (NEARLY_FULL, NEARLY_FULL - 1, 20 * 10**6, NEARLY_FULL + 10**6):
        harness.disk.free = free
        harness.maintenance.check_space()
    assert (harness.reported, harness.code) == (["disk_nearly_full"], "disk_nearly_full")
    assert harness.maintenance.notice is not None
    assert harness.maintenance.notice.params["free_mb"] == 501
    harness.disk.free = MUCH
    harness.maintenance.check_space()
    assert (harness.reported, harness.code) == (["disk_nearly_full", None], None)


def test_a_disk_that_cannot_be_asked_is_no_news(
    harness: MaintenanceHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_folder: Path) -> int:
        raise OSError("gone")

    monkeypatch.setattr(harness.maintenance, "_free", fail)
    harness.maintenance.check_space()
    assert harness.reported == []


def test_a_backup_for_which_there_is_no_room_is_told_until_it_could_be_made(
    harness: MaintenanceHarness, store: Store, path: Path
) -> None:
    harness.disk.free = 0
    harness.maintenance.back_up()
    assert harness.code == "backup_no_room"
    assert store.groups.create("A").name == "A"
    harness.disk.free = MUCH
    harness.now += HOUR
    harness.maintenance.back_up()
    assert (harness.reported, len(list_backups(path))) == (["backup_no_room", None], 1)


@pytest.mark.parametrize("error", [StoreError("backup_failed", problem="x"), ZeroDivisionError()])
def test_whatever_keeps_a_backup_from_being_made_is_told_and_the_store_goes_on(
    harness: MaintenanceHarness, store: Store, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr("storage.file.backups.make_backup", fail)
    harness.maintenance.back_up()
    assert harness.code == "backup_failed"
    assert store.groups.create("A").name == "A"


def test_a_file_that_cannot_be_read_for_a_moment_is_backed_up_later(
    harness: MaintenanceHarness, store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_: Store) -> int:
        raise StoreError("database_failed", problem="disk I/O error", path=str(path))

    with monkeypatch.context() as patch:
        patch.setattr(Store, "n_saves", fail)
        harness.maintenance.back_up()
    assert harness.code == "database_failed"
    harness.now += HOUR
    harness.maintenance.back_up()
    assert harness.reported == ["database_failed", None]
    assert len(list_backups(path)) == 1


def test_a_removal_that_was_cut_off_before_the_backups_is_finished_later(
    harness: MaintenanceHarness, store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    group = store.groups.create("Fulano de Tal")
    for day in (0, 1):
        make_backup(path, NOON + day * 24 * HOUR)
    with monkeypatch.context() as cut_off:
        cut_off.setattr("storage.exchange.exchange.remove_from_backups", _power_cut)
        with pytest.raises(KeyboardInterrupt):
            store.exchange.purge("group", group.id)
    assert _backups_with(b"Fulano", path) == 2

    harness.maintenance.finish_removals()
    assert _backups_with(b"Fulano", path) == 0
    files = {backup.path: backup.path.stat().st_ino for backup in list_backups(path)}
    harness.maintenance.finish_removals()  # nothing is left to be done: no backup is written anew
    assert {backup.path: backup.path.stat().st_ino for backup in list_backups(path)} == files


def _power_cut(*_: object) -> None:
    raise KeyboardInterrupt


def _backups_with(octets: bytes, path: Path) -> int:
    return sum(octets in backup.path.read_bytes() for backup in list_backups(path))


def test_a_backup_that_was_being_made_loses_what_is_deleted_meanwhile(
    harness: MaintenanceHarness, store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By another process, which knows nothing of the backup."""
    group = store.groups.create("Fulano de Tal")
    monkeypatch.setattr("storage.file.backups._PAGES", 1)

    def stop() -> bool:
        if store.groups.all():
            with monkeypatch.context() as other_process:
                other_process.setattr(
                    "storage.exchange.exchange.remove_from_backups", lambda *_: []
                )
                assert not store.exchange.purge("group", group.id).overwritten
        return False

    monkeypatch.setattr("storage.file.opening._BUSY_S", 0.05)
    assert make_backup(path, NOON, stop=stop)
    assert _backups_with(b"Fulano", path) == 1
    files = (path, path.with_name("pinel.db-wal"))
    assert b"Fulano" in b"".join(file.read_bytes() for file in files)
    harness.maintenance.finish_removals()
    assert _backups_with(b"Fulano", path) == 0
    assert b"Fulano" not in b"".join(file.read_bytes() for file in files)


def test_a_backup_that_somebody_holds_loses_what_was_deleted_when_it_is_free(
    harness: MaintenanceHarness, store: Store, path: Path
) -> None:
    group = store.groups.create("Fulano de Tal")
    backup = make_backup(path, NOON)
    assert backup
    folder = backup.path.with_name(f".{backup.path.name}.part")
    folder.mkdir()  # in the way of writing it anew
    assert store.exchange.purge("group", group.id).still_in == (backup.path,)
    harness.maintenance.finish_removals()
    assert _backups_with(b"Fulano", path) == 1
    shutil.rmtree(folder)
    harness.maintenance.finish_removals()
    assert _backups_with(b"Fulano", path) == 0


def test_once_started_it_backs_up_by_itself_and_ends_when_told(
    store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert maintenance._FIRST_S >= 10
    monkeypatch.setattr(maintenance, "_FIRST_S", 0.0)
    made = threading.Event()

    def make(*given: Any, **named: Any) -> None:
        make_backup(*given, **named)
        made.set()

    monkeypatch.setattr("storage.file.backups.make_backup", make)
    harness = MaintenanceHarness(store)
    answers = iter([NEARLY_FULL - 1])
    monkeypatch.setattr(harness.maintenance, "_free", lambda folder: next(answers, MUCH))
    harness.maintenance.start()
    assert harness.reported[0] == "disk_nearly_full"
    assert made.wait(20)
    harness.maintenance.close()
    assert len(list_backups(path)) == 1
    assert harness.reported == ["disk_nearly_full", None]
    assert "store-maintenance" not in {thread.name for thread in threading.enumerate()}


def test_a_file_that_cannot_be_written_is_not_looked_after(path: Path) -> None:
    with Store.without_file(path, StoreError("database_newer", path=str(path))) as store:
        harness = MaintenanceHarness(store)
        harness.disk.free = 0
        harness.maintenance.start()
        assert (harness.reported, harness.code) == ([], None)
        harness.maintenance.close()


def test_an_hour_with_work_makes_one_backup_and_one_without_makes_none(
    harness: MaintenanceHarness, store: Store, path: Path
) -> None:
    for n_backups in (1, 2, 2, 3):
        if n_backups > len(list_backups(path)):
            store.groups.create(f"G{harness.now}")
        harness.maintenance.back_up()
        assert len(list_backups(path)) == n_backups
        harness.now += HOUR


def test_at_the_end_what_is_new_is_backed_up_and_only_that(
    harness: MaintenanceHarness, store: Store, path: Path
) -> None:
    harness.maintenance.back_up_at_the_end()
    assert list_backups(path) == []  # nothing was ever saved
    store.groups.create("A")
    for _ in range(2):
        harness.maintenance.back_up_at_the_end()
        assert len(list_backups(path)) == 1


def test_a_backup_at_the_end_that_takes_too_long_is_given_up_and_leaves_nothing(
    harness: MaintenanceHarness, store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(maintenance, "_CLOSING_S", -1.0)
    store.groups.create("A")
    harness.maintenance.back_up_at_the_end()
    assert not list((path.parent / "backups").iterdir())
