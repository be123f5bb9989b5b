"""Deleting for good: rows are deleted from every table and overwritten in the file. A tombstone for each key keeps
merges from bringing them back.

`deletions` counts the decisions about a key: with an odd `turn` a person has kept the row in spite of its tombstone,
with an even one it was deleted anew. Of two turns the greater holds, so that decisions join in any order. Only what a
person deletes gets tombstones: a row below a deleted one goes with it, but a merge makes no tombstone of its own.
A group goes with each class in which any PC has seen it (`former_classes`), if that was deleted by a PC that did not
know that the group had left. So what is deleted does not depend on which state of a group comes first.
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
# with groups that were seen in a class which was deleted without knowing where they are now
TOMBSTONED_KEYS = f"""(SELECT id FROM (
    SELECT id FROM main.tombstones UNION SELECT group_id FROM main.former_classes
    WHERE NOT has_left AND classroom_id IN {_TOMBSTONED_CLASSES}) WHERE id NOT IN {RETAINED_KEYS})"""
_TOMBSTONED = "(SELECT id FROM temp.dead)"  # with the rows below them, see `dead_rows`


def _deleted(table: ReplicatedTable) -> str:
    """Condition: the row's key or that of a row that it belongs to has a tombstone."""
    own = [f"id IN {_TOMBSTONED}"] if "id" in table.key else []
    return " OR ".join([*own, *(_parent_deleted(*parent) for parent in _followed(table))])


def _followed(table: ReplicatedTable) -> tuple[tuple[str, str], ...]:
    """Parents by which a row is found; not those of rows with tombstones of their own."""
    return () if table.own_tombstone else table.parents


def _parent_deleted(column: str, name: str) -> str:
    parent = _BY_NAME[name]
    keys = f"(SELECT id FROM {name} WHERE {_deleted(parent)})" if _followed(parent) else _TOMBSTONED
    return f"{column} IN {keys}"


# rows that refer to a row are deleted before it
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
# keys of the classes, groups and programs that deleted rows belong to: exports of one of these may hold the rows
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
    """What was deleted for good.

    Attributes:
        ids: keys that were deleted; backups are to lose the same.
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


def purge(database: Database, kind: str, *keys: str) -> Deletion:
    """Deletes a `classroom` with its groups, a `group` with its programs, a `program` with its runs, a `run` with
    its notes, a `lesson`, a `note` or a `taught_sign`, one or several; not from backups, which `Exchange.remove` does,
    nor from bundles.

    Raises:
        StoreError: KIND`_not_found`; `run_in_progress` where a run of it has not ended.
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
    """Deletes rows by their keys with all that belongs to them, within the caller's transaction.

    A person has decided it: the keys get tombstones, as do the groups, lessons and programs that are deleted with
    them; so do keys without a row. The same again changes nothing. What is deleted is overwritten in the file; a
    write-ahead log still holds it until `Database.checkpoint`. Names of files, which people make of those of groups,
    are deleted too.

    Args:
        spare_running: raises StoreError `run_in_progress` where a run that has not ended would be deleted.
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
    """Within, `temp.dead` has the keys that are deleted, with the groups, lessons and programs below them."""
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
    """Deletes the rows of `temp.dead` and all that belongs to them; `ids` are those of rows that were there."""
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
    """Keys in `temp.dead` of rows that are here."""
    keys = " UNION ALL ".join(
        f"SELECT id FROM main.{table.name} WHERE id IN {_TOMBSTONED}"
        for table in REPLICATED
        if table.deletable and "id" in table.key
    )
    return {str(key) for (key,) in tuples(db, keys)}


def counts_to_delete(db: sqlite3.Connection) -> dict[str, int]:
    """Rows by table that `erase` would delete now."""
    rows = {
        table: row_count(db, f"main.{table}", condition) for table, condition in _DELETIONS.items()
    }
    return {table: n for table, n in rows.items() if n}


def names_to_delete(db: sqlite3.Connection) -> tuple[str, ...]:
    """Names of what `erase` would delete now, classes first; not all where there are many."""
    return tuple(str(row["name"]) for row in db.execute(_PENDING_NAMES))


def tombstoned_keys(db: sqlite3.Connection) -> set[str]:
    """Keys of all that was deleted for good, and not kept since."""
    return {str(key) for (key,) in tuples(db, TOMBSTONED_KEYS[1:-1])}


def _note_who_left(db: sqlite3.Connection, ids: Collection[str]) -> None:
    """Groups that were in these classes and are elsewhere now do not go with them."""
    left = """UPDATE former_classes SET has_left = 1 WHERE classroom_id = :key AND group_id IN (
        SELECT id FROM groups WHERE classroom_id IS NOT :key)"""
    db.executemany(left, [{"key": key} for key in ids])


def _raise_turn(db: sqlite3.Connection, ids: Iterable[str]) -> None:
    """Rows that were kept once are deleted in the next turn."""
    query = "UPDATE deletions SET turn = turn + 1 WHERE turn % 2 AND id = ?"
    db.executemany(query, [(key,) for key in ids])


def _note_below(db: sqlite3.Connection, before: set[str]) -> None:
    """What a person deletes gets tombstones, each row that goes with it too, and how far its work was known here."""
    rows = {str(key) for (key,) in tuples(db, _TOMBSTONED[1:-1])} - before
    db.executemany("INSERT OR IGNORE INTO tombstones VALUES (?)", [(key,) for key in rows])
    _raise_turn(db, rows)
    for key, version_vector in version_vectors(db, rows):
        db.execute(
            "INSERT INTO deletions VALUES (?, 0, ?) ON CONFLICT (id) DO UPDATE SET knew = excluded.knew",
            [key, version_vector],
        )


def _exports_of_tombstoned(db: sqlite3.Connection) -> tuple[Exported, ...]:
    """Those of all of the store, and those of a part that has to do with it; none where nothing is deleted."""
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
    """Exports of deleted rows alone are named once, when the rows go. Of merged files the name alone is deleted."""
    tombstoned = {str(key) for (key,) in tuples(db, _TOMBSTONED[1:-1])}
    for row in db.execute("SELECT id, content FROM exports").fetchall():
        if (scope := _scope_of(row["content"])) and scope <= tombstoned:
            db.execute("DELETE FROM exports WHERE id = ?", [row["id"]])
    db.execute("UPDATE merges SET file = '' WHERE file <> ''")


def _scope_of(content: str) -> set[str]:
    """Keys of the class, group or program that an exported file is of; none for all of the store."""
    return {key for key in from_json(content)["of"].values() if key}


def _running(db: sqlite3.Connection) -> int:
    return row_count(db, "runs", "state = 'running'")
