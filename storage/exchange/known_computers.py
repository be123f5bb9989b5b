"""The PCs whose bundles were merged into the store."""

from dataclasses import dataclass

from storage.exchange.signing import fingerprint, own_public_key
from storage.exchange.trust import LatestKey, Trust, latest_key
from storage.file.connection import Database
from storage.sql import rows_of
from storage.sqlite import sqlite3
from storage.work.computers import find_computer


@dataclass(frozen=True, slots=True)
class KnownComputer:
    """A PC whose bundles were merged into the store.

    Attributes:
        n_runs: its runs in the store.
        public_key: with which it signed the bundle that came last; None if none was signed.
        trust: `changed_key` if the teacher approved it with another key; `own` of this PC's own files.
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
        keys = {
            str(row["computer_id"]): _key_of(db, database, str(row["computer_id"])) for row in rows
        }
    return [KnownComputer(**dict(row), **keys[row["computer_id"]]._asdict()) for row in rows]


def _key_of(db: sqlite3.Connection, database: Database, computer_id: str) -> LatestKey:
    """The key of the PC's last bundle; a file that this PC wrote itself needs no approval."""
    key, trust = latest_key(db, computer_id)
    own = find_computer(db)
    is_own = own is not None and own[0] == computer_id and key is not None
    if is_own and own_public_key(database.path, computer_id, make=False) == key:
        trust = "own"
    return LatestKey(key, trust)
