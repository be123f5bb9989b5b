"""The PCs whose bundles were merged into the store."""

from dataclasses import dataclass

from storage.file.connection import Database
from storage.sql import rows_of


@dataclass(frozen=True, slots=True)
class KnownComputer:
    """A PC whose bundles were merged into the store; `n_runs` are its runs in the store."""

    computer_id: str
    name: str
    exported_at: str
    merged_at: str
    n_runs: int


def known_computers(database: Database) -> list[KnownComputer]:
    """Returns every PC whose bundles were merged, by the time of the last merge, newest first."""
    with database.read_connection() as db:
        rows = rows_of(
            db,
            """SELECT merges.computer_id, coalesce(computers.name, merges.computer_name) AS name,
                      max(merges.exported_at) AS exported_at, max(merges.merged_at) AS merged_at,
                      (SELECT count(*) FROM runs WHERE runs.computer_id = merges.computer_id) AS n_runs
               FROM merges LEFT JOIN computers ON computers.id = merges.computer_id
               GROUP BY merges.computer_id ORDER BY max(merges.merged_at) DESC, merges.computer_id""",
        )
    return [KnownComputer(**dict(row)) for row in rows]
