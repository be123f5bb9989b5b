"""The integrity check that the start leaves out, as it takes long: indexes that do not fit their tables.

By a wrong bit in an index nothing is lost, but rows cannot be found by their key, and no edit of them is written.
"""

from storage.errors import StoreError
from storage.file.connection import Database
from storage.sql import Stop, damage


def check_and_reindex(database: Database, stop: Stop = lambda: False) -> str | None:
    """What is wrong with the file after its indexes were made anew; None when all is well, or when stopped.

    Readers and writers go on during the check. Indexes are only made anew where something is wrong.
    """
    try:
        problem = _problem(database, stop)
        if problem is None or not database.can_write:
            return problem
        database.write(lambda db: db.execute("REINDEX").rowcount)
        return _problem(database, stop)
    except StoreError as error:
        return None if stop() else str(error.params.get("problem") or error.code)


def _problem(database: Database, stop: Stop) -> str | None:
    with database.reading() as db:
        return damage(db, stop=stop)
