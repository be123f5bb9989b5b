"""Unconfirmed runs: their pass does not count until this PC has repeated them.

`storage/exchange/confirmation_tracking.py` records them.
"""

from collections import Counter

from storage.file.repository import Repository
from storage.run_validity import WAITING, ConfirmationFinding


class Unconfirmed(Repository):
    """The entries of the table `unconfirmed_runs`."""

    def waiting(self) -> list[str]:
        """Returns the runs to repeat, the shortest record first, so that long runs do not delay all others.

        Leaves out deleted runs, and runs of an own activity that this store does not have yet.
        """
        rows = self._rows(
            """SELECT run_id FROM unconfirmed_runs JOIN runs ON runs.id = run_id WHERE finding IS NULL
               AND (activity IS NULL OR length(activity) < 36 OR activity IN (SELECT id FROM own_activities))
               ORDER BY (SELECT total(n_rows) FROM telemetry WHERE telemetry.run_id = unconfirmed_runs.run_id),
                        marked_at, run_id"""
        )
        return [str(row["run_id"]) for row in rows]

    def counts(self) -> dict[str, int]:
        """Returns how many runs wait, and how many have each finding."""
        rows = self._rows(
            f"""SELECT coalesce(finding, '{WAITING}') AS mark, count(*) AS n FROM unconfirmed_runs
                WHERE run_id IN (SELECT id FROM runs) GROUP BY mark"""
        )
        return Counter({str(row["mark"]): int(row["n"]) for row in rows})

    def accept(self, run_id: str) -> None:
        """Confirms a run that cannot be repeated here, as the teacher decided; changes no other run."""
        query = "DELETE FROM unconfirmed_runs WHERE run_id = ? AND finding = 'not_repeatable'"
        self._database.write(lambda db: db.execute(query, [run_id]).rowcount)

    def confirm(self, run_id: str) -> None:
        """Deletes the entry, so that the run counts from now on."""
        query = "DELETE FROM unconfirmed_runs WHERE run_id = ?"
        self._database.write(lambda db: db.execute(query, [run_id]).rowcount)

    def note(self, run_id: str, finding: ConfirmationFinding) -> None:
        """Records why the run stays unconfirmed."""
        query = "UPDATE unconfirmed_runs SET finding = ? WHERE run_id = ?"
        self._database.write(lambda db: db.execute(query, [finding, run_id]).rowcount)
