"""A backup a day and room on the disk, looked after while the app runs."""

import threading
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from storage import Notice, Store, StoreError, caretaker
from storage.backups import list_backups, make_backup
from storage.caretaker import NEARLY_FULL, Caretaker

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)
HOUR = timedelta(hours=1)
MUCH = 10**12


class Disk:
    """A disk with as much room as the test says."""

    def __init__(self) -> None:
        self.free = MUCH

    def __call__(self, _folder: Path) -> int:
        return self.free


class Keeping:
    """A caretaker on a clock and a disk of the test's own."""

    def __init__(self, store: Store) -> None:
        self.now = NOON
        self.disk = Disk()
        self.told: list[str | None] = []
        self.caretaker = Caretaker(store, self._hear, clock=lambda: self.now, free=self.disk)

    def _hear(self, notice: Notice | None) -> None:
        self.told.append(notice.code if notice else None)

    @property
    def code(self) -> str | None:
        return self.caretaker.notice.code if self.caretaker.notice else None


@pytest.fixture
def keeping(store: Store) -> Iterator[Keeping]:
    keeping = Keeping(store)
    yield keeping
    keeping.caretaker.close()


def test_a_day_of_hours_makes_one_backup(keeping: Keeping, path: Path) -> None:
    for _ in range(24):
        keeping.caretaker.back_up()
        keeping.now += HOUR
    assert [backup.made_at for backup in list_backups(path)] == [NOON]
    keeping.caretaker.back_up()
    assert [backup.made_at for backup in list_backups(path)] == [NOON + 24 * HOUR, NOON]
    assert keeping.told == []


def test_a_clock_that_was_set_back_does_not_put_backups_off(keeping: Keeping, path: Path) -> None:
    keeping.caretaker.back_up()
    keeping.now -= timedelta(days=3000)
    for _ in range(5):
        keeping.caretaker.back_up()
        keeping.now += HOUR
    assert [backup.number for backup in list_backups(path)] == [2, 1]
    assert list_backups(path)[0].made_at == NOON - timedelta(days=3000)


def test_a_disk_that_is_nearly_full_is_told_once_and_taken_back_when_there_is_room(
    keeping: Keeping,
) -> None:
    for free in (NEARLY_FULL, NEARLY_FULL - 1, 20 * 10**6, NEARLY_FULL + 10**6):
        keeping.disk.free = free
        keeping.caretaker.look_at_disk()
    assert (keeping.told, keeping.code) == (["disk_nearly_full"], "disk_nearly_full")
    assert keeping.caretaker.notice is not None
    assert keeping.caretaker.notice.params["free_mb"] == 501
    keeping.disk.free = MUCH
    keeping.caretaker.look_at_disk()
    assert (keeping.told, keeping.code) == (["disk_nearly_full", None], None)


def test_a_disk_that_cannot_be_asked_is_no_news(
    keeping: Keeping, monkeypatch: pytest.MonkeyPatch
) -> None:
    def gone(_folder: Path) -> int:
        raise OSError("gone")

    monkeypatch.setattr(keeping.caretaker, "_free", gone)
    keeping.caretaker.look_at_disk()
    assert keeping.told == []


def test_a_backup_for_which_there_is_no_room_is_told_until_it_could_be_made(
    keeping: Keeping, store: Store, path: Path
) -> None:
    keeping.disk.free = 0
    keeping.caretaker.back_up()
    assert keeping.code == "backup_no_room"
    assert store.groups.create("A").name == "A"
    keeping.disk.free = MUCH
    keeping.now += HOUR
    keeping.caretaker.back_up()
    assert (keeping.told, len(list_backups(path))) == (["backup_no_room", None], 1)


@pytest.mark.parametrize("error", [StoreError("backup_failed", problem="x"), ZeroDivisionError()])
def test_whatever_keeps_a_backup_from_being_made_is_told_and_the_store_goes_on(
    keeping: Keeping, store: Store, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr("storage.backups.make_backup", fail)
    keeping.caretaker.back_up()
    assert keeping.code == "backup_failed"
    assert store.groups.create("A").name == "A"


def test_once_started_it_backs_up_by_itself_and_ends_when_told(
    store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert caretaker._FIRST_S >= 10
    monkeypatch.setattr(caretaker, "_FIRST_S", 0.0)
    made = threading.Event()

    def make(*given: Any, **named: Any) -> None:
        make_backup(*given, **named)
        made.set()

    monkeypatch.setattr("storage.backups.make_backup", make)
    keeping = Keeping(store)
    answers = iter([NEARLY_FULL - 1])
    monkeypatch.setattr(keeping.caretaker, "_free", lambda folder: next(answers, MUCH))
    keeping.caretaker.start()
    assert keeping.told[0] == "disk_nearly_full"
    assert made.wait(20)
    keeping.caretaker.close()
    assert len(list_backups(path)) == 1
    assert keeping.told == ["disk_nearly_full", None]
    assert "store-caretaker" not in {thread.name for thread in threading.enumerate()}


def test_a_file_that_cannot_be_written_is_not_looked_after(path: Path) -> None:
    with Store.without_file(path, StoreError("database_newer", path=str(path))) as store:
        keeping = Keeping(store)
        keeping.disk.free = 0
        keeping.caretaker.start()
        assert (keeping.told, keeping.code) == ([], None)
        keeping.caretaker.close()
