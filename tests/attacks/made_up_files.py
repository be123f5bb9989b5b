"""Files that somebody made up, and PCs that took one with an earlier release."""

import json
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from storage import Store, StoreError, text
from storage.exchange.bundle_writing import counts_of
from storage.exchange.content_hash import content_hash
from storage.exchange.scope import Scope
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import a_run, exported, work

FAR_ID = "05ffffff-ffff-7fff-bfff-ffffffffffff"
AHEAD = (
    "UPDATE versions SET number = 1000000000 WHERE number = 2",
    "UPDATE versions SET number = 10003 WHERE number = 2",
    "UPDATE groups SET revision = 1000001",
    "UPDATE programs SET revision = 1000000, changed_at = '2127-01-01T00:00:00Z'",
)
TOMORROW = f"changed_at = '{datetime.now(UTC) + timedelta(hours=20):%Y-%m-%dT%H:%M:%S}Z'"
Change = Callable[[sqlite3.Connection], object]


def forged(path: Path, change: Change | str) -> Path:
    """The bundle after a change by somebody who knows the checksum and the counts."""
    with closing(sqlite3.connect(path, isolation_level=None)) as db:
        if isinstance(change, str):
            db.executescript(change)
        else:
            change(db)
        values = [content_hash(db), json.dumps(counts_of(db))]
        db.execute("UPDATE bundle SET content_hash = ?, counts = ?", values)
        db.execute("DELETE FROM signatures")  # it would not fit
    return path


def refusal(attempt: Callable[[], object]) -> str:
    """The code with which an attempt is refused."""
    with pytest.raises(StoreError) as caught:
        attempt()
    return caught.value.code


def program_file(store: Store, dest: Path) -> Path:
    """A program with its work, as a group takes it along without PIN."""
    program, _ = work(store, store.groups.create("Onças"), "Quadrado")
    return exported(store, dest, Scope(program_id=program.id)).path


def suffering(store: Store) -> str:
    """What a release before this one did with `FAR_ID`: ids after it, and numbers at their end. The program's key."""
    program, _ = work(store, store.groups.create("Araras"), "Círculo")
    newest = store.versions.newest(program.id)
    assert newest is not None
    _follow(FAR_ID)
    store._database.write(
        lambda db: db.execute(
            f"""INSERT INTO versions (id, program_id, number, created_at, workspace, faults)
                VALUES ('{FAR_ID}', '{program.id}', 1000000000, '{newest.created_at}', '{{}}', '[]')"""
        )
    )
    version = store.versions.save(program.id, {"mine": 1}, {"pinel_ir": 1, "commands": []})
    a_run(store, version.id)
    work(store, store.groups.create("Tucanos"), "Triângulo")
    return program.id


def _follow(key: str) -> None:
    """Ids of this process follow one, as they did before."""
    ids = text._Ids()
    ids.continue_after(key)
    text._ids = ids
