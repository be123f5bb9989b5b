"""The table of attacks, continued: what a stranger tries where parts meet. It reads as `test_attacks.py` does."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from pinel_desktop.activities import shipped_activity
from pinel_desktop.doctor import examination
from pinel_desktop.school.teacher import TeacherSessions
from storage import StoreError, open_store
from storage.file.backups import make_backup
from storage.file.commit_counter import path_of
from storage.limits import N_FEATURES
from storage.maintenance import Maintenance
from storage.text import utc_now
from tests.attacks.damage import PAGE, a_day, reopened, spoil
from tests.attacks.forging import MISSION, Pc, falsified, pcs
from tests.attacks.power_cuts import power_cut_while_read
from tests.attacks.wrong_bits import Disk, content_of

Pcs = Callable[[str], Pc]
__all__ = ["pcs"]
OTHER_CONTENT = """UPDATE versions SET workspace = '{"zzz": {"z": 1}}', document = NULL"""

# ---- a sender, and work that is here already ----


def test_a_file_does_not_put_another_program_in_the_place_of_a_saved_one(pcs: Pcs) -> None:
    pcs("pupil").drives()
    forgery = falsified(pcs("pupil").file(), OTHER_CONTENT)
    for name in ("pupil", "teacher"):
        with pytest.raises(StoreError, match="bundle_hostile"):
            pcs(name).merges(forgery)


def test_nor_does_it_where_an_earlier_release_gave_the_key(pcs: Pcs) -> None:
    run = pcs("teacher").drives()
    file = falsified(pcs("teacher").file(), of_before=True)
    pcs("other").merges(file)
    saved = pcs("other").version(run)
    pcs("other").merges(falsified(file, OTHER_CONTENT))
    assert pcs("other").version(run) == saved


def test_a_forged_program_that_came_first_keeps_nothing_of_its_author_s_out(pcs: Pcs) -> None:
    run = pcs("pupil").drives()
    with pytest.raises(StoreError, match="bundle_hostile"):
        pcs("teacher").merges(falsified(pcs("pupil").file(), OTHER_CONTENT))
    pcs("teacher").merges(pcs("pupil").file())
    assert pcs("teacher").version(run) == pcs("pupil").version(run)
    pcs("teacher").confirms()
    assert pcs("teacher").counts(run)


def test_nor_does_it_change_a_sign_that_a_class_taught(pcs: Pcs) -> None:
    store = pcs("teacher").store
    room = store.classrooms.create("8A").id
    store.taught_signs.add(room, "oi", bytes(2 * N_FEATURES))
    pcs("teacher").merges(falsified(pcs("teacher").file(), "UPDATE taught_signs SET sign = 'zz'"))
    assert [one.sign for one in store.taught_signs.of_classroom(room)] == ["oi"]


@pytest.mark.parametrize("verdict", ["passed = 1", "passed = NULL"])
def test_a_run_that_is_still_to_be_judged_gets_no_samples_of_a_better_one(
    pcs: Pcs, verdict: str
) -> None:
    bad, good = pcs("teacher").drives(well=False), pcs("teacher").drives()
    pcs("teacher").forgets_verdict_on(bad)
    samples = f"SELECT '{bad}', chunk, first_tick, n_rows, data FROM telemetry"
    file = falsified(
        pcs("teacher").file(),
        f"DELETE FROM telemetry WHERE run_id = '{bad}'",
        f"INSERT INTO telemetry {samples} WHERE run_id = '{good}'",
        f"UPDATE runs SET {verdict} WHERE id = '{bad}'",
    )
    n_rows = len(pcs("teacher").store.runs.telemetry(bad).rows)
    pcs("teacher").merges(file)
    assert len(pcs("teacher").store.runs.telemetry(bad).rows) == n_rows
    assert not pcs("teacher").counts(bad)


# ---- a damaged file, and what the teacher decided after its backup ----


def test_a_pin_that_was_changed_stays_so_when_the_backup_is_restored(tmp_path: Path) -> None:
    with open_store(tmp_path / "pinel.db") as store:
        TeacherSessions(store.settings).set_pin("3141")
        make_backup(store.path, utc_now())
        TeacherSessions(store.settings).set_pin("2718")
    spoil(tmp_path / "pinel.db", 0, 16)
    with open_store(tmp_path / "pinel.db") as store:
        assert store.notice
        assert store.notice.code in ("database_restored", "database_salvaged")
        assert TeacherSessions(store.settings).sign_in("2718")


def test_on_a_full_disk_a_damaged_file_stays_until_there_is_room_to_read_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    day = a_day(tmp_path, n_edits=30, n_backed_up=999, n_in_log=10)
    spoil(day.path, PAGE, 3 * PAGE)
    with monkeypatch.context() as full:
        full.setattr("storage.salvage.salvage._LEFT_FREE", 10**18)
        with pytest.raises(StoreError, match="disk_full"):
            open_store(day.path)
    notice, n_retained = reopened(day)
    assert notice
    assert (notice.code, n_retained) == ("database_salvaged_alone", 30)


def test_a_power_cut_while_a_damaged_file_is_read_leaves_no_copy_of_the_work(
    tmp_path: Path,
) -> None:
    with open_store(tmp_path / "pinel.db") as store:
        store.groups.create("Onças")
    spoil(tmp_path / "pinel.db", 0, 16)
    power_cut_while_read(tmp_path / "pinel.db")
    with open_store(tmp_path / "pinel.db") as store:
        assert [group.name for group in store.groups.all()] == ["Onças"]
    assert [one for one in tmp_path.iterdir() if one.is_dir()] == []


# ---- what is confirmed in the background ----


@pytest.mark.timeout(60)
def test_a_program_that_would_count_for_hours_is_repeated_no_further_than_its_record(
    pcs: Pcs,
) -> None:
    run = pcs("pupil").drives(well=False)
    endless = """{"pinel_ir": 1, "name": "", "functions": [], "commands": [{"action": "repeat",
        "times": 100000, "commands": [{"action": "repeat", "times": 100000, "commands": []}]}]}"""
    forged = (f"UPDATE versions SET document = '{endless}'", "UPDATE runs SET passed = 1")
    pcs("teacher").merges(falsified(pcs("pupil").file(), *forged, of_before=True))
    pcs("teacher").confirms()
    assert pcs("teacher").mark(run) == "differs"


def test_a_file_of_long_runs_does_not_hold_up_a_short_one_that_comes_later(pcs: Pcs) -> None:
    long = pcs("pupil").drives()
    pcs("teacher").merges(falsified(pcs("pupil").file(), "UPDATE runs SET passed = 1"))
    short = pcs("other").drives(well=False, passed=True)
    pcs("teacher").merges(pcs("other").file())
    assert pcs("teacher").store.unconfirmed.waiting() == [short, long]


def test_a_pass_of_an_activity_that_comes_later_is_confirmed_then(pcs: Pcs) -> None:
    run, key = pcs("pupil").drives(), pcs("pupil").store.own_activities.new_key()
    pcs("teacher").merges(falsified(pcs("pupil").file(), f"UPDATE runs SET activity = '{key}'"))
    pcs("teacher").confirms()
    assert pcs("teacher").mark(run) == "waiting"
    document = shipped_activity(MISSION).model_dump(mode="json")
    pcs("teacher").store.own_activities.save(key, "Quadrado", {**document, "name": key}, {})
    pcs("teacher").confirms()
    assert pcs("teacher").mark(run) is None


# ---- something else in the place of a file ----


@pytest.mark.parametrize("put", [Path.mkdir, os.mkfifo])
def test_a_folder_or_a_pipe_in_the_place_of_the_file_is_told_at_once(
    tmp_path: Path, put: Callable[[Path], None]
) -> None:
    put(tmp_path / "pinel.db")
    with pytest.raises(StoreError, match="database_failed"):
        open_store(tmp_path / "pinel.db")


@pytest.mark.parametrize("at", ["0001-01-01T00:00:00+14:00", 100_000 * "["])
def test_a_damaged_mark_does_not_keep_pinel_from_starting(tmp_path: Path, at: str) -> None:
    path_of(tmp_path / "pinel.db").write_text(f'{{"saves": 9, "at": "{at}"}}'.replace('"[', "["))
    with open_store(tmp_path / "pinel.db") as store:
        assert store.groups.create("Onças")


# ---- one wrong bit where no sum is ----


@pytest.mark.parametrize("table", ["classrooms", "groups", "programs", "versions", "runs"])
@pytest.mark.parametrize("bit", [1, 6, 7])
def test_a_wrong_bit_in_a_key_deletes_nothing_and_lets_people_work_on(
    tmp_path: Path, table: str, bit: int
) -> None:
    disk = Disk(tmp_path)
    with disk.after_a_flip(table, "id", bit) as store:
        assert content_of(store).n_rows == disk.before.n_rows
        store.groups.create("Tucanos")
        disk.export(store)


def test_a_key_that_looks_made_up_by_a_wrong_bit_is_damage_and_said_to_be(tmp_path: Path) -> None:
    disk = Disk(tmp_path)
    with disk.after_a_flip("groups", "id", 1) as store:
        assert store.notice
        assert store.notice.code == "database_restored"
        assert content_of(store) == disk.before


@pytest.mark.parametrize(("table", "column"), [("groups", "id"), ("programs", "group_id")])
def test_programs_that_a_wrong_bit_took_out_of_every_list_are_told(
    tmp_path: Path, table: str, column: str
) -> None:
    with Disk(tmp_path).after_a_flip(table, column, 4) as store:
        maintenance = Maintenance(store)
        maintenance.check_integrity()
        assert maintenance.notice
        assert maintenance.notice.code == "backup_found_damage"
        assert examination._database(store.path).code == "doctor_database_inconsistent"


@pytest.mark.parametrize("bit", [0, 7])  # no JSON, no text
def test_a_wrong_bit_in_a_setting_does_not_keep_pinel_from_starting(
    tmp_path: Path, bit: int
) -> None:
    disk = Disk(tmp_path)
    with disk.after_a_flip("settings", "value", bit, "key = 'computer_id'") as store:
        assert store.notice
        assert store.notice.code == "settings_mended"
        assert content_of(store) == disk.before


@pytest.mark.parametrize("table", ["classrooms", "groups", "programs", "computers"])
def test_a_wrong_bit_in_a_name_blocks_no_list_no_other_name_and_no_export(
    tmp_path: Path, table: str
) -> None:
    disk = Disk(tmp_path)
    with disk.after_a_flip(table, "name", 7) as store:
        (group,) = store.groups.all()
        assert [one.n_versions for one in store.programs.of_group(group.id)] == [2]
        disk.export(store)
        store.groups.change(group.id, {"name": "Araras"})
        assert content_of(store).groups == {"Araras"}
