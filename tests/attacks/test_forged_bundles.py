"""Thousands of files with values changed at random: each is refused, or nothing of it counts as passed."""

import random
import shutil
from collections.abc import Callable
from contextlib import closing, suppress
from pathlib import Path

import pytest

from storage import Store, StoreError
from storage.exchange.bundle_writing import counts_of
from storage.exchange.content_hash import content_hash
from storage.sql import column_names, opened
from storage.sqlite import sqlite3
from storage.tables.replicated import REPLICATED
from storage.text import to_json
from tests.attacks.forging import Pc, pcs
from tests.storage.bundle_makers import give_keys_of_before, hash_of

__all__ = ["pcs"]
N_FORGED = 5_000
VALUES = (
    *(None, 0, 1, 2, -1, 10**6, 10**9, 2**62, 1.5),
    *("", "square", "passed", "{}", "[]", "2026-01-01T00:00:00Z", b"\0"),
)
PASSED = "UPDATE runs SET passed = 1, activity = 'square', state = 'finished'"


def forge(path: Path, chance: random.Random) -> None:
    """Changes some values, claims that all runs passed, and makes checksum and counts fit."""
    with closing(opened(path, "rw")) as db:
        db.execute("PRAGMA foreign_keys = OFF")
        db.execute(PASSED)
        if chance.random() < 0.5:  # else a change of a version is refused for its key
            give_keys_of_before(db)
        for _ in range(chance.randrange(4)):
            table = chance.choice(REPLICATED)
            column = chance.choice(column_names(db, table.name))
            with suppress(sqlite3.IntegrityError):  # the table itself refuses it
                db.execute(
                    f"UPDATE OR IGNORE {table.name} SET {column} = ?", [chance.choice(VALUES)]
                )
        if chance.random() < 0.5:
            db.execute(
                "INSERT OR IGNORE INTO unconfirmed_runs (run_id, marked_at) SELECT id, '' FROM runs LIMIT 1"
            )
        values = [content_hash(db), to_json(counts_of(db))]
        db.execute("UPDATE bundle SET content_hash = ?, counts = ?", values)


def counted(store: Store) -> set[str]:
    """Runs that count as passed."""
    query = (
        "SELECT id FROM runs WHERE passed = 1 AND id NOT IN (SELECT run_id FROM unconfirmed_runs)"
    )
    with store._database.read_connection() as db:
        return {str(row["id"]) for row in db.execute(query)}


@pytest.mark.nightly
@pytest.mark.timeout(3600)
def test_of_thousands_of_forged_files_nothing_counts(
    pcs: Callable[[str], Pc], tmp_path: Path
) -> None:
    teacher, pupil = pcs("teacher"), pcs("pupil")
    own = teacher.drives()
    pupil.drives()
    pupil.drives(well=False)
    teacher.merges(teacher.file())
    pupil.merges(teacher.file())  # the forger knows the run that counts here
    original, chance, n_merged = pupil.file(), random.Random(16), 0
    for _ in range(N_FORGED):
        forged = shutil.copyfile(original, tmp_path / "forged.pinel")
        forge(forged, chance)
        before = hash_of(teacher.store)
        try:
            teacher.merges(forged)
            n_merged += 1
        except StoreError:
            assert hash_of(teacher.store) == before
        assert counted(teacher.store) == {own}
    assert n_merged > N_FORGED / 10
