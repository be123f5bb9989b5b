"""The daily check of versions and runs."""

import hashlib
import itertools
from collections.abc import Callable
from contextlib import closing

import pytest

from storage import Store, VersionRow
from storage.file.backups import make_backup
from storage.file.row_checksums import content_checksum, stored_checksum
from storage.scrub import Scrubber
from storage.sql import opened as opened_file
from storage.sql import tuples
from storage.sqlite import sqlite3
from storage.text import utc_now
from tests.storage.bundle_makers import a_run


def checksum_keys(store: Store) -> set[tuple[str, str]]:
    with store._database.read_connection() as db:
        rows = db.execute("SELECT table_name, row_id FROM content_sums")
        return {(str(row[0]), str(row[1])) for row in rows}


def delete_checksums(store: Store) -> None:
    store._database.write(lambda db: db.execute("DELETE FROM content_sums").rowcount)


def test_a_run_has_its_sums_when_it_ends_and_loses_them_when_it_is_deleted(
    store: Store, version: VersionRow
) -> None:
    before = checksum_keys(store)
    run_id = a_run(store, version.id)
    store.runs.get(run_id)
    assert checksum_keys(store) - before == {
        (part, run_id) for part in ("runs", "events", "telemetry")
    }
    backup = make_backup(store.path, utc_now())
    store.exchange.purge("run", run_id)
    assert checksum_keys(store) == before
    assert backup is not None
    with closing(opened_file(backup.path, "immutable")) as db:
        assert {row[1] for row in db.execute("SELECT * FROM content_sums")} == {version.id}


def test_a_result_renews_the_sum_of_the_run_alone(store: Store, version: VersionRow) -> None:
    run_id = a_run(store, version.id)

    def run_checksums() -> list[str | None]:
        with store._database.read_connection() as db:
            return [stored_checksum(db, part, run_id) for part in ("runs", "events", "telemetry")]

    store.settings.set("x", 1)  # the run's end is on disk
    before = run_checksums()
    store.grading_results.record(run_id, True, {})
    after = run_checksums()
    assert (after[0] != before[0], after[1:]) == (True, before[1:])
    assert store.runs.get(run_id).passed


def test_a_sum_stays_what_it_was_however_many_rows_it_is_of(
    store: Store, version: VersionRow
) -> None:
    runs = [a_run(store, version.id) for _ in range(2)]

    def add(db: sqlite3.Connection) -> None:
        db.executemany(
            "INSERT INTO events (run_id, seq, tick, type, data) VALUES (?, ?, ?, 'said', '{}')",
            [(run, seq, seq // 2) for run in runs for seq in range(1000, 1600)],
        )

    store._database.write(add)
    for run in runs:
        octets = hashlib.sha256()
        with store._database.read_connection() as db:
            query = "SELECT seq, tick, type, data FROM events WHERE run_id = ? ORDER BY seq"
            for seq, tick, kind, data in tuples(db, query, (run,)):
                texts = f"type=t{len(kind)}:{kind}data=t{len(data.encode())}:{data}"
                octets.update(f"run_id=t36:{run}seq=i{seq};tick=i{tick};{texts}\n".encode())
            assert stored_checksum(db, "events", run) == octets.hexdigest()
            assert content_checksum(db, "events", run) == octets.hexdigest()


def test_rows_of_an_earlier_release_get_their_sums_when_they_are_first_seen(
    store: Store, version: VersionRow
) -> None:
    a_run(store, version.id)
    store.settings.set("x", 1)
    before = checksum_keys(store)
    delete_checksums(store)
    assert Scrubber(store._database).check_all() == (0, 0)
    assert checksum_keys(store) == before


def test_the_check_rests_nineteen_times_as_long_as_it_works_and_ends_when_the_app_closes(
    store: Store, version: VersionRow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("storage.scrub._PIECE_S", 0.0)
    monkeypatch.setattr("storage.scrub.time.monotonic", itertools.count().__next__)
    store.versions.save(version.program_id, {"blocks": {"n": 2}}, None)
    rests: list[float] = []

    def pause(seconds: float) -> bool:
        rests.append(seconds)
        return True  # the app is closed

    Scrubber(store._database, pause=pause).check_all()
    assert rests == [19.0]


def test_an_app_that_closes_does_not_wait_for_the_check(opened: Callable[..., Store]) -> None:
    check = Scrubber(opened()._database)
    check.start()
    check.close()
    assert check.notice is None
