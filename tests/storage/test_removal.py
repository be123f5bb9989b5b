"""What is deleted for good is gone, from every table and from the bytes of the file."""

import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest

from storage import Recorder, RunStart, Store
from storage.content import content_hash
from storage.opening import connect
from storage.removal import forget_log, remove_keys
from tests.storage.conftest import SQUARE, WORLD
from tests.storage.sample_runs import ended, sample


@pytest.fixture
def db(store: Store, path: Path) -> Iterator[sqlite3.Connection]:
    connection = connect(path.as_uri())
    yield connection
    connection.close()


def busy_group(store: Store, name: str) -> str:
    """A group with a program, a version and a run whose texts all hold the name."""
    group = store.groups.create(name)
    program = store.programs.create(group.id, f"{name} program")
    version = store.versions.save(program.id, {"text": f"{name} blocks " * 900}, SQUARE)
    run = store.runs.begin(RunStart("sim", "w", WORLD, 1, "0.1.0", version_id=version.id))
    recorder = Recorder(store)
    for tick in range(40):
        recorder(sample(run.id, tick))
    recorder({"v": 1, "type": "said", "run": run.id, "seq": 40, "tick": 39, "text": name})
    recorder(ended(run.id, 41, 40))
    return group.id


def removed(db: sqlite3.Connection, *ids: str) -> dict[str, int]:
    db.execute("BEGIN IMMEDIATE")
    counts = remove_keys(db, ids)
    db.execute("COMMIT")
    return counts


def test_a_group_goes_with_all_that_it_made(store: Store, db: sqlite3.Connection) -> None:
    gone, kept = (busy_group(store, name) for name in ("Zebras", "Onças"))
    counts = removed(db, gone)
    assert counts == {
        "events": 2,
        "telemetry": 1,
        "runs": 1,
        "versions": 1,
        "programs": 1,
        "groups": 1,
    }
    assert [group.id for group in store.groups.all()] == [kept]
    assert db.execute("PRAGMA foreign_key_check").fetchall() == []
    assert removed(db, gone) == {}


def test_nothing_of_its_text_is_left_in_the_file(
    store: Store, db: sqlite3.Connection, path: Path
) -> None:
    gone = busy_group(store, "Zebras")
    for n in range(30):
        busy_group(store, f"Onças {n}")
    removed(db, gone)
    assert forget_log(db)
    assert b"Zebras" not in path.read_bytes()
    assert path.with_name(f"{path.name}-wal").stat().st_size == 0


def test_keys_that_are_not_there_are_kept_from_coming(db: sqlite3.Connection) -> None:
    before = content_hash(db)
    assert removed(db, "0193a5b0-0000-7000-8000-000000000000") == {}
    assert content_hash(db) != before
