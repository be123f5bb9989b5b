"""Who vouches for a bundle, and which of its runs this PC must repeat before their pass counts.

This PC vouches for its own bundles, and PCs that the teacher approved for theirs, but for runs that they name as
unconfirmed themselves. All that comes from others is merged too; a pass among it is marked in `unconfirmed_runs`.

In the SQL `main` is the store and `bundle` the bundle.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal, NamedTuple

from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.signing import own_public_key
from storage.file.connection import Database
from storage.marks import FINDINGS
from storage.sql import column_names, row_count
from storage.sqlite import sqlite3
from storage.tables.runs import EVENTS, RUNS, TELEMETRY
from storage.tables.work import VERSIONS
from storage.work.computers import find_computer

Trust = Literal["own", "approved", "unapproved", "changed_key", "unsigned"]
_VOUCHED_FOR: tuple[Trust, ...] = ("own", "approved")
_UNCONFIRMED = "(SELECT run_id FROM main.unconfirmed_runs)"
# a run that counts as passed, or will be judged by its record: only these need a mark
_COUNTS = "activity IS NOT NULL AND (passed = 1 OR passed IS NULL AND check_report IS NULL)"
_REFERENCES = ("group_id", "program_id", "version_id", "lesson_id", "computer_id")


@dataclass(frozen=True, slots=True)
class Sender:
    """Who wrote a bundle.

    Attributes:
        trust: `changed_key` if the teacher approved this PC with another key.
        public_key: with which it is signed, in hex; None without signature.
    """

    trust: Trust
    public_key: str | None

    @property
    def is_vouched_for(self) -> bool:
        """Whether what it says of passes counts at once."""
        return self.trust in _VOUCHED_FOR


def sender_of(db: sqlite3.Connection, database: Database, info: BundleInfo) -> Sender:
    """Who wrote the bundle, as far as this store knows."""
    key, computer = info.signed_by, find_computer(db)
    if key is None:
        return Sender("unsigned", None)
    if computer and own_public_key(database.path, computer[0], make=False) == key:
        return Sender("own", key)
    approved = {
        str(row[0])
        for row in db.execute(
            "SELECT public_key FROM main.computer_keys WHERE computer_id = ? AND approved_at IS NOT NULL",
            [info.computer_id],
        )
    }
    if key in approved:
        return Sender("approved", key)
    return Sender("changed_key" if approved else "unapproved", key)


class LatestKey(NamedTuple):
    """The key with which a PC signed last."""

    public_key: str | None
    trust: Trust


def latest_key(db: sqlite3.Connection, computer_id: str) -> LatestKey:
    """The key of the bundle of a PC that came last."""
    rows = db.execute(
        """SELECT public_key, approved_at FROM computer_keys WHERE computer_id = ?
           ORDER BY seen_at DESC, public_key""",
        [computer_id],
    ).fetchall()
    if not rows:
        return LatestKey(None, "unsigned")
    key, approved_at = rows[0]
    others: Trust = "changed_key" if any(row[1] for row in rows[1:]) else "unapproved"
    return LatestKey(str(key), "approved" if approved_at else others)


def note_key(db: sqlite3.Connection, info: BundleInfo, now: str) -> None:
    """Keeps the key of a signed bundle, for the teacher to approve."""
    if info.signed_by is not None:
        db.execute(
            """INSERT INTO main.computer_keys (public_key, computer_id, name, seen_at) VALUES (?, ?, ?, ?)
               ON CONFLICT DO UPDATE SET name = excluded.name, seen_at = excluded.seen_at""",
            [info.signed_by, info.computer_id, info.computer_name, now],
        )


def kept_runs(sender: Sender) -> str:
    """Condition: the run `ours` counts here as passed, or is to be judged by its record, and the bundle, for which
    nobody vouches, must not change it."""
    is_cut_off = "ours.state = 'running' OR ours.reason IS 'interrupted'"
    is_to_be_judged = f"ours.passed IS NULL AND ours.check_report IS NULL AND NOT ({is_cut_off})"
    counts = f"ours.activity IS NOT NULL AND (ours.passed IS 1 OR {is_to_be_judged})"
    return "0" if sender.is_vouched_for else f"({counts} AND ours.id NOT IN {_UNCONFIRMED})"


@contextmanager
def marking(
    db: sqlite3.Connection, sender: Sender, now: str, *, by_teacher: bool = True
) -> Iterator[None]:
    """Merge within this: afterwards the runs that came or changed have the marks that they need.

    Args:
        by_teacher: False for a file that pupils bring by themselves, which nobody vouches for.
    """
    is_vouched_for = sender.is_vouched_for and by_teacher
    if is_vouched_for:
        _put_versions_right(db)
        _put_right(db)
    shared = f"SELECT * FROM main.runs WHERE id IN (SELECT id FROM bundle.runs) AND {_COUNTS}"
    db.execute(f"CREATE TEMP TABLE before AS {shared}")
    yield
    db.execute(
        f"CREATE TEMP TABLE came AS SELECT id FROM ({shared} EXCEPT SELECT * FROM temp.before)"
    )
    if is_vouched_for:
        _mark_named(db, now)
    else:
        _mark_all(db, sender.public_key if by_teacher else None, now)
    for name in ("before", "came"):
        db.execute(f"DROP TABLE temp.{name}")


def n_unconfirmed(db: sqlite3.Connection) -> int:
    """How many runs of the bundle have a mark in the store."""
    return row_count(db, "main.unconfirmed_runs", "run_id IN (SELECT id FROM bundle.runs)")


def _mark_all(db: sqlite3.Connection, public_key: str | None, now: str) -> None:
    """Approving the key later vouches for these runs, but not for those that the sender did not vouch for itself."""
    db.execute(
        """INSERT OR REPLACE INTO main.unconfirmed_runs
           SELECT id, CASE WHEN id NOT IN (SELECT run_id FROM bundle.unconfirmed_runs) THEN ? END, ?, NULL
           FROM temp.came""",
        [public_key, now],
    )


def _mark_named(db: sqlite3.Connection, now: str) -> None:
    """Marks what the bundle names as unconfirmed, with the key that it came with first."""
    db.execute(
        f"""INSERT OR IGNORE INTO main.unconfirmed_runs
            SELECT run_id, public_key, ?, CASE WHEN finding IN {FINDINGS} THEN finding END
            FROM bundle.unconfirmed_runs AS named
            WHERE run_id IN temp.came AND NOT EXISTS (SELECT 1 FROM main.computer_keys AS known
                WHERE known.public_key = named.public_key AND known.approved_at IS NOT NULL)""",
        [now],
    )


def _put_versions_right(db: sqlite3.Connection) -> None:
    """Versions of the PC that vouches become as they are in its bundle: a forged copy may have come first."""
    names = column_names(db, VERSIONS.name)
    listed, ours = ", ".join(names), ", ".join(f"ours.{name}" for name in names)
    db.execute(
        f"""UPDATE main.versions AS ours SET ({listed}) =
            (SELECT {listed} FROM bundle.versions AS theirs WHERE theirs.id = ours.id)
            WHERE id IN (SELECT theirs.id FROM bundle.versions AS theirs
                JOIN bundle.bundle AS sender ON sender.computer_id = theirs.computer_id
                WHERE theirs.program_id = ours.program_id)
            AND EXISTS (SELECT {ours} EXCEPT SELECT {listed} FROM bundle.versions AS theirs
                WHERE theirs.id = ours.id)"""
    )


def _put_right(db: sqlite3.Connection) -> None:
    """Marked runs for which the bundle vouches become as they are in it, and lose their mark."""
    same = " AND ".join(f"ours.{name} IS theirs.{name}" for name in _REFERENCES)
    db.execute(
        f"""CREATE TEMP TABLE vouched AS SELECT ours.id
            FROM main.runs AS ours JOIN bundle.runs AS theirs ON theirs.id = ours.id
            WHERE ours.id IN {_UNCONFIRMED} AND {same} AND theirs.state <> 'running'
                AND ours.id NOT IN (SELECT run_id FROM bundle.unconfirmed_runs)"""
    )
    names = column_names(db, RUNS.name)
    listed = ", ".join(names)
    db.execute(
        f"""UPDATE main.runs SET ({listed}) =
            (SELECT {listed} FROM bundle.runs AS theirs WHERE theirs.id = runs.id)
            WHERE id IN temp.vouched"""
    )
    for table in (EVENTS, TELEMETRY):
        columns = ", ".join(column_names(db, table.name))
        db.execute(f"DELETE FROM main.{table.name} WHERE run_id IN temp.vouched")
        db.execute(
            f"""INSERT INTO main.{table.name} ({columns}) SELECT {columns} FROM bundle.{table.name}
                WHERE run_id IN temp.vouched"""
        )
    db.execute("DELETE FROM main.unconfirmed_runs WHERE run_id IN temp.vouched")
    db.execute("DROP TABLE temp.vouched")
