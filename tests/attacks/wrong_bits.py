"""A small school on a disk that flips one bit of a key, a name or a setting: nothing of it has a sum."""

import shutil
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import NamedTuple

from storage import Store, open_store
from storage.file.backups import make_backup
from storage.sql import opened, row_count
from storage.text import utc_now
from tests.storage.bundle_makers import exported, work

_COUNTED = ("classrooms", "groups", "programs", "versions", "runs", "events", "notes")


class Content(NamedTuple):
    """What is in a file after it was opened: its PC, rows by table, names of its groups."""

    computer: tuple[str, str]
    n_rows: dict[str, int]
    groups: set[str]


class Disk:
    """The file of a school as it was closed, with a backup; each attempt begins with the same file."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._path = folder / "sound" / "pinel.db"
        with open_store(self._path) as store:
            store.computers.this()
            group = store.groups.create("Onças", classroom_id=store.classrooms.create("8A").id)
            work(store, group, "P")
            make_backup(store.path, utc_now())
            self.before = content_of(store)

    @contextmanager
    def after_a_flip(self, table: str, column: str, bit: int, where: str = "1") -> Iterator[Store]:
        """The store, opened after one bit of the first letter of the first value was flipped."""
        shutil.rmtree(self._folder / "now", ignore_errors=True)
        path = shutil.copytree(self._path.parent, self._folder / "now") / "pinel.db"
        with closing(opened(path, "rw")) as db:
            db.execute("PRAGMA foreign_keys = OFF")
            db.text_factory = bytearray
            query = f"SELECT rowid, {column} FROM {table} WHERE {where} LIMIT 1"
            row, value = db.execute(query).fetchone()
            value[0] ^= 1 << bit
            change = f"UPDATE {table} SET {column} = CAST(? AS TEXT) WHERE rowid = ?"
            db.execute(change, [bytes(value), row])
        with open_store(path, close_interrupted=True) as store:
            yield store

    def export(self, store: Store) -> None:
        exported(store, self._folder / "now" / "all.pinel")


def content_of(store: Store) -> Content:
    with store._database.read_connection() as db:
        n_rows = {table: row_count(db, table) for table in _COUNTED}
    return Content(store.computers.this(), n_rows, {group.name for group in store.groups.all()})
