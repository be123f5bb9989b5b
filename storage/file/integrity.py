"""The integrity check that the start leaves out, as it takes long: indexes that do not fit their tables, and rows that
do not fit each other.

By a wrong bit in an index nothing is lost, but rows cannot be found by their key, and no edit of them is written. By
one in the key of a group its programs belong to none, and no list has them.
"""

from storage.errors import StoreError
from storage.file.connection import Database
from storage.sql import Stop, integrity_problem, stoppable


def check_and_reindex(database: Database, stop: Stop = lambda: False) -> str | None:
    """What is wrong with the file after its indexes were made anew; None when all is well, or when stopped.

    Readers and writers go on during the check. Indexes are only made anew where something is wrong.
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
    """The first row that belongs to one which is not there, as the tables of both."""
    with database.read_connection() as db, stoppable(db, stop):
        row = db.execute("PRAGMA foreign_key_check").fetchone()
        return f"{row[0]} - {row[2]}" if row else None


def _problem(database: Database, stop: Stop) -> str | None:
    with database.read_connection() as db:
        return integrity_problem(db, stop=stop)
