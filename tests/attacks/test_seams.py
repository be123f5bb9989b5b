"""The table of attacks, continued: what a stranger tries where parts meet. It reads as `test_attacks.py` does."""

from collections.abc import Callable

import pytest

from tests.attacks.signing import Pc, falsified, pcs

Pcs = Callable[[str], Pc]
__all__ = ["pcs"]
OTHER_CONTENT = """UPDATE versions SET workspace = '{"zzz": {"z": 1}}', document = NULL"""

# ---- a sender, and work that is here already ----


def test_a_file_does_not_put_another_program_in_the_place_of_a_saved_one(pcs: Pcs) -> None:
    run = pcs("teacher").drives()
    saved = pcs("teacher").version(run)
    pcs("teacher").merges(falsified(pcs("teacher").file(), OTHER_CONTENT))
    assert pcs("teacher").version(run) == saved


def test_nor_does_it_on_the_way_over_a_pc_that_is_approved(pcs: Pcs) -> None:
    run = pcs("pupil").drives()
    pcs("teacher").merges(pcs("pupil").file(), pcs("relay").file())
    pcs("teacher").approves(pcs("relay"))
    pcs("relay").merges(falsified(pcs("pupil").file(), OTHER_CONTENT))
    pcs("teacher").merges(pcs("relay").file())
    assert pcs("teacher").version(run) == pcs("pupil").version(run)


def test_a_forged_program_that_came_first_gives_way_to_its_author_s(pcs: Pcs) -> None:
    pcs("teacher").merges(pcs("pupil").file())
    pcs("teacher").approves(pcs("pupil"))
    run = pcs("pupil").drives()
    pcs("teacher").merges(falsified(pcs("pupil").file(), OTHER_CONTENT))
    assert pcs("teacher").version(run) != pcs("pupil").version(run)
    pcs("teacher").merges(pcs("pupil").file())
    assert pcs("teacher").version(run) == pcs("pupil").version(run)
    assert pcs("teacher").counts(run)


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
