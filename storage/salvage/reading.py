"""Rows out of the pages of a damaged file, into a fresh database with the tables of this release.

A page belongs to the table from whose root it is reached. Where the way to it is damaged, its rows tell the table: each
value must be one that a store writes, as for a bundle of anybody. So no tree, no index and no schema is needed.
"""

import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import NamedTuple

from storage.salvage.keys import mend_keys
from storage.salvage.pages import Pages
from storage.salvage.records import (
    INDEX_INTERIOR,
    INDEX_LEAF,
    TABLE_INTERIOR,
    TABLE_LEAF,
    Values,
    cells,
    children,
    kind_of,
)
from storage.salvage.soundness import take_out_versions
from storage.sql import column_names
from storage.sqlite import sqlite3
from storage.tables import rules
from storage.tables.columns import Table
from storage.tables.local import LOCAL
from storage.tables.replicated import REPLICATED, TOMBSTONES
from storage.tables.rules import Rule

Stop = Callable[[], bool]
_SAMPLE_OCTETS = 4 * 64  # of a sample, more than any release has
_EDITS_INDEX = "idx_versions_program_id_number"
_TABLES: tuple[Table, ...] = (*REPLICATED, *LOCAL)
# without row numbers, and told by a row alone from the entries of any index
_TOLD_BY_SHAPE = ("tombstones", "content_sums", "unconfirmed_runs", "deletions")
_A_KEY = "00000000-0000-4000-8000-000000000000"  # any that a rule accepts


@dataclass(slots=True)
class Found:
    """What the reading came to.

    Attributes:
        edits: program and number of each edit that an index still names, readable or not, and of those that are not
            as they were written.
        n_unread: cells of tables that could not be read.
        is_cut_short: the time was over before the end of the file.
    """

    edits: set[tuple[str, int]] = field(default_factory=set)
    n_unread: int = 0
    is_cut_short: bool = False


class _Shape(NamedTuple):
    """What rows of a table must look like."""

    name: str
    columns: tuple[str, ...]
    rules: tuple[Rule, ...]
    n_least: int


def read_into(db: sqlite3.Connection, pages: Pages, stop: Stop) -> Found:
    """Adds the readable rows to a database that `migrate` has made; of two states of a row the newer is kept.

    Args:
        stop: asked after each page.
    """
    return _Reading(db, pages, stop).read()


class _Reading:
    def __init__(self, db: sqlite3.Connection, pages: Pages, stop: Stop) -> None:
        self._db, self._pages, self._stop = db, pages, stop
        self._shapes = _shapes(db, [table for table in _TABLES if table is not TOMBSTONES])
        self._keyed = _shapes(db, [table for table in _TABLES if _is_keyed(db, table)])
        self._found = Found()
        self._strange: set[tuple[str, str]] = set()  # table and key of rows whose key is none
        self._are_earlier = False  # whether earlier states of pages are being read
        self._owners = _owners(pages)

    def read(self) -> Found:
        self._db.execute("BEGIN")
        self._read_pages(lambda number: [self._pages.newest(number)])
        self._found.edits |= mend_keys(self._db, self._strange)
        take_out_versions(self._db)  # an earlier state may have them as they were written
        n_unread = self._found.n_unread
        # rows of a damaged page may be in an earlier state of it
        self._are_earlier = True
        self._read_pages(lambda number: list(self._pages.states(number))[1:])
        self._found.n_unread = n_unread
        self._tell_apart()
        self._found.edits |= take_out_versions(self._db)
        self._db.execute("COMMIT")
        return self._found

    def _read_pages(self, states: Callable[[int], list[bytes]]) -> None:
        for number in self._pages.numbers():
            if self._stop():
                self._found.is_cut_short = True
                return
            for page in states(number):
                self._read_page(page, number)

    def _read_page(self, page: bytes, number: int) -> None:
        owner, kind = self._owners.get(number), kind_of(page, number)
        if kind == TABLE_LEAF:
            self._read_table(page, number, owner)
        elif kind in (INDEX_LEAF, INDEX_INTERIOR):
            self._read_index(page, number, owner)
        elif owner is not None and kind != TABLE_INTERIOR:
            self._found.n_unread += 1

    def _read_table(self, page: bytes, number: int, owner: str | None) -> None:
        shape = self._shapes.get(owner or "")
        if owner is not None and shape is None:  # of SQLite's own tables
            return
        for cell in cells(self._pages, page, number):
            if cell.values is None:
                self._found.n_unread += 1
                continue
            shape = self._fitting(cell.values, shape)
            if shape is not None:
                self._add(shape, cell.values)
                continue
            self._found.n_unread += owner is not None
            shape = self._shapes.get(owner or "")
            if shape is not None and not self._are_earlier:
                self._add_strange(shape, cell.values)

    def _add_strange(self, shape: _Shape, values: Values) -> None:
        """A row of which only the key is not as a store writes it: what names the row may tell it."""
        key = values[0]
        if (
            isinstance(key, str)
            and shape.columns[0] == "id"
            and _fits(shape, (_A_KEY, *values[1:]))
        ):
            self._strange.add((shape.name, key))
            self._add(shape, values)

    def _fitting(self, values: Values, likely: _Shape | None) -> _Shape | None:
        """Rows of one page are of one table, mostly that to which the page belongs."""
        if likely is not None and _fits(likely, values):
            return likely
        return next((s for s in self._shapes.values() if _fits(s, values)), None)

    def _tell_apart(self) -> None:
        """Rows of one shape belong to the table of which the key is; those of a page without owner were guessed."""
        for name, parent in (("version_labels", "versions"), ("class_presets", "classrooms")):
            theirs = f"id IN (SELECT id FROM {parent})"
            listed = ", ".join(self._shapes[name].columns)
            self._db.execute(
                f"INSERT OR IGNORE INTO {name} ({listed})"
                f" SELECT id, name, revision, changed_at FROM computers WHERE {theirs}"
            )
            self._db.execute(f"DELETE FROM computers WHERE {theirs}")

    def _read_index(self, page: bytes, number: int, owner: str | None) -> None:
        """Tables without row numbers lie in pages of this kind too."""
        if owner not in (None, _EDITS_INDEX, *self._keyed):
            return
        for cell in cells(self._pages, page, number):
            if cell.values is None or not self._read_entry(cell.values, owner):
                self._found.n_unread += owner is not None

    def _read_entry(self, values: Values, owner: str | None) -> bool:
        match values:
            case (str(program), int(n), int(_)) if owner == _EDITS_INDEX:
                self._found.edits.add((program, n))
                return True
        for name in _TOLD_BY_SHAPE if owner is None else (owner,):
            shape = self._keyed.get(name)
            if shape is not None and _fits(shape, values):
                self._add(shape, values)
                return True
        return False

    def _add(self, shape: _Shape, values: Values) -> None:
        if self._are_earlier and shape.name == "content_sums" and values[0] == "runs":
            return  # the row has another sum since it was judged
        names = shape.columns[: len(values)]
        marks = ", ".join("?" * len(names))
        with suppress(sqlite3.IntegrityError):
            self._db.execute(
                f"INSERT OR IGNORE INTO {shape.name} ({', '.join(names)}) VALUES ({marks})", values
            )


def _fits(shape: _Shape, values: Values) -> bool:
    """The row may be shorter than the table's: columns that a later release added have no value in it."""
    if not shape.n_least <= len(values) <= len(shape.columns):
        return False
    return all(rule(value) for rule, value in zip(shape.rules, values, strict=False))


def _shapes(db: sqlite3.Connection, tables: Sequence[Table]) -> dict[str, _Shape]:
    """Shapes by table; of those that have one shape the likelier table first."""
    return {table.name: _shape(db, table) for table in tables}


def _shape(db: sqlite3.Connection, table: Table) -> _Shape:
    accepted = {column.name: column.accepts for column in table.columns}
    accepted |= _OTHER_RULES.get(table.name, {})
    names = column_names(db, table.name)
    needed = _needed(db, table.name)
    return _Shape(table.name, names, tuple(map(accepted.__getitem__, names)), needed)


def _is_keyed(db: sqlite3.Connection, table: Table) -> bool:
    """Whether the table has no row numbers: it is kept as an index is, by its key."""
    query = "SELECT wr FROM pragma_table_list WHERE schema = 'main' AND name = ?"
    return bool(db.execute(query, [table.name]).fetchone()[0])


def _needed(db: sqlite3.Connection, table: str) -> int:
    """Values that each row has: up to the last column that must not be NULL and has no default."""
    rows = db.execute(f"PRAGMA table_info({table})").fetchall()
    return 1 + max(int(row[0]) for row in rows if row[5] or (row[3] and row[4] is None))


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


def _owners(pages: Pages) -> dict[int, str]:
    """The name of the table or index to which each page belongs that can be reached."""
    owners: dict[int, str] = {}
    for name, root in _roots(pages):
        for number in _below(pages, root):
            owners.setdefault(number, name)
    return owners


def _roots(pages: Pages) -> Iterator[tuple[str, int]]:
    yield "sqlite_schema", 1
    for number in _below(pages, 1):
        for page in pages.states(number):
            if kind_of(page, number) == TABLE_LEAF:
                for cell in cells(pages, page, number):
                    match cell.values:
                        case ("table" | "index", str(name), str(_), int(root), *_) if root > 1:
                            yield name, root
                break


def _below(pages: Pages, root: int) -> Iterator[int]:
    """Pages of a tree, the root first."""
    seen, left = set(), [root]
    while left:
        number = left.pop()
        if number in seen:
            continue
        seen.add(number)
        yield number
        page = next((p for p in pages.states(number) if kind_of(p, number) in _KINDS), b"")
        if kind_of(page, number) in (TABLE_INTERIOR, INDEX_INTERIOR):
            left += [child for child in children(page, number) if pages.newest(child)]


_KINDS = (TABLE_LEAF, TABLE_INTERIOR, INDEX_LEAF, INDEX_INTERIOR)
