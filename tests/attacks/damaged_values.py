"""Bits that flip inside values, as on a disk that fails: SQLite does not see them."""

import random
import struct
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from storage import Store, open_store
from storage.exchange.bundle_writing import BundleInfo
from storage.file.backups import make_backup
from storage.file.row_checksums import KEYS
from storage.scrub import Scrubber
from storage.sql import opened
from storage.sqlite import sqlite3
from storage.text import utc_now
from tests.storage.bundle_makers import exported, merged, work

N_PROGRAMS = 4


class Row(NamedTuple):
    """What a sum belongs to: a row, or all rows of a run."""

    table: str
    key: str


class School:
    """A store with programs, versions and runs, whose disk flips bits."""

    def __init__(self, store: Store) -> None:
        self.store = store
        group = store.groups.create("A")
        self.works = [work(store, group, f"P{n}") for n in range(N_PROGRAMS)]
        self.program_id = self.works[0][0].id
        self.run_id = self.works[0][1]
        store.runs.get(self.run_id)  # all is on disk

    @property
    def newest_id(self) -> str:
        with self.store._database.read_connection() as db:
            query = "SELECT id FROM versions WHERE program_id = ? ORDER BY number DESC LIMIT 1"
            return str(db.execute(query, [self.program_id]).fetchone()[0])

    def back_up(self) -> None:
        make_backup(self.store.path, utc_now())

    def export(self, dest: Path) -> BundleInfo:
        return exported(self.store, dest)

    def merge(self, path: Path) -> None:
        merged(self.store, path)

    def check(self) -> tuple[int, int]:
        """How many rows the daily check mended, and how many it left damaged."""
        return Scrubber(self.store._database, pause=lambda _: False).check_all()

    def judge(self, run_id: str, *, passed: bool) -> None:
        self.store.grading_results.record(run_id, passed, {})

    def spoil(self, table: str, key: str, column: str, value: bytes) -> None:
        """Puts other octets in the place of a text."""
        with closing(opened(self.store.path, "rw")) as disk:
            disk.execute(
                f"UPDATE {table} SET {column} = CAST(? AS TEXT) WHERE {KEYS[table]} = ?",
                [value, key],
            )

    def flip(self, chance: random.Random) -> Row:
        """Flips one bit of one value of one row that has a sum."""
        with closing(opened(self.store.path, "rw")) as disk:
            disk.text_factory = bytearray
            table = chance.choice(sorted(KEYS))
            rowid, *row = chance.choice(_rows_with_sum(disk, table))
            names = [str(one[1], "utf-8") for one in disk.execute(f"PRAGMA table_info({table})")]
            column, value = chance.choice(
                [pair for pair in zip(names, row, strict=True) if pair[1] not in (None, b"")]
            )
            kind = "TEXT" if isinstance(value, bytearray) else "BLOB"
            other = _flipped(value, chance)
            place = f"CAST(? AS {kind})" if isinstance(value, bytes | bytearray) else "?"
            disk.execute(f"UPDATE {table} SET {column} = {place} WHERE rowid = ?", [other, rowid])
            return Row(table, bytes(row[names.index(KEYS[table])]).decode())


@contextmanager
def school(folder: Path) -> Iterator[School]:
    with open_store(folder / "pinel.db") as store:
        yield School(store)


def _rows_with_sum(disk: sqlite3.Connection, table: str) -> list[tuple[Any, ...]]:
    query = f"""SELECT rowid, * FROM {table} WHERE {KEYS[table]} IN
        (SELECT row_id FROM content_sums WHERE table_name = '{table}')"""
    return disk.execute(query).fetchall()


def _flipped(value: object, chance: random.Random) -> object:
    match value:
        case bytes() | bytearray():
            octets = bytearray(value)
            octets[chance.randrange(len(octets))] ^= 1 << chance.randrange(8)
            return bytes(octets)
        case int():
            return value ^ (1 << chance.randrange(32))
        case float():
            octets = bytearray(struct.pack("<d", value))
            octets[chance.randrange(7)] ^= 1 << chance.randrange(8)
            return struct.unpack("<d", octets)[0]
    raise TypeError(value)
