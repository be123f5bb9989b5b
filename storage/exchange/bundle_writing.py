"""Writes bundles: one SQLite file with a whole store, or with the rows of one class, group or program.

A bundle has the tables and views of a store, so Datasette opens it. One more table, `bundle`, has its origin and its
checksum (docs/bundles.md).
"""

import logging
from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

from storage.errors import StoreError, translated
from storage.exchange.bundle_rules import refused_rows
from storage.exchange.content_hash import content_hash
from storage.exchange.scope import ALL, Scope
from storage.file.atomic_files import atomic_create
from storage.file.connection import Database
from storage.file.row_checksums import KEYS, OF_RUNS, is_intact
from storage.limits import MAX_REVISION
from storage.sql import column_names, insert, opened, row_count, rows_of
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.migrations import migrate
from storage.tables.replicated import REPLICATED
from storage.tables.runs import RUNS
from storage.tables.work import VERSIONS
from storage.text import new_id, to_json

_log = logging.getLogger(__name__)

FORMAT = 1
SUFFIX = ".pinel"
LESSON_FILE = 0x504E4C41  # SQLite's application_id of a bundle that prepares a PC for a lesson; 0 for other bundles
BUNDLE_TABLE = """CREATE TABLE bundle (
    format INTEGER NOT NULL,
    app_version TEXT NOT NULL,
    exported_at TEXT NOT NULL,
    computer_id TEXT NOT NULL,
    computer_name TEXT NOT NULL,
    content_hash TEXT NOT NULL,
    counts TEXT NOT NULL,
    anonymous INTEGER NOT NULL
) STRICT"""
_MAX_NAMED = 8
_WHOSE = {
    "versions": """(SELECT groups.name || ' / ' || programs.name FROM store.programs
        JOIN store.groups ON groups.id = group_id WHERE programs.id = program_id)""",
    "runs": "coalesce((SELECT name FROM store.groups WHERE groups.id = group_id), '?')",
}
Alteration = Callable[[sqlite3.Connection], None]


@dataclass(frozen=True, slots=True)
class BundleInfo:
    """The content of the table `bundle`, and the rows that were left out.

    Attributes:
        content_hash: `content_hash.content_hash` of the content, as the release that wrote the file computes it.
        counts: rows by table.
        anonymous: names and texts were left out.
        lesson_id: the lesson that the file prepares a PC for; None for a file of work.
        left_out: for a file just written, `table.column key` of rows that other PCs would refuse.
        lacking: names of groups, and of groups with a program, whose work the file therefore lacks in part or whole.
    """

    path: Path
    app_version: str
    exported_at: str
    computer_id: str
    computer_name: str
    content_hash: str
    counts: dict[str, int]
    anonymous: bool
    lesson_id: str | None = None
    left_out: tuple[str, ...] = ()
    lacking: tuple[str, ...] = ()

    @property
    def left_out_params(self) -> dict[str, object]:
        """Parameters of the message about `left_out`: how many rows, and the first names of `lacking`."""
        more = " …" if len(self.lacking) > _MAX_NAMED else ""
        return {
            "count": len(self.left_out),
            "of": ("; ".join(self.lacking[:_MAX_NAMED]) or "-") + more,
        }


def export_bundle(
    database: Database,
    dest: Path,
    *,
    app_version: str,
    computer: tuple[str, str],
    scope: Scope = ALL,
    alter: Alteration | None = None,
    is_recorded: bool = True,
) -> BundleInfo:
    """Writes the present rows, without runs that have not ended; the file appears when it is complete.

    Args:
        dest: the file. If it exists, the new one gets a number.
        computer: key and name of this PC.
        alter: changes the copy before it is finished; the bundle then counts as anonymous.
        is_recorded: whether `exports` gets an entry; False for a file that a browser downloads or that is
            deleted at once.

    Raises:
        StoreError: `classroom_not_found`, `group_not_found`, `program_not_found`, `lesson_not_found`; `export_failed`
            or `disk_full` if nothing could be written.
    """
    with database.read_connection() as db:
        scope.require(db)
    try:
        with (
            atomic_create(dest) as file,
            closing(_new_database(file.part)) as db,
        ):
            damaged = _fill(db, database.address, scope)
            if alter is not None:
                forget_unconfirmed(db)
                alter(db)
            left_out, lacking = _leave_out(db, damaged)
            info = BundleInfo(
                dest,
                app_version,
                database.now(),
                *computer,
                content_hash(db),
                counts_of(db),
                alter is not None,
                scope.lesson_id,
                left_out,
                lacking,
            )
            _describe(db, info)
    except sqlite3.Error as error:
        raise _not_written(translated(error, dest), dest) from error
    except OSError as error:
        raise StoreError("export_failed", path=str(dest), problem=error.strerror) from error
    info = replace(info, path=file.final)
    if is_recorded:
        record_export(database, info, scope)
    return info


def record_export(database: Database, info: BundleInfo, scope: Scope) -> None:
    """Records the file in `exports`, if the store can be written: rows deleted later may still be in the file."""
    content = {"checksum": info.content_hash, "of": scope.values(), "runs": info.counts["runs"]}
    row = {
        "id": new_id(),
        "path": str(info.path.absolute()),
        "made_at": info.exported_at,
        "content": to_json(content),
    }
    if database.can_write:
        database.write(lambda db: insert(db, "exports", row))


def counts_of(db: sqlite3.Connection) -> dict[str, int]:
    """Returns the number of rows of each replicated table that the file has."""
    return {
        table.name: row_count(db, table.name)
        for table in REPLICATED
        if column_names(db, table.name)
    }


def _new_database(path: Path) -> sqlite3.Connection:
    """Opens a new database without journal: a file whose writing fails is deleted."""
    db = opened(path, "rwc")
    db.execute("PRAGMA journal_mode = OFF")
    db.execute("PRAGMA synchronous = OFF")
    return db


def _fill(db: sqlite3.Connection, store: str, scope: Scope) -> dict[str, str]:
    """Copies the rows, except damaged ones; returns `table key` of each damaged row and the names of its owners."""
    migrate(db)
    db.execute(BUNDLE_TABLE)
    db.execute("ATTACH DATABASE ? AS store", [store])
    db.execute("BEGIN")
    damaged: dict[str, str] = {}
    for table, condition in scope.conditions():
        if table in (VERSIONS, RUNS):
            damaged |= _record_damaged(db, table, condition, scope)
        _copy_table(db, table, condition, scope)
    db.execute(
        "INSERT INTO main.unconfirmed_runs SELECT * FROM store.unconfirmed_runs"
        " WHERE run_id IN (SELECT id FROM main.runs)"
    )
    db.execute("COMMIT")
    db.execute("DETACH DATABASE store")
    return damaged


def _record_damaged(
    db: sqlite3.Connection, table: ReplicatedTable, condition: str, scope: Scope
) -> dict[str, str]:
    """Records versions, and runs with their events and samples, whose checksum does not match.

    Returns:
        `table key` of each, and the name of its group, for versions with the program.
    """
    parts = OF_RUNS if table is RUNS else (table.name,)
    query = f"SELECT id, {_WHOSE[table.name]} FROM store.{table.name} WHERE {condition}"
    found = {
        f"{part} {key}": (key, str(whose))
        for key, whose in rows_of(db, query, scope.values())
        for part in parts
        if not is_intact(db, part, key, "store")
    }
    db.execute("CREATE TEMP TABLE IF NOT EXISTS damaged (id TEXT PRIMARY KEY)")
    keys = [(key,) for key, _ in found.values()]
    db.executemany("INSERT OR IGNORE INTO temp.damaged VALUES (?)", keys)
    return {row: whose for row, (_, whose) in found.items()}


def _copy_table(
    db: sqlite3.Connection, table: ReplicatedTable, condition: str, scope: Scope
) -> None:
    names = column_names(db, table.name)
    listed = ", ".join(names)
    if key := KEYS.get(table.name):
        condition = f"{condition} AND {key} NOT IN (SELECT id FROM temp.damaged)"
    db.execute(
        f"INSERT OR IGNORE INTO main.{table.name} ({listed}) SELECT {listed} FROM store.{table.name}"
        f" WHERE {table.condition.format(schema='store')} AND {condition} ORDER BY {', '.join(table.key)}",
        scope.values(),
    )
    if "revision" in names:
        db.execute(f"UPDATE main.{table.name} SET revision = min(revision, {MAX_REVISION})")


def _leave_out(
    db: sqlite3.Connection, damaged: Mapping[str, str]
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Deletes rows for which other PCs would refuse the whole bundle, with their children.

    Args:
        damaged: rows that were not copied, and the names of their owners.

    Returns:
        The rows, and the names of groups and programs that lost work.
    """
    refused = [
        (table, key, place) for table in REPLICATED for key, place in refused_rows(db, table)
    ]
    if not refused and not damaged:
        return (), ()
    before = _amounts(db)
    for table, key, _ in refused:
        condition = " AND ".join(f"{name} = CAST(? AS TEXT)" for name in table.key)
        db.execute(f"DELETE FROM {table.name} WHERE {condition}", key)
    while orphans := db.execute("PRAGMA foreign_key_check").fetchall():
        for table_name, rowid, *_ in orphans:
            db.execute(f"DELETE FROM {table_name} WHERE rowid = ?", [rowid])
    rows = (*damaged, *(f"{place} {' '.join(map(str, key))}" for _, key, place in refused))
    for row in rows:
        _log.warning("left out of the bundle, as other PCs would refuse it: %s", row)
    after = _amounts(db)
    names = {name for (key, name), n in before.items() if after.get((key, name)) != n}
    return rows, tuple(sorted(names.union(damaged.values())))


def _amounts(db: sqlite3.Connection) -> dict[tuple[str, str], int]:
    """Returns the number of runs of each group and of versions of each program, by key and name."""
    found = rows_of(
        db,
        """SELECT id, name, (SELECT count(*) FROM runs WHERE group_id = groups.id) FROM groups
           UNION ALL
           SELECT programs.id, groups.name || ' / ' || programs.name,
                  (SELECT count(*) FROM versions WHERE program_id = programs.id)
           FROM programs JOIN groups ON groups.id = group_id""",
    )
    return {(str(key), str(name)): n for key, name, n in found}


def _describe(db: sqlite3.Connection, info: BundleInfo) -> None:
    row = {
        "format": FORMAT,
        "app_version": info.app_version,
        "exported_at": info.exported_at,
        "computer_id": info.computer_id,
        "computer_name": info.computer_name,
        "content_hash": info.content_hash,
        "counts": to_json(info.counts),
        "anonymous": int(info.anonymous),
    }
    insert(db, "bundle", row)
    if info.lesson_id is not None:
        db.execute(f"PRAGMA application_id = {LESSON_FILE}")
    db.execute("PRAGMA journal_mode = DELETE")


def forget_unconfirmed(db: sqlite3.Connection) -> None:
    """Makes an unconfirmed pass count as not judged, for a file for statistics, which lacks `unconfirmed_runs`."""
    db.execute("UPDATE runs SET passed = NULL WHERE id IN (SELECT run_id FROM unconfirmed_runs)")
    db.execute("DELETE FROM unconfirmed_runs")


def _not_written(error: StoreError, dest: Path) -> StoreError:
    if error.code == "disk_full":
        return StoreError("disk_full", path=str(dest))
    return StoreError(
        "export_failed", path=str(dest), problem=str(error.params.get("problem", error.code))
    )
