"""Merging a bundle into a store: the union of both by key, of two states of one row the later.

The union does not depend on the order: the same bundles give the same store, and a bundle that was merged before
changes nothing. A row with a tombstone stays deleted, with all that belongs to it. No row of the store is
deleted because a file says so, unless a person says so too. Each bundle is one transaction: of one that is cut off
nothing is in the store, and it can be merged again.

In the SQL `main` is the store and `bundle` the bundle; a row of the store is called `ours`, one of the bundle `theirs`.
"""

from dataclasses import dataclass, replace
from pathlib import Path

from storage.exchange.bundle_reading import open_bundle
from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.deletion import (
    Deletion,
    Exported,
    PendingDeletion,
    add_tombstones_below,
    pending_deletion,
    remove_keys,
    tombstones,
)
from storage.exchange.signing import fingerprint
from storage.exchange.trust import (
    Sender,
    Trust,
    kept_runs,
    latest_key,
    marking,
    n_unconfirmed,
    note_key,
    sender_of,
)
from storage.file.connection import Database
from storage.sql import column_names, insert, row_count
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import REPLICATED, TOMBSTONES
from storage.tables.runs import EVENTS, RUNS, TELEMETRY
from storage.tables.work import LABELS, NOTES, VERSIONS
from storage.text import dumped, new_id

_FIRST = ("revision", "changed_at")
_DEAD = "(SELECT id FROM main.tombstones)"
_WITH_ID = tuple(table for table in REPLICATED if "id" in table.key and table is not TOMBSTONES)
_BEFORE_VERSIONS = _WITH_ID[: _WITH_ID.index(VERSIONS)]
_OURS = " UNION ALL ".join(
    f"SELECT id FROM main.{table.name}" for table in _WITH_ID if table.deletable
)


@dataclass(frozen=True, slots=True)
class MergeReport:
    """What a merge did: numbers of rows by table, without zeros.

    Attributes:
        added: rows that were not in the store.
        changed: rows of which the bundle had a later state.
        skipped: rows that were left out, as they or what they belong to was deleted from the store.
        removed: rows of the store that were deleted, as the bundle has tombstones for them.
        would_delete: rows of the store that a merge with `delete` would delete, None where it was done or for nothing.
        tombstones: keys of what was deleted; backups are to lose the same.
        exports: files that were written from this store and may still hold it.
        still_in: backups that could not be written anew, and may hold it.
        sender: who wrote it, as far as the store knows.
        n_unconfirmed: runs of it whose pass does not count here yet.
    """

    info: BundleInfo
    added: dict[str, int]
    changed: dict[str, int]
    skipped: dict[str, int]
    removed: dict[str, int]
    would_delete: PendingDeletion | None = None
    tombstones: tuple[str, ...] = ()
    exports: tuple[Exported, ...] = ()
    still_in: tuple[Path, ...] = ()
    sender: Sender | None = None
    n_unconfirmed: int = 0

    @property
    def left_in(self) -> list[str]:
        """Files that people have to delete by hand, as they may hold what was deleted."""
        return [one.path for one in self.exports] + [str(path) for path in self.still_in]

    @property
    def fingerprint(self) -> str | None:
        """What people compare of the key of the PC that signed it."""
        return self.info.signed_by and fingerprint(self.info.signed_by)

    @property
    def nothing_new(self) -> bool:
        """All of it was in the store already, or was deleted from it."""
        return not (self.added or self.changed or self.removed or self.would_delete)


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


def merge(database: Database, path: Path, *, delete: bool = False) -> MergeReport:
    """Merges a bundle into the store; on disk when this returns.

    Args:
        delete: also deletes from the store what was deleted for good where the bundle is from; not from the
            write-ahead log nor from backups, which `Exchange.merge` does.

    Raises:
        StoreError: the bundle is refused (see `open_bundle`), it deletes a run that has not ended
            (`run_in_progress`) or the store cannot be written; nothing has changed.
    """
    with open_bundle(path) as bundle:

        def write(db: sqlite3.Connection) -> MergeReport:
            sender, now = sender_of(db, database, bundle.info), database.now()
            note_key(db, bundle.info, now)
            with marking(db, sender, now):
                report = merge_attached(
                    db, bundle.info, now, delete=delete, kept_runs=kept_runs(sender)
                )
            return replace(report, sender=sender, n_unconfirmed=n_unconfirmed(db))

        return database.write(write, attached=bundle.address)


def known_computers(database: Database) -> list[KnownComputer]:
    """Every PC that bundles were from, the one whose bundle was merged last first."""
    with database.reading() as db:
        rows = db.execute(
            """SELECT merges.computer_id, coalesce(computers.name, merges.computer_name) AS name,
                      max(merges.exported_at) AS exported_at, max(merges.merged_at) AS merged_at,
                      (SELECT count(*) FROM runs WHERE runs.computer_id = merges.computer_id) AS n_runs
               FROM merges LEFT JOIN computers ON computers.id = merges.computer_id
               GROUP BY merges.computer_id ORDER BY max(merges.merged_at) DESC, merges.computer_id"""
        ).fetchall()
        keys = {str(row["computer_id"]): latest_key(db, str(row["computer_id"])) for row in rows}
    return [KnownComputer(**dict(row), **keys[row["computer_id"]]._asdict()) for row in rows]


def insert_new(db: sqlite3.Connection, table: ReplicatedTable, condition: str) -> int:
    """Adds the rows of the bundle that meet the condition and whose key the store does not have; tells how many."""
    names = column_names(db, table.name)
    return db.execute(
        f"INSERT INTO main.{table.name} ({', '.join(names)})"
        f" SELECT {_of('theirs', names)} FROM bundle.{table.name} AS theirs"
        f" WHERE ({condition}) AND {is_new(table)} ORDER BY {_of('theirs', table.key)}"
    ).rowcount


def is_new(table: ReplicatedTable) -> str:
    """Condition: the store has no row of this key."""
    return f"NOT EXISTS (SELECT 1 FROM main.{table.name} AS ours WHERE {_same_key(table)})"


def may_merge(table: ReplicatedTable) -> str:
    """Condition: neither the row nor what it belongs to is deleted; a bundle holds what its rows belong to."""
    parents = [
        f"(theirs.{column} IS NULL OR EXISTS (SELECT 1 FROM main.{parent} WHERE id = theirs.{column}))"
        for column, parent in table.parents
    ]
    return " AND ".join([f"theirs.id NOT IN {_DEAD}", *parents])


def some(counts: dict[str, int]) -> dict[str, int]:
    """Without zeros."""
    return {table: n for table, n in counts.items() if n > 0}


def merge_attached(
    db: sqlite3.Connection, info: BundleInfo, now: str, *, delete: bool, kept_runs: str = "0"
) -> MergeReport:
    """The same with the bundle attached as the schema `bundle`, within the caller's transaction.

    Args:
        kept_runs: condition of runs `ours` that must not change.
    """
    merging = _Merging(db, delete=delete, kept_runs=kept_runs)
    if _was_merged(db, info):
        would_delete = merging.would_delete()
        if not (would_delete and delete):
            _note(db, info, now, {})
            merging.count_skipped()
            return MergeReport(info, {}, {}, some(merging.skipped), {}, would_delete)
    db.execute("PRAGMA defer_foreign_keys = ON")
    before = tombstones(db) if delete else set()
    merging.tombstones()
    for table in _BEFORE_VERSIONS:
        merging.add_tombstones_below(table)
        merging.rows(table)
    deletion = remove_keys(db, (), spare_running=True) if delete else Deletion()
    for table in (VERSIONS, LABELS):
        merging.rows(table)
    merging.runs()
    merging.rows(NOTES)
    _note(db, info, now, merging.added)
    return MergeReport(
        info,
        some(merging.added),
        some(merging.changed),
        some(merging.skipped),
        deletion.counts,
        None if delete else merging.would_delete(),
        tuple(sorted(tombstones(db) - before)) if deletion.counts else (),
        deletion.exports,
    )


class _Merging:
    """One bundle being merged, table by table; counts what becomes of its rows."""

    def __init__(self, db: sqlite3.Connection, *, delete: bool, kept_runs: str = "0") -> None:
        self.added: dict[str, int] = {}
        self.changed: dict[str, int] = {}
        self.skipped: dict[str, int] = {}
        self._db = db
        self._delete = delete
        self._kept_runs = kept_runs

    def tombstones(self) -> None:
        """Adds the tombstones; those of rows in the store only when they are to be deleted."""
        kept = "" if self._delete else f" WHERE id NOT IN ({_OURS})"
        self.added["tombstones"] = self._do(
            f"INSERT OR IGNORE INTO main.tombstones SELECT id FROM bundle.tombstones{kept}"
        )

    def add_tombstones_below(self, table: ReplicatedTable) -> None:
        """A row whose parent, in its later state, is deleted gets a tombstone of its own."""
        of_ours = f" OR {self._is_later(table)}" if self._delete else ""
        for column, _ in table.parents:
            self._do(
                f"INSERT OR IGNORE INTO main.tombstones SELECT theirs.id {_both(table, 'LEFT')}"
                f" WHERE theirs.{column} IN {_DEAD} AND (ours.id IS NULL{of_ours})"
            )

    def would_delete(self) -> PendingDeletion | None:
        """What a merge with `delete` would delete, found out by a trial that is rolled back."""
        self._do("SAVEPOINT trial")
        try:
            self._do(
                "INSERT OR IGNORE INTO main.tombstones"
                f" SELECT id FROM bundle.tombstones WHERE id IN ({_OURS})"
            )
            trial = _Merging(self._db, delete=True)
            for table in _BEFORE_VERSIONS:
                trial.add_tombstones_below(table)
            add_tombstones_below(self._db)
            return pending_deletion(self._db)
        finally:
            self._do("ROLLBACK TO trial")
            self._do("RELEASE trial")

    def rows(self, table: ReplicatedTable) -> None:
        """Adds rows that may come and are new, and brings the others to their later state."""
        self._count_skipped(table)
        self.added[table.name] = insert_new(self._db, table, may_merge(table))
        self.changed[table.name] = self._bring_forward(table, may_merge(table))

    def runs(self) -> None:
        """Runs with their events and samples: those of the later state, of equal states all."""
        later, equal = (
            self._is_later(RUNS),
            f"({self._compared(RUNS, '=')} AND NOT {self._kept_runs})",
        )
        self._do(f"CREATE TEMP TABLE replaced AS SELECT ours.id {_both(RUNS)} WHERE {later}")
        self._do(f"CREATE TEMP TABLE shared AS SELECT ours.id {_both(RUNS)} WHERE {equal}")
        self._do(
            f"""CREATE TEMP TABLE coming AS
                SELECT theirs.id {_both(RUNS, "LEFT")}
                WHERE {may_merge(RUNS)} AND (ours.id IS NULL OR {later} OR {equal})"""
        )
        for table in (EVENTS, TELEMETRY):
            self._do(f"DELETE FROM main.{table.name} WHERE run_id IN temp.replaced")
        self.rows(RUNS)
        for table in (EVENTS, TELEMETRY):
            insert_new(self._db, table, "theirs.run_id IN temp.coming")
            self._bring_forward(table, "theirs.run_id IN temp.shared")
        for name in ("replaced", "shared", "coming"):
            self._do(f"DROP TABLE temp.{name}")

    def count_skipped(self) -> None:
        """Counts the rows that are left out, for a bundle of which nothing is merged."""
        for table in _WITH_ID:
            self._count_skipped(table)

    def _bring_forward(self, table: ReplicatedTable, condition: str) -> int:
        names = column_names(self._db, table.name)
        later = f"SELECT {_of('theirs', table.key)} {_both(table)} WHERE {self._is_later(table)} AND {condition}"
        same_key = " AND ".join(f"theirs.{name} = {table.name}.{name}" for name in table.key)
        return self._do(
            f"UPDATE main.{table.name} SET ({', '.join(names)}) ="
            f" (SELECT {_of('theirs', names)} FROM bundle.{table.name} AS theirs WHERE {same_key})"
            f" WHERE ({', '.join(table.key)}) IN ({later})"
        )

    def _count_skipped(self, table: ReplicatedTable) -> None:
        skipped = f"NOT ({may_merge(table)})"
        self.skipped[table.name] = row_count(self._db, f"bundle.{table.name} AS theirs", skipped)

    def _is_later(self, table: ReplicatedTable) -> str:
        is_later = self._compared(table, ">")
        if table is not RUNS:
            return is_later
        return f"((ours.state = 'running' OR {is_later}) AND NOT {self._kept_runs})"

    def _compared(self, table: ReplicatedTable, sign: str) -> str:
        """Of two states the one with the greater `later_by`, revision, time and values, in this order, is later."""
        names = column_names(self._db, table.name)
        rest = [name for name in names if name not in (*_FIRST, *table.key)]
        order = [name for name in _FIRST if name in names] + rest
        # not coalesce alone: what stands in for NULL must not be greater than any number ("not judged" and "passed")
        theirs, ours = (
            ", ".join(
                [
                    *(value.format(side=side) for value in table.later_by),
                    *(f"{side}.{name} IS NOT NULL, coalesce({side}.{name}, 0)" for name in order),
                ]
            )
            for side in ("theirs", "ours")
        )
        return f"(({theirs}) {sign} ({ours}))"

    def _do(self, statement: str) -> int:
        return self._db.execute(statement).rowcount


def _both(table: ReplicatedTable, kind: str = "") -> str:
    return f"FROM bundle.{table.name} AS theirs {kind} JOIN main.{table.name} AS ours ON {_same_key(table)}"


def _same_key(table: ReplicatedTable) -> str:
    return " AND ".join(f"ours.{name} = theirs.{name}" for name in table.key)


def _of(side: str, names: tuple[str, ...]) -> str:
    return ", ".join(f"{side}.{name}" for name in names)


def _was_merged(db: sqlite3.Connection, info: BundleInfo) -> bool:
    """The same content was merged before. Rows of it that the store lacks were deleted since."""
    found = db.execute("SELECT 1 FROM main.merges WHERE checksum = ?", [info.content_hash])
    return found.fetchone() is not None


def _note(db: sqlite3.Connection, info: BundleInfo, now: str, added: dict[str, int]) -> None:
    values = {
        "id": new_id(),
        "computer_id": info.computer_id,
        "computer_name": info.computer_name,
        "file": info.path.name,
        "checksum": info.content_hash,
        "exported_at": info.exported_at,
        "merged_at": now,
        "added": dumped(some(added)),
    }
    same = "computer_id = :computer_id AND checksum = :checksum AND exported_at = :exported_at"
    if db.execute(f"SELECT 1 FROM main.merges WHERE {same}", values).fetchone() is None:
        insert(db, "main.merges", values)
