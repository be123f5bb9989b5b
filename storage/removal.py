"""Deleting for good: rows gone from every table, their text from the file, and a key left so that no merge brings
them back."""

import sqlite3
from collections.abc import Iterable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from storage.connection import Access
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

# kind -> what tells which class, group and programs it has to do with
_RELATED = {
    "classroom": """SELECT groups.classroom_id, groups.id, programs.id FROM groups
        LEFT JOIN programs ON programs.group_id = groups.id WHERE groups.classroom_id = ?""",
    "group": """SELECT groups.classroom_id, groups.id, programs.id FROM groups
        LEFT JOIN programs ON programs.group_id = groups.id WHERE groups.id = ?""",
    "program": """SELECT groups.classroom_id, groups.id, programs.id FROM programs
        JOIN groups ON groups.id = programs.group_id WHERE programs.id = ?""",
    "run": """SELECT groups.classroom_id, groups.id, runs.program_id FROM runs
        LEFT JOIN groups ON groups.id = runs.group_id WHERE runs.id = ?""",
    "lesson": "SELECT classroom_id FROM lessons WHERE id = ?",
    "note": """SELECT groups.classroom_id, groups.id, runs.program_id FROM notes JOIN runs ON runs.id = notes.run_id
        LEFT JOIN groups ON groups.id = runs.group_id WHERE notes.id = ?""",
}


@dataclass(frozen=True, slots=True)
class Exported:
    """A file that was written from this store."""

    path: str
    made_at: str


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
        exports = _exports_of(db, kind, key)
        known, running = tombstones(db), _running(db)
        counts = remove_keys(db, [key])
        if _running(db) != running:
            raise StoreError("run_in_progress")
        return Removal(tuple(sorted(tombstones(db) - known)), counts, exports, False)

    removal = access.write(job)
    with closing(connect(access.address)) as db:
        overwritten = forget_log(db)
    return Removal(removal.ids, removal.counts, removal.exports, overwritten)


def remove_keys(db: sqlite3.Connection, ids: Iterable[str]) -> dict[str, int]:
    """Deletes rows by their keys with all that belongs to them, within the caller's transaction.

    The keys are kept as tombstones, with those of the groups, lessons and programs that went with them; keys that
    are not there are kept too. The same again changes nothing. What is deleted is overwritten in the file; a WAL
    still holds it until `forget_log`.

    Returns:
        How many rows went, by table; tables that lost none are left out.
    """
    db.execute("PRAGMA secure_delete = ON")
    db.executemany("INSERT OR IGNORE INTO tombstones (id) VALUES (?)", [(key,) for key in ids])
    bury_below(db)
    counts = {
        table: db.execute(f"DELETE FROM {table} WHERE {condition}").rowcount
        for table, condition in _DELETIONS
    }
    return {table: n for table, n in counts.items() if n}


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


def _exports_of(db: sqlite3.Connection, kind: str, key: str) -> tuple[Exported, ...]:
    """Those of all of the store, and those of a part that has to do with it."""
    related = {key, *(value for row in db.execute(_RELATED[kind], [key]) for value in row if value)}
    rows = db.execute("SELECT path, made_at, content FROM exports ORDER BY id").fetchall()
    parts = [{part for part in loaded(row["content"])["of"].values() if part} for row in rows]
    return tuple(
        Exported(row["path"], row["made_at"])
        for row, part in zip(rows, parts, strict=True)
        if not part or part & related
    )


def tombstones(db: sqlite3.Connection) -> set[str]:
    """Keys of all that was deleted for good."""
    return {str(row["id"]) for row in db.execute("SELECT id FROM tombstones")}


def _running(db: sqlite3.Connection) -> int:
    return int(db.execute("SELECT count(*) FROM runs WHERE state = 'running'").fetchone()[0])
