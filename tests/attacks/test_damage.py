"""The table of attacks, continued: a file or a value that was damaged. It reads as `test_attacks.py` does."""

import os
import random
import shutil
from collections import Counter
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import RunFilter, StoreError, open_store
from storage.file.backups import make_backup
from storage.sql import opened, row_count
from storage.sqlite import sqlite3
from tests.attacks.damage import (
    PAGE,
    Day,
    a_day,
    code_of,
    doctor_code,
    log_of,
    outcome_of,
    pinel,
    reopened,
    spoil,
    wait_until,
)
from tests.attacks.damaged_values import N_PROGRAMS, school

# ---- a file that was damaged ----


@pytest.fixture
def day(tmp_path: Path) -> Day:
    """270 edits, 150 of them in the backup and the last 40 in the write-ahead log."""
    return a_day(tmp_path)


def test_a_missing_database_beside_its_backup_is_no_first_start(day: Day) -> None:
    day.path.unlink()
    assert doctor_code(day) == "doctor_database_gone"
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_gone_salvaged"
    assert n_retained == 150 + int(str(notice.params["n_edits"])) >= 190


def test_an_empty_database_without_any_backup_gives_back_what_its_log_holds(day: Day) -> None:
    shutil.rmtree(day.path.parent / "backups")
    day.path.write_bytes(b"")
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_gone_kept"
    assert n_retained >= 40


def test_a_missing_database_with_nothing_left_beside_it_is_said_once(day: Day) -> None:
    shutil.rmtree(day.path.parent / "backups")
    for file in (day.path, log_of(day.path)):
        file.unlink()
    assert [code_of(reopened(day)) for _ in range(2)] == ["database_gone", None]


def test_a_first_start_is_silent(tmp_path: Path) -> None:
    assert reopened(Day(tmp_path / "data" / "pinel.db", {}, 0)) == (None, 0)


def test_a_damaged_file_gives_back_what_the_backup_does_not_have(day: Day) -> None:
    spoil(day.path, 20 * PAGE, 5 * PAGE)
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_salvaged"
    assert n_retained + int(str(notice.params["n_unread"])) == 270
    assert n_retained >= 255


def test_a_damaged_file_without_any_backup_is_not_given_up(day: Day) -> None:
    shutil.rmtree(day.path.parent / "backups")
    spoil(day.path, PAGE, 20 * PAGE)
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_salvaged_alone"
    assert n_retained + int(str(notice.params["n_unread"])) == 270


def test_an_edit_with_wrong_bits_in_a_damaged_file_is_reported_as_lost_not_imported(
    day: Day,
) -> None:
    shutil.rmtree(day.path.parent / "backups")
    day.path.write_bytes(day.path.read_bytes().replace(b'"100 xxx', b'"101 xxx', 1))
    spoil(day.path, PAGE, PAGE)
    notice, n_retained = reopened(day)
    assert notice
    assert (notice.params["n_unread"], n_retained) == (1, 269)


def test_what_was_deleted_for_good_stays_deleted_when_a_damaged_file_is_salvaged(
    tmp_path: Path,
) -> None:
    path = tmp_path / "pinel.db"
    with open_store(path) as store:
        store.exchange.purge("group", store.groups.create("A").id)
        store.groups.create("B")
    spoil(path, 0, 16)
    with open_store(path) as store:
        assert [group.name for group in store.groups.all()] == ["B"]
        assert len(store.exchange.finish_removals()) == 1  # the damaged file, which may hold it


def test_a_wrong_bit_in_the_log_does_not_cut_off_what_follows_it(day: Day) -> None:
    spoil(log_of(day.path), 32 + 30 * (24 + PAGE) + 100, 1)
    assert doctor_code(day) == "doctor_database_end"
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_end_salvaged"
    assert n_retained >= 268


def test_a_log_whose_first_page_is_overwritten_still_gives_back_what_follows(day: Day) -> None:
    spoil(log_of(day.path), 0, PAGE)
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_end_salvaged"
    assert n_retained >= 268


@pytest.mark.parametrize("n_frames", [0, 60])
def test_a_log_that_is_shorter_than_it_was_is_noticed(day: Day, n_frames: int) -> None:
    os.truncate(log_of(day.path), 32 + n_frames * (24 + PAGE) if n_frames else 0)
    assert doctor_code(day) == "doctor_database_earlier"
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_earlier"
    assert n_retained == 270 - int(str(notice.params["n_saves"]))
    assert reopened(day) == (None, n_retained)  # said once


def test_an_earlier_copy_put_back_names_the_backup_that_knows_more(day: Day) -> None:
    reopened(day)
    earlier = day.path.read_bytes()
    with open_store(day.path) as store:
        store.groups.create("B")
        make_backup(day.path, datetime.now(UTC))
    day.path.write_bytes(earlier)
    notice, _ = reopened(day)
    assert notice
    assert notice.code == "database_earlier_backup"
    assert pinel("--db", day.path, "salvage", str(notice.params["backup"])) == 0
    with open_store(day.path) as store:
        assert {group.name for group in store.groups.all()} == {"A", "B"}


def test_an_idle_app_leaves_nothing_in_the_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("storage.file.writer._IDLE_S", 0.05)
    with open_store(tmp_path / "pinel.db") as store:
        store.groups.create("A")
        wait_until(lambda: log_of(store.path).stat().st_size == 0)


@pytest.mark.parametrize("turn", range(24))
def test_no_damage_to_a_file_loses_anything_silently(turn: int, tmp_path: Path) -> None:
    assert outcome_of(turn, tmp_path).is_honest


def test_a_file_that_was_cut_off_in_its_list_of_tables_is_salvaged(day: Day) -> None:
    """SQLite calls it an error of the disk."""
    while can_list_tables(day.path):
        os.truncate(day.path, day.path.stat().st_size - PAGE)
    notice, n_retained = reopened(day)
    assert notice
    assert notice.code == "database_salvaged"
    assert n_retained >= day.n_backed_up + 40  # those of the log


def can_list_tables(path: Path) -> bool:
    with closing(opened(path, "ro")) as db:
        try:
            return bool(db.execute("SELECT count(*) FROM sqlite_master").fetchone())
        except sqlite3.DatabaseError:
            return False


@pytest.mark.nightly
@pytest.mark.timeout(1800)
def test_no_damage_of_three_hundred_loses_anything_silently(tmp_path: Path) -> None:
    outcomes = [outcome_of(turn, tmp_path / str(turn)) for turn in range(300)]
    print("\n", Counter(outcome.code or "nothing lost" for outcome in outcomes))
    assert [outcome for outcome in outcomes if not outcome.is_honest] == []


# ---- a value that was damaged ----


@pytest.mark.parametrize("n", [12, pytest.param(300, marks=pytest.mark.nightly)])
def test_a_bit_that_flips_in_a_value_is_detected_and_repaired_from_the_backup(
    tmp_path: Path, n: int
) -> None:
    chance = random.Random(16)
    with school(tmp_path) as pc:
        pc.back_up()
        for turn in range(n):
            row = pc.flip(chance)
            assert (turn, row, pc.check()) == (turn, row, (1, 0))


def test_of_a_newest_version_that_is_damaged_the_last_sound_one_is_offered(tmp_path: Path) -> None:
    with school(tmp_path) as pc:
        pc.spoil("versions", pc.newest_id, "workspace", b'{"text": "\xff"}')
        with pytest.raises(StoreError) as error:
            pc.store.versions.newest(pc.program_id)
        sound = pc.store.versions.newest_intact(pc.program_id)
        assert sound is not None
        assert (error.value.code, sound.number) == ("version_damaged", 1)
        saved = pc.store.versions.save(pc.program_id, {"text": "on"}, None, parent_id=sound.id)
        assert pc.store.versions.newest(pc.program_id) == saved


def test_a_damaged_newest_version_is_opened_as_it_was_where_a_backup_has_it(tmp_path: Path) -> None:
    with school(tmp_path) as pc:
        before = pc.store.versions.newest(pc.program_id)
        pc.back_up()
        pc.spoil("versions", pc.newest_id, "workspace", b"{}")
        assert pc.store.versions.newest(pc.program_id) == before


def test_a_damaged_value_is_repaired_by_a_bundle_that_contains_it(tmp_path: Path) -> None:
    with school(tmp_path) as pc:
        pc.export(tmp_path / "a.pinel")
        pc.spoil("events", pc.run_id, "data", b"{}")
        assert pc.check() == (0, 1)
        pc.merge(tmp_path / "a.pinel")
        assert pc.check() == (0, 0)
        assert pc.store.runs.events(pc.run_id)[0]["text"] == "P0"


def test_a_damaged_run_does_not_count_as_passed_and_says_so(tmp_path: Path) -> None:
    with school(tmp_path) as pc:
        pc.judge(pc.run_id, passed=True)
        pc.spoil("runs", pc.run_id, "check_report", b"{")
        assert pc.check() == (0, 1)
        assert pc.store.history.page(RunFilter(outcome="passed")) == []
        line = pc.store.history.page(RunFilter())[-1]
        assert (line.run.id, line.run.reason, line.run.passed_bit) == (
            pc.run_id,
            "run_damaged",
            None,
        )
        with pytest.raises(StoreError, match="run_damaged"):
            pc.store.runs.get(pc.run_id)


def test_a_damaged_version_goes_into_no_bundle_and_is_named(tmp_path: Path) -> None:
    with school(tmp_path) as pc:
        damaged = pc.newest_id
        pc.spoil("versions", damaged, "document", b"{}")
        info = pc.export(tmp_path / "a.pinel")
        assert info.left_out == (f"versions {damaged}",)
        with closing(opened(info.path, "immutable")) as db:
            assert row_count(db, "versions") == 2 * N_PROGRAMS - 1
