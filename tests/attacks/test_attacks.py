"""The table of attacks: what a file, a sender or a process may try, and what PINEL does about it.

Each test is one attack, in a few lines that read as a sentence; how it is done lies in the modules beside this file.
docs/trust.md tells a school the same in plain words.
"""

from pathlib import Path

import pytest

from storage import Store, open_store
from storage.limits import MAX_REVISION
from tests.attacks.engine import NOTICED_S, SOON_S, desk
from tests.attacks.made_up_files import (
    AHEAD,
    FAR_ID,
    TOMORROW,
    forged,
    program_file,
    refusal,
    suffering,
)
from tests.storage.bundle_makers import exported, hash_of, merged, work

# ---- a file that somebody made up ----


def test_a_made_up_id_does_not_get_in_and_later_work_goes_to_other_pcs(
    here: Store, there: Store, tmp_path: Path
) -> None:
    rename = f"PRAGMA foreign_keys = OFF; UPDATE version_labels SET id = '{FAR_ID}'"
    later = f"UPDATE versions SET id = '{FAR_ID}', number = 1000000000 WHERE number = 2"
    runs = f"UPDATE runs SET version_id = '{FAR_ID}'"
    file = forged(program_file(there, tmp_path / "p.pinel"), f"{rename}; {later}; {runs}")
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


def test_a_pc_that_took_such_a_file_with_an_earlier_release_is_mended_and_says_so(
    tmp_path: Path, there: Store, fresh_ids: None
) -> None:
    with open_store(tmp_path / "suffers.db") as before:
        suffering(before)
    with open_store(tmp_path / "suffers.db") as mended:
        assert mended.notice is not None
        assert mended.notice.code == "database_mended"
        merged(there, exported(mended, tmp_path / "x.pinel").path)
        assert hash_of(there) == hash_of(mended)


def test_a_file_that_lacks_work_says_whose(here: Store, tmp_path: Path) -> None:
    program, _ = work(here, here.groups.create("Onças"), "Quadrado")
    here._database.write(lambda db: db.execute("UPDATE versions SET parent_id = 'x'"))
    info = exported(here, tmp_path / "x.pinel")
    assert info.lacking == ("Onças", f"Onças / {program.name}")


# ---- a file that somebody signed ----

# ---- a person at the page ----

# ---- a deletion that arrives with a file ----

# ---- a file that was damaged ----

# ---- a value that was damaged ----

# ---- a process that hangs or grows ----


@pytest.mark.waits
def test_a_frozen_engine_is_replaced_its_run_is_told_as_lost_and_the_next_run_works(
    tmp_path: Path,
) -> None:
    with desk(tmp_path) as group, group.run_with_frozen_engine() as (_, wait_for_end):
        end, silent_s = wait_for_end()
        assert (end["state"], end["reason"]) == ("failed", "engine_lost")
        assert silent_s < NOTICED_S
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
    assert flood.longest_s < SOON_S
    assert flood.grown_mb < 100.0
