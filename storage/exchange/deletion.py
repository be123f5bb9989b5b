"""Deleting for good: rows gone from every table, their text from the file, and a key left so that no merge brings
them back."""

import sqlite3
from collections.abc import Iterable
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

from storage.connection import Access
from storage.content import tuples
from storage.errors import StoreError
from storage.opening import connect
from storage.text import loaded

# What has a key of its own and is deleted by it -> what of it is deleted too, by which column. A run, version or
# label is only ever found below these.
_BELOW = (
    ("groups", "classroom_id"),
    ("lessons", "classroom_id"),
    ("programs", "group_id"),
)
_DEAD = "(SELECT id FROM tombstones)"
_DEAD_VERSIONS = f"(SELECT id FROM versions WHERE id IN {_DEAD} OR program_id IN {_DEAD})"
_DEAD_RUNS = f"""(SELECT id FROM runs WHERE id IN {_DEAD} OR group_id IN {_DEAD} OR program_id IN {_DEAD}
    OR version_id IN {_DEAD_VERSIONS})"""
# what refers to a row goes before the row
_DELETIONS = (
    ("events", f"run_id IN {_DEAD_RUNS}"),
    ("telemetry", f"run_id IN {_DEAD_RUNS}"),
    ("notes", f"id IN {_DEAD} OR run_id IN {_DEAD_RUNS}"),
    ("runs", f"id IN {_DEAD_RUNS}"),
    ("version_labels", f"id IN {_DEAD} OR id IN {_DEAD_VERSIONS}"),
    ("versions", f"id IN {_DEAD_VERSIONS}"),
    ("programs", f"id IN {_DEAD}"),
    ("groups", f"id IN {_DEAD}"),
    ("lessons", f"id IN {_DEAD}"),
    ("classrooms", f"id IN {_DEAD}"),
)
_DOOMED_NAMES = f"""SELECT name FROM (
    SELECT 1 AS place, name FROM main.classrooms WHERE id IN {_DEAD}
    UNION SELECT 2, name FROM main.groups WHERE id IN {_DEAD}
    UNION SELECT 3, title FROM main.lessons WHERE id IN {_DEAD}
    UNION SELECT 4, name FROM main.programs WHERE id IN {_DEAD}
    UNION SELECT 5, coalesce(program_name, world) FROM main.runs WHERE id IN {_DEAD}
        OR id IN (SELECT run_id FROM main.notes WHERE id IN {_DEAD}))
    WHERE name <> '' GROUP BY name ORDER BY min(place), name LIMIT 20"""

# whom what is dead and still here has to do with: files of a part are named when it is about one of these
_RELATED = f"""
    WITH dead_runs AS (
             SELECT group_id, program_id FROM runs WHERE id IN {_DEAD_RUNS}
                 OR id IN (SELECT run_id FROM notes WHERE id IN {_DEAD})),
         dead_programs AS (SELECT id, group_id FROM programs WHERE id IN {_DEAD}
                               OR id IN (SELECT program_id FROM dead_runs)),
         dead_groups AS (SELECT id, classroom_id FROM groups WHERE id IN {_DEAD}
                             OR id IN (SELECT group_id FROM dead_programs UNION SELECT group_id FROM dead_runs))
    SELECT id FROM tombstones UNION SELECT id FROM dead_programs UNION SELECT id FROM dead_groups
    UNION SELECT classroom_id FROM dead_groups UNION SELECT classroom_id FROM lessons WHERE id IN {_DEAD}"""


@dataclass(frozen=True, slots=True)
class Exported:
    """A file that was written from this store."""

    path: str
    made_at: str


@dataclass(frozen=True, slots=True)
class Gone:
    """Rows that went, by table, without those that lost none; and files that may still hold them."""

    counts: dict[str, int]
    exports: tuple[Exported, ...]


@dataclass(frozen=True, slots=True)
class Removal:
    """What was deleted for good.

    Attributes:
        ids: the keys that no merge brings back; backups are to lose the same.
        counts: rows by table.
        exports: files that were written from this store and may still hold it.
        overwritten: False while another program still reads the log, in which the text is until it has ended.
        still_in: backups that could not be written anew, and may hold it.
    """

    ids: tuple[str, ...]
    counts: dict[str, int]
    exports: tuple[Exported, ...]
    overwritten: bool
    still_in: tuple[Path, ...] = ()


def remove(access: Access, kind: str, key: str) -> Removal:
    """Deletes a `classroom` with its groups, a `group` with its programs, a `program` with its runs, a `run` with
    its notes, a `lesson` or a `note`; not from backups, which `Exchange.remove` does, nor from bundles.

    Raises:
        StoreError: KIND`_not_found`; `run_in_progress` where a run of it has not ended.
    """

    def job(db: sqlite3.Connection) -> Removal:
        if db.execute(f"SELECT 1 FROM {kind}s WHERE id = ?", [key]).fetchone() is None:
            raise StoreError(f"{kind}_not_found", id=key)
        known, running = tombstones(db), _running(db)
        gone = remove_keys(db, [key])
        if _running(db) != running:
            raise StoreError("run_in_progress")
        return Removal(tuple(sorted(tombstones(db) - known)), gone.counts, gone.exports, False)

    removal = access.write(job)
    with closing(connect(access.address)) as db:
        overwritten = forget_log(db)
    return replace(removal, overwritten=overwritten)


def remove_keys(db: sqlite3.Connection, ids: Iterable[str]) -> Gone:
    """Deletes rows by their keys with all that belongs to them, within the caller's transaction.

    The keys are kept as tombstones, with those of the groups, lessons and programs that went with them; keys that
    are not there are kept too. The same again changes nothing. What is deleted is overwritten in the file; a WAL
    still holds it until `forget_log`. Names of files, which people make of those of groups, go too.
    """
    db.execute("PRAGMA secure_delete = ON")
    db.executemany("INSERT OR IGNORE INTO tombstones (id) VALUES (?)", [(key,) for key in ids])
    bury_below(db)
    exports = _exports_of_dead(db)
    counts = {
        table: db.execute(f"DELETE FROM {table} WHERE {condition}").rowcount
        for table, condition in _DELETIONS
    }
    if any(counts.values()):
        _forget_files(db)
    return Gone({table: n for table, n in counts.items() if n}, exports)


@dataclass(frozen=True, slots=True)
class Doomed:
    """What a merge would delete, by number; `names` are those of classes, groups, lessons and programs, not all where
    there are many."""

    groups: int
    programs: int
    runs: int
    names: tuple[str, ...]


def doomed(db: sqlite3.Connection) -> Doomed | None:
    """What `remove_keys` would delete now, when its keys and `bury_below` are done; None for nothing."""
    rows = {
        table: int(db.execute(f"SELECT count(*) FROM main.{table} WHERE {condition}").fetchone()[0])
        for table, condition in _DELETIONS
    }
    if not any(rows.values()):
        return None
    names = db.execute(_DOOMED_NAMES).fetchall()
    return Doomed(
        rows["groups"], rows["programs"], rows["runs"], tuple(str(row["name"]) for row in names)
    )


def bury_below(db: sqlite3.Connection) -> None:
    """What belongs to a deleted class or group is deleted by a key of its own."""
    for table, parent in _BELOW:
        db.execute(
            f"INSERT OR IGNORE INTO tombstones SELECT id FROM {table} WHERE {parent} IN {_DEAD}"
        )


def forget_log(db: sqlite3.Connection) -> bool:
    """Empties the WAL, outside of a transaction; False where another program still reads from it."""
    busy, _, _ = db.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()
    return not busy


def _exports_of_dead(db: sqlite3.Connection) -> tuple[Exported, ...]:
    """Those of all of the store, and those of a part that has to do with it; none where nothing is deleted."""
    if doomed(db) is None:
        return ()
    related = {str(key) for (key,) in tuples(db, _RELATED) if key}
    rows = db.execute("SELECT path, made_at, content FROM exports ORDER BY id").fetchall()
    return tuple(
        Exported(row["path"], row["made_at"])
        for row in rows
        if not (part := _part_of(row["content"])) or part & related
    )


def _forget_files(db: sqlite3.Connection) -> None:
    """Files of what is gone alone are named once, when it goes; where others came from is told by their PC."""
    dead = tombstones(db)
    for row in db.execute("SELECT id, content FROM exports").fetchall():
        if (part := _part_of(row["content"])) and part <= dead:
            db.execute("DELETE FROM exports WHERE id = ?", [row["id"]])
    db.execute("UPDATE merges SET file = '' WHERE file <> ''")


def _part_of(content: str) -> set[str]:
    """Keys of the class, group or program that an exported file is of; none for all of the store."""
    return {part for part in loaded(content)["of"].values() if part}


def tombstones(db: sqlite3.Connection) -> set[str]:
    """Keys of all that was deleted for good."""
    return {str(row["id"]) for row in db.execute("SELECT id FROM tombstones")}


def _running(db: sqlite3.Connection) -> int:
    return int(db.execute("SELECT count(*) FROM runs WHERE state = 'running'").fetchone()[0])
