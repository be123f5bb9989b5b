"""Copies of the backups in the school's shared folder: a real folder, which is away, in the way or never answers."""

import shutil
import threading
from collections.abc import Callable, Iterator
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

from storage import Store
from storage.exchange import backup_share
from storage.exchange.backup_share import COPIES_BACKUPS, SHARED_FOLDER
from storage.file.backups import list_backups, make_backup
from storage.file.share_copies import ShareCopies
from tests.storage.test_maintenance import HOUR, NOON, MaintenanceHarness

WAIT_S = 30.0


@pytest.fixture
def shared(store: Store, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The shared folder, with what another PC and a person put there."""
    monkeypatch.setattr(backup_share, "_CLEAN_TIMEOUT_S", WAIT_S)
    folder = tmp_path / "rede"
    (folder / "PINEL-backups" / "PC 9-00000000").mkdir(parents=True)
    for name in ("PC 9-00000000/pinel-00001-20261121T120000Z.db", "leia-me.txt"):
        (folder / "PINEL-backups" / name).touch()
    store.computers.rename("PC 7")
    store.settings.set(SHARED_FOLDER, str(folder))
    store.settings.set(COPIES_BACKUPS, value=True)
    return folder


@pytest.fixture
def harness(store: Store) -> Iterator[MaintenanceHarness]:
    harness = MaintenanceHarness(store)
    yield harness
    harness.maintenance.close()


class Hanging:
    """A folder that does not answer until it is freed."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.reached, self.freed, self.n_asked = threading.Event(), threading.Event(), 0
        monkeypatch.setattr(ShareCopies, "copy_newest", self._hang)

    def _hang(self, *_: object) -> None:
        self.n_asked += 1
        self.reached.set()
        self.freed.wait(WAIT_S)


@pytest.fixture
def hanging(monkeypatch: pytest.MonkeyPatch) -> Iterator[Hanging]:
    hanging = Hanging(monkeypatch)
    yield hanging
    hanging.freed.set()


def copies(shared: Path, name: str = "PC 7") -> list[Path]:
    return sorted(shared.glob(f"PINEL-backups/{name}-*/*"))


def names(files: list[Path]) -> list[str]:
    return [file.name for file in files]


def backed_up(store: Store, n: int = 1) -> None:
    """Makes backups and has each copied."""
    for _ in range(n):
        made = make_backup(store.path, NOON + HOUR * len(list_backups(store.path)))
        assert made
        assert store.backup_share.update(WAIT_S)


def test_nothing_is_copied_unless_the_teacher_wants_it(store: Store, shared: Path) -> None:
    store.settings.set(COPIES_BACKUPS, value=False)
    backed_up(store)
    assert copies(shared) == []
    assert not list(store.path.parent.glob("*.copies.json"))


def test_each_backup_is_copied_and_the_last_three_stay(store: Store, shared: Path) -> None:
    before = set(shared.rglob("*"))
    backed_up(store, 5)
    newest = [backup.path for backup in list_backups(store.path)[:3]]
    assert names(copies(shared)) == names(newest[::-1])
    assert [file.read_bytes() for file in copies(shared)] == [
        file.read_bytes() for file in newest[::-1]
    ]
    store.computers.rename("PC 8")
    backed_up(store)
    assert (len(copies(shared)), len(copies(shared, "PC 8"))) == (2, 1)
    assert before < set(shared.rglob("*"))


def test_a_copy_that_was_cut_off_leaves_nothing_and_is_made_anew(
    store: Store, shared: Path
) -> None:
    backed_up(store)
    (copy,) = copies(shared)
    whole = copy.read_bytes()
    copy.write_bytes(whole[:5000])
    part = copy.with_name(".pinel-00001-20261121T120000Z.db.part")
    part.write_bytes(whole[:5000])
    assert store.backup_share.update(WAIT_S)
    assert copies(shared) == [copy]
    assert copy.read_bytes() == whole


def test_copies_never_count_as_work_that_needs_another_backup(
    harness: MaintenanceHarness, store: Store, shared: Path
) -> None:
    for _ in range(5):
        harness.maintenance.back_up()
        assert store.backup_share.update(WAIT_S)
        harness.now += HOUR
    assert len(copies(shared)) == len(list_backups(store.path)) == 1


def test_a_folder_that_is_away_is_told_until_it_is_back(
    harness: MaintenanceHarness, store: Store, shared: Path
) -> None:
    away = shared.rename(shared.with_name("fora"))
    harness.maintenance.back_up()
    assert store.backup_share.update(WAIT_S)
    assert harness.code == "backup_share_failed"
    assert not shared.exists()
    away.rename(shared)
    harness.maintenance.copy_to_share()
    assert store.backup_share.update(WAIT_S)
    assert harness.reported == ["backup_share_failed", None]
    assert len(copies(shared)) == 1


def test_what_is_deleted_for_good_is_in_no_copy(store: Store, shared: Path) -> None:
    group = store.groups.create("Fulano de Tal")
    backed_up(store, 2)
    assert store.exchange.purge("group", group.id).still_in == ()
    assert store.backup_share.update(WAIT_S)
    assert names(copies(shared)) == [list_backups(store.path)[0].path.name]
    assert _with_the_name(shared) == []


def test_a_new_disk_begins_with_a_copy_and_its_deletions_reach_the_copies_of_before(
    store: Store, shared: Path, opened: Callable[..., Store], tmp_path: Path
) -> None:
    store.groups.create("Fulano de Tal")
    backed_up(store, 2)
    with opened(tmp_path / "salvaged" / "pinel.db") as salvaged:
        assert salvaged.salvage(copies(shared)[-1]).n_rows
        assert [group.name for group in salvaged.groups.all()] == ["Fulano de Tal"]
    (tmp_path / "new").mkdir()
    with opened(shutil.copy(copies(shared)[-1], tmp_path / "new" / "pinel.db")) as new:
        (group,) = new.groups.all()
        new.exchange.purge("group", group.id)
        backed_up(new)
    assert _with_the_name(shared) == []
    assert len(copies(shared)) == 1


def test_copies_out_of_reach_are_named_and_cleaned_later(
    harness: MaintenanceHarness, store: Store, shared: Path, tmp_path: Path
) -> None:
    """Also after another folder was chosen."""
    group = store.groups.create("Fulano de Tal")
    backed_up(store, 2)
    out_of_reach = copies(shared)
    away = shared.rename(shared.with_name("fora"))
    (tmp_path / "outra").mkdir()
    store.settings.set(SHARED_FOLDER, str(tmp_path / "outra"))
    assert list(store.exchange.purge("group", group.id).still_in) == out_of_reach
    away.rename(shared)
    harness.maintenance.finish_removals()
    assert store.backup_share.update(WAIT_S)
    assert _with_the_name(shared) == _with_the_name(tmp_path / "outra") == []
    assert len(copies(tmp_path / "outra")) == 1


def _with_the_name(folder: Path) -> list[Path]:
    files = [file for file in folder.rglob("*") if file.is_file()]
    return [file for file in files if b"Fulano" in file.read_bytes()]


def test_a_data_folder_that_was_copied_leaves_the_copies_of_its_origin_alone(
    store: Store, shared: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    group = store.groups.create("Fulano de Tal")
    backed_up(store, 3)
    before = copies(shared)
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: "another machine")
    store.computers.rename("PC 7b")
    backed_up(store, 2)
    store.exchange.purge("group", group.id)
    assert set(before) < set(shared.rglob("*"))


def test_a_folder_that_never_answers_holds_up_neither_backups_nor_the_end(
    harness: MaintenanceHarness,
    store: Store,
    shared: Path,
    hanging: Hanging,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(backup_share, "_SLOW_S", 0.0)
    monkeypatch.setattr(backup_share, "_CLEAN_TIMEOUT_S", 0.0)
    harness.maintenance.back_up()
    harness.maintenance.copy_to_share()
    assert hanging.reached.wait(WAIT_S)
    group = store.groups.create("A")
    harness.now += timedelta(hours=2)
    harness.maintenance.back_up()
    assert len(list_backups(store.path)) == 2
    harness.maintenance.copy_to_share()
    assert harness.code == "backup_share_failed"
    store.exchange.purge("group", group.id)
    assert not store.backup_share.update(wait_s=0.1)
    assert hanging.n_asked == 1
    harness.maintenance.close()


def test_the_end_waits_for_the_copy_only_within_its_own_time(
    harness: MaintenanceHarness, store: Store, shared: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    waits: list[float] = []
    monkeypatch.setattr(store.backup_share, "update", waits.append)
    monkeypatch.setattr("storage.maintenance._CLOSING_S", WAIT_S)
    store.groups.create("A")
    harness.maintenance.back_up_at_the_end()
    assert len(list_backups(store.path)) == 1
    assert len(waits) == 1
    assert waits[0] < WAIT_S


def test_a_copy_that_fails_in_the_middle_leaves_the_ones_before(
    store: Store, shared: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    backed_up(store)
    before = copies(shared)

    def full(_from: Any, to: Path) -> None:
        to.write_bytes(b"SQLite")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("shutil.copyfile", full)
    backed_up(store)
    assert copies(shared) == before
    assert store.backup_share.problem
    assert store.backup_share.problem.params["problem"] == "No space left on device"
