"""Recovers rows of a damaged file into a new database with the tables of this release.

SQLite reads each table from its root page, then each page by itself (`page_reader`). If the tree above a page is
damaged, the values of its rows identify its table: they must fit the rules of the table, as the rows of a bundle must.
"""

import zlib
from collections.abc import Mapping
from contextlib import closing, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from storage.salvage.damaged_rows import remove_damaged_versions
from storage.salvage.keys import repair_keys
from storage.salvage.page_reader import (
    EDITS_INDEX,
    INDEX_INTERIOR,
    INDEX_LEAF,
    TABLE_LEAF,
    PageReader,
    Row,
)
from storage.sql import Stop, column_names
from storage.sqlite import sqlite3
from storage.tables import rules
from storage.tables.columns import Table
from storage.tables.local import LOCAL
from storage.tables.replicated import REPLICATED
from storage.tables.rules import Rule

_SAMPLE_OCTETS = 4 * 64  # upper bound for one sample, in octets; no release has more
_TABLES: dict[str, Table] = {table.name: table for table in (*REPLICATED, *LOCAL)}
# tables by key whose rows cannot be confused with the entries of an index
_IDENTIFIED_BY_SCHEMA = ("tombstones", "content_sums", "unconfirmed_runs", "deletions")
_A_KEY = "00000000-0000-4000-8000-000000000000"  # any valid key


@dataclass(slots=True)
class RecoveryStats:
    """The result of a recovery.

    Attributes:
        edits: program and number of each edit that an index lists, readable or not, and of each damaged edit.
        is_cut_short: the time limit was reached before the end of the file.
    """

    edits: set[tuple[str, int]] = field(default_factory=set)
    is_cut_short: bool = False


class _RowSchema(NamedTuple):
    """The columns of a table and the rules for their values."""

    name: str
    columns: tuple[str, ...]
    rules: tuple[Rule, ...]

    def fits(self, values: Row) -> bool:
        return all(rule(value) for rule, value in zip(self.rules, values, strict=True))


def recover_rows(
    db: sqlite3.Connection, file: Path, folder: Path, usual_roots: Mapping[str, int], stop: Stop
) -> RecoveryStats:
    """Adds the readable rows of a file to a database that `migrate` has made.

    Args:
        folder: a folder for a copy of the file.
        usual_roots: root pages of tables and indexes, used where the file's own schema is damaged.
        stop: polled; once it returns True, the recovery ends with the rows found so far.
    """
    with closing(PageReader(folder / "copy", file, db, _TABLES, stop)) as reader:
        return _Recovery(db, reader, {**usual_roots, **reader.roots}, stop).read()


class _Recovery:
    def __init__(
        self, db: sqlite3.Connection, reader: PageReader, roots: Mapping[str, int], stop: Stop
    ) -> None:
        self._db, self._reader, self._roots, self._stop = db, reader, roots, stop
        self._schemas = {name: _row_schema(db, table) for name, table in _TABLES.items()}
        self._of_leaves = [one for name, one in self._schemas.items() if name not in reader.keyed]
        self._of_indexes = [self._schemas[name] for name in _IDENTIFIED_BY_SCHEMA]
        self._stats = RecoveryStats()
        self._added_hashes: set[int] = set()  # of accepted rows; pages may yield a row again
        self._invalid_keys: set[tuple[str, str]] = set()  # table and key of such rows

    def read(self) -> RecoveryStats:
        self._db.execute("BEGIN")
        for name in (EDITS_INDEX, *self._schemas):
            if name in self._roots:
                self._read_tree(name)
        for page in self._reader.pages():
            if self._stop():
                self._stats.is_cut_short = True
                break
            self._read_page(page)
        self._reassign_rows()
        self._stats.edits |= repair_keys(self._db, self._invalid_keys)
        self._stats.edits |= remove_damaged_versions(self._db)
        self._db.execute("COMMIT")
        return self._stats

    def _read_tree(self, name: str) -> None:
        for row in self._reader.tree(name, self._roots[name]):
            match row:
                case (str(program), int(number), int(_)) if name == EDITS_INDEX:
                    self._stats.edits.add((program, number))
                case _ if name != EDITS_INDEX and not self._try_add(self._schemas[name], row):
                    self._add_with_invalid_key(self._schemas[name], row)

    def _read_page(self, page: bytes) -> None:
        """Adds the rows of a page. Tries the table of the page before first, as a table's pages often lie together."""
        likely = self._of_leaves if page[0] == TABLE_LEAF else self._of_indexes
        if page[0] not in (TABLE_LEAF, INDEX_LEAF, INDEX_INTERIOR):
            return
        for shape in likely:
            accepted = [self._try_add(shape, row) for row in self._reader.rows(shape.name, page)]
            if accepted and all(accepted):
                likely.remove(shape)
                likely.insert(0, shape)
                return

    def _try_add(self, shape: _RowSchema, row: Row) -> bool:
        """Adds a row that fits the schema. A row that fitted a table before belongs to no other table."""
        if hash(row) in self._added_hashes:
            return True
        if not shape.fits(row):
            return False
        self._added_hashes.add(hash(row))
        self._add(shape, row)
        return True

    def _add_with_invalid_key(self, shape: _RowSchema, row: Row) -> None:
        """Adds a row in which only the key is invalid; `repair_keys` may find its key by the rows that refer to it."""
        key = row[0]
        is_keyed = isinstance(key, str) and shape.columns[0] == "id"
        if is_keyed and shape.fits((_A_KEY, *row[1:])):
            self._invalid_keys.add((shape.name, str(key)))
            self._add(shape, row)

    def _add(self, shape: _RowSchema, row: Row) -> None:
        placeholders = ", ".join("?" * len(row))
        with suppress(sqlite3.IntegrityError):
            self._db.execute(
                f"INSERT OR IGNORE INTO {shape.name} ({', '.join(shape.columns)}) VALUES ({placeholders})",
                row,
            )

    def _reassign_rows(self) -> None:
        """Moves rows to the table that their key belongs to, as these three tables have the same columns."""
        for name, parent in (("version_labels", "versions"), ("class_presets", "classrooms")):
            theirs = f"id IN (SELECT id FROM {parent})"
            listed = ", ".join(self._schemas[name].columns)
            self._db.execute(
                f"INSERT OR IGNORE INTO {name} ({listed})"
                f" SELECT id, name, revision, changed_at FROM computers WHERE {theirs}"
            )
            self._db.execute(f"DELETE FROM computers WHERE {theirs}")


def _row_schema(db: sqlite3.Connection, table: Table) -> _RowSchema:
    accepted = {column.name: column.accepts for column in table.columns}
    accepted |= _OTHER_RULES.get(table.name, {})
    names = column_names(db, table.name)
    return _RowSchema(table.name, names, tuple(map(accepted.__getitem__, names)))


def _unpacks(blob: object) -> bool:
    """Returns True if zlib packed the blob, as far as its first octets show."""
    if not isinstance(blob, bytes):
        return False
    unpacking = zlib.decompressobj()
    with suppress(zlib.error):
        unpacking.decompress(blob, _SAMPLE_OCTETS * 10**5)
        return unpacking.eof and not unpacking.unused_data
    return False


_OTHER_RULES: Mapping[str, Mapping[str, Rule]] = {
    # a run that has not ended is recovered too, and ended as after a power cut
    "runs": {"state": rules.one_of("running", "finished", "stopped", "failed")},
    "telemetry": {"data": _unpacks},
    "settings": {"value": lambda value: isinstance(value, str)},
}
