"""The integrity check that takes too long for the start: indexes that do not match their tables, and rows whose parent
is missing.

A wrong bit in an index loses no row. But the row is not found by its key, and cannot be edited. A wrong
bit in the key of a group leaves its programs without a group, so no list shows them.
"""

from storage.errors import StoreError
from storage.file.connection import Database
from storage.sql import Stop, integrity_problem, stoppable


def check_and_reindex(database: Database, stop: Stop = lambda: False) -> str | None:
    """Returns the problem of the file after rebuilding its indexes; None for none, or if stopped.

    Readers and writers continue during the check. Indexes are rebuilt only if there is a problem.
    """
    try:
        problem = _problem(database, stop)
        if problem and database.can_write:
            database.write(lambda db: db.execute("REINDEX").rowcount)
            problem = _problem(database, stop)
        return problem or _misfit(database, stop)
    except StoreError as error:
        return None if stop() else str(error.params.get("problem") or error.code)


def _misfit(database: Database, stop: Stop) -> str | None:
    """Returns the first row whose parent is missing, as the tables of both."""
    with database.read_connection() as db, stoppable(db, stop):
        row = db.execute("PRAGMA foreign_key_check").fetchone()
        return f"{row[0]} - {row[2]}" if row else None


def _problem(database: Database, stop: Stop) -> str | None:
    with database.read_connection() as db:
        return integrity_problem(db, stop=stop)
