"""Whether runs have passed their activity, which is found out after they have ended."""

from storage.file.repository import Repository
from storage.row_types import SIMULATOR, Json
from storage.run_validity import counted
from storage.sql import require
from storage.text import to_json

# Runs that count for their activity: those of the simulator, and of real robots those that were judged.
COUNTS = f"(link = '{SIMULATOR}' OR passed IS NOT NULL)"


class GradingResults(Repository):
    """Results of the runs that an activity belongs to."""

    def pending(self) -> list[str]:
        """Runs that have ended and have no result yet, the oldest first. That a run is not judged is a result, too.

        Not runs that came from elsewhere and are to be repeated first: they are judged by their record.
        """
        rows = self._rows(
            """SELECT id FROM runs INDEXED BY runs_lesson WHERE lesson_id IS NOT NULL AND activity IS NOT NULL
               AND passed IS NULL AND check_report IS NULL AND state != 'running'
               AND id NOT IN (SELECT run_id FROM unconfirmed_runs) ORDER BY id"""
        )
        return [str(row["id"]) for row in rows]

    def of_group(self, group_id: str) -> dict[str, bool]:
        """The activities that a group has tried, with whether one run counts as passed; a real run not judged is none.

        Raises:
            StoreError: `group_not_found`.
        """
        query = f"""SELECT activity, coalesce(max({counted()}), 0) AS passed FROM runs
            WHERE group_id = ? AND activity IS NOT NULL AND {COUNTS} GROUP BY activity"""
        with self._database.read_connection() as db:
            require(db, "groups", group_id)
            return {row["activity"]: bool(row["passed"]) for row in db.execute(query, [group_id])}

    def record(self, run_id: str, passed: bool | None, report: Json) -> None:
        """On disk when this returns; a run gets one result. `passed` is None for one that was not judged."""

        query = """UPDATE runs SET passed = ?, check_report = ?
            WHERE id = ? AND passed IS NULL AND check_report IS NULL"""
        values = [None if passed is None else int(passed), to_json(report), run_id]
        self._database.write(lambda db: db.execute(query, values).rowcount)
