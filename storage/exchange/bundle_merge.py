"""The steps of a merge, as SQL: `main` is the store, `bundle` the bundle, `ours` and `theirs` are their rows."""

from collections.abc import Collection

from storage.exchange.deleting.deletion import (
    RETAINED_KEYS,
    TOMBSTONED_KEYS,
    Deletion,
    counts_to_delete,
    delete_tombstoned,
    keys_to_delete,
    names_to_delete,
    purge_keys,
    tombstoned_rows,
)
from storage.exchange.deleting.pending import PendingDeletion, PendingWork, pending_work, retain
from storage.exchange.joins import insert_new, is_new, may_merge, qualified_columns, rows_in_both
from storage.sql import column_names, row_count
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import DELETIONS, FORMER_CLASSES, REPLICATED, TOMBSTONES
from storage.tables.runs import EVENTS, RUNS, TELEMETRY
from storage.tables.work import GROUPS, TAUGHT_SIGNS, VERSIONS

_FIRST = ("revision", "changed_at")
_DECISIONS = (TOMBSTONES, DELETIONS, FORMER_CLASSES)
_WITH_ID = tuple(table for table in REPLICATED if "id" in table.key and table not in _DECISIONS)
TABLES_BEFORE_VERSIONS = _WITH_ID[: _WITH_ID.index(VERSIONS)]
# immutable tables, and the columns that may still change: the repair of implausible ids sets numbers
_IMMUTABLE = {VERSIONS.name: ("number",), TAUGHT_SIGNS.name: ()}
# condition: the PC that deleted the class knew that the group had left it, so the group is not deleted
_HAS_LEFT = f"""ours.classroom_id IN {TOMBSTONED_KEYS} AND theirs.id NOT IN {TOMBSTONED_KEYS} AND EXISTS (
    SELECT 1 FROM main.former_classes
    WHERE group_id = ours.id AND classroom_id = ours.classroom_id AND has_left)"""
_GROUP_HERE = "group_id IN (SELECT id FROM main.groups)"
# keys whose tombstone would delete rows of the store, and former classes of groups of the store
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


class BundleMerge:
    """Merges one bundle table by table; counts the rows that it adds, changes and skips."""

    def __init__(self, db: sqlite3.Connection, *, delete: bool, protected_runs: str = "0") -> None:
        self.added: dict[str, int] = {}
        self.changed: dict[str, int] = {}
        self.skipped: dict[str, int] = {}
        self._db = db
        self._delete = delete
        self._protected_runs = protected_runs
        self._given_up: set[str] = set()

    def has_nothing_new(self) -> bool:
        """Returns True if merging this bundle again would change nothing; it was merged before."""
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
        """Merges turns, tombstones and former classes.

        Without `delete`, leaves out the ones that would delete rows of the store.
        """
        for table, deletes_nothing in _DECIDED:
            condition = "1" if self._delete else f"({deletes_nothing})"
            self.added[table.name] = insert_new(self._db, table, condition)
            if table is not TOMBSTONES:
                self.changed[table.name] = self._apply_newer(table, condition)

    def snapshot_memberships(self) -> None:
        """Stores the classes of all groups, in the store and in the bundle, in `temp.seen`.

        `record_former_classes` compares them with the classes after the merge.
        """
        self._do(
            """CREATE TEMP TABLE seen AS
               SELECT id AS group_id, classroom_id, 1 AS was_here FROM main.groups WHERE classroom_id IS NOT NULL
               UNION SELECT id, classroom_id, id IN (SELECT id FROM main.groups) FROM bundle.groups
               WHERE classroom_id IS NOT NULL"""
        )

    def record_former_classes(self, which: str = "1") -> None:
        """Records the classes of `temp.seen` that a group is no longer in.

        Without `delete`, leaves out the deleted classes, since a former class would delete the group too.
        """
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
        """Deletes the tombstoned rows in their newer state, and the rows that a person gave up.

        A retained group retains its class, so the tombstone of the class no longer deletes its other groups.
        The groups that the person did not retain are deleted by their own keys.
        """
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
        """Retains groups and programs that would be deleted, and returns them.

        These are the requested ones and, with `retain_newer`, the newer ones.
        """
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
        """Returns the deletion that a merge with `delete` would make, None for none."""
        return self._dry_run()[0]

    def _dry_run(self) -> tuple[PendingDeletion | None, set[str]]:
        """Returns the deletion that a merge would make, and its keys, from a dry run that is rolled back."""
        self._do("SAVEPOINT trial")
        try:
            trial = BundleMerge(self._db, delete=True, protected_runs=self._protected_runs)
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
        """Applies newer states to tombstoned rows too, since children are deleted with their newer parent."""
        for table in TABLES_BEFORE_VERSIONS:
            self.changed[table.name] = self._apply_newer(table, "1")
        self.changed[GROUPS.name] += self._replace(GROUPS, _HAS_LEFT)
        self.record_former_classes("was_here")

    def rows(self, table: ReplicatedTable) -> None:
        """Adds new rows and applies newer states, except for deleted rows and their children."""
        self._count_skipped(table)
        self.added[table.name] = insert_new(self._db, table, may_merge(table))
        n_changed = self._apply_newer(table, may_merge(table))
        self.changed[table.name] = self.changed.get(table.name, 0) + n_changed

    def runs(self) -> None:
        """Merges runs with their events and samples.

        If the bundle's run is newer, its events and samples replace the stored ones. If both states are equal, the
        store gets the events and samples of both.
        """
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
        """Sets rows that store and bundle both have to the bundle's state; returns their number."""
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
        """Returns True if the store lacks a tombstone, turn or former class of the bundle.

        It lacks one that would delete rows which are still in the store.
        """
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
        """Condition: the immutable columns are equal. If they differ, the file is forged or damaged."""
        names = column_names(self._db, table.name)
        fixed = [name for name in names if name not in _IMMUTABLE[table.name]]
        return " AND ".join(f"ours.{name} IS theirs.{name}" for name in fixed)

    def _state_order(self, table: ReplicatedTable, sign: str) -> str:
        """Condition that orders two states by `precedence`, revision, time and values; the greater is newer."""
        names = column_names(self._db, table.name)
        rest = [name for name in names if name not in (*_FIRST, *table.key)]
        order = [name for name in _FIRST if name in names] + rest
        # coalesce alone would rank NULL as 0: any value must win over NULL ("passed" over "not judged")
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
