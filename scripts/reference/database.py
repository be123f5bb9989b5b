"""The generated parts of docs/database.md and docs/parquet.md."""

from contextlib import closing

from storage.sql import column_names
from storage.sqlite import sqlite3
from storage.tables.columns import JSON, Column, Table
from storage.tables.migrations import migrate
from storage.tables.replicated import REPLICATED, TABLES
from storage.tables.views import VIEWS


def tables_and_views() -> str:
    """Views and tables of a new database."""
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as db:
        migrate(db)
        views = [_view(name, column_names(db, name)) for name in sorted(VIEWS)]
        tables = [_table(TABLES[name], column_names(db, name)) for name in sorted(TABLES)]
    return "\n".join(["## Views\n", *views, "\n## Tables\n", *tables]).rstrip() + "\n"


def parquet_columns() -> str:
    """Columns of all Parquet files."""
    lines = ["| table | column | type | what it says |", "|---|---|---|---|"]
    for table in REPLICATED:
        for n, column in enumerate(table.parquet_columns if table.parquet else ()):
            first = "" if n else f"`{table.name}` "
            lines.append(f"| {first}| `{column.name}` | {column.type} | {column.description} |")
    return "\n".join(lines) + "\n"


def _view(name: str, columns: tuple[str, ...]) -> str:
    return f"- **{name}**: {', '.join(f'`{column}`' for column in columns)}"


def _table(table: Table, names: tuple[str, ...]) -> str:
    columns = {column.name: column for column in table.columns}
    lines = [f"### {table.name}\n", f"{table.description}\n", "| column | type | | what it holds |"]
    lines += ["|---|---|---|---|", *(_column(columns[name], table.key) for name in names)]
    return "\n".join([*lines, ""])


def _column(column: Column, key: tuple[str, ...]) -> str:
    notes = [
        "key" if column.name in key else "",
        f"of `{column.references}`" if column.references else "",
        "JSON" if column.kind is JSON else "",
        "may be empty" if column.optional else "",
    ]
    note_text = ", ".join(note for note in notes if note)
    return f"| `{column.name}` | {column.kind.sql} | {note_text} | {column.description} |"
