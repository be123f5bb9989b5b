"""Merging a bundle into a store: the union of both by key, of two states of one row the later.

The union does not depend on the order: the same bundles give the same store, and a bundle that was merged before
changes nothing. A row with a tombstone stays deleted, with all that belongs to it, until a person on any PC keeps it
(`deleting/`); of what was skipped meanwhile the rest comes when its bundle is merged again. No row of the store is
deleted because a file says so, unless a person says so too. Each bundle is one transaction: of one that is cut off
nothing is in the store, and it can be merged again.

In the SQL `main` is the store and `bundle` the bundle; a row of the store is called `ours`, one of the bundle `theirs`.
"""

from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

from storage.exchange.bundle_reading import open_bundle
from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.confirmation_tracking import COUNTS_HERE, n_unconfirmed, tracking_unconfirmed
from storage.exchange.deleting.deletion import (
    RETAINED_KEYS,
    TOMBSTONED_KEYS,
    Deletion,
    counts_to_delete,
    delete_tombstoned,
    keys_to_delete,
    names_to_delete,
    purge_keys,
    tombstoned_keys,
    tombstoned_rows,
)
from storage.exchange.deleting.pending import PendingDeletion, PendingWork, pending_work, retain
from storage.exchange.deleting.unresolved import record_unresolved
from storage.exchange.joins import insert_new, is_new, may_merge, qualified_columns, rows_in_both
from storage.exchange.merge_report import MergeReport
from storage.file.connection import Database
from storage.sql import column_names, insert, row_count
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import DELETIONS, FORMER_CLASSES, REPLICATED, TOMBSTONES
from storage.tables.runs import EVENTS, RUNS, TELEMETRY
from storage.tables.work import GROUPS, LABELS, NOTES, TAUGHT_SIGNS, VERSIONS
from storage.text import new_id, to_json

_FIRST = ("revision", "changed_at")
_DECISIONS = (TOMBSTONES, DELETIONS, FORMER_CLASSES)
_WITH_ID = tuple(table for table in REPLICATED if "id" in table.key and table not in _DECISIONS)
_BEFORE_VERSIONS = _WITH_ID[: _WITH_ID.index(VERSIONS)]
# rows that PINEL never changes, with what may follow: a version's number, where made-up ones were mended
_IMMUTABLE = {VERSIONS.name: ("number",), TAUGHT_SIGNS.name: ()}
# for the PC that deleted the class the group was elsewhere: it does not go with it
_HAS_LEFT = f"""ours.classroom_id IN {TOMBSTONED_KEYS} AND theirs.id NOT IN {TOMBSTONED_KEYS} AND EXISTS (
    SELECT 1 FROM main.former_classes
    WHERE group_id = ours.id AND classroom_id = ours.classroom_id AND has_left)"""
_GROUP_HERE = "group_id IN (SELECT id FROM main.groups)"
# what a tombstone would delete: rows that are here, and groups that were in that class
_OURS = " UNION ALL ".join(
    (
        *(f"SELECT id FROM main.{table.name}" for table in _WITH_ID if table.deletable),
        f"SELECT classroom_id FROM main.former_classes WHERE NOT has_left AND {_GROUP_HERE}",
    )
)
_DECIDED = (
    (DELETIONS, f"theirs.turn % 2 OR theirs.id NOT IN ({_OURS})"),
    (TOMBSTONES, f"theirs.id IN {RETAINED_KEYS} OR theirs.id NOT IN ({_OURS})"),
    (
        FORMER_CLASSES,
        f"theirs.has_left OR NOT (theirs.{_GROUP_HERE} AND theirs.classroom_id IN {TOMBSTONED_KEYS})",
    ),
)


def merge(
    database: Database,
    path: Path,
    *,
    delete: bool = False,
    retained: Collection[str] = (),
    retain_newer: bool = False,
) -> MergeReport:
    """Merges a bundle into the store; on disk when this returns.

    Args:
        delete: also deletes from the store what was deleted for good where the bundle is from; not from the
            write-ahead log nor from backups, which `Exchange.merge` does.
        retained: with `delete`, keys of groups and programs that stay nevertheless.
        retain_newer: with `delete`, so does what was moved, or is newer here than where it was deleted.

    Raises:
        StoreError: the bundle is refused (see `open_bundle`), it deletes a run that has not ended
            (`run_in_progress`) or the store cannot be written; nothing has changed.
    """
    with open_bundle(path) as bundle:

        def write(db: sqlite3.Connection) -> MergeReport:
            now = database.now()
            with tracking_unconfirmed(db, now):
                report = merge_attached(
                    db,
                    bundle.info,
                    now,
                    delete=delete,
                    retained=retained,
                    retain_newer=retain_newer,
                    protected_runs=COUNTS_HERE,
                )
            record_unresolved(db, bundle.info, report.would_delete)
            return replace(report, n_unconfirmed=n_unconfirmed(db))

        return database.write(write, attached=bundle.address)


def nonzero(counts: dict[str, int]) -> dict[str, int]:
    """Without zeros."""
    return {table: n for table, n in counts.items() if n > 0}


def merge_attached(
    db: sqlite3.Connection,
    info: BundleInfo,
    now: str,
    *,
    delete: bool,
    retained: Collection[str] = (),
    retain_newer: bool = False,
    protected_runs: str = "0",
) -> MergeReport:
    """The same with the bundle attached as the schema `bundle`, within the caller's transaction.

    Args:
        protected_runs: condition of runs `ours` that must not change.
    """
    db.execute("PRAGMA defer_foreign_keys = ON")
    merging = _BundleMerge(db, delete=delete, protected_runs=protected_runs)
    if _was_merged(db, info) and merging.has_nothing_new():
        _note(db, info, now, {})
        return MergeReport(info, {}, {}, {}, {})
    before = tombstoned_keys(db) if delete else set()
    staying = merging.retain(retained, retain_newer=retain_newer) if delete else ()
    merging.snapshot_memberships()
    merging.merge_tombstones()
    deletion = merging.delete() if delete else Deletion()
    for table in _BEFORE_VERSIONS:
        merging.rows(table)
    merging.record_former_classes()
    db.execute("DROP TABLE temp.seen")
    for table in (VERSIONS, LABELS):
        merging.rows(table)
    merging.runs()
    merging.rows(NOTES)
    _note(db, info, now, merging.added)
    deleted = set(deletion.ids) | (tombstoned_keys(db) - before)
    return MergeReport(
        info,
        nonzero(merging.added),
        nonzero(merging.changed),
        nonzero(merging.skipped),
        deletion.counts,
        None if delete else merging.would_delete(),
        staying,
        tuple(sorted(deleted)) if deletion.counts else (),
        deletion.exports,
    )


class _BundleMerge:
    """One bundle being merged, table by table; counts what becomes of its rows."""

    def __init__(self, db: sqlite3.Connection, *, delete: bool, protected_runs: str = "0") -> None:
        self.added: dict[str, int] = {}
        self.changed: dict[str, int] = {}
        self.skipped: dict[str, int] = {}
        self._db = db
        self._delete = delete
        self._protected_runs = protected_runs
        self._given_up: set[str] = set()

    def has_nothing_new(self) -> bool:
        """Of a bundle that was merged before: nothing was left out that may be wanted now, as something is kept."""
        if self._misses_decisions():
            return False
        others = (table for table in _WITH_ID if table is not VERSIONS)  # versions never change
        missing = (
            *(f"FROM bundle.{table.name} AS theirs WHERE {is_new(table)}" for table in _WITH_ID),
            *(f"{rows_in_both(table)} WHERE {self._is_newer(table)}" for table in others),
        )
        if any(self._db.execute(f"SELECT 1 {rows} LIMIT 1").fetchone() for rows in missing):
            return False
        return self.would_delete() is None

    def merge_tombstones(self) -> None:
        """Joins turns and tombstones; those that would delete rows of the store only when they are to be deleted."""
        for table, deletes_nothing in _DECIDED:
            condition = "1" if self._delete else f"({deletes_nothing})"
            self.added[table.name] = insert_new(self._db, table, condition)
            if table is not TOMBSTONES:
                self.changed[table.name] = self._apply_newer(table, condition)

    def snapshot_memberships(self) -> None:
        """Keeps in mind in which classes groups are and were, here and in the bundle, until they are noted."""
        self._do(
            """CREATE TEMP TABLE seen AS
               SELECT id AS group_id, classroom_id, 1 AS was_here FROM main.groups WHERE classroom_id IS NOT NULL
               UNION SELECT id, classroom_id, id IN (SELECT id FROM main.groups) FROM bundle.groups
               WHERE classroom_id IS NOT NULL"""
        )

    def record_former_classes(self, which: str = "1") -> None:
        """Notes classes in which a group is no more; those that would delete it only when it is to be deleted."""
        spared = (
            ""
            if self._delete
            else f" AND NOT ({_GROUP_HERE} AND classroom_id IN {TOMBSTONED_KEYS})"
        )
        self._do(
            f"""INSERT OR IGNORE INTO main.former_classes SELECT group_id, classroom_id, 0 FROM temp.seen
                WHERE (group_id, classroom_id) NOT IN (SELECT id, coalesce(classroom_id, '') FROM main.groups)
                AND {which}{spared}"""
        )

    def delete(self) -> Deletion:
        """Deletes what is deleted in its later state, and what a person did not keep of a class that stays."""
        self._apply_newer_parents()
        with tombstoned_rows(self._db):
            deletion = delete_tombstoned(self._db, spare_running=True)
        self.record_former_classes("was_here")
        if not self._given_up:
            return deletion
        rest = purge_keys(self._db, self._given_up, spare_running=True)
        counts = {
            table: deletion.counts.get(table, 0) + rest.counts.get(table, 0)
            for table in (*deletion.counts, *rest.counts)
        }
        exports = dict.fromkeys((*deletion.exports, *rest.exports))
        return Deletion((*deletion.ids, *rest.ids), counts, tuple(exports))

    def retain(self, requested: Collection[str], *, retain_newer: bool) -> tuple[PendingWork, ...]:
        """Keeps these of what is to be deleted, and what is newer; tells which."""
        if not requested and not retain_newer:
            return ()
        pending, to_delete = self._dry_run()
        if pending is None:
            return ()
        chosen = {*requested, *(pending.newer if retain_newer else ())}
        staying = tuple(one for one in pending.work if one.id in chosen)
        if staying:
            self._given_up = to_delete - retain(self._db, [one.id for one in staying], to_delete)
        return staying

    def would_delete(self) -> PendingDeletion | None:
        """What a merge with `delete` would delete."""
        return self._dry_run()[0]

    def _dry_run(self) -> tuple[PendingDeletion | None, set[str]]:
        """What would be deleted and the keys of it, found out by a trial that is rolled back."""
        self._do("SAVEPOINT trial")
        try:
            trial = _BundleMerge(self._db, delete=True, protected_runs=self._protected_runs)
            trial.snapshot_memberships()
            trial.merge_tombstones()
            trial._apply_newer_parents()
            with tombstoned_rows(self._db):
                to_delete, counts = keys_to_delete(self._db), counts_to_delete(self._db)
                names = names_to_delete(self._db)
        finally:
            self._do("ROLLBACK TO trial")
            self._do("RELEASE trial")
        if not counts:
            return None, set()
        groups, programs, runs = (counts.get(name, 0) for name in ("groups", "programs", "runs"))
        work = tuple(pending_work(self._db, to_delete))
        return PendingDeletion(groups, programs, runs, names, work), to_delete

    def _apply_newer_parents(self) -> None:
        """Also what belongs to a deleted row in its later state: it is deleted with it."""
        for table in _BEFORE_VERSIONS:
            self.changed[table.name] = self._apply_newer(table, "1")
        self.changed[GROUPS.name] += self._replace(GROUPS, _HAS_LEFT)
        self.record_former_classes("was_here")

    def rows(self, table: ReplicatedTable) -> None:
        """Adds rows that may come and are new, and brings the others to their later state."""
        self._count_skipped(table)
        self.added[table.name] = insert_new(self._db, table, may_merge(table))
        n_changed = self._apply_newer(table, may_merge(table))
        self.changed[table.name] = self.changed.get(table.name, 0) + n_changed

    def runs(self) -> None:
        """Runs with their events and samples: those of the later state, of equal states all."""
        newer, equal = (
            self._is_newer(RUNS),
            f"({self._state_order(RUNS, '=')} AND NOT {self._protected_runs})",
        )
        self._do(f"CREATE TEMP TABLE replaced AS SELECT ours.id {rows_in_both(RUNS)} WHERE {newer}")
        self._do(f"CREATE TEMP TABLE shared AS SELECT ours.id {rows_in_both(RUNS)} WHERE {equal}")
        self._do(
            f"""CREATE TEMP TABLE coming AS
                SELECT theirs.id {rows_in_both(RUNS, "LEFT")}
                WHERE {may_merge(RUNS)} AND (ours.id IS NULL OR {newer} OR {equal})"""
        )
        for table in (EVENTS, TELEMETRY):
            self._do(f"DELETE FROM main.{table.name} WHERE run_id IN temp.replaced")
        self.rows(RUNS)
        for table in (EVENTS, TELEMETRY):
            insert_new(self._db, table, "theirs.run_id IN temp.coming")
            self._apply_newer(table, "theirs.run_id IN temp.shared")
        for name in ("replaced", "shared", "coming"):
            self._do(f"DROP TABLE temp.{name}")

    def _apply_newer(self, table: ReplicatedTable, condition: str) -> int:
        return self._replace(table, f"{self._is_newer(table)} AND {condition}")

    def _replace(self, table: ReplicatedTable, condition: str) -> int:
        """Rows that both have become as they are in the bundle."""
        names = column_names(self._db, table.name)
        keys = f"SELECT {qualified_columns('theirs', table.key)} {rows_in_both(table)} WHERE {condition}"
        same_key = " AND ".join(f"theirs.{name} = {table.name}.{name}" for name in table.key)
        return self._do(
            f"UPDATE main.{table.name} SET ({', '.join(names)}) ="
            f" (SELECT {qualified_columns('theirs', names)} FROM bundle.{table.name} AS theirs WHERE {same_key})"
            f" WHERE ({', '.join(table.key)}) IN ({keys})"
        )

    def _count_skipped(self, table: ReplicatedTable) -> None:
        skipped = f"NOT ({may_merge(table)})"
        self.skipped[table.name] = row_count(self._db, f"bundle.{table.name} AS theirs", skipped)

    def _misses_decisions(self) -> bool:
        """The store does not have a tombstone or turn of the bundle, as what it would delete is still here."""
        newer = f"SELECT 1 {rows_in_both(DELETIONS)} WHERE {self._is_newer(DELETIONS)}"
        new = (
            f"SELECT 1 FROM bundle.{table.name} AS theirs WHERE {is_new(table)}"
            for table in _DECISIONS
        )
        return any(self._db.execute(f"{query} LIMIT 1").fetchone() for query in (newer, *new))

    def _is_newer(self, table: ReplicatedTable) -> str:
        is_newer = self._state_order(table, ">")
        if table.name in _IMMUTABLE:
            return f"({is_newer} AND {self._is_same(table)})"
        if table is not RUNS:
            return is_newer
        return f"((ours.state = 'running' OR {is_newer}) AND NOT {self._protected_runs})"

    def _is_same(self, table: ReplicatedTable) -> str:
        """What was written once: a file that has it otherwise was made up, or is damaged."""
        names = column_names(self._db, table.name)
        fixed = [name for name in names if name not in _IMMUTABLE[table.name]]
        return " AND ".join(f"ours.{name} IS theirs.{name}" for name in fixed)

    def _state_order(self, table: ReplicatedTable, sign: str) -> str:
        """Of two states the one with the greater `later_by`, revision, time and values, in this order, is later."""
        names = column_names(self._db, table.name)
        rest = [name for name in names if name not in (*_FIRST, *table.key)]
        order = [name for name in _FIRST if name in names] + rest
        # not coalesce alone: what stands in for NULL must not be greater than any number ("not judged" and "passed")
        theirs, ours = (
            ", ".join(
                [
                    *(value.format(side=side) for value in table.precedence),
                    *(f"{side}.{name} IS NOT NULL, coalesce({side}.{name}, 0)" for name in order),
                ]
            )
            for side in ("theirs", "ours")
        )
        return f"(({theirs}) {sign} ({ours}))"

    def _do(self, statement: str) -> int:
        return self._db.execute(statement).rowcount


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
        "added": to_json(nonzero(added)),
    }
    same = "computer_id = :computer_id AND checksum = :checksum AND exported_at = :exported_at"
    if db.execute(f"SELECT 1 FROM main.merges WHERE {same}", values).fetchone() is None:
        insert(db, "main.merges", values)
