"""Damage that the start does not look for, as it takes long: indexes that do not fit their tables.

Of a wrong bit in an index nothing is lost, but what is there cannot be found by its key, and no edit of it is kept.
"""

from collections.abc import Callable

from storage.connection import Access
from storage.errors import StoreError

Stop = Callable[[], bool]
_STEPS_BETWEEN_STOPS = 10_000


def mend(access: Access, stop: Stop = lambda: False) -> str | None:
    """What SQLite finds wrong in the file after its indexes were made anew; None when all is well, or when stopped.

    Reading all of it goes on beside everybody's work. Indexes are only made anew where one does not fit.
    """
    try:
        problem = _problem(access, stop)
        if problem is None or not access.can_write:
            return problem
        access.write(lambda db: db.execute("REINDEX").rowcount)
        return _problem(access, stop)
    except StoreError as error:
        return None if stop() else str(error.params.get("problem") or error.code)


def _problem(access: Access, stop: Stop) -> str | None:
    with access.reading() as db:
        db.set_progress_handler(stop, _STEPS_BETWEEN_STOPS)
        try:
            finding = str(db.execute("PRAGMA integrity_check(1)").fetchone()[0])
        finally:
            db.set_progress_handler(None, 0)
    return None if finding == "ok" else finding
