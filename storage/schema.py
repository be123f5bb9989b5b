"""Tables and views, as migrations of sqlite-utils: a function's name is the migration's identity.

Keys are UUIDv7 text, so that files of many PCs can be merged by key. Views carry plain names for people who
open the file with Datasette or `sqlite-utils`; `about` says what is what.

sqlite-utils (and numpy with it) takes longer to load than a group's program to be read, and most starts find the
tables up to date: it is imported only to change them.
"""

import sqlite3
from collections.abc import Callable
from typing import TYPE_CHECKING

from storage.class_tables import MEANINGS, make_class_tables, make_class_views

if TYPE_CHECKING:
    from sqlite_utils import Database

# as sqlite-utils names them
MIGRATION_SET = "pinel"
MIGRATIONS_TABLE = "_sqlite_migrations"

_ABOUT = {
    "groups": "Pupils who work together. name_key is the name without spaces and case; used_at orders the list.",
    "programs": "Saved blocks of a group; the content is in versions.",
    "versions": "Every state of a program, never overwritten; number counts within the program. workspace is"
    " what the editor shows, document what the robot gets (null while faults is not empty), world the group's own"
    " (null where it is chosen by name).",
    "runs": "One execution of a version (or, from the command line, of document) in a world.",
    "events": "What happened in a run, by seq; tick / 30 is the time in s; data holds the other fields.",
    "telemetry": "Samples of a run at 30 Hz in chunks: zlib of byte-shuffled int32 differences, column by"
    " column; steps in storage/telemetry.py.",
    "settings": "What was chosen, as JSON.",
    **MEANINGS,
    "group_list, program_list, version_list, run_list, lesson_list, note_list": "The same for people: names and"
    " times instead of keys.",
}


def first_tables(db: "Database") -> None:
    """Groups, programs, versions, runs with events and telemetry, settings."""
    _tables_of_work(db)
    _tables_of_runs(db)
    db.create_table(
        "settings", {"key": str, "value": str}, pk="key", not_null={"value"}, strict=True
    )


def first_views(db: "Database") -> None:
    """The same content with plain names."""
    _view_about(db)
    db.create_view(
        "group_list",
        """SELECT name, color, created_at, used_at,
                  (SELECT count(*) FROM programs WHERE group_id = groups.id) AS programs,
                  (SELECT count(*) FROM runs WHERE group_id = groups.id) AS runs
           FROM groups ORDER BY used_at DESC""",
    )
    db.create_view(
        "program_list",
        """SELECT groups.name AS "group", programs.name AS program, programs.created_at, programs.updated_at,
                  (SELECT count(*) FROM versions WHERE program_id = programs.id) AS versions
           FROM programs JOIN groups ON groups.id = programs.group_id ORDER BY programs.id DESC""",
    )
    db.create_view(
        "run_list",
        """SELECT runs.id, groups.name AS "group", runs.program_name AS program, runs.world, runs.state,
                  runs.reason, runs.started_at, runs.duration_s, runs.path_length_m, runs.closing_error_m
           FROM runs LEFT JOIN groups ON groups.id = runs.group_id ORDER BY runs.id DESC""",
    )


def worlds_of_versions(db: "Database") -> None:
    """A version may hold a world that its group made."""
    db.table("versions").add_column("world", str)
    _view_about(db)


def classes_and_lessons(db: "Database") -> None:
    """Groups belong to classes, work to lessons; the bin, names of versions, notes, and what merging needs."""
    make_class_tables(db)
    make_class_views(db)
    _view_about(db)


def history_index(db: "Database") -> None:
    """Runs are chosen by more than their group (storage/history.py)."""
    db.execute(
        "CREATE INDEX runs_history ON runs (id, group_id, lesson_id, activity, state, passed, started_at)"
    )


# In their order. New ones are added at the end; none is ever changed.
_MIGRATIONS: tuple[Callable[["Database"], None], ...] = (
    first_tables,
    first_views,
    worlds_of_versions,
    classes_and_lessons,
    history_index,
)
KNOWN_MIGRATIONS = frozenset(migration.__name__ for migration in _MIGRATIONS)


def steps() -> tuple[str, ...]:
    """Names of the migrations in their order."""
    return tuple(migration.__name__ for migration in _MIGRATIONS)


def migrate(connection: sqlite3.Connection, n_steps: int | None = None) -> None:
    """Makes the tables, or brings them up to date, each step in a transaction of its own.

    Args:
        n_steps: how many of the steps a file is to have, all with None.
    """
    from sqlite_utils import Database  # noqa: PLC0415 - see above
    from sqlite_utils.migrations import Migrations  # noqa: PLC0415

    migrations = Migrations(MIGRATION_SET)
    for migration in _MIGRATIONS[:n_steps]:
        migrations()(migration)
    migrations.apply(Database(connection, execute_plugins=False))


def _view_about(db: "Database") -> None:
    rows = " UNION ALL ".join(
        f"SELECT {db.quote(name)} AS name, {db.quote(meaning)} AS meaning"
        for name, meaning in _ABOUT.items()
    )
    db.create_view("about", rows, replace=True)


def _tables_of_work(db: "Database") -> None:
    db.create_table(
        "groups",
        {"id": str, "name": str, "name_key": str, "color": str, "created_at": str, "used_at": str},
        pk="id",
        not_null={"name", "name_key", "color", "created_at", "used_at"},
        strict=True,
    ).create_index(["name_key"], unique=True)
    db.create_table(
        "programs",
        {"id": str, "group_id": str, "name": str, "created_at": str, "updated_at": str},
        pk="id",
        not_null={"group_id", "name", "created_at", "updated_at"},
        foreign_keys=[("group_id", "groups", "id")],
        strict=True,
    ).create_index(["group_id", "id"])
    db.create_table(
        "versions",
        {
            "id": str,
            "program_id": str,
            "number": int,
            "created_at": str,
            "workspace": str,
            "document": str,
            "faults": str,
        },
        pk="id",
        not_null={"program_id", "number", "created_at", "workspace", "faults"},
        foreign_keys=[("program_id", "programs", "id")],
        strict=True,
    ).create_index(["program_id", "number"])


def _tables_of_runs(db: "Database") -> None:
    runs = db.create_table(
        "runs",
        {
            "id": str,
            "group_id": str,
            "program_id": str,
            "program_name": str,
            "version_id": str,
            "document": str,
            "link": str,
            "world": str,
            "world_document": str,
            "seed": int,
            "parameters": str,
            "app_version": str,
            "state": str,
            "reason": str,
            "params": str,
            "block": str,
            "started_at": str,
            "ended_at": str,
            "duration_s": float,
            "n_executed": int,
            "path_length_m": float,
            "closing_error_m": float,
            "summary": str,
            "telemetry_sha256": str,
            "path": str,
        },
        pk="id",
        not_null={
            "link",
            "world",
            "world_document",
            "seed",
            "parameters",
            "app_version",
            "state",
            "started_at",
        },
        foreign_keys=[
            ("group_id", "groups", "id"),
            ("program_id", "programs", "id"),
            ("version_id", "versions", "id"),
        ],
        strict=True,
    )
    for columns in (["group_id", "id"], ["program_id"], ["version_id"]):
        runs.create_index(columns)
    db.execute("CREATE INDEX running ON runs (state) WHERE state = 'running'")
    db.create_table(
        "events",
        {"run_id": str, "seq": int, "tick": int, "type": str, "data": str},
        pk=("run_id", "seq"),
        not_null={"tick", "type", "data"},
        foreign_keys=[("run_id", "runs", "id")],
        strict=True,
    )
    db.create_table(
        "telemetry",
        {"run_id": str, "chunk": int, "first_tick": int, "n_rows": int, "data": bytes},
        pk=("run_id", "chunk"),
        not_null={"first_tick", "n_rows", "data"},
        foreign_keys=[("run_id", "runs", "id")],
        strict=True,
    )
