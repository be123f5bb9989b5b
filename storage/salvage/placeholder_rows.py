"""Placeholders for missing parents: work whose group or program could not be read gets a placeholder as parent."""

from storage.choices import GREY
from storage.sql import tuples
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED
from storage.text import name_key, new_id


def add_missing_parents(db: sqlite3.Connection, now: str) -> None:
    """Adds the parents of rows of the schema `bundle` that neither `bundle` nor the store has."""
    _add_placeholder_programs(db, now)
    _add_placeholder_groups(db, now)
    for table in REPLICATED:
        _detach(db, table)


def _missing(column: str, table: str, parent: str) -> str:
    """Returns SQL of keys that rows refer to, for which no row is left, and which were not deleted for good."""
    return (
        f"SELECT DISTINCT {column} FROM bundle.{table} WHERE {column} IS NOT NULL"
        f" AND {column} NOT IN (SELECT id FROM bundle.{parent}) AND {column} NOT IN (SELECT id FROM main.{parent})"
        f" AND {column} NOT IN (SELECT id FROM bundle.tombstones) AND {column} NOT IN (SELECT id FROM main.tombstones)"
    )


def _add_placeholder_programs(db: sqlite3.Connection, now: str) -> None:
    missing = [str(key) for (key,) in tuples(db, _missing("program_id", "versions", "programs"))]
    if not missing:
        return
    group = new_id()
    _add_group(db, group, now)
    for key in missing:
        db.execute(
            "INSERT INTO bundle.programs (id, group_id, name, created_at, updated_at) VALUES (?, ?, ?, ?, ?)",
            [key, group, f"Programa {key[-4:]}", now, now],
        )


def _add_placeholder_groups(db: sqlite3.Connection, now: str) -> None:
    for (key,) in tuples(db, _missing("group_id", "programs", "groups")).fetchall():
        _add_group(db, str(key), now)


def _add_group(db: sqlite3.Connection, key: str, now: str) -> None:
    name = f"Grupo {key[-4:]}"
    db.execute(
        "INSERT INTO bundle.groups (id, name, name_key, color, created_at, used_at) VALUES (?, ?, ?, ?, ?, ?)",
        [key, name, name_key(name), GREY, now, now],
    )


def _detach(db: sqlite3.Connection, table: ReplicatedTable) -> None:
    """Clears references to missing parents where the column is optional, as the class of a group."""
    optional = {column.name for column in table.columns if column.optional}
    for column, parent in table.parents:
        if column in optional:
            missing = _missing(column, table.name, parent)
            db.execute(
                f"UPDATE bundle.{table.name} SET {column} = NULL WHERE {column} IN ({missing})"
            )
