"""Deleting for good: rows are deleted from every table and overwritten in the file. A tombstone for each key keeps
merges from bringing them back."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

from storage.errors import StoreError
from storage.file.connection import Database
from storage.sql import require, row_count, tuples
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED
from storage.tables.runs import RUNS
from storage.text import loaded

_BY_NAME = {table.name: table for table in REPLICATED}
_DEAD = "(SELECT id FROM main.tombstones)"


def _deleted(table: ReplicatedTable) -> str:
    """Condition: the row's key or that of a row that it belongs to has a tombstone."""
    own = [f"id IN {_DEAD}"] if "id" in table.key else []
    return " OR ".join([*own, *(_parent_deleted(*parent) for parent in _followed(table))])


def _followed(table: ReplicatedTable) -> tuple[tuple[str, str], ...]:
    """Parents by which a row is found; not those of rows with tombstones of their own."""
    return () if table.own_tombstone else table.parents


def _parent_deleted(column: str, name: str) -> str:
    parent = _BY_NAME[name]
    keys = f"(SELECT id FROM {name} WHERE {_deleted(parent)})" if _followed(parent) else _DEAD
    return f"{column} IN {keys}"


# rows that refer to a row are deleted before it
_DELETIONS = {table.name: _deleted(table) for table in reversed(REPLICATED) if table.deletable}
_DEAD_RUNS = f"(SELECT id FROM runs WHERE {_deleted(RUNS)})"
_PENDING_NAMES = f"""SELECT name FROM (
    SELECT 1 AS place, name FROM main.classrooms WHERE id IN {_DEAD}
    UNION SELECT 2, name FROM main.groups WHERE id IN {_DEAD}
    UNION SELECT 3, title FROM main.lessons WHERE id IN {_DEAD}
    UNION SELECT 4, name FROM main.programs WHERE id IN {_DEAD}
    UNION SELECT 5, sign FROM main.taught_signs WHERE id IN {_DEAD}
    UNION SELECT 6, coalesce(program_name, world) FROM main.runs WHERE id IN {_DEAD}
        OR id IN (SELECT run_id FROM main.notes WHERE id IN {_DEAD}))
    WHERE name <> '' GROUP BY name ORDER BY min(place), name LIMIT 20"""
# keys of the classes, groups and programs that deleted rows belong to: exports of one of these may hold the rows
_CONCERNED = f"""
    WITH dead_runs AS (
             SELECT group_id, program_id FROM runs WHERE id IN {_DEAD_RUNS}
                 OR id IN (SELECT run_id FROM notes WHERE id IN {_DEAD})),
         dead_programs AS (SELECT id, group_id FROM programs WHERE id IN {_DEAD}
                               OR id IN (SELECT program_id FROM dead_runs)),
         dead_groups AS (SELECT id, classroom_id FROM groups WHERE id IN {_DEAD}
                             OR id IN (SELECT group_id FROM dead_programs UNION SELECT group_id FROM dead_runs))
    SELECT id FROM tombstones UNION SELECT id FROM dead_programs UNION SELECT id FROM dead_groups
    UNION SELECT classroom_id FROM dead_groups UNION SELECT classroom_id FROM lessons WHERE id IN {_DEAD}
    UNION SELECT classroom_id FROM taught_signs WHERE id IN {_DEAD}"""


@dataclass(frozen=True, slots=True)
class Exported:
    """A file that was written from this store."""

    path: str
    made_at: str


@dataclass(frozen=True, slots=True)
class Deletion:
    """What was deleted for good.

    Attributes:
        ids: tombstones that were added; backups are to lose the same.
        counts: rows by table, without those that lost none.
        exports: files that were written from this store and may still hold it.
        overwritten: False while another program still reads the write-ahead log, which holds the text until then.
        still_in: backups that could not be written anew, and may hold it.
    """

    ids: tuple[str, ...] = ()
    counts: dict[str, int] = field(default_factory=dict)
    exports: tuple[Exported, ...] = ()
    overwritten: bool = False
    still_in: tuple[Path, ...] = ()


@dataclass(frozen=True, slots=True)
class PendingDeletion:
    """What a merge would delete, by number; `names` are those of classes, groups, lessons and programs, not all where
    there are many."""

    groups: int
    programs: int
    runs: int
    names: tuple[str, ...]


def remove(database: Database, kind: str, *keys: str) -> Deletion:
    """Deletes a `classroom` with its groups, a `group` with its programs, a `program` with its runs, a `run` with
    its notes, a `lesson`, a `note` or a `taught_sign`, one or several; not from backups, which `Exchange.remove` does,
    nor from bundles.

    Raises:
        StoreError: KIND`_not_found`; `run_in_progress` where a run of it has not ended.
    """

    def job(db: sqlite3.Connection) -> Deletion:
        for key in keys:
            require(db, f"{kind}s", key)
        return remove_keys(db, keys, spare_running=True)

    deletion = database.write(job)
    return replace(deletion, overwritten=database.checkpoint(is_patient=True))


def remove_keys(
    db: sqlite3.Connection, ids: Iterable[str], *, spare_running: bool = False
) -> Deletion:
    """Deletes rows by their keys with all that belongs to them, within the caller's transaction.

    The keys get tombstones, as do the groups, lessons and programs that are deleted with them; so do keys without a
    row. The same again changes nothing. What is deleted is overwritten in the file; a write-ahead log still holds it
    until `Database.checkpoint`. Names of files, which people make of those of groups, are deleted too.

    Args:
        spare_running: raises StoreError `run_in_progress` where a run that has not ended would be deleted.
    """
    db.execute("PRAGMA secure_delete = ON")
    before = tombstones(db)
    db.executemany("INSERT OR IGNORE INTO tombstones (id) VALUES (?)", [(key,) for key in ids])
    add_tombstones_below(db)
    exports = _exports_of_dead(db)
    running = _running(db)
    counts = {
        table: db.execute(f"DELETE FROM {table} WHERE {condition}").rowcount
        for table, condition in _DELETIONS.items()
    }
    if spare_running and _running(db) != running:
        raise StoreError("run_in_progress")
    if any(counts.values()):
        _delete_file_names(db)
    added = tuple(sorted(tombstones(db) - before))
    return Deletion(added, {table: n for table, n in counts.items() if n}, exports)


def pending_deletion(db: sqlite3.Connection) -> PendingDeletion | None:
    """What `remove_keys` would delete now, where the tombstones are in the table already; None for nothing."""
    rows = {
        table: row_count(db, f"main.{table}", condition) for table, condition in _DELETIONS.items()
    }
    if not any(rows.values()):
        return None
    names = db.execute(_PENDING_NAMES).fetchall()
    return PendingDeletion(
        rows["groups"], rows["programs"], rows["runs"], tuple(str(row["name"]) for row in names)
    )


def add_tombstones_below(db: sqlite3.Connection) -> None:
    """Rows that are deleted with their parent get tombstones of their own, the parents first."""
    for table in REPLICATED:
        if table.own_tombstone:
            for column, _ in table.parents:
                db.execute(
                    f"INSERT OR IGNORE INTO tombstones SELECT id FROM {table.name} WHERE {column} IN {_DEAD}"
                )


def tombstones(db: sqlite3.Connection) -> set[str]:
    """Keys of all that was deleted for good."""
    return {str(row["id"]) for row in db.execute("SELECT id FROM tombstones")}


def _exports_of_dead(db: sqlite3.Connection) -> tuple[Exported, ...]:
    """Those of all of the store, and those of a part that has to do with it; none where nothing is deleted."""
    if pending_deletion(db) is None:
        return ()
    concerned = {str(key) for (key,) in tuples(db, _CONCERNED) if key}
    rows = db.execute("SELECT path, made_at, content FROM exports ORDER BY id").fetchall()
    return tuple(
        Exported(row["path"], row["made_at"])
        for row in rows
        if not (scope := _scope_of(row["content"])) or scope & concerned
    )


def _delete_file_names(db: sqlite3.Connection) -> None:
    """Exports of deleted rows alone are named once, when the rows go. Of merged files the name alone is deleted."""
    dead = tombstones(db)
    for row in db.execute("SELECT id, content FROM exports").fetchall():
        if (scope := _scope_of(row["content"])) and scope <= dead:
            db.execute("DELETE FROM exports WHERE id = ?", [row["id"]])
    db.execute("UPDATE merges SET file = '' WHERE file <> ''")


def _scope_of(content: str) -> set[str]:
    """Keys of the class, group or program that an exported file is of; none for all of the store."""
    return {key for key in loaded(content)["of"].values() if key}


def _running(db: sqlite3.Connection) -> int:
    return row_count(db, "runs", "state = 'running'")
