"""Copies of the file: made while others write, kept for a while, put back when the file is damaged."""

import os
import threading
from collections.abc import Callable, Collection
from datetime import datetime, timedelta
from itertools import pairwise
from pathlib import Path

import pytest

from storage import Store, open_store
from storage.exchange.deleting.deletion import purge, purge_keys
from storage.file import backups
from storage.file.backups import (
    Backup,
    damage_of,
    folder_of,
    is_due,
    list_backups,
    make_backup,
    prune,
    remove_from_backups,
    retained_backups,
)
from storage.sqlite import sqlite3
from tests.storage.file.backup_files import DAY, MUCH, NOON, backed_up, much, names_in
from tests.storage.file.refusals import code_of


def test_a_backup_is_the_file_at_one_moment_under_a_number_and_its_time(
    store: Store, path: Path
) -> None:
    store.groups.create("A")
    backup = backed_up(path)
    store.groups.create("B")
    assert backup.path == path.parent / "backups" / "pinel-00001-20261121T120000Z.db"
    assert (backup.number, backup.made_at) == (1, NOON)
    assert names_in(backup.path) == ["A"]
    assert damage_of(backup.path) is None
    assert [file.name for file in folder_of(path).iterdir()] == [backup.path.name]


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
def test_nobody_may_read_a_backup_who_may_not_read_the_file(store: Store, path: Path) -> None:
    path.chmod(0o600)
    assert backed_up(path).path.stat().st_mode & 0o777 == 0o600


def test_those_who_write_do_not_wait_for_a_backup_and_do_not_keep_it_from_ending(
    store: Store, path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = store.programs.create(store.groups.create("A").id, "P")
    for n in range(40):
        store.versions.save(program.id, {"n": n, "text": "x" * 50_000}, None)
    monkeypatch.setattr(backups, "_PAGES", 8)
    saved: list[object] = []

    def stop() -> bool:
        saved.append(store.versions.save(program.id, {"during": len(saved)}, None))
        return False

    backup = make_backup(path, NOON, free=much, stop=stop)
    assert backup is not None
    assert len(saved) > 10
    db = sqlite3.connect(f"{backup.path.as_uri()}?immutable=1", uri=True)
    assert db.execute("SELECT count(*) FROM versions").fetchone() == (40,)
    db.close()
    assert store.programs.get(program.id).n_versions == 40 + len(saved)


def test_a_backup_that_is_stopped_leaves_nothing(store: Store, path: Path) -> None:
    assert make_backup(path, NOON, free=much, stop=lambda: True) is None
    assert list(folder_of(path).iterdir()) == []


def test_what_a_power_cut_left_of_a_backup_goes_with_the_next(store: Store, path: Path) -> None:
    folder_of(path).mkdir()
    left = folder_of(path) / "pinel-00001-20261120T120000Z.db.part"
    left.write_bytes(b"half")
    assert backed_up(path).number == 1
    assert not left.exists()


def test_a_disk_without_room_for_a_backup_is_left_alone(store: Store, path: Path) -> None:
    assert code_of(lambda: make_backup(path, NOON, free=lambda _: 10**6)) == "backup_no_room"
    assert not folder_of(path).exists()
    assert store.groups.create("A").name == "A"


def test_a_file_that_is_damaged_unseen_makes_no_backup_and_is_told(path: Path) -> None:
    with open_store(path) as store:
        for n in range(200):
            store.groups.create(f"Grupo {n}")
    good = backed_up(path)
    content = path.read_bytes()
    middle = len(content) // 2 // 4096 * 4096
    path.write_bytes(content[:middle] + os.urandom(4096 * 3) + content[middle + 4096 * 3 :])
    assert code_of(lambda: backed_up(path, NOON + DAY)) == "backup_found_damage"
    assert list_backups(path) == [good]
    assert list(folder_of(path).iterdir()) == [good.path]


def test_a_folder_that_cannot_be_made_is_told(store: Store, path: Path) -> None:
    folder_of(path).write_text("a file in its place")
    assert code_of(lambda: backed_up(path)) == "backup_failed"


def test_files_of_others_in_the_folder_are_neither_listed_nor_deleted(
    store: Store, path: Path
) -> None:
    folder_of(path).mkdir()
    others = ["pinel-2-00001-20261121T120000Z.db", "photo.jpg", "pinel-00001-20269999T990000Z.db"]
    for name in others:
        (folder_of(path) / name).write_text("")
    backup = backed_up(path)
    assert list_backups(path) == [backup]
    prune(path, free=much)
    assert {file.name for file in folder_of(path).iterdir()} == {*others, backup.path.name}


@pytest.mark.parametrize(
    ("age", "due"),
    [
        (timedelta(0), False),
        (timedelta(hours=23), False),
        (DAY, True),
        (timedelta(days=-400), True),
    ],
    ids=["new", "hours", "a day", "of the future"],
)
def test_the_next_is_due_after_a_day_or_when_the_clock_was_set_back(
    store: Store, path: Path, age: timedelta, due: bool
) -> None:
    assert is_due(path, NOON, 0)
    backed_up(path, NOON - age)
    assert is_due(path, NOON, 0) is due


def test_the_newest_is_the_last_that_was_made_whatever_the_clock_said(
    store: Store, path: Path
) -> None:
    times = [NOON, NOON + 26_000 * DAY, NOON - 3000 * DAY]
    made = [backed_up(path, time) for time in times]
    assert list_backups(path) == made[::-1]


def fakes(*made_at: datetime, size: int = 10) -> list[Backup]:
    """Backups made at these times, the newest first."""
    made = [Backup(Path(f"{n}"), n, time, size) for n, time in enumerate(made_at)]
    return made[::-1]


def test_the_last_three_are_kept_and_the_last_of_each_day_for_14_days_then_of_each_week_for_8() -> (
    None
):
    twice_a_day = [NOON + n * DAY / 2 for n in range(2 * 150)]
    chosen = retained_backups(fakes(*twice_a_day), MUCH)
    assert [backup.number for backup in chosen[:4]] == [299, 298, 297, 296]
    days = sorted({backup.made_at.date() for backup in chosen}, reverse=True)
    assert len(days) == 14 + 8
    assert all(before - after == DAY for before, after in pairwise(days[:14]))
    assert len({day.isocalendar()[:2] for day in days[14:]}) == 8
    assert len(chosen) <= 3 + 14 + 8


def test_a_pc_that_has_the_same_day_every_day_has_more_than_one_backup() -> None:
    assert len(retained_backups(fakes(*[NOON] * 30), MUCH)) == 3


def test_holidays_and_wrong_clocks_make_nothing_old() -> None:
    before_holidays = [NOON + n * DAY for n in range(5)]
    chosen = fakes(*before_holidays, NOON + 90 * DAY, NOON + 30_000 * DAY, NOON - 5000 * DAY)
    assert retained_backups(chosen, MUCH) == chosen


def test_the_oldest_go_when_together_they_are_too_large_but_never_the_newest() -> None:
    made = fakes(*(NOON + n * DAY for n in range(5)), size=100)
    assert retained_backups(made, 350) == made[:3]
    assert retained_backups(made, 1) == made[:1]


def test_backups_take_a_tenth_of_the_free_disk_at_most(store: Store, path: Path) -> None:
    made = [backed_up(path, NOON + n * DAY) for n in range(5)]
    size = made[0].size_bytes
    prune(path, free=lambda _: 19 * size)
    assert list_backups(path) == [made[4], made[3]]


def remove_group(db: sqlite3.Connection, ids: Collection[str]) -> None:
    db.executemany("DELETE FROM groups WHERE id = ?", [(key,) for key in ids])


def test_what_is_deleted_for_good_goes_out_of_every_backup_to_the_last_byte(
    store: Store, path: Path
) -> None:
    deleted = store.groups.create("Fulano de Tal")
    backed_up(path)
    store.groups.create("B")
    backed_up(path, NOON + DAY)
    before = list_backups(path)
    assert remove_from_backups(path, [deleted.id], remove_group) == []
    assert [(b.path, b.made_at) for b in list_backups(path)] == [
        (b.path, b.made_at) for b in before
    ]
    assert [names_in(backup.path) for backup in list_backups(path)] == [["B"], []]
    for backup in list_backups(path):
        content = backup.path.read_bytes()
        assert damage_of(backup.path) is None
        assert b"Fulano" not in content
        assert deleted.id.encode() not in content


def test_what_may_still_hold_deleted_work_is_named(store: Store, path: Path) -> None:
    deleted = store.groups.create("Fulano de Tal")
    bad = backed_up(path).path
    bad.write_bytes(b"rubbish" * 1000)
    good = backed_up(path, NOON + DAY).path
    aside = path.with_name("pinel.damaged-20261121-120000.db")
    aside.write_bytes(b"Fulano")
    assert remove_from_backups(path, [deleted.id], remove_group) == [bad, aside]
    assert names_in(good) == []


def test_a_group_with_all_its_work_goes_out_of_backups_of_earlier_releases_too(
    older: Path, opened: Callable[..., Store]
) -> None:
    with sqlite3.connect(older) as db:
        db.execute(
            """INSERT INTO programs (id, group_id, name, created_at, updated_at)
               VALUES ('p', 'g', 'Quadrado', 't', 't')"""
        )
        db.execute(
            """INSERT INTO versions (id, program_id, number, created_at, workspace, faults)
               VALUES ('v', 'p', 1, 't', '{}', '[]')"""
        )
    db.close()
    backed_up(older)
    store = opened(older, clock=lambda: NOON + DAY)
    retained_group = store.groups.create("B")
    backed_up(older, NOON + 2 * DAY)
    assert remove_from_backups(older, ["g"], purge_keys) == []
    assert [names_in(backup.path) for backup in list_backups(older)] == [
        [retained_group.name],
        [],
        [],
    ]
    for backup in list_backups(older):
        db = sqlite3.connect(f"{backup.path.as_uri()}?immutable=1", uri=True)
        assert db.execute("SELECT count(*) FROM versions").fetchone() == (0,)
        db.close()


def test_a_backup_that_is_being_made_does_not_keep_what_is_deleted_meanwhile(
    store: Store, path: Path
) -> None:
    deleted = store.groups.create("Fulano de Tal")
    deleting: list[threading.Thread] = []

    def delete() -> None:
        purge(store._database, "group", deleted.id)
        remove_from_backups(path, [deleted.id], purge_keys)

    def stop() -> bool:
        if not deleting:  # the copy has begun
            deleting.append(threading.Thread(target=delete))
            deleting[0].start()
        return False

    assert make_backup(path, NOON, free=much, stop=stop) is not None
    deleting[0].join()
    assert [names_in(backup.path) for backup in list_backups(path)] == [[]]
