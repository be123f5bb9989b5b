"""Stores with rows of every kind, and bundles of them."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from pathlib import Path

from storage import GroupRow, ProgramRow, RunRecorder, RunStart, Store, open_store
from storage.exchange.bundle_writing import BundleInfo, export_bundle
from storage.exchange.content_hash import content_hash
from storage.exchange.deleting.deletion import purge_keys
from storage.exchange.merge_report import MergeReport
from storage.exchange.merging import merge
from storage.exchange.scope import ALL, Scope
from storage.sqlite import sqlite3
from tests.storage.sample_documents import SQUARE, WORLD
from tests.storage.sample_runs import ended, sample

Opened = Callable[[str], Store]


class TickingClock:
    """A deterministic clock; each call returns a later time."""

    def __init__(self, start: str = "2026-03-02T08:00:00+00:00") -> None:
        self._now = datetime.fromisoformat(start).astimezone(UTC)

    def __call__(self) -> datetime:
        self._now += timedelta(seconds=1)
        return self._now


@contextmanager
def a_store(path: Path, start: str = "2026-03-02T08:00:00+00:00") -> Iterator[Store]:
    with open_store(path, clock=TickingClock(start)) as store:
        yield store


_OF_VERSIONS = (
    ("versions", "id"),
    ("versions", "parent_id"),
    ("version_labels", "id"),
    ("runs", "version_id"),
)


def give_keys_of_before(db: sqlite3.Connection) -> None:
    """Versions get keys as releases before 0.3 gave them, which tell nothing of the content."""
    for table, column in _OF_VERSIONS:
        other = f"substr({column}, 1, 14) || '7' || substr({column}, 16)"
        db.execute(f"UPDATE {table} SET {column} = {other}")


def a_run(store: Store, version_id: str | None, ticks: int = 45, text: str = "olá") -> str:
    """Records a run; returns its id."""
    document = None if version_id else SQUARE
    run = store.runs.begin(
        RunStart("sim", "w", WORLD, 1, "0.1.0", version_id=version_id, document=document)
    )
    recorder = RunRecorder(store)
    for tick in range(ticks):
        recorder(sample(run.id, tick))
    recorder(
        {
            "v": 1,
            "type": "said",
            "run": run.id,
            "seq": ticks,
            "tick": ticks,
            "block": None,
            "text": text,
        }
    )
    recorder(ended(run.id, ticks + 1, ticks))
    return run.id


def work(store: Store, group: GroupRow, name: str) -> tuple[ProgramRow, str]:
    """Creates a program with two versions, a label, a run and a note; returns the program and the run's id."""
    program = store.programs.create(group.id, name)
    store.versions.save(program.id, {"text": name}, SQUARE)
    version = store.versions.save(program.id, {"text": f"{name}!"}, SQUARE, world=WORLD)
    store.versions.label(version.id, "funciona")
    run_id = a_run(store, version.id, text=name)
    store.notes.write(run_id, f"Muito bem, {name}")
    return program, run_id


def exported(store: Store, dest: Path, scope: Scope = ALL) -> BundleInfo:
    return export_bundle(
        store._database, dest, app_version="0.1.0", computer=store.computers.this(), scope=scope
    )


def merged(
    store: Store, path: Path, *, delete: bool = True, retain_newer: bool = False
) -> MergeReport:
    """Merges a bundle; with `delete` also its deletions, without which stores do not converge."""
    return merge(store._database, path, delete=delete, retain_newer=retain_newer)


def removed(store: Store, *ids: str) -> None:
    """Deletes the rows with these keys for good."""
    store._database.write(lambda db: purge_keys(db, ids))


def hash_of(store: Store) -> str:
    with store._database.read_connection() as db:
        return content_hash(db)


def problems_in(path: Path) -> list[object]:
    """Findings of SQLite's integrity check of a file."""
    db = sqlite3.connect(path)
    try:
        found = [row for row in db.execute("PRAGMA integrity_check") if row != ("ok",)]
        return [*found, *db.execute("PRAGMA foreign_key_check")]
    finally:
        db.close()
