"""Whether runs have passed the activity of their lesson, which is found out after they have ended."""

from storage.file.repository import Repository
from storage.records import Json
from storage.text import dumped


class Checks(Repository):
    """Results of the runs that an activity belongs to."""

    def pending(self) -> list[str]:
        """Runs that have ended and have no result yet, the oldest first."""
        rows = self._rows(
            """SELECT id FROM runs INDEXED BY runs_lesson WHERE lesson_id IS NOT NULL AND activity IS NOT NULL
               AND passed IS NULL AND state != 'running' ORDER BY id"""
        )
        return [str(row["id"]) for row in rows]

    def record(self, run_id: str, passed: bool, report: Json) -> None:
        """On disk when this returns; a run gets one result."""

        query = "UPDATE runs SET passed = ?, check_report = ? WHERE id = ? AND passed IS NULL"
        values = [int(passed), dumped(report), run_id]
        self._database.write(lambda db: db.execute(query, values).rowcount)
