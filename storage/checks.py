"""Whether runs have passed the activity of their lesson: noted after they have ended."""

import sqlite3

from storage.connection import Access
from storage.records import Json
from storage.text import dumped


class Checks:
    """What came of the runs that an activity belongs to."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def waiting(self) -> list[str]:
        """Runs that have ended and were not looked at yet, the oldest first."""
        with self._access.reading() as db:
            rows = db.execute(
                """SELECT id FROM runs INDEXED BY runs_lesson WHERE lesson_id IS NOT NULL AND activity IS NOT NULL
                   AND passed IS NULL AND state != 'running' ORDER BY id"""
            ).fetchall()
        return [str(row["id"]) for row in rows]

    def keep(self, run_id: str, passed: bool, report: Json) -> None:
        """On disk when this returns; a run is judged once."""

        def write(db: sqlite3.Connection) -> None:
            db.execute(
                "UPDATE runs SET passed = ?, check_report = ? WHERE id = ? AND passed IS NULL",
                [int(passed), dumped(report), run_id],
            )

        self._access.write(write)
