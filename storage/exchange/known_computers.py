"""The PCs whose bundles were merged into the store."""

from dataclasses import dataclass

from storage.exchange.signing import fingerprint
from storage.exchange.trust import Trust, latest_key
from storage.file.connection import Database
from storage.sql import rows_of


@dataclass(frozen=True, slots=True)
class KnownComputer:
    """A PC whose bundles were merged into the store.

    Attributes:
        n_runs: its runs in the store.
        public_key: with which it signed the bundle that came last; None if none was signed.
        trust: `changed_key` if the teacher approved it with another key.
    """

    computer_id: str
    name: str
    exported_at: str
    merged_at: str
    n_runs: int
    public_key: str | None
    trust: Trust

    @property
    def fingerprint(self) -> str | None:
        """What people compare of its key."""
        return self.public_key and fingerprint(self.public_key)


def known_computers(database: Database) -> list[KnownComputer]:
    """Every PC that bundles were from, the one whose bundle was merged last first."""
    with database.reading() as db:
        rows = rows_of(
            db,
            """SELECT merges.computer_id, coalesce(computers.name, merges.computer_name) AS name,
                      max(merges.exported_at) AS exported_at, max(merges.merged_at) AS merged_at,
                      (SELECT count(*) FROM runs WHERE runs.computer_id = merges.computer_id) AS n_runs
               FROM merges LEFT JOIN computers ON computers.id = merges.computer_id
               GROUP BY merges.computer_id ORDER BY max(merges.merged_at) DESC, merges.computer_id""",
        )
        keys = {str(row["computer_id"]): latest_key(db, str(row["computer_id"])) for row in rows}
    return [KnownComputer(**dict(row), **keys[row["computer_id"]]._asdict()) for row in rows]
