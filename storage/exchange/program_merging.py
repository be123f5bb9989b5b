"""Merges what a group took along: one program, or all of the group. This needs no PIN, so it only adds rows.

Anybody may have changed the file. So no row of the store changes. The merge only adds the programs, their versions with
their labels, their runs, and the rows that they belong to: the group, its class, lessons and PCs. Notes are left
out, because they are the teacher's. A pass of these runs does not count until this PC has repeated the run
(`confirmation_tracking.py`).
"""

from contextlib import closing
from dataclasses import replace
from pathlib import Path

from storage.errors import StoreError
from storage.exchange.bundle_reading import open_bundle
from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.confirmation_tracking import n_unconfirmed, tracking_unconfirmed
from storage.exchange.joins import insert_new, is_new, may_merge
from storage.exchange.merge_report import MergeReport
from storage.exchange.merging import nonzero
from storage.file.connection import Database
from storage.file.opening import connect
from storage.limits import MAX_SAMPLES_WITHOUT_PIN
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import COMPUTERS
from storage.tables.runs import EVENTS, RUNS, TELEMETRY, TRUTHS
from storage.tables.work import CLASSROOMS, GROUPS, LABELS, LESSONS, PROGRAMS, VERSIONS

_PROGRAM = "(SELECT id FROM bundle.programs)"
# programs that the store has already stay in their group of the store
_GROUP = f"""coalesce((SELECT group_id FROM main.programs WHERE id IN {_PROGRAM}),
    (SELECT group_id FROM bundle.programs))"""
_VERSIONS = f"(SELECT id FROM main.versions WHERE program_id IN {_PROGRAM})"
_WORK = f"""SELECT {{column}} FROM bundle.versions WHERE program_id IN {_PROGRAM}
    UNION SELECT {{column}} FROM bundle.runs WHERE program_id IN {_PROGRAM}"""
_WORKED_IN = _WORK.format(column="lesson_id")
_LESSONS = f"({_WORKED_IN} UNION SELECT part_of FROM bundle.lessons WHERE id IN ({_WORKED_IN}))"
# rows of the bundle that belong to the programs, parents before children
_OF_PROGRAM: tuple[tuple[ReplicatedTable, str], ...] = (
    (
        COMPUTERS,
        f"theirs.id IN ({_WORK.format(column='computer_id')}"
        f" UNION SELECT computer_id FROM bundle.lessons WHERE id IN {_LESSONS})",
    ),
    (
        CLASSROOMS,
        f"theirs.id IN (SELECT classroom_id FROM bundle.groups WHERE id = {_GROUP}"
        f" UNION SELECT classroom_id FROM bundle.lessons WHERE id IN {_LESSONS})",
    ),
    (GROUPS, f"theirs.id = {_GROUP}"),
    (LESSONS, f"theirs.id IN {_LESSONS}"),
    (PROGRAMS, "1"),
    (VERSIONS, f"theirs.program_id IN {_PROGRAM}"),
    (LABELS, f"theirs.id IN {_VERSIONS}"),
)
_RUNS = f"""theirs.program_id IN {_PROGRAM} AND theirs.group_id = {_GROUP}
    AND (theirs.version_id IS NULL OR theirs.version_id IN {_VERSIONS})"""


def merge_program(database: Database, path: Path) -> tuple[MergeReport, str]:
    """Adds the new rows of a bundle with programs of one group.

    Returns the report, and the key of the newest program, which is one outside the bin if there is any.

    Raises:
        StoreError: `bundle_not_program` if it has no program, programs of several groups, or deletions; else as
            `merging.merge`.
    """
    with open_bundle(path, max_samples=MAX_SAMPLES_WITHOUT_PIN) as bundle:
        with closing(connect(bundle.address)) as db:
            programs = db.execute(
                """SELECT coalesce(max(CASE WHEN deleted_at IS NULL THEN id END), max(id)) AS id
                   FROM programs GROUP BY group_id"""
            ).fetchall()
            deletes = db.execute("SELECT 1 FROM tombstones LIMIT 1").fetchone()
        if len(programs) != 1 or deletes:
            raise StoreError("bundle_not_program", path=str(path))

        def write(db: sqlite3.Connection) -> MergeReport:
            with tracking_unconfirmed(db, database.now(), replaces_refuted=False):
                report = _merge(db, bundle.info)
            return replace(report, n_unconfirmed=n_unconfirmed(db))

        report = database.write(write, attached=bundle.address)
    return report, str(programs[0]["id"])


def _merge(db: sqlite3.Connection, info: BundleInfo) -> MergeReport:
    """Adds the rows. `merges` gets no entry, because a teacher's merge of the same file adds more."""
    db.execute("PRAGMA defer_foreign_keys = ON")
    added = {
        table.name: insert_new(db, table, f"({condition}) AND {may_merge(table)}")
        for table, condition in _OF_PROGRAM
    }
    coming = f"{_RUNS} AND {may_merge(RUNS)} AND {is_new(RUNS)}"
    db.execute(f"CREATE TEMP TABLE coming AS SELECT id FROM bundle.runs AS theirs WHERE {coming}")
    added[RUNS.name] = insert_new(db, RUNS, "theirs.id IN temp.coming")
    for table in (EVENTS, TELEMETRY, TRUTHS):
        added[table.name] = insert_new(db, table, "theirs.run_id IN temp.coming")
    db.execute("DROP TABLE temp.coming")
    return MergeReport(info, nonzero(added), {}, {}, {})
