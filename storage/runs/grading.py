"""Grading results: whether runs have passed their activity, which is judged after they have ended."""

from storage.file.repository import Repository
from storage.row_types import SIMULATOR, Json
from storage.run_validity import counted
from storage.sql import require
from storage.text import to_json

# condition: the run counts for its activity: a simulated one always, one of a real robot if it was judged
COUNTS = f"(link = '{SIMULATOR}' OR passed IS NOT NULL)"


class GradingResults(Repository):
    """The grading results of runs with an activity."""

    def pending(self) -> list[str]:
        """Returns ended runs without a result, oldest first. "Not judged" is a result, too.

        Leaves out unconfirmed runs, which must be repeated first.
        """
        rows = self._rows(
            """SELECT id FROM runs INDEXED BY runs_lesson WHERE lesson_id IS NOT NULL AND activity IS NOT NULL
               AND passed IS NULL AND check_report IS NULL AND state != 'running'
               AND id NOT IN (SELECT run_id FROM unconfirmed_runs) ORDER BY id"""
        )
        return [str(row["id"]) for row in rows]

    def of_group(self, group_id: str) -> dict[str, bool]:
        """Returns the activities that a group has tried, and whether a run passed each and counts.

        A run of a real robot that was not judged is no try.

        Raises:
            StoreError: `group_not_found`.
        """
        query = f"""SELECT activity, coalesce(max({counted()}), 0) AS passed FROM runs
            WHERE group_id = ? AND activity IS NOT NULL AND {COUNTS} GROUP BY activity"""
        with self._database.read_connection() as db:
            require(db, "groups", group_id)
            return {row["activity"]: bool(row["passed"]) for row in db.execute(query, [group_id])}

    def record(self, run_id: str, passed: bool | None, report: Json) -> None:
        """Records the result of a run; a run gets one result only. It is on disk when this returns.

        Args:
            passed: None for a run that was not judged.
        """

        query = """UPDATE runs SET passed = ?, check_report = ?
            WHERE id = ? AND passed IS NULL AND check_report IS NULL"""
        values = [None if passed is None else int(passed), to_json(report), run_id]
        self._database.write(lambda db: db.execute(query, values).rowcount)
