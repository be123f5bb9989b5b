"""Merges a bundle into a store: the union of both by key; of two states of one row the newer wins.

The result does not depend on the order: the same bundles give the same store. A bundle that was merged before changes
nothing. A tombstoned row stays deleted, with all rows that belong to it, until a person on any PC retains it
(`deleting/`). The rows that a merge skipped meanwhile come when their bundle is merged again. A merge deletes no row of
the store unless a person confirms it. Each bundle is one transaction: an interrupted merge changes nothing and can be
repeated.

In the SQL `main` is the store and `bundle` the bundle. A row of the store is `ours`, a row of the bundle `theirs`.
"""

from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

from storage.exchange.bundle_merge import TABLES_BEFORE_VERSIONS, BundleMerge
from storage.exchange.bundle_reading import open_bundle
from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.confirmation_tracking import COUNTS_HERE, n_unconfirmed, tracking_unconfirmed
from storage.exchange.deleting.deletion import Deletion, tombstoned_keys
from storage.exchange.deleting.unresolved import record_unresolved
from storage.exchange.merge_report import MergeReport
from storage.file.connection import Database
from storage.sql import insert
from storage.sqlite import sqlite3
from storage.tables.runs import TRUTHS
from storage.tables.work import LABELS, NOTES, VERSIONS
from storage.text import new_id, to_json

_NEWEST_LESSON = """
    SELECT coalesce(part_of, id) FROM main.lessons
    WHERE id IN (SELECT lesson_id FROM bundle.runs UNION SELECT lesson_id FROM bundle.versions)
    ORDER BY opened_at DESC, id DESC LIMIT 1"""


def merge(
    database: Database,
    path: Path,
    *,
    delete: bool = False,
    retained: Collection[str] = (),
    retain_newer: bool = False,
) -> MergeReport:
    """Merges a bundle into the store. The transaction is on disk when this returns.

    Args:
        delete: also deletes the rows of the store that the bundle's tombstones name. `Exchange.merge` deletes
            them from the write-ahead log and the backups.
        retained: with `delete`, keys of groups and programs that are retained in spite of a tombstone.
        retain_newer: with `delete`, also retains groups and programs that were moved to another class. Likewise groups
            and programs with work that the deleting PC did not have.

    Raises:
        StoreError: the bundle is refused (see `open_bundle`), it deletes a run that has not ended
            (`run_in_progress`) or the store cannot be written. Nothing has changed then.
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
            return replace(report, n_unconfirmed=n_unconfirmed(db), lesson_id=_newest_lesson(db))

        return database.write(write, attached=bundle.address)


def _newest_lesson(db: sqlite3.Connection) -> str | None:
    found = db.execute(_NEWEST_LESSON).fetchone()
    return str(found[0]) if found else None


def nonzero(counts: dict[str, int]) -> dict[str, int]:
    """Returns the counts that are not zero."""
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
    """Merges the bundle that is attached as the schema `bundle`, within the caller's transaction; see `merge`.

    Args:
        protected_runs: SQL condition of the runs `ours` that must not change.
    """
    db.execute("PRAGMA defer_foreign_keys = ON")
    merging = BundleMerge(db, delete=delete, protected_runs=protected_runs)
    if _was_merged(db, info) and merging.has_nothing_new():
        _note(db, info, now, {})
        return MergeReport(info, {}, {}, {}, {})
    before = tombstoned_keys(db) if delete else set()
    staying = merging.retain(retained, retain_newer=retain_newer) if delete else ()
    merging.snapshot_memberships()
    merging.merge_tombstones()
    deletion = merging.delete() if delete else Deletion()
    for table in TABLES_BEFORE_VERSIONS:
        merging.rows(table)
    merging.record_former_classes()
    db.execute("DROP TABLE temp.seen")
    for table in (VERSIONS, LABELS):
        merging.rows(table)
    merging.runs()
    merging.rows(NOTES)
    merging.rows(TRUTHS)
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


def _was_merged(db: sqlite3.Connection, info: BundleInfo) -> bool:
    """Returns True if the same content was merged before. Rows that the store lacks were deleted since."""
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
