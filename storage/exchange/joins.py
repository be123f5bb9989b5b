"""SQL that joins a table of a bundle with that of the store, by key.

In it `main` is the store and `bundle` the bundle; a row of the store is called `ours`, one of the bundle `theirs`.
"""

from storage.exchange.deleting.deletion import TOMBSTONED_KEYS
from storage.sql import column_names
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable


def insert_new(db: sqlite3.Connection, table: ReplicatedTable, condition: str) -> int:
    """Adds the rows of the bundle that meet the condition and whose key the store does not have; tells how many."""
    names = column_names(db, table.name)
    return db.execute(
        f"INSERT INTO main.{table.name} ({', '.join(names)})"
        f" SELECT {qualified_columns('theirs', names)} FROM bundle.{table.name} AS theirs"
        f" WHERE ({condition}) AND {is_new(table)} ORDER BY {qualified_columns('theirs', table.key)}"
    ).rowcount


def is_new(table: ReplicatedTable) -> str:
    """Condition: the store has no row of this key."""
    return f"NOT EXISTS (SELECT 1 FROM main.{table.name} AS ours WHERE {same_key(table)})"


def may_merge(table: ReplicatedTable) -> str:
    """Condition: neither the row nor what it belongs to is deleted; a bundle holds what its rows belong to."""
    parents = [
        f"(theirs.{column} IS NULL OR EXISTS (SELECT 1 FROM main.{parent} WHERE id = theirs.{column}))"
        for column, parent in table.parents
    ]
    return " AND ".join([f"theirs.id NOT IN {TOMBSTONED_KEYS}", *parents])


def rows_in_both(table: ReplicatedTable, kind: str = "") -> str:
    """Rows of a table that both have, `theirs` and `ours`."""
    return f"FROM bundle.{table.name} AS theirs {kind} JOIN main.{table.name} AS ours ON {same_key(table)}"


def same_key(table: ReplicatedTable) -> str:
    """Condition: `ours` and `theirs` are one row."""
    return " AND ".join(f"ours.{name} = theirs.{name}" for name in table.key)


def qualified_columns(side: str, names: tuple[str, ...]) -> str:
    """Columns of `ours` or `theirs`."""
    return ", ".join(f"{side}.{name}" for name in names)
