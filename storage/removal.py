"""Deleting for good: rows gone from every table, their text from the file, and a key left so that no merge brings
them back."""

import sqlite3
from collections.abc import Iterable

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
