"""The table of attacks: what a file, a sender or a process may try, and what PINEL does about it.

Each test is one attack, in a few lines that read as a sentence; how it is done lies in the modules beside this file.
docs/trust.md tells a school the same in plain words.
"""

import itertools
from collections.abc import Callable
from itertools import permutations
from pathlib import Path

import pytest

from pinel_desktop.program.pointers import in_document_order
from pinel_desktop.program.reading import read_document
from pinel_desktop.school.teacher import TeacherSessions
from pinel_desktop.web.guard import Guard
from storage import Store, StoreError
from storage.limits import MAX_REVISION, MAX_TURN
from tests.attacks.deletions import Lab
from tests.attacks.engine import NOTICED_S, SOON_S, desk
from tests.attacks.forging import LATEST_ALLOWED, Pc, edited, falsified, pcs
from tests.attacks.made_up_files import (
    AHEAD,
    FAR_ID,
    TOMORROW,
    CountedKeys,
    CountedText,
    forged,
    in_encoding,
    program_file,
    refusal,
    samples_of_hours,
)
from tests.attacks.pins import PIN, FullDisk, Pins, open_pins_again
from tests.storage.bundle_makers import exported, merged, work

Pcs = Callable[[str], Pc]
__all__ = ["pcs"]
FORGERIES = (
    "UPDATE runs SET world = 'zzz', duration_s = 1 WHERE id = '{run}'",
    "UPDATE telemetry SET (data, n_rows) = (SELECT data, n_rows FROM telemetry WHERE run_id = '{other}')"
    " WHERE run_id = '{run}'",
)

# ---- a file that somebody made up ----


def test_a_made_up_id_does_not_get_in_and_later_work_goes_to_other_pcs(
    here: Store, there: Store, tmp_path: Path
) -> None:
    rename = f"PRAGMA foreign_keys = OFF; UPDATE version_labels SET id = '{FAR_ID}'"
    renumber = f"UPDATE versions SET id = '{FAR_ID}', number = 1000000000 WHERE number = 2"
    runs = f"UPDATE runs SET version_id = '{FAR_ID}'"
    file = forged(program_file(there, tmp_path / "p.pinel"), f"{rename}; {renumber}; {runs}")
    assert refusal(lambda: here.exchange.merge_program(file)) == "bundle_hostile"
    group = here.groups.create("Tucanos")
    work(here, group, "Depois")
    assert merged(there, exported(here, tmp_path / "all.pinel").path).added["runs"] == 1


@pytest.mark.parametrize("change", AHEAD)
def test_a_number_or_revision_that_no_work_reaches_does_not_get_in(
    here: Store, there: Store, tmp_path: Path, change: str
) -> None:
    file = forged(program_file(there, tmp_path / "p.pinel"), change)
    assert refusal(lambda: here.exchange.merge_program(file)) == "bundle_hostile"
    assert refusal(lambda: here.exchange.merge(file)) == "bundle_hostile"


def test_the_greatest_revision_that_gets_in_does_not_beat_the_teachers_correction(
    here: Store, there: Store, tmp_path: Path
) -> None:
    file = program_file(there, tmp_path / "p.pinel")
    forged(file, f"UPDATE groups SET name = 'Feio', revision = {MAX_REVISION}, {TOMORROW}")
    merged(here, file)
    (group,) = here.groups.all()
    merged(there, file)
    here.groups.change(group.id, {"name": "Onças"})
    merged(there, exported(here, tmp_path / "mended.pinel").path)
    assert there.groups.get(group.id).name == "Onças"


def test_a_file_that_lacks_work_says_whose(here: Store, tmp_path: Path) -> None:
    program, _ = work(here, here.groups.create("Onças"), "Quadrado")
    here._database.write(lambda db: db.execute("UPDATE versions SET parent_id = 'x'"))
    info = exported(here, tmp_path / "x.pinel")
    assert info.lacking == ("Onças", f"Onças / {program.name}")


@pytest.mark.parametrize("encoding", ["UTF-16le", "UTF-16be"])
def test_a_file_in_another_encoding_does_not_get_in(
    here: Store, there: Store, tmp_path: Path, encoding: str
) -> None:
    file = program_file(there, tmp_path / "p.pinel")
    in_encoding(file, encoding)
    assert refusal(lambda: here.exchange.merge_program(file)) == "bundle_hostile"


def test_samples_of_months_are_refused_before_they_are_unpacked(
    here: Store, there: Store, tmp_path: Path, n_unpacked: list[int]
) -> None:
    file = forged(program_file(there, tmp_path / "p.pinel"), samples_of_hours(400))
    assert refusal(lambda: here.exchange.merge_program(file)) == "bundle_too_long"
    assert n_unpacked == []


def test_a_function_with_50_000_parameters_is_one_fault_and_looked_through_once() -> None:
    parameters = CountedText.many(50_000)
    function = {"name": "f", "parameters": parameters, "commands": []}
    reading = read_document({"pinel_ir": 1, "commands": [], "functions": [function]})
    assert [fault.code for fault in reading.faults] == ["too_many_parameters"]
    assert CountedText.n_compared < 200_000


def test_50_000_unknown_keys_are_faults_and_ordered_at_once() -> None:
    document = CountedKeys({"pinel_ir": 1, "commands": []} | {f"k{n}": 1 for n in range(50_000)})
    assert len(in_document_order(document, [(key,) for key in document])) == 50_002
    assert document.n_listed < 5


# ---- a pass that comes with a file ----


def test_a_pass_that_somebody_wrote_into_the_file_never_counts(pcs: Pcs) -> None:
    run = pcs("pupil").drives(well=False)
    pcs("teacher").merges(falsified(pcs("pupil").file(), "UPDATE runs SET passed = 1"))
    assert (pcs("teacher").counts(run), pcs("teacher").mark(run)) == (False, "waiting")
    pcs("teacher").confirms()
    assert (pcs("teacher").counts(run), pcs("teacher").mark(run)) == (False, "not_passed")


def test_a_pass_with_samples_of_another_way_never_counts(pcs: Pcs) -> None:
    run, other = pcs("pupil").drives(well=False), pcs("pupil").drives()
    samples = f"(SELECT data FROM telemetry WHERE run_id = '{other}' LIMIT 1)"
    file = falsified(
        pcs("pupil").file(),
        f"UPDATE runs SET passed = 1 WHERE id = '{run}'",
        f"UPDATE telemetry SET data = {samples}, n_rows = (SELECT n_rows FROM telemetry"
        f" WHERE run_id = '{other}' LIMIT 1) WHERE run_id = '{run}'",
    )
    pcs("teacher").merges(file)
    pcs("teacher").confirms()
    assert (pcs("teacher").counts(run), pcs("teacher").mark(run)) == (False, "differs")
    assert pcs("teacher").counts(other)  # the honest pass of the same file


def test_an_honest_pass_counts_once_it_was_repeated(pcs: Pcs) -> None:
    run = pcs("pupil").drives()
    report = pcs("teacher").merges(pcs("pupil").file())
    assert report.n_unconfirmed == 1
    assert not pcs("teacher").counts(run)
    pcs("teacher").confirms()
    assert (pcs("teacher").counts(run), pcs("teacher").mark(run)) == (True, None)


def test_a_file_neither_takes_a_pass_away_nor_changes_its_record(pcs: Pcs) -> None:
    run = pcs("teacher").drives()
    file = falsified(
        pcs("teacher").file(),
        "UPDATE runs SET passed = 0, state = 'stopped'",
        "DELETE FROM telemetry",
    )
    pcs("teacher").merges(file)
    row = pcs("teacher").store.runs.get(run)
    assert (row.state, row.passed, row.unconfirmed) == ("finished", True, None)
    assert len(pcs("teacher").store.runs.telemetry(run).rows)


@pytest.mark.parametrize("forgery", FORGERIES)
def test_a_forged_record_that_came_first_gives_way_to_the_true_one(pcs: Pcs, forgery: str) -> None:
    run, other = pcs("pupil").drives(), pcs("pupil").drives(well=False)
    pcs("teacher").merges(falsified(pcs("pupil").file(), forgery.format(run=run, other=other)))
    pcs("teacher").confirms()
    assert not pcs("teacher").counts(run)
    pcs("teacher").merges(pcs("pupil").file())
    assert pcs("teacher").mark(run) == "waiting"
    pcs("teacher").confirms()
    assert pcs("teacher").store.runs.get(run) == pcs("pupil").store.runs.get(run)
    assert pcs("teacher").counts(run)


def test_nor_does_a_forged_record_take_the_place_of_one_that_was_repeated(pcs: Pcs) -> None:
    run = pcs("pupil").drives()
    forgery = falsified(pcs("pupil").file(), "UPDATE runs SET world = 'zzz', seed = 9")
    pcs("teacher").merges(pcs("pupil").file())
    pcs("teacher").confirms()
    pcs("teacher").merges(forgery)
    assert pcs("teacher").store.runs.get(run) == pcs("pupil").store.runs.get(run)
    assert pcs("teacher").counts(run)


def test_what_was_repeated_in_vain_is_repeated_again_only_for_another_record(pcs: Pcs) -> None:
    run = pcs("pupil").drives(well=False)
    file = falsified(pcs("pupil").file(), "UPDATE runs SET passed = 1")
    pcs("teacher").merges(file)
    pcs("teacher").confirms()
    pcs("teacher").merges(file)
    assert pcs("teacher").mark(run) == "not_passed"


def test_a_forged_pass_that_comes_over_another_pc_never_counts(pcs: Pcs) -> None:
    run = pcs("pupil").drives(well=False)
    pcs("relay").merges(falsified(pcs("pupil").file(), "UPDATE runs SET passed = 1"))
    pcs("teacher").merges(pcs("relay").file())
    pcs("teacher").confirms()
    assert not pcs("teacher").counts(run)


def test_a_run_that_cannot_be_repeated_counts_when_the_teacher_accepts_it(pcs: Pcs) -> None:
    run, wrong = pcs("pupil").drives(), pcs("pupil").drives(well=False)
    change = f"UPDATE runs SET passed = 1, link = CASE id WHEN '{run}' THEN 'rosaria' ELSE link END"
    file = falsified(pcs("pupil").file(), change)
    pcs("teacher").merges(file)
    pcs("teacher").store.unconfirmed.accept(run)
    assert pcs("teacher").mark(run) == "waiting"
    pcs("teacher").confirms()
    assert [pcs("teacher").mark(one) for one in (run, wrong)] == ["not_repeatable", "not_passed"]
    for one in (run, wrong):
        pcs("teacher").store.unconfirmed.accept(one)
    pcs("teacher").merges(file)
    assert [pcs("teacher").counts(one) for one in (run, wrong)] == [True, False]


def test_a_file_that_pupils_bring_without_the_teacher_counts_only_once_repeated(pcs: Pcs) -> None:
    run, forgery = pcs("pupil").drives(), pcs("pupil").drives(well=False)
    pcs("other").store.exchange.merge_program(pcs("pupil").program_file(run))
    file = falsified(pcs("pupil").program_file(forgery), "UPDATE runs SET passed = 1")
    pcs("other").store.exchange.merge_program(file)
    assert (pcs("other").counts(run), pcs("other").counts(forgery)) == (False, False)
    pcs("other").confirms()
    assert (pcs("other").counts(run), pcs("other").counts(forgery)) == (True, False)


def test_a_row_that_no_checksum_counts_does_not_get_in(pcs: Pcs) -> None:
    run = pcs("pupil").drives(well=False)
    file = edited(
        pcs("pupil").file(), f"INSERT INTO computers (id, name) SELECT '{run}', 'Forjado'"
    )
    with pytest.raises(StoreError, match=r"bundle_(damaged|hostile)"):
        pcs("teacher").merges(file)


@pytest.mark.parametrize("order", list(permutations(("pupil", "teacher", "third"))))
def test_a_forged_name_gives_way_to_the_teacher_s_correction_on_all_pcs(
    pcs: Pcs, order: tuple[str, ...]
) -> None:
    group = pcs("pupil").store.groups.create("Onças")
    forgery = falsified(
        pcs("pupil").file(), f"UPDATE groups SET name = 'Zzz', name_key = 'zzz', {LATEST_ALLOWED}"
    )
    pcs("teacher").merges(forgery)
    pcs("teacher").store.groups.change(group.id, {"name": "Onças"})
    files = [forgery, pcs("pupil").file(), pcs("teacher").file()]
    for name in order:
        pcs(name).merges(*files)
        files = [*files[1:], files[0]]
        assert [one.name for one in pcs(name).store.groups.all()] == ["Onças"]


# ---- a person at the page ----


def test_pupils_who_try_pins_do_not_keep_the_teacher_out(pins: Pins) -> None:
    for _ in range(8):
        pins.guess("the pupils' window")
    assert pins.sessions.sign_in(PIN, "the window opened anew")


def test_who_begins_ever_new_sessions_guesses_once_in_two_minutes(pins: Pins) -> None:
    n_tried = sum(pins.guess(f"session {n}", after_s=10) for n in range(360))
    assert n_tried <= 10 + 30
    with open_pins_again(pins) as again:
        assert not again.guess("after another start")


def test_the_teacher_enters_on_a_full_disk(pins: Pins) -> None:
    full = TeacherSessions(FullDisk(pins.settings), pins.clock, pins.clock)
    assert full.is_signed_in(full.sign_in(PIN))


def test_an_address_that_was_looked_over_opens_nothing_after_its_use(tmp_path: Path) -> None:
    guard = Guard()
    key = guard.fresh_link().partition("key=")[2]
    assert guard.redeem(key)
    assert not guard.redeem(key)


# ---- a deletion that arrives with a file ----


def test_a_class_deleted_while_its_group_was_moved_ends_the_same_in_any_order(lab: Lab) -> None:
    files = lab.class_deleted_while_its_group_moved()
    hashes = {lab.hash_of_a_new_pc(order) for order in itertools.permutations(files)}
    assert len(hashes) == 1


def test_what_was_made_in_a_moved_group_is_on_all_pcs_in_the_end(lab: Lab) -> None:
    for order in itertools.permutations(range(3)):
        hashes, programs = lab.everybody_merges_after_class_deleted_and_group_moved(order)
        assert len(hashes) == 1
        assert programs == [{"before", "on the third PC", "where it was moved"}] * 3


def test_a_group_that_had_left_a_class_where_that_was_deleted_stays_and_is_not_asked_about(
    lab: Lab,
) -> None:
    asked, programs, hashes = lab.class_deleted_where_its_group_had_left_and_here_it_was_worked_in()
    assert asked == {"8º B"}
    assert programs == {"só aqui"}
    assert len(hashes) == 1


def test_a_deletion_that_was_not_confirmed_does_not_keep_pcs_apart(lab: Lab) -> None:
    here, there = lab.run_deleted_there_then_its_group_here()
    assert here == there


def test_work_that_the_sender_of_a_deletion_never_saw_is_named_and_kept(lab: Lab) -> None:
    asked, left = lab.group_deleted_there_and_worked_on_here()
    assert [(one.name, one.is_moved, one.n_new_runs) for one in asked] == [("Onças", True, 1)]
    assert left == {"Onças"}


def test_what_was_kept_on_one_pc_is_not_deleted_by_the_next_file(lab: Lab) -> None:
    assert lab.groups_after_it_was_retained_and_old_files_came() == [{"Onças"}, {"Onças"}]


def test_a_made_up_file_cannot_keep_for_ever_what_a_school_must_delete(lab: Lab) -> None:
    assert lab.deleted_after_a_forged_retention(MAX_TURN - 1) == [set(), set()]
    with pytest.raises(StoreError, match="bundle_hostile"):
        lab.deleted_after_a_forged_retention(MAX_TURN + 1)


def test_what_was_kept_can_be_deleted_anew(lab: Lab) -> None:
    asked, left = lab.deleted_again_after_it_was_retained()
    assert asked == {"Onças"}
    assert left == [set(), set()]


# ---- a process that hangs or grows ----


@pytest.mark.waits
def test_a_frozen_engine_is_replaced_its_run_is_told_as_lost_and_the_next_run_works(
    tmp_path: Path,
) -> None:
    with desk(tmp_path) as group, group.run_with_frozen_engine() as (_, wait_for_end):
        end, unresponsive_s = wait_for_end()
        assert (end["state"], end["reason"]) == ("failed", "engine_lost")
        assert unresponsive_s < NOTICED_S
        assert group.engine.wait_until_ready(60.0)  # on a busy PC the start alone takes long
        assert group.run_to_the_end()["state"] == "finished"


@pytest.mark.waits
def test_stop_at_a_frozen_engine_is_not_told_as_done(tmp_path: Path) -> None:
    with desk(tmp_path) as group, group.run_with_frozen_engine() as (run, _):
        answer, took_s = group.command(run, "stop")
        assert (answer.status, answer.error["code"]) == (503, "stop_unconfirmed")
        assert took_s < SOON_S


@pytest.mark.waits
def test_a_hundred_thousand_commands_to_a_frozen_engine_hold_up_nobody_and_fill_no_memory(
    tmp_path: Path,
) -> None:
    with desk(tmp_path) as group, group.run_with_frozen_engine() as (run, _):
        flood = group.flood(run, 100_000)
    assert flood.codes <= {"", "engine_silent", "run_not_live"}  # taken, refused, over
    assert flood.codes > {""}
    assert flood.max_s < SOON_S
    assert flood.grown_mb < 100.0
