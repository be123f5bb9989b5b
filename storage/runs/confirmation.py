"""Runs whose pass does not count until this PC has repeated them.

`storage/exchange/confirmation_tracking.py` records which these are.
"""

from collections import Counter

from storage.file.repository import Repository
from storage.run_validity import WAITING, ConfirmationFinding


class Unconfirmed(Repository):
    """The marks."""

    def waiting(self) -> list[str]:
        """Runs to be repeated, those with the shortest record before the others, so that a file of long ones does not
        hold up all that come later. Not those that were deleted, nor those of an own activity that is not here yet.
        """
        rows = self._rows(
            """SELECT run_id FROM unconfirmed_runs JOIN runs ON runs.id = run_id WHERE finding IS NULL
               AND (activity IS NULL OR length(activity) < 36 OR activity IN (SELECT id FROM own_activities))
               ORDER BY (SELECT total(n_rows) FROM telemetry WHERE telemetry.run_id = unconfirmed_runs.run_id),
                        marked_at, run_id"""
        )
        return [str(row["run_id"]) for row in rows]

    def counts(self) -> dict[str, int]:
        """How many runs wait, and how many there are of each finding."""
        rows = self._rows(
            f"""SELECT coalesce(finding, '{WAITING}') AS mark, count(*) AS n FROM unconfirmed_runs
                WHERE run_id IN (SELECT id FROM runs) GROUP BY mark"""
        )
        return Counter({str(row["mark"]): int(row["n"]) for row in rows})

    def accept(self, run_id: str) -> None:
        """A run that cannot be repeated here counts, as the teacher says; nothing changes for another."""
        query = "DELETE FROM unconfirmed_runs WHERE run_id = ? AND finding = 'not_repeatable'"
        self._database.write(lambda db: db.execute(query, [run_id]).rowcount)

    def confirm(self, run_id: str) -> None:
        """The run counts from now on."""
        query = "DELETE FROM unconfirmed_runs WHERE run_id = ?"
        self._database.write(lambda db: db.execute(query, [run_id]).rowcount)

    def note(self, run_id: str, finding: ConfirmationFinding) -> None:
        """The run stays marked, for this reason."""
        query = "UPDATE unconfirmed_runs SET finding = ? WHERE run_id = ?"
        self._database.write(lambda db: db.execute(query, [finding, run_id]).rowcount)
