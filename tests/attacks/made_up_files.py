"""Files that somebody made up."""

import json
from collections.abc import Callable, Iterator
from contextlib import closing
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
import pytest

from storage import Store, StoreError
from storage.exchange.bundle_writing import counts_of
from storage.exchange.content_hash import content_hash
from storage.exchange.scope import Scope
from storage.runs.telemetry import COLUMNS, pack
from storage.sql import column_names, opened
from storage.sqlite import sqlite3
from storage.text import new_id
from tests.storage.bundle_makers import exported, work

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


def in_encoding(path: Path, encoding: str) -> None:
    """The same bundle, its texts in another encoding."""
    honest = path.rename(path.with_suffix(".honest"))
    with closing(opened(honest, "ro")) as db, closing(opened(path, "rwc")) as copy:
        copy.execute(f"PRAGMA encoding = '{encoding}'")
        made = db.execute(
            "SELECT type, name, sql FROM sqlite_schema WHERE sql IS NOT NULL"
        ).fetchall()
        for kind, name, statement in made:
            copy.execute(statement)
            if kind == "table" and (rows := db.execute(f"SELECT * FROM {name}").fetchall()):
                marks = ", ".join("?" * len(rows[0]))
                copy.executemany(f"INSERT INTO {name} VALUES ({marks})", rows)


def samples_of_hours(hours: int) -> Change:
    """Fills the file with runs of an hour and two thirds in which the robot stands still: 13 kB of file each."""
    chunk = pack(np.zeros((90_000, len(COLUMNS))))

    def change(db: sqlite3.Connection) -> None:
        (run_id,) = db.execute("SELECT run_id FROM telemetry").fetchone()
        rest = ", ".join(column_names(db, "runs")[1:])
        for _ in range(hours * 3 // 5):
            key = new_id()
            db.execute(
                f"INSERT INTO runs (id, {rest}) SELECT ?, {rest} FROM runs WHERE id = ?",
                [key, run_id],
            )
            rows = [(key, n, 0, 90_000, chunk) for n in range(2)]
            db.executemany("INSERT INTO telemetry VALUES (?, ?, ?, ?, ?)", rows)

    return change


class CountedText(str):
    """A text that counts how often it is compared."""

    n_compared = 0
    __slots__ = ()

    @classmethod
    def many(cls, number: int) -> list[str]:
        cls.n_compared = 0
        return [cls(f"p{n}") for n in range(number)]

    def __eq__(self, other: object) -> bool:
        CountedText.n_compared += 1
        return str.__eq__(self, other) is True

    __hash__ = str.__hash__


class CountedKeys(dict[str, object]):
    """An object that counts how often its keys are listed."""

    n_listed = 0

    def __iter__(self) -> Iterator[str]:
        self.n_listed += 1
        return super().__iter__()
