"""Pending deletions: finds the work that a merge would delete, and retains it if a person decides so.

Also finds whether the work was moved, or is newer than the version vector of the deleting PC.

In the SQL `main` is the store as it was before the merge, and `bundle` the bundle.
"""

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Any

from storage.sql import tuples
from storage.sqlite import sqlite3
from storage.text import from_json, to_json

_VERSION_VECTORS = """SELECT id, knew FROM main.deletions
    UNION ALL SELECT id, knew FROM bundle.deletions"""
_DELETED_THERE = "SELECT id FROM bundle.tombstones UNION SELECT id FROM main.tombstones"
_GROUPS = """SELECT groups.id, groups.name, classroom_id, coalesce(classrooms.name, '') AS place
    FROM main.groups LEFT JOIN main.classrooms ON classrooms.id = classroom_id ORDER BY place, groups.name, groups.id"""
_PROGRAMS = """SELECT programs.id, programs.name, group_id, groups.name AS place
    FROM main.programs JOIN main.groups ON groups.id = group_id ORDER BY place, programs.name, programs.id"""
_WORK = """SELECT 'edit' AS kind, versions.id, program_id, group_id, coalesce(computer_id, '') AS computer_id
    FROM main.versions JOIN main.programs ON programs.id = program_id
    UNION ALL SELECT 'run', id, program_id, group_id, coalesce(computer_id, '') FROM main.runs"""
# rows retained with a group or program: its class, in the store or in the bundle, and all rows below it
_RETAINED = """
    WITH chosen AS (SELECT value AS id FROM json_each(?)),
         a_program AS (SELECT id, group_id FROM main.programs
                       WHERE id IN (SELECT id FROM chosen) OR group_id IN (SELECT id FROM chosen)),
         a_group AS (SELECT id FROM main.groups
                     WHERE id IN (SELECT id FROM chosen UNION SELECT group_id FROM a_program)),
         a_class AS (SELECT classroom_id AS id FROM main.groups WHERE id IN (SELECT id FROM a_group)
                     UNION SELECT classroom_id FROM bundle.groups WHERE id IN (SELECT id FROM a_group))
    SELECT id FROM a_program UNION SELECT id FROM a_group UNION SELECT id FROM a_class WHERE id IS NOT NULL
    UNION SELECT id FROM main.lessons WHERE classroom_id IN (SELECT id FROM a_class)
    UNION SELECT id FROM main.taught_signs WHERE classroom_id IN (SELECT id FROM a_class)"""


@dataclass(frozen=True, slots=True)
class PendingWork:
    """A group that a merge would delete, or a program whose group stays.

    Attributes:
        kind: `group` or `program`.
        place: name of the class of the group now, or of the group of the program; "" for none.
        is_moved: the group is in another class than on the deleting PC.
        n_new_programs: programs that the deleting PC did not have; likewise edits and runs.
    """

    kind: str
    id: str
    name: str
    place: str
    is_moved: bool
    n_programs: int
    n_runs: int
    n_new_programs: int
    n_new_edits: int
    n_new_runs: int

    @property
    def is_newer(self) -> bool:
        """True if it was moved, or has work that the deleting PC did not have; it is retained by default."""
        return bool(self.is_moved or self.n_new_programs or self.n_new_edits or self.n_new_runs)


@dataclass(frozen=True, slots=True)
class PendingDeletion:
    """The rows that a merge would delete, as numbers.

    `names` has names of classes, groups, lessons, programs, signs and runs, 20 at most. `work` has each group and
    program that can be retained.
    """

    groups: int
    programs: int
    runs: int
    names: tuple[str, ...]
    work: tuple[PendingWork, ...] = ()

    @property
    def newer(self) -> frozenset[str]:
        """Keys of groups and programs that were moved, or are newer here."""
        return frozenset(one.id for one in self.work if one.is_newer)


def pending_work(db: sqlite3.Connection, to_delete: Collection[str]) -> Iterator[PendingWork]:
    """Yields the groups and programs among the keys to delete; the bundle is attached."""
    version_vectors = _version_vectors(db)
    deleted = {str(key) for (key,) in tuples(db, _DELETED_THERE)}
    work = [row for row in tuples(db, _WORK) if row[2] in to_delete or row[3] in to_delete]
    programs = [row for row in tuples(db, _PROGRAMS) if row[0] in to_delete]
    for key, name, classroom_id, place in tuples(db, _GROUPS).fetchall():
        if key in to_delete:
            known = version_vectors.get(key, {}) if key in deleted else {"newest": {}}
            mine = [row for row in work if row[3] == key]
            new_programs = sum(row[2] == key and row[0] not in deleted for row in programs)
            is_moved = known.get("classroom", classroom_id) != classroom_id
            n_programs = sum(row[2] == key for row in programs)
            counts = (n_programs, *_counted(mine, known, new_programs))
            yield PendingWork("group", key, name, place, is_moved, *counts)
    for key, name, group_id, place in programs:
        if group_id not in to_delete:
            mine = [row for row in work if row[2] == key]
            yield PendingWork(
                "program",
                key,
                name,
                place,
                False,
                1,
                *_counted(mine, version_vectors.get(key, {}), 0),
            )


def retain(db: sqlite3.Connection, ids: Collection[str], to_delete: Collection[str]) -> set[str]:
    """Records that groups and programs are retained with their rows, on every PC, until they are deleted again.

    Returns:
        Their keys, the keys of their classes, and of all rows below these.
    """
    retained = {str(key) for (key,) in tuples(db, _RETAINED, (to_json(sorted(ids)),))}
    turns = f"""
        SELECT dead.id, (SELECT max(turn) FROM (SELECT 0 AS turn
                   UNION ALL SELECT turn FROM main.deletions WHERE id = dead.id
                   UNION ALL SELECT turn FROM bundle.deletions WHERE id = dead.id)) AS turn
        FROM ({_DELETED_THERE} UNION SELECT id FROM main.groups WHERE id IN (SELECT value FROM json_each(?))) AS dead
        WHERE dead.id IN (SELECT value FROM json_each(?))"""
    db.execute(
        f"""INSERT INTO main.deletions (id, turn, knew) SELECT id, turn | 1, '{{}}' FROM ({turns}) WHERE 1
            ON CONFLICT (id) DO UPDATE SET turn = excluded.turn""",
        [to_json(sorted(retained.intersection(to_delete))), to_json(sorted(retained))],
    )
    return retained


def _version_vectors(db: sqlite3.Connection) -> dict[str, dict[str, Any]]:
    return {str(key): from_json(text) for key, text in tuples(db, _VERSION_VECTORS)}


def _counted(
    work: list[tuple[Any, ...]], known: dict[str, Any], new_programs: int
) -> tuple[int, int, int, int]:
    """Returns numbers of runs, new programs, new edits and new runs. Earlier releases recorded no vector."""
    newest = known.get("newest")
    new = [
        kind
        for kind, key, _, _, computer_id in work
        if newest is not None and key > newest.get(computer_id, "")
    ]
    n_runs = sum(row[0] == "run" for row in work)
    return n_runs, new_programs, new.count("edit"), new.count("run")
