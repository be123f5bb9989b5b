"""SQL that joins a table of a bundle with the same table of the store, by key.

In the SQL `main` is the store and `bundle` the bundle. A row of the store is `ours`, a row of the bundle `theirs`.
"""

from storage.exchange.deleting.deletion import TOMBSTONED_KEYS
from storage.sql import column_names
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable


def insert_new(db: sqlite3.Connection, table: ReplicatedTable, condition: str) -> int:
    """Adds the bundle's rows that meet the condition and whose key the store lacks; returns their number."""
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
    """Condition: neither the row nor a parent of it was deleted; a bundle holds the parents of its rows."""
    parents = [
        f"(theirs.{column} IS NULL OR EXISTS (SELECT 1 FROM main.{parent} WHERE id = theirs.{column}))"
        for column, parent in table.parents
    ]
    return " AND ".join([f"theirs.id NOT IN {TOMBSTONED_KEYS}", *parents])


def rows_in_both(table: ReplicatedTable, kind: str = "") -> str:
    """Returns the FROM clause of the rows that both have, `theirs` and `ours`."""
    return f"FROM bundle.{table.name} AS theirs {kind} JOIN main.{table.name} AS ours ON {same_key(table)}"


def same_key(table: ReplicatedTable) -> str:
    """Condition: `ours` and `theirs` are the same row."""
    return " AND ".join(f"ours.{name} = theirs.{name}" for name in table.key)


def qualified_columns(side: str, names: tuple[str, ...]) -> str:
    """Returns the columns, qualified with `ours` or `theirs`."""
    return ", ".join(f"{side}.{name}" for name in names)
