"""The generated parts of docs/database.md and docs/parquet.md; a test holds them current.

`python -m storage.tables.description` writes them, from the repository's root: all that follows the mark.
"""

import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

from storage.sql import column_names
from storage.tables.columns import JSON, Column, Table
from storage.tables.migrations import migrate
from storage.tables.replicated import REPLICATED, TABLES
from storage.tables.views import VIEWS

MARK = "<!-- what follows is made by `python -m storage.tables.description` -->\n"


def database_page() -> str:
    """Views and tables, as a fresh file has them."""
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as db:
        migrate(db)
        views = [_view(name, column_names(db, name)) for name in sorted(VIEWS)]
        tables = [_table(TABLES[name], column_names(db, name)) for name in sorted(TABLES)]
    return "\n".join(["## Views\n", *views, "\n## Tables\n", *tables]).rstrip() + "\n"


def parquet_page() -> str:
    """The columns of all files."""
    lines = ["| table | column | type | what it says |", "|---|---|---|---|"]
    for table in REPLICATED:
        for n, column in enumerate(table.parquet_columns if table.parquet else ()):
            first = "" if n else f"`{table.name}` "
            lines.append(f"| {first}| `{column.name}` | {column.type} | {column.says} |")
    return "\n".join(lines) + "\n"


PAGES: dict[str, Callable[[], str]] = {"database": database_page, "parquet": parquet_page}


def page(name: str, current: str) -> str:
    """A page of docs/ with its generated part made anew."""
    return current.split(MARK, maxsplit=1)[0] + MARK + "\n" + PAGES[name]()


def _view(name: str, columns: tuple[str, ...]) -> str:
    return f"- **{name}**: {', '.join(f'`{column}`' for column in columns)}"


def _table(table: Table, names: tuple[str, ...]) -> str:
    columns = {column.name: column for column in table.columns}
    lines = [f"### {table.name}\n", f"{table.says}\n", "| column | type | | what it holds |"]
    lines += ["|---|---|---|---|", *(_column(columns[name], table.key) for name in names)]
    return "\n".join([*lines, ""])


def _column(column: Column, key: tuple[str, ...]) -> str:
    notes = [
        "key" if column.name in key else "",
        f"of `{column.references}`" if column.references else "",
        "JSON" if column.kind is JSON else "",
        "may be empty" if column.optional else "",
    ]
    told = ", ".join(note for note in notes if note)
    return f"| `{column.name}` | {column.kind.sql} | {told} | {column.says} |"


if __name__ == "__main__":
    for name in PAGES:
        path = Path("docs") / f"{name}.md"
        path.write_text(page(name, path.read_text("utf-8")), "utf-8")
