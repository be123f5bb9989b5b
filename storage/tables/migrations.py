"""Applies migrations to the tables and views of a file. The library sqlite-utils records each migration's name.

Views have plain names for people who open the file with Datasette or `sqlite-utils`. The view `about` describes all
tables; every migration makes it again.

sqlite-utils, with numpy, takes longer to load than a group's program to be read, and most starts have no migration to
apply. So sqlite-utils and the declarations of the tables are imported only for a migration.
"""

from collections.abc import Callable
from contextlib import nullcontext
from typing import TYPE_CHECKING

from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS

if TYPE_CHECKING:
    from sqlite_utils import Database

# as sqlite-utils names them
MIGRATION_SET = "pinel"
MIGRATIONS_TABLE = "_sqlite_migrations"


def migrate(
    connection: sqlite3.Connection, n_steps: int | None = None, *, at_once: bool = False
) -> None:
    """Applies the migrations that the file lacks, each in a transaction of its own.

    Args:
        n_steps: how many of the migrations the file must have; None for all.
        at_once: applies all in one transaction, for a new file, because each transaction waits for the disk.
    """
    from sqlite_utils import Database  # noqa: PLC0415 - for a migration only
    from sqlite_utils.migrations import Migrations  # noqa: PLC0415

    migrations = Migrations(MIGRATION_SET)
    for name in list(MIGRATIONS)[:n_steps]:
        migrations(name=name)(_step(name))
    db = Database(connection, execute_plugins=False)
    with db.atomic() if at_once else nullcontext():
        migrations.apply(db)


def _step(name: str) -> "Callable[[Database], None]":
    def step(db: "Database") -> None:
        for statement in (*MIGRATIONS[name], "DROP VIEW IF EXISTS about", _view_about()):
            db.execute(statement)

    return step


def _view_about() -> str:
    from storage.tables.replicated import TABLES  # noqa: PLC0415 - for a migration only
    from storage.tables.views import VIEWS  # noqa: PLC0415

    meanings = {table.name: table.description for table in TABLES.values()}
    meanings[", ".join(VIEWS)] = "The same for people: names and times instead of keys."
    rows = " UNION ALL ".join(
        f"SELECT {_quoted(name)} AS name, {_quoted(meaning)} AS meaning"
        for name, meaning in meanings.items()
    )
    return f'CREATE VIEW "about" AS {rows}'


def _quoted(text: str) -> str:
    return "'" + text.replace("'", "''") + "'"
