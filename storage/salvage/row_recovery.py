"""Rows out of a damaged file, into a fresh database with the tables of this release.

SQLite reads each table from its first page, then each page by itself (`desk`): where the way to a page is damaged, its
rows tell the table, as each value must be one that a store writes, as for a bundle of anybody.
"""

import zlib
from collections.abc import Mapping
from contextlib import closing, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from storage.salvage.damaged_rows import remove_damaged_versions
from storage.salvage.desk import EDITS_INDEX, INDEX_INTERIOR, INDEX_LEAF, TABLE_LEAF, Desk, Row
from storage.salvage.keys import repair_keys
from storage.sql import Stop, column_names
from storage.sqlite import sqlite3
from storage.tables import rules
from storage.tables.columns import Table
from storage.tables.local import LOCAL
from storage.tables.replicated import REPLICATED
from storage.tables.rules import Rule

_SAMPLE_OCTETS = 4 * 64  # of a sample, more than any release has
_TABLES: dict[str, Table] = {table.name: table for table in (*REPLICATED, *LOCAL)}
# tables by key that are told by a row alone from the entries of any index
_IDENTIFIED_BY_SCHEMA = ("tombstones", "content_sums", "unconfirmed_runs", "deletions")
_A_KEY = "00000000-0000-4000-8000-000000000000"  # any that a rule accepts


@dataclass(slots=True)
class RecoveryStats:
    """What the reading came to.

    Attributes:
        edits: program and number of each edit that an index still names, readable or not, and of those that are not
            as they were written.
        is_cut_short: the time was over before the end of the file.
    """

    edits: set[tuple[str, int]] = field(default_factory=set)
    is_cut_short: bool = False


class _RowSchema(NamedTuple):
    """What rows of a table must look like."""

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
        folder: where a copy of the file has room.
        usual_roots: where tables and indexes begin if the file's own list of them is damaged.
        stop: asked all the time; once it is true, the reading ends with what was found until then.
    """
    with closing(Desk(folder / "copy", file, db, _TABLES, stop)) as desk:
        return _Recovery(db, desk, {**usual_roots, **desk.roots}, stop).read()


class _Recovery:
    def __init__(
        self, db: sqlite3.Connection, desk: Desk, roots: Mapping[str, int], stop: Stop
    ) -> None:
        self._db, self._desk, self._roots, self._stop = db, desk, roots, stop
        self._schemas = {name: _row_schema(db, table) for name, table in _TABLES.items()}
        self._of_leaves = [one for name, one in self._schemas.items() if name not in desk.keyed]
        self._of_indexes = [self._schemas[name] for name in _IDENTIFIED_BY_SCHEMA]
        self._found = RecoveryStats()
        self._added_hashes: set[int] = set()  # rows that fitted, however often they are met
        self._invalid_keys: set[tuple[str, str]] = set()  # table and key of rows whose key is none

    def read(self) -> RecoveryStats:
        self._db.execute("BEGIN")
        for name in (EDITS_INDEX, *self._schemas):
            if name in self._roots:
                self._read_tree(name)
        for page in self._desk.pages():
            if self._stop():
                self._found.is_cut_short = True
                break
            self._read_page(page)
        self._reassign_rows()
        self._found.edits |= repair_keys(self._db, self._invalid_keys)
        self._found.edits |= remove_damaged_versions(self._db)
        self._db.execute("COMMIT")
        return self._found

    def _read_tree(self, name: str) -> None:
        for row in self._desk.tree(name, self._roots[name]):
            match row:
                case (str(program), int(number), int(_)) if name == EDITS_INDEX:
                    self._found.edits.add((program, number))
                case _ if name != EDITS_INDEX and not self._try_add(self._schemas[name], row):
                    self._add_with_invalid_key(self._schemas[name], row)

    def _read_page(self, page: bytes) -> None:
        """A page is of one table, mostly of that to which the page before belongs."""
        likely = self._of_leaves if page[0] == TABLE_LEAF else self._of_indexes
        if page[0] not in (TABLE_LEAF, INDEX_LEAF, INDEX_INTERIOR):
            return
        for shape in likely:
            accepted = [self._try_add(shape, row) for row in self._desk.rows(shape.name, page)]
            if accepted and all(accepted):
                likely.remove(shape)
                likely.insert(0, shape)
                return

    def _try_add(self, shape: _RowSchema, row: Row) -> bool:
        """Adds a row that fits; one that fitted before is no other table's."""
        if hash(row) in self._added_hashes:
            return True
        if not shape.fits(row):
            return False
        self._added_hashes.add(hash(row))
        self._add(shape, row)
        return True

    def _add_with_invalid_key(self, shape: _RowSchema, row: Row) -> None:
        """A row of which only the key is not as a store writes it: what names the row may tell it."""
        key = row[0]
        is_keyed = isinstance(key, str) and shape.columns[0] == "id"
        if is_keyed and shape.fits((_A_KEY, *row[1:])):
            self._invalid_keys.add((shape.name, str(key)))
            self._add(shape, row)

    def _add(self, shape: _RowSchema, row: Row) -> None:
        marks = ", ".join("?" * len(row))
        with suppress(sqlite3.IntegrityError):
            self._db.execute(
                f"INSERT OR IGNORE INTO {shape.name} ({', '.join(shape.columns)}) VALUES ({marks})",
                row,
            )

    def _reassign_rows(self) -> None:
        """Rows of one shape belong to the table of which the key is; those of a page without owner were guessed."""
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
    """True for what zlib has packed, as far as one looks."""
    if not isinstance(blob, bytes):
        return False
    unpacking = zlib.decompressobj()
    with suppress(zlib.error):
        unpacking.decompress(blob, _SAMPLE_OCTETS * 10**5)
        return unpacking.eof and not unpacking.unused_data
    return False


_OTHER_RULES: Mapping[str, Mapping[str, Rule]] = {
    # one that has not ended is ended, as after a power cut
    "runs": {"state": rules.one_of("running", "finished", "stopped", "failed")},
    "telemetry": {"data": _unpacks},
    "settings": {"value": lambda value: isinstance(value, str)},
}
