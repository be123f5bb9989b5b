"""Runs that come again: cut off on one side and ended on the other, judged or not yet."""

import shutil
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import RunRecorder, RunStart, open_store
from storage.file.backups import make_backup
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import Opened, a_run, exported, hash_of, merged, work
from tests.storage.sample_documents import SQUARE, WORLD
from tests.storage.sample_runs import ended, sample


def test_a_run_that_was_cut_off_here_is_replaced_by_its_end(pc: Opened, tmp_path: Path) -> None:
    """A store came back from a backup that was made while the run went on."""
    whole, cut = pc("a"), pc("b")
    run_id = a_run(whole, None)
    path = exported(whole, tmp_path / "a.pinel").path
    merged(cut, path)

    def cut_off(db: sqlite3.Connection) -> None:
        db.execute("UPDATE runs SET state = 'running', ended_at = NULL WHERE id = ?", [run_id])
        db.execute("DELETE FROM telemetry WHERE run_id = ?", [run_id])
        db.execute("UPDATE events SET data = '{}' WHERE run_id = ?", [run_id])
        db.execute("DELETE FROM merges")

    cut._database.write(cut_off)
    assert merged(cut, path).changed == {"runs": 1}
    assert hash_of(cut) == hash_of(whole)
    assert cut.runs.events(run_id) == whole.runs.events(run_id)


@pytest.mark.parametrize("reason", ["blocked", "unset_variable", None])
def test_a_whole_run_is_not_replaced_by_its_copy_from_a_backup(
    pc: Opened, tmp_path: Path, reason: str | None
) -> None:
    """The backup was made while the run went on; its copy is closed as interrupted when the app starts."""
    here, teacher = pc("a"), pc("b")
    run = here.runs.begin(RunStart("sim", "w", WORLD, 1, "0.1.0", document=SQUARE))
    recorder = RunRecorder(here)
    for tick in range(60):
        recorder(sample(run.id, tick))
    recorder.flush()
    backup = make_backup(here.path, datetime(2026, 3, 3, tzinfo=UTC))
    assert backup
    for tick in range(60, 200):
        recorder(sample(run.id, tick))
    state = "failed" if reason else "finished"
    recorder(ended(run.id, 201, 200, state=state, reason=reason))
    whole = exported(here, tmp_path / "whole.pinel").path
    merged(teacher, whole)

    restored = tmp_path / "restored.db"
    shutil.copy(backup.path, restored)
    with open_store(restored, close_interrupted=True) as cut:
        assert cut.runs.get(run.id).reason == "interrupted"
        assert not merged(teacher, exported(cut, tmp_path / "cut.pinel").path).changed
        assert merged(cut, whole).changed["runs"] == 1
        for store in (cut, teacher):
            assert store.runs.get(run.id).reason == reason
            assert len(store.runs.telemetry(run.id).rows) == 200
            assert hash_of(store) == hash_of(here)


@pytest.mark.parametrize("order", [("judged", "unjudged"), ("unjudged", "judged")])
def test_what_was_judged_stays_judged(pc: Opened, tmp_path: Path, order: tuple[str, ...]) -> None:
    """A bundle was written before the check of the run had come to its end, another one after."""
    here, there = pc("a"), pc("b")
    _, run_id = work(there, there.groups.create("Onças"), "Quadrado")
    exported(there, tmp_path / "unjudged.pinel")
    there.grading_results.record(run_id, True, {"cases": []})
    exported(there, tmp_path / "judged.pinel")
    for name in order:
        for store in (here, there):
            merged(store, tmp_path / f"{name}.pinel")
    assert (here.runs.get(run_id).passed, there.runs.get(run_id).passed) == (True, True)
    assert hash_of(here) == hash_of(there)
