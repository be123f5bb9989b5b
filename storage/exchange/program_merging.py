"""Bringing in the one program that a group takes along: only what is not here yet, as anybody may do it.

Such a file may say anything. Whatever it says, no row that is here changes, and nothing comes but the program and what
it belongs to: its group, class, lessons and PCs, its versions with their labels, its runs. Notes are the teacher's.
"""

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

from storage.bundle_reading import open_bundle
from storage.bundles import BundleInfo
from storage.connection import Access
from storage.content import (
    CLASSROOMS,
    COMPUTERS,
    EVENTS,
    GROUPS,
    LABELS,
    LESSONS,
    PROGRAMS,
    RUNS,
    TELEMETRY,
    VERSIONS,
    Content,
    columns,
)
from storage.errors import StoreError
from storage.merging import MergeReport, is_new, may_come, of
from storage.opening import connect

_PROGRAM = "(SELECT id FROM bundle.programs)"
# where the program is here already its group is the one that it has here
_GROUP = f"""coalesce((SELECT group_id FROM main.programs WHERE id IN {_PROGRAM}),
    (SELECT group_id FROM bundle.programs))"""
_VERSIONS = f"(SELECT id FROM main.versions WHERE program_id IN {_PROGRAM})"
_WORK = f"""SELECT {{column}} FROM bundle.versions WHERE program_id IN {_PROGRAM}
    UNION SELECT {{column}} FROM bundle.runs WHERE program_id IN {_PROGRAM}"""
_WORKED_IN = _WORK.format(column="lesson_id")
_LESSONS = f"({_WORKED_IN} UNION SELECT part_of FROM bundle.lessons WHERE id IN ({_WORKED_IN}))"
_COMING = "theirs.run_id IN temp.coming"
# what of a bundle is of the program; what refers to a row comes after it
_OF_PROGRAM: tuple[tuple[Content, str], ...] = (
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


def merge_program(access: Access, path: Path) -> tuple[MergeReport, str]:
    """Brings in what is new of a bundle of one program; tells the program's key too.

    Raises:
        StoreError: `bundle_not_program` where it holds more or less, or deletions; else as `merging.merge`.
    """
    with open_bundle(path) as bundle:
        with closing(connect(bundle.address)) as db:
            programs = [str(row["id"]) for row in db.execute("SELECT id FROM programs LIMIT 2")]
            deletes = db.execute("SELECT 1 FROM tombstones LIMIT 1").fetchone()
        if len(programs) != 1 or deletes:
            raise StoreError("bundle_not_program", path=str(path))
        report = access.write(lambda db: _merge(db, bundle.info), attached=bundle.address)
    return report, programs[0]


def _merge(db: sqlite3.Connection, info: BundleInfo) -> MergeReport:
    """Not noted in `merges`: a teacher's merge of the same file brings more."""
    added = {content.table: n for content, n in _added(db)}
    return MergeReport(info, {table: n for table, n in added.items() if n}, {}, {}, {})


def _added(db: sqlite3.Connection) -> Iterator[tuple[Content, int]]:
    db.execute("PRAGMA defer_foreign_keys = ON")
    for content, condition in _OF_PROGRAM:
        yield content, _insert(db, content, f"{condition} AND {may_come(content)}")
    coming = f"{_RUNS} AND {may_come(RUNS)} AND {is_new(RUNS)}"
    db.execute(f"CREATE TEMP TABLE coming AS SELECT id FROM bundle.runs AS theirs WHERE {coming}")
    yield RUNS, _insert(db, RUNS, "theirs.id IN temp.coming")
    for content in (EVENTS, TELEMETRY):
        yield content, _insert(db, content, _COMING)
    db.execute("DROP TABLE temp.coming")


def _insert(db: sqlite3.Connection, content: Content, condition: str) -> int:
    names = columns(db, content.table)
    return db.execute(
        f"INSERT INTO main.{content.table} ({', '.join(names)})"
        f" SELECT {of('theirs', names)} FROM bundle.{content.table} AS theirs"
        f" WHERE ({condition}) AND {is_new(content)} ORDER BY {of('theirs', content.key)}"
    ).rowcount
