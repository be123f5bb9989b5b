"""Opens a bundle. Anybody may have made it, so the whole file is checked before any of it is used.

The file is read once, into a private copy. A stick may be read-only or pulled out, and a file on a share may change
meanwhile. A bundle of an earlier release is migrated on the copy.
"""

import logging
import re
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from storage.errors import StoreError, error_name
from storage.exchange.bundle_rules import problem_in_rows
from storage.exchange.bundle_writing import (
    BUNDLE_TABLE,
    FORMAT,
    LESSON_FILE,
    BundleInfo,
    counts_of,
)
from storage.exchange.content_hash import content_hash
from storage.file.temporary import remove_leftovers, temporary_folder
from storage.limits import MAX_VALUE, SAMPLES_PER_HOUR
from storage.sql import address, column_names, integrity_problem, opened
from storage.sqlite import sqlite3
from storage.tables import rules
from storage.tables.ddl import BASELINE, MIGRATIONS
from storage.tables.migrations import MIGRATION_SET, MIGRATIONS_TABLE, migrate
from storage.tables.replicated import TABLES
from storage.text import from_json

_log = logging.getLogger(__name__)
_MAX_BYTES = 4 * 2**30
_MAGIC = b"SQLite format 3\0"
_HEADER = 100
# the texts of the view `about` change from release to release; they contain nothing executable
_ABOUT = re.compile(
    r"CREATEVIEW\"about\"AS(UNIONALL)?(SELECT'([^']|'')*'ASname,'([^']|'')*'ASmeaning(UNIONALL)?)+"
)
_MAX_CACHED_BUNDLES = 512
_Objects = frozenset[tuple[str, str, str, str]]


@dataclass(frozen=True, slots=True)
class Bundle:
    """A bundle that passed all checks.

    Attributes:
        address: URI of the private copy, with the tables of this release; the copy is deleted afterwards.
    """

    info: BundleInfo
    address: str


@contextmanager
def open_bundle(path: Path, *, max_samples: int | None = None) -> Iterator[Bundle]:
    """Yields the bundle, if every part of it is as PINEL writes it. Only reads the file.

    Args:
        max_samples: maximum of all runs together. Unpacking samples takes time, and some bundles need no PIN.

    Raises:
        StoreError: `bundle_missing`, `bundle_unreadable`; `bundle_foreign` file of another program;
            `bundle_is_store` the file that an app works in; `bundle_damaged` truncated or changed; `bundle_newer`;
            `bundle_hostile` has content that no PINEL writes; `bundle_too_large`, `bundle_too_long`; `disk_full` no
            space for the copy.
    """
    remove_leftovers()
    with temporary_folder() as folder:
        copy = folder / "bundle"
        try:
            _copied(path, copy)
            info = _examined(copy, path, max_samples)
        except StoreError as error:  # people get the code, the log gets the problem
            _log.info("%s: %s %s", path, error.code, error.params.get("problem", ""))
            raise
        except (sqlite3.DatabaseError, UnicodeDecodeError) as error:
            _log.info("%s: %s", path, error)
            raise _refusal(error, path) from error
        yield Bundle(info, address(copy, "immutable"))


class Declaration(NamedTuple):
    """What a file says of itself, unchecked.

    Attributes:
        anonymous: names were left out of it.
        computer_id: the PC that wrote it, "" if it cannot be a bundle.
    """

    anonymous: bool = False
    computer_id: str = ""


def declaration_of(path: Path, size_bytes: int, modified_s: float) -> Declaration:
    """Reads the declaration in a file's head, only once while the size and time of the file stay the same."""
    try:
        return _read_declaration(path, size_bytes, modified_s)
    except (sqlite3.Error, UnicodeDecodeError):  # not cached: a stick may be busy
        return Declaration()


def prepares_lesson(path: Path) -> bool:
    """Returns whether the file declares that it prepares a PC for a lesson; False if it cannot be read."""
    try:
        with path.open("rb") as file:
            head = file.read(_HEADER)
    except OSError:
        return False
    return head.startswith(_MAGIC) and int.from_bytes(head[68:72], "big") == LESSON_FILE


@lru_cache(maxsize=_MAX_CACHED_BUNDLES)
def _read_declaration(path: Path, size_bytes: int, modified_s: float) -> Declaration:
    with closing(_connected(path)) as db:
        rows = db.execute("SELECT sql FROM sqlite_schema WHERE name = 'bundle'").fetchall()
        if [_text("bundle", str(row[0])) for row in rows] != [_text("bundle", BUNDLE_TABLE)]:
            return Declaration()
        found = db.execute("SELECT anonymous, computer_id FROM bundle LIMIT 1").fetchone()
        return Declaration(bool(found[0]), str(found[1])) if found else Declaration()


def check_head(path: Path) -> None:
    """Checks kind, size and head of a file, and nothing of its content.

    Raises StoreError `bundle_missing`, `bundle_too_large`, `bundle_foreign`, `bundle_damaged`, `bundle_unreadable`.
    """
    try:
        if not path.is_file():
            raise StoreError("bundle_missing", path=str(path))
        if path.stat().st_size > _MAX_BYTES:
            raise StoreError("bundle_too_large", path=str(path), max=_MAX_BYTES // 2**30)
        with path.open("rb") as file:
            head = file.read(_HEADER)
        if not head.startswith(_MAGIC[: len(head)]):
            raise StoreError("bundle_foreign", path=str(path))
        if path.stat().st_size != _size_by(head):
            raise StoreError("bundle_damaged", path=str(path), problem="cut off")
    except OSError as error:
        raise StoreError("bundle_unreadable", path=str(path), problem=error.strerror) from error


def _copied(path: Path, copy: Path) -> None:
    check_head(path)
    try:
        if shutil.disk_usage(copy.parent).free < path.stat().st_size:
            raise StoreError("disk_full", path=str(copy.parent))
        shutil.copyfile(path, copy)
    except OSError as error:
        raise StoreError("bundle_unreadable", path=str(path), problem=error.strerror) from error


def _size_by(head: bytes) -> int:
    """Returns the length of the file in bytes by its header (sqlite.org/fileformat.html), -1 if it is cut."""
    if len(head) < _HEADER:
        return -1
    page = int.from_bytes(head[16:18], "big")
    return (65536 if page == 1 else page) * int.from_bytes(head[28:32], "big")


def _examined(copy: Path, path: Path, max_samples: int | None) -> BundleInfo:
    with closing(_connected(copy)) as db:
        n_steps = _release(db, path)
        if max_samples is not None:
            _require_few_samples(db, path, max_samples)
        if copy.stat().st_size > MAX_VALUE:  # no value is longer than its file
            for name in (*TABLES, "bundle"):
                _require_bounded(db, name)
        if problem := integrity_problem(db):
            raise StoreError("bundle_damaged", path=str(path), problem=problem)
        info = _described(db, path)
        if content_hash(db) != info.content_hash:
            raise StoreError("bundle_damaged", path=str(path), problem="checksum")
        if problem := problem_in_rows(db):
            raise StoreError("bundle_hostile", path=str(path), problem=problem)
    if n_steps < len(MIGRATIONS):
        with closing(sqlite3.connect(copy, isolation_level=None)) as db:
            migrate(db)
    return info


def _require_few_samples(db: sqlite3.Connection, path: Path, max_samples: int) -> None:
    (n_samples,) = db.execute("SELECT total(max(n_rows, 0)) FROM telemetry").fetchone()
    if n_samples > max_samples:
        hours = {
            "value": round(n_samples / SAMPLES_PER_HOUR),
            "max": round(max_samples / SAMPLES_PER_HOUR),
        }
        raise StoreError("bundle_too_long", path=str(path), **hours)


def _release(db: sqlite3.Connection, path: Path) -> int:
    """Returns how many migrations the file has, after checking that they make all of its objects.

    Compares definitions before it queries any table, since a query would run a view or a trigger of the file.
    """
    # the lengths and comparisons of other checks assume UTF-8
    if db.execute("PRAGMA encoding").fetchone()[0] != "UTF-8":
        raise StoreError("bundle_hostile", path=str(path), problem="encoding")
    objects = _objects(db)
    tables = {name for kind, name, _, _ in objects if kind == "table"}
    if MIGRATIONS_TABLE not in tables or not _steps_table() <= objects:
        raise StoreError("bundle_foreign", path=str(path))
    _require_bounded(db, MIGRATIONS_TABLE)
    applied = {
        str(row[0])
        for row in db.execute(
            f"SELECT name FROM {MIGRATIONS_TABLE} WHERE migration_set = ?", [MIGRATION_SET]
        )
    }
    if applied - MIGRATIONS.keys():
        raise StoreError("bundle_newer", path=str(path))
    if "bundle" not in tables:
        raise StoreError("bundle_is_store", path=str(path))
    if applied != set(list(MIGRATIONS)[: len(applied)]) or len(applied) < len(BASELINE):
        raise StoreError("bundle_hostile", path=str(path), problem=MIGRATIONS_TABLE)
    if _format(db, objects) > FORMAT:
        raise StoreError("bundle_newer", path=str(path))
    unexpected = objects ^ _expected(len(applied))
    if unexpected:
        raise StoreError("bundle_hostile", path=str(path), problem=min(unexpected)[1])
    return len(applied)


def _format(db: sqlite3.Connection, objects: _Objects) -> int:
    """Returns the bundle's format. Reads it by itself, as a later format may have other columns too."""
    texts = [text for kind, name, _, text in objects if (kind, name) == ("table", "bundle")]
    if not texts[0].startswith("CREATETABLEbundle(formatINTEGERNOTNULL,"):
        return FORMAT
    row = db.execute("SELECT format FROM bundle LIMIT 1").fetchone()
    return row[0] if row and isinstance(row[0], int) else FORMAT


def _described(db: sqlite3.Connection, path: Path) -> BundleInfo:
    rows = db.execute("SELECT * FROM bundle LIMIT 2").fetchall()
    if len(rows) != 1:
        raise StoreError("bundle_damaged", path=str(path), problem="bundle")
    values = dict(zip(column_names(db, "bundle"), rows[0], strict=True))
    for column, rule in _RULES.items():
        if not rule(values[column]):
            raise StoreError("bundle_hostile", path=str(path), problem=f"bundle.{column}")
    if from_json(values["counts"]) != counts_of(db):
        raise StoreError("bundle_hostile", path=str(path), problem="bundle.counts")
    del values["format"]
    values |= {"counts": from_json(values["counts"]), "anonymous": bool(values["anonymous"])}
    return BundleInfo(path, **values, lesson_id=_lesson_of(db))


def _lesson_of(db: sqlite3.Connection) -> str | None:
    """Returns the lesson that the file prepares a PC for, None for another file.

    The file also has the lesson that this lesson was joined to.
    """
    if db.execute("PRAGMA application_id").fetchone()[0] != LESSON_FILE:
        return None
    found = db.execute("SELECT id FROM lessons ORDER BY part_of IS NULL, id LIMIT 1").fetchone()
    return found and str(found[0])


def _are_counts(value: dict[str, Any]) -> bool:
    return all(isinstance(n, int) for n in value.values())


_RULES: dict[str, rules.Rule] = {
    "app_version": rules.short,
    "exported_at": rules.time,
    "computer_id": rules.key,
    "computer_name": rules.name,
    "content_hash": rules.short,
    "counts": rules.json_of(dict, _are_counts),
}


def _objects(db: sqlite3.Connection) -> _Objects:
    """Returns type, name, table and SQL of every object in the file; SQLite's own indexes have no SQL."""
    _require_bounded(db, "sqlite_schema")
    rows = db.execute(
        "SELECT type, name, tbl_name, coalesce(sql, '') FROM sqlite_schema"
    ).fetchall()
    return frozenset((kind, name, table, _text(name, sql)) for kind, name, table, sql in rows)


def _text(name: str, sql: str) -> str:
    """Returns the SQL without white space, which differs between releases of the library that writes it."""
    text = "".join(sql.split())
    return "about" if name == "about" and _ABOUT.fullmatch(text) else text


@lru_cache(maxsize=8)
def _expected(n_steps: int) -> _Objects:
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as db:
        migrate(db, n_steps)
        db.execute(BUNDLE_TABLE)
        return _objects(db)


def _steps_table() -> _Objects:
    return frozenset(found for found in _expected(len(BASELINE)) if found[2] == MIGRATIONS_TABLE)


def _connected(copy: Path) -> sqlite3.Connection:
    db = opened(copy, "immutable")
    if hasattr(db, "setlimit"):  # pysqlite3 has none: see `_require_bounded`
        db.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, MAX_VALUE)
    db.execute("PRAGMA trusted_schema = OFF")
    db.execute("PRAGMA cell_size_check = ON")
    return db


def _require_bounded(db: sqlite3.Connection, table: str) -> None:
    """Raises DataError if a text or blob is too long. SQLite gets lengths without reading the values."""
    if hasattr(db, "setlimit"):
        return
    too_long = " OR ".join(
        f"octet_length({name}) > {MAX_VALUE}" for name in column_names(db, table)
    )
    if too_long and db.execute(f"SELECT 1 FROM {table} WHERE {too_long} LIMIT 1").fetchone():
        raise sqlite3.DataError("string or blob too big")


def _refusal(error: Exception, path: Path) -> StoreError:
    if isinstance(error, sqlite3.DataError):
        return StoreError("bundle_hostile", path=str(path), problem=str(error))
    if error_name(error).startswith("SQLITE_FULL"):
        return StoreError("disk_full", path=tempfile.gettempdir())
    return StoreError("bundle_damaged", path=str(path), problem=str(error))
