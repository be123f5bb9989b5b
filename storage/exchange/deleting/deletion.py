"""Deletion for good: rows are deleted from every table and overwritten in the file. A tombstone for each key prevents
merges from bringing the rows back.

`deletions.turn` counts the decisions about a key (a causal length). If `turn` is odd, a person retained the row in
spite of its tombstone; if it is even, a person deleted the row again. Of two turns the greater wins, so decisions
merge in any order. Only a deletion by a person makes tombstones. A merge deletes the children of a deleted row but
makes no tombstone for them.

`former_classes` has the classes in which any PC has had a group. The group is deleted with such a class, unless the
PC that deleted the class knew that the group had left. So the result does not depend on which state of a group
comes first.
"""

from collections.abc import Collection, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from storage.errors import StoreError
from storage.exchange.deleting.knowledge import version_vectors
from storage.file.connection import Database
from storage.sql import require, row_count, tuples
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED
from storage.tables.runs import RUNS
from storage.text import from_json

_BY_NAME = {table.name: table for table in REPLICATED}
RETAINED_KEYS = "(SELECT id FROM main.deletions WHERE turn % 2)"
_TOMBSTONED_CLASSES = f"(SELECT id FROM main.tombstones WHERE id NOT IN {RETAINED_KEYS})"
# also groups of former classes that were deleted by a PC which did not know that the group had left
TOMBSTONED_KEYS = f"""(SELECT id FROM (
    SELECT id FROM main.tombstones UNION SELECT group_id FROM main.former_classes
    WHERE NOT has_left AND classroom_id IN {_TOMBSTONED_CLASSES}) WHERE id NOT IN {RETAINED_KEYS})"""
_TOMBSTONED = "(SELECT id FROM temp.dead)"  # with the rows below them, see `tombstoned_rows`


def _deleted(table: ReplicatedTable) -> str:
    """Condition: the row or one of its ancestors has a tombstone."""
    own = [f"id IN {_TOMBSTONED}"] if "id" in table.key else []
    return " OR ".join([*own, *(_parent_deleted(*parent) for parent in _followed(table))])


def _followed(table: ReplicatedTable) -> tuple[tuple[str, str], ...]:
    """Returns the parents by which a row is found; none for tables whose rows get tombstones of their own."""
    return () if table.own_tombstone else table.parents


def _parent_deleted(column: str, name: str) -> str:
    parent = _BY_NAME[name]
    keys = f"(SELECT id FROM {name} WHERE {_deleted(parent)})" if _followed(parent) else _TOMBSTONED
    return f"{column} IN {keys}"


# children are deleted before their parents
_DELETIONS = {table.name: _deleted(table) for table in reversed(REPLICATED) if table.deletable}
_TOMBSTONED_RUNS = f"(SELECT id FROM runs WHERE {_deleted(RUNS)})"
_PENDING_NAMES = f"""SELECT name FROM (
    SELECT 1 AS place, name FROM main.classrooms WHERE id IN {_TOMBSTONED}
    UNION SELECT 2, name FROM main.groups WHERE id IN {_TOMBSTONED}
    UNION SELECT 3, title FROM main.lessons WHERE id IN {_TOMBSTONED}
    UNION SELECT 4, name FROM main.programs WHERE id IN {_TOMBSTONED}
    UNION SELECT 5, sign FROM main.taught_signs WHERE id IN {_TOMBSTONED}
    UNION SELECT 6, coalesce(program_name, world) FROM main.runs WHERE id IN {_TOMBSTONED}
        OR id IN (SELECT run_id FROM main.notes WHERE id IN {_TOMBSTONED}))
    WHERE name <> '' GROUP BY name ORDER BY min(place), name LIMIT 20"""
# keys of the classes, groups and programs of the deleted rows: exports of one of these may hold the rows
_CONCERNED = f"""
    WITH dead_runs AS (
             SELECT group_id, program_id FROM runs WHERE id IN {_TOMBSTONED_RUNS}
                 OR id IN (SELECT run_id FROM notes WHERE id IN {_TOMBSTONED})),
         dead_programs AS (SELECT id, group_id FROM programs WHERE id IN {_TOMBSTONED}
                               OR id IN (SELECT program_id FROM dead_runs)),
         dead_groups AS (SELECT id, classroom_id FROM groups WHERE id IN {_TOMBSTONED}
                             OR id IN (SELECT group_id FROM dead_programs UNION SELECT group_id FROM dead_runs))
    SELECT id FROM temp.dead UNION SELECT id FROM dead_programs UNION SELECT id FROM dead_groups
    UNION SELECT classroom_id FROM dead_groups UNION SELECT classroom_id FROM lessons WHERE id IN {_TOMBSTONED}
    UNION SELECT classroom_id FROM taught_signs WHERE id IN {_TOMBSTONED}"""


@dataclass(frozen=True, slots=True)
class Exported:
    """A file that was written from this store."""

    path: str
    made_at: str


@dataclass(frozen=True, slots=True)
class Deletion:
    """The rows that were deleted for good.

    Attributes:
        ids: their keys, which must be deleted from the backups too.
        counts: deleted rows by table, without zeros.
        exports: files that were written from this store and may still hold the rows.
        overwritten: False while another program still reads the write-ahead log, which holds the texts until then.
        still_in: backups that could not be rewritten and may still hold the rows.
    """

    ids: tuple[str, ...] = ()
    counts: dict[str, int] = field(default_factory=dict)
    exports: tuple[Exported, ...] = ()
    overwritten: bool = False
    still_in: tuple[Path, ...] = ()


def purge(database: Database, kind: str, *keys: str) -> Deletion:
    """Deletes one or several rows of a kind with their children. `Exchange.purge` deletes them from backups too.

    A `classroom` is deleted with its groups, a `group` with its programs, a `program` with its runs, a `run` with its
    notes; other kinds are `lesson`, `note` and `taught_sign`. Bundles are not changed.

    Raises:
        StoreError: KIND`_not_found`; `run_in_progress` if a run to delete has not ended.
    """

    def job(db: sqlite3.Connection) -> Deletion:
        for key in keys:
            require(db, f"{kind}s", key)
        return purge_keys(db, keys, spare_running=True)

    deletion = database.write(job)
    return replace(deletion, overwritten=database.checkpoint(waits_for_readers=True))


def purge_keys(
    db: sqlite3.Connection, ids: Collection[str], *, spare_running: bool = False
) -> Deletion:
    """Deletes rows by their keys with all rows that belong to them, within the caller's transaction.

    This is a person's decision. So the keys get tombstones, also keys without a row, as do the groups, lessons and
    programs that are deleted with them. Repeating the call changes nothing. Deleted rows are overwritten in the file; a
    write-ahead log still holds them until `Database.checkpoint`. Names of merged files are deleted too, because people
    name files after groups.

    Args:
        spare_running: raises StoreError `run_in_progress` if a run that has not ended would be deleted.
    """
    before = tombstoned_keys(db)
    _note_who_left(db, ids)
    db.executemany("INSERT OR IGNORE INTO tombstones (id) VALUES (?)", [(key,) for key in ids])
    _raise_turn(db, ids)
    with tombstoned_rows(db):
        _note_below(db, before)
        deletion = delete_tombstoned(db, spare_running=spare_running)
    return replace(deletion, ids=tuple(sorted(tombstoned_keys(db) - before)))


@contextmanager
def tombstoned_rows(db: sqlite3.Connection) -> Iterator[None]:
    """Makes `temp.dead` within the context: the tombstoned keys and the groups, lessons and programs below them."""
    db.execute("CREATE TEMP TABLE dead (id TEXT PRIMARY KEY) WITHOUT ROWID")
    try:
        db.execute(f"INSERT INTO temp.dead SELECT id FROM {TOMBSTONED_KEYS}")
        for table in REPLICATED:
            if table.own_tombstone:
                for column, _ in table.parents:
                    db.execute(
                        f"INSERT OR IGNORE INTO temp.dead SELECT id FROM main.{table.name}"
                        f" WHERE {column} IN {_TOMBSTONED}"
                    )
        yield
    finally:
        db.execute("DROP TABLE temp.dead")


def delete_tombstoned(db: sqlite3.Connection, *, spare_running: bool) -> Deletion:
    """Deletes the rows of `temp.dead` with all rows that belong to them; `ids` are the keys of rows that existed."""
    db.execute("PRAGMA secure_delete = ON")
    exports = _exports_of_tombstoned(db)
    running = _running(db)
    ids = tuple(sorted(keys_to_delete(db)))
    counts = {
        table: db.execute(f"DELETE FROM {table} WHERE {condition}").rowcount
        for table, condition in _DELETIONS.items()
    }
    if spare_running and _running(db) != running:
        raise StoreError("run_in_progress")
    if any(counts.values()):
        _delete_file_names(db)
    return Deletion(ids, {table: n for table, n in counts.items() if n}, exports)


def keys_to_delete(db: sqlite3.Connection) -> set[str]:
    """Returns the keys in `temp.dead` of rows that exist."""
    keys = " UNION ALL ".join(
        f"SELECT id FROM main.{table.name} WHERE id IN {_TOMBSTONED}"
        for table in REPLICATED
        if table.deletable and "id" in table.key
    )
    return {str(key) for (key,) in tuples(db, keys)}


def counts_to_delete(db: sqlite3.Connection) -> dict[str, int]:
    """Returns the numbers of rows by table that `delete_tombstoned` would delete now."""
    rows = {
        table: row_count(db, f"main.{table}", condition) for table, condition in _DELETIONS.items()
    }
    return {table: n for table, n in rows.items() if n}


def names_to_delete(db: sqlite3.Connection) -> tuple[str, ...]:
    """Returns names of rows that `delete_tombstoned` would delete now, classes first, 20 at most."""
    return tuple(str(row["name"]) for row in db.execute(_PENDING_NAMES))


def tombstoned_keys(db: sqlite3.Connection) -> set[str]:
    """Returns the keys of all rows that were deleted for good and not retained since."""
    return {str(key) for (key,) in tuples(db, TOMBSTONED_KEYS[1:-1])}


def _note_who_left(db: sqlite3.Connection, ids: Collection[str]) -> None:
    """Records the groups that have left these classes, so that they are not deleted with the class."""
    left = """UPDATE former_classes SET has_left = 1 WHERE classroom_id = :key AND group_id IN (
        SELECT id FROM groups WHERE classroom_id IS NOT :key)"""
    db.executemany(left, [{"key": key} for key in ids])


def _raise_turn(db: sqlite3.Connection, ids: Iterable[str]) -> None:
    """Raises the turn of retained rows, so that they count as deleted again."""
    query = "UPDATE deletions SET turn = turn + 1 WHERE turn % 2 AND id = ?"
    db.executemany(query, [(key,) for key in ids])


def _note_below(db: sqlite3.Connection, before: set[str]) -> None:
    """Makes tombstones for the rows that a person deletes with others, and records the version vector of each."""
    rows = {str(key) for (key,) in tuples(db, _TOMBSTONED[1:-1])} - before
    db.executemany("INSERT OR IGNORE INTO tombstones VALUES (?)", [(key,) for key in rows])
    _raise_turn(db, rows)
    for key, version_vector in version_vectors(db, rows):
        db.execute(
            "INSERT INTO deletions VALUES (?, 0, ?) ON CONFLICT (id) DO UPDATE SET knew = excluded.knew",
            [key, version_vector],
        )


def _exports_of_tombstoned(db: sqlite3.Connection) -> tuple[Exported, ...]:
    """Returns exports of the whole store and exports of a part that may hold the rows; none if no row is deleted."""
    if not counts_to_delete(db):
        return ()
    concerned = {str(key) for (key,) in tuples(db, _CONCERNED) if key}
    rows = db.execute("SELECT path, made_at, content FROM exports ORDER BY id").fetchall()
    return tuple(
        Exported(row["path"], row["made_at"])
        for row in rows
        if not (scope := _scope_of(row["content"])) or scope & concerned
    )


def _delete_file_names(db: sqlite3.Connection) -> None:
    """Deletes the exports of deleted rows alone, and the file names of merged bundles.

    A report names such an export once, at the deletion. Of merged bundles the other columns stay.
    """
    tombstoned = {str(key) for (key,) in tuples(db, _TOMBSTONED[1:-1])}
    for row in db.execute("SELECT id, content FROM exports").fetchall():
        if (scope := _scope_of(row["content"])) and scope <= tombstoned:
            db.execute("DELETE FROM exports WHERE id = ?", [row["id"]])
    db.execute("UPDATE merges SET file = '' WHERE file <> ''")


def _scope_of(content: str) -> set[str]:
    """Returns the keys of the class, group or program of an exported file; none for the whole store."""
    return {key for key in from_json(content)["of"].values() if key}


def _running(db: sqlite3.Connection) -> int:
    return row_count(db, "runs", "state = 'running'")
