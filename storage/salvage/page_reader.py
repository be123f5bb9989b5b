"""Reads single pages of a damaged SQLite file, or the tree below a page, without the file's header and schema.

SQLite opens a copy with an intact header and a schema of our own. In this schema every table has the same root page,
the desk. A page to read is written to the desk, and a plain SELECT reads it (sqlite.org/fileformat2.html).
"""

import shutil
import struct
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing, suppress
from itertools import islice, takewhile
from pathlib import Path

from storage.file.log import PAGE, intact_frames
from storage.sql import Stop, opened, tuples
from storage.sqlite import sqlite3

TABLE_LEAF, INDEX_LEAF, INDEX_INTERIOR = 13, 10, 2
EDITS_INDEX = "idx_versions_program_id_number"
Row = tuple[object, ...]
_EMPTY = struct.pack(">BHHHB", TABLE_LEAF, 0, 0, PAGE, 0)
# header of a file in UTF-8 without free pages; its counters make SQLite ignore the page count
_HEADER = struct.pack(
    ">16sH6B9I40x", b"SQLite format 3", PAGE, 1, 1, 0, 64, 32, 32, 1, 0, 0, 0, 1, 4, 0, 0, 1
)
# offset of the file's change counter: SQLite reads pages again when the counter has changed
_CHANGES = 24
_MIN_CELL_BYTES = 4
_STEPS_BETWEEN_STOPS = 10_000
# an index has the format of a table without row numbers
_EDITS = f"""CREATE TABLE {EDITS_INDEX} (program_id TEXT, number INTEGER, row INTEGER, more,
    PRIMARY KEY (program_id, number, row)) WITHOUT ROWID"""


class PageReader:
    """The copy of the damaged file, open for reading.

    Args:
        path: path of the copy to make.
        file: the damaged file, with its write-ahead log beside it; both may be missing.
        db: a database that has the tables `names`.
        stop: polled while SQLite reads; no more rows come once it returns True.

    Attributes:
        roots: root page of each table and index, as far as the file's own schema can be read.
        keyed: tables stored by key (WITHOUT ROWID), each with the clause that orders its rows backward.
    """

    def __init__(
        self, path: Path, file: Path, db: sqlite3.Connection, names: Iterable[str], stop: Stop
    ) -> None:
        self._stop, self._n_changes = stop, 1
        if file.exists():
            shutil.copyfile(file, path)
        path.touch()
        self._file = path.open("r+b", buffering=0)
        for number, page in intact_frames(file):
            self._write((number - 1) * PAGE, page)
        self._n_pages = max(1, -(-self._file.seek(0, 2) // PAGE))
        self._desk_offset = self._n_pages * PAGE
        self._write(0, _HEADER)
        self.roots = roots(path)
        definitions, self.keyed = _definitions(db, names)
        self._clear(path, definitions)
        self._db = opened(path, "ro")
        self._db.text_factory = _text
        self._db.set_progress_handler(stop, _STEPS_BETWEEN_STOPS)

    def _clear(self, path: Path, definitions: Mapping[str, str]) -> None:
        """Replaces the file's schema by one in which the desk is the root page of every table."""
        self._write(0, (_HEADER + _EMPTY).ljust(PAGE, b"\0"))
        self._write(self._desk_offset, _EMPTY.ljust(PAGE, b"\0"))
        with closing(opened(path, "rw")) as db:
            db.execute("PRAGMA journal_mode = OFF")
            db.execute("PRAGMA synchronous = OFF")
            db.execute("PRAGMA writable_schema = ON")
            rows = [(name, name, self._n_pages + 1, sql) for name, sql in definitions.items()]
            db.executemany("INSERT INTO sqlite_schema VALUES ('table', ?, ?, ?, ?)", rows)

    def close(self) -> None:
        """Closes the copy, so that it can be deleted."""
        self._db.close()
        self._file.close()

    def pages(self) -> Iterator[bytes]:
        """Yields all pages except the first, in order."""
        return map(self.page, range(2, self._n_pages + 1))

    def page(self, number: int) -> bytes:
        """Returns the newest readable state of a page; zeros for a page beyond the end."""
        self._file.seek((number - 1) * PAGE)
        return self._file.read(PAGE).ljust(PAGE, b"\0")

    def tree(self, table: str, root: int) -> Iterator[Row]:
        """Yields the readable rows of the table whose root page has that number.

        Rows before or after damage may come twice. A text that is not UTF-8 is given as bytes.
        """
        return self._rows(table, self.page(root))

    def rows(self, table: str, page: bytes) -> Iterator[Row]:
        """Yields the readable rows of one page, as if the page belonged to that table."""
        return self._rows(table, _as_leaf(page))

    def _rows(self, table: str, page: bytes) -> Iterator[Row]:
        """Reads forward up to the damage, then by row numbers, then backward."""
        self._lay(page)
        backward = self.keyed.get(table, "ORDER BY rowid DESC")
        with suppress(sqlite3.DatabaseError):
            yield from self._selected(f"SELECT * FROM {table}")
            return
        if table not in self.keyed:
            yield from self._by_number(table)
        with suppress(sqlite3.DatabaseError):
            yield from self._selected(f"SELECT * FROM {table} {backward}")

    def _by_number(self, table: str) -> Iterator[Row]:
        numbers: list[int] = []
        with suppress(sqlite3.DatabaseError):
            cursor = self._db.execute(f"SELECT rowid FROM {table}")
            numbers.extend(number for (number,) in islice(cursor, self._max_rows))
        for number in numbers:
            if self._stop():
                return
            with suppress(sqlite3.DatabaseError):
                yield from self._selected(f"SELECT * FROM {table} WHERE rowid = {number}")

    def _selected(self, query: str) -> Iterator[Row]:
        """Yields rows with no more values than the table has columns; longer rows belong to another table."""
        for *values, more in islice(self._db.execute(query), self._max_rows):
            if more is None:
                yield tuple(values)

    @property
    def _max_rows(self) -> int:
        return self._desk_offset // _MIN_CELL_BYTES  # more rows mean that pages form a cycle

    def _lay(self, page: bytes) -> None:
        self._n_changes += 1
        self._write(self._desk_offset, page)
        self._write(_CHANGES, struct.pack(">I", self._n_changes))

    def _write(self, place: int, octets: bytes) -> None:
        self._file.seek(place)
        self._file.write(octets)


def roots(path: Path) -> dict[str, int]:
    """Returns the root page of each table and index of a file, as far as SQLite can read its schema."""
    found: dict[str, int] = {}
    with closing(opened(path, "ro")) as db:
        for order in ("ASC", "DESC"):
            with suppress(sqlite3.DatabaseError):
                db.execute("PRAGMA writable_schema = ON")  # a damaged row hides no others
                query = f"SELECT name, rootpage FROM sqlite_schema WHERE rootpage > 1 ORDER BY rowid {order}"
                for name, page in islice(tuples(db, query), 1000):
                    found[name] = page
    return found


def _as_leaf(page: bytes) -> bytes:
    """Returns the page as a leaf with a valid cell count, without the pages below it."""
    is_interior = page[0] == INDEX_INTERIOR
    start = 12 if is_interior else 8
    n_declared = min(int.from_bytes(page[3:5], "big"), (PAGE - start) // 2)
    places = takewhile(
        lambda place: start < place < PAGE, struct.unpack_from(f">{n_declared}H", page, start)
    )
    cells = [place + 4 * is_interior for place in places]
    kind = INDEX_LEAF if is_interior else page[0]
    listed = struct.pack(f">BHHHB{len(cells)}H", kind, 0, len(cells), 0, 0, *cells)
    return listed + page[len(listed) :]


def _definitions(
    db: sqlite3.Connection, names: Iterable[str]
) -> tuple[dict[str, str], Mapping[str, str]]:
    """Returns definitions of the tables and, for tables by key, the clause that orders their rows backward.

    The tables have no constraints, and one column more, `more`, for surplus values.
    """
    made, keyed = {EDITS_INDEX: _EDITS}, {EDITS_INDEX: _backward("program_id", "number", "row")}
    for name in names:
        columns = tuples(db, f"PRAGMA table_info({name})").fetchall()
        parts = [f"{c[1]} {c[2]} DEFAULT {c[4] or 'NULL'}" for c in columns] + ["more"]
        is_keyed = tuples(
            db, "SELECT wr FROM pragma_table_list WHERE name = ?", (name,)
        ).fetchone()[0]
        if is_keyed:
            key = [str(c[1]) for c in sorted(columns, key=lambda c: int(c[5])) if c[5]]
            keyed[name] = _backward(*key)
            parts.append(f"PRIMARY KEY ({', '.join(key)})")
        made[name] = f"CREATE TABLE {name} ({', '.join(parts)}){' WITHOUT ROWID' * is_keyed}"
    return made, keyed


def _backward(*key: str) -> str:
    return f"ORDER BY {', '.join(f'{column} DESC' for column in key)}"


def _text(octets: bytes) -> str | bytes:
    try:
        return octets.decode()
    except UnicodeDecodeError:
        return octets
