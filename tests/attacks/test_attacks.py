"""The table of attacks: what a file, a sender or a process may try, and what PINEL does about it.

Each test is one attack, in a few lines that read as a sentence; how it is done lies in the modules beside this file.
docs/trust.md tells a school the same in plain words.
"""

from pathlib import Path

import pytest

from tests.attacks.engine import NOTICED_S, SOON_S, desk

# ---- a file that somebody made up ----

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
