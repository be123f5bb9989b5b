"""What comes out of a damaged file is as it was written, or is told."""

import shutil
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from storage import Store, open_store
from storage.file.notices import SalvageResult
from storage.file.row_checksums import OF_RUNS, is_intact
from storage.salvage.salvage import salvage_into
from storage.scrub import Scrubber
from storage.sql import opened, row_count, tuples
from tests.storage.bundle_makers import a_run, work

NOW = "2026-03-03T08:00:00.000000Z"
DAMAGE_BY_TABLE = {
    "runs": "UPDATE runs SET seed = seed + 1024",
    "events": "UPDATE events SET data = replace(data, 'Quadrado', 'Quadradz')",
    "telemetry": "UPDATE telemetry SET first_tick = first_tick + 64",
}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """A file with a group, a program of two versions and a run."""
    path = tmp_path / "damaged.db"
    with open_store(path) as store:
        work(store, store.groups.create("Onças"), "Quadrado")
    return path


@pytest.fixture
def salvaged(tmp_path: Path, file: Path) -> Callable[[], tuple[SalvageResult, Path]]:
    return lambda: (salvage_into(file, tmp_path / "new.db", NOW), tmp_path / "new.db")


def damage(path: Path, statement: str) -> None:
    """Changes values as a disk does: no sum is renewed."""
    with closing(opened(path, "rw")) as disk:
        assert disk.execute(statement).rowcount > 0


def unsound(path: Path) -> list[str]:
    """Tables with rows that are not as they were written, as the store sees it."""
    with closing(opened(path, "ro")) as db:
        keys = tuples(db, "SELECT table_name, row_id FROM content_sums").fetchall()
        return sorted(table for table, key in keys if not is_intact(db, table, key))


def test_all_of_a_sound_file_comes_out(salvaged: Callable[[], tuple[SalvageResult, Path]]) -> None:
    found, path = salvaged()
    assert (found.n_edits, found.n_unread) == (2, 0)
    assert not unsound(path)
    with closing(opened(path, "ro")) as db:
        assert {table: row_count(db, table) for table in ("runs", "notes")} == {
            "runs": 1,
            "notes": 1,
        }


def test_a_version_that_is_not_as_it_was_written_counts_as_unread(
    file: Path, salvaged: Callable[[], tuple[SalvageResult, Path]]
) -> None:
    damage(file, "UPDATE versions SET workspace = replace(workspace, '!', '#') WHERE number = 2")
    found, path = salvaged()
    assert (found.n_edits, found.n_unread) == (1, 1)
    with open_store(path) as store:
        (program,) = store.programs.of_group(store.groups.all()[0].id)
        newest = store.versions.newest(program.id)
        assert newest
        assert newest.workspace == {"text": "Quadrado"}


@pytest.mark.parametrize("table", ["versions", "runs", "programs", "groups"])
@pytest.mark.parametrize("bit", [1, 64])  # the key is another one, or none
def test_a_row_in_whose_key_a_bit_flipped_comes_back_with_its_key(
    file: Path, salvaged: Callable[[], tuple[SalvageResult, Path]], table: str, bit: int
) -> None:
    before = rows(file, table)
    damage(file, f"{flip_key_of(table, bit)} WHERE id = (SELECT max(id) FROM {table})")
    found, path = salvaged()
    assert (found.n_edits, found.n_unread, unsound(path)) == (2, 0, [])
    assert rows(path, table) == before


def test_a_version_with_a_damaged_key_that_does_not_give_its_sum_either_counts_as_unread(
    file: Path, salvaged: Callable[[], tuple[SalvageResult, Path]]
) -> None:
    damage(file, f"{flip_key_of('versions', 64)}, created_at = '{NOW}' WHERE number = 1")
    found, _ = salvaged()
    assert (found.n_edits, found.n_unread) == (1, 1)


def flip_key_of(table: str, bit: int) -> str:
    """Flips a bit of the fifth sign."""
    sign = "unicode(substr(id, 5, 1))"
    flipped = f"char(({sign} | {bit}) - ({sign} & {bit}))"
    return f"UPDATE {table} SET id = substr(id, 1, 4) || {flipped} || substr(id, 6)"


@pytest.mark.parametrize("table", OF_RUNS)
def test_what_is_left_of_a_run_is_kept_and_told_as_damaged(
    file: Path, salvaged: Callable[[], tuple[SalvageResult, Path]], table: str
) -> None:
    damage(file, DAMAGE_BY_TABLE[table])
    _, path = salvaged()
    assert unsound(path) == [table]
    with open_store(path) as store:
        assert row_count_of(store, table) > 0
        assert Scrubber(store._database, pause=lambda _: False).check_all() == (0, 1)


@pytest.mark.parametrize("table", ["versions", *OF_RUNS])
def test_what_the_backup_has_as_it_was_written_stays(
    file: Path, tmp_path: Path, table: str
) -> None:
    backup = tmp_path / "backup.db"
    shutil.copy(file, backup)
    before = rows(backup, table)
    damage(file, DAMAGE_BY_TABLE.get(table, 'UPDATE versions SET workspace = \'{"text":"zzz"}\''))
    found = salvage_into(file, backup, NOW)
    assert (found.n_edits, found.n_unread, unsound(backup)) == (0, 0, [])
    assert rows(backup, table) == before


def test_a_judged_run_with_damaged_events_takes_those_of_the_backup(
    file: Path, tmp_path: Path
) -> None:
    backup = tmp_path / "backup.db"
    shutil.copy(file, backup)
    before = rows(backup, "events")
    with open_store(file) as store:
        store.grading_results.record(run_of(store), True, {})
    damage(file, DAMAGE_BY_TABLE["events"])
    salvage_into(file, backup, NOW)
    assert not unsound(backup)
    with open_store(backup) as store:
        assert store.runs.get(run_of(store)).passed
    assert rows(backup, "events") == before


def test_a_mark_of_a_run_that_does_not_count_yet_comes_along(
    file: Path, salvaged: Callable[[], tuple[SalvageResult, Path]]
) -> None:
    mark = f"INSERT INTO unconfirmed_runs SELECT id, NULL, '{NOW}', NULL FROM runs"
    damage(file, mark)
    _, path = salvaged()
    with closing(opened(path, "ro")) as db:
        assert row_count(db, "unconfirmed_runs") == 1


def test_sums_of_what_was_deleted_do_not_come_back(file: Path, tmp_path: Path) -> None:
    with open_store(file) as store:
        a_run(store, None)
        store.exchange.purge("program", store.programs.of_group(store.groups.all()[0].id)[0].id)
    salvage_into(file, tmp_path / "new.db", NOW)
    with closing(opened(tmp_path / "new.db", "ro")) as db:
        without_row = "row_id NOT IN (SELECT id FROM versions UNION SELECT id FROM runs)"
        assert row_count(db, "content_sums", without_row) == 0


def rows(path: Path, table: str) -> list[tuple[object, ...]]:
    with closing(opened(path, "ro")) as db:
        return tuples(db, f"SELECT * FROM {table} ORDER BY 1, 2").fetchall()


def run_of(store: Store) -> str:
    with store._database.read_connection() as db:
        return str(db.execute("SELECT id FROM runs").fetchone()["id"])


def row_count_of(store: Store, table: str) -> int:
    with store._database.read_connection() as db:
        return row_count(db, table)
