"""The part of a store that goes into a bundle: all, one class, group or program with its rows, or a lesson file."""

from collections.abc import Iterator
from dataclasses import dataclass

from storage.sql import require
from storage.sqlite import sqlite3
from storage.tables.columns import ReplicatedTable
from storage.tables.replicated import COMPUTERS, DELETIONS, FORMER_CLASSES, REPLICATED, TOMBSTONES
from storage.tables.runs import RUNS
from storage.tables.work import (
    CALIBRATED_ROBOTS,
    CLASS_PRESETS,
    CLASSROOMS,
    GROUPS,
    LESSONS,
    OWN_ACTIVITIES,
    PROGRAMS,
    TAUGHT_SIGNS,
)

# copied last, in this order, and only the rows that copied rows refer to
_REFERRED = (LESSONS, CLASSROOMS, COMPUTERS)
_JOINED = "id IN (SELECT part_of FROM store.lessons WHERE id IN (SELECT id FROM main.lessons))"


# tables whose rows the setups of versions name, by the setup's entry
_NAMED_IN_SETUPS = {OWN_ACTIVITIES.name: "activity", CALIBRATED_ROBOTS.name: "calibrated_robot"}
_OF_SETUPS = """id IN (SELECT json_extract(versions.setup, '$.{entry}') FROM store.versions
    JOIN store.programs ON programs.id = versions.program_id WHERE {condition})"""

_RETAINED_OF_GROUP = """turn % 2 AND id IN (SELECT :group UNION SELECT id FROM store.programs WHERE group_id = :group
    UNION SELECT classroom_id FROM store.groups WHERE id = :group)"""


@dataclass(frozen=True, slots=True)
class Scope:
    """The whole store, or the rows that belong to one class, group or program.

    Attributes:
        lesson_id: given with its class: the rows that other PCs need for this lesson, without work of pupils.
    """

    classroom_id: str | None = None
    group_id: str | None = None
    program_id: str | None = None
    lesson_id: str | None = None

    @property
    def whole(self) -> bool:
        """True for the whole store."""
        return not (self.classroom_id or self.group_id or self.program_id)

    def conditions(self) -> Iterator[tuple[ReplicatedTable, str]]:
        """Yields the condition of the rows to copy from the schema `store` to `main`, table by table.

        A condition may refer to rows that were copied before, and has parameters, see `values`.
        """
        if self.whole:
            yield from ((table, "1") for table in REPLICATED)
            return
        chosen = self._chosen()
        for table in (*(table for table in REPLICATED if table not in _REFERRED), *_REFERRED):
            yield table, chosen.get(table.name) or _belonging(table)
            if table is LESSONS:
                yield table, _JOINED

    def values(self) -> dict[str, str | None]:
        """Returns the parameters of the conditions."""
        return {
            "classroom": self.classroom_id,
            "group": self.group_id,
            "program": self.program_id,
            "lesson": self.lesson_id,
        }

    def require(self, db: sqlite3.Connection) -> None:
        """Raises StoreError KIND`_not_found`."""
        for kind, key in self.values().items():
            if key:
                require(db, f"{kind}s", key)

    def _chosen(self) -> dict[str, str]:
        """Returns the conditions by table that differ from `_belonging`."""
        rows = {
            TOMBSTONES.name: "0",
            DELETIONS.name: "0",
            FORMER_CLASSES.name: "0",
            TAUGHT_SIGNS.name: "0",  # belong to the whole class
            CLASS_PRESETS.name: "0",
            RUNS.name: """(program_id IN (SELECT id FROM main.programs)
                OR program_id IS NULL AND group_id IN (SELECT id FROM main.groups))""",
        }
        if self.program_id:
            of_program = "id IN (SELECT group_id FROM store.programs WHERE id = :program)"
            chosen = {GROUPS.name: of_program, PROGRAMS.name: "id = :program"}
            return rows | chosen | _of_setups("programs.id = :program")
        if self.group_id:
            chosen = {GROUPS.name: "id = :group", DELETIONS.name: _RETAINED_OF_GROUP}
            chosen[FORMER_CLASSES.name] = "group_id = :group"
            return rows | chosen | _of_setups("programs.group_id = :group")
        return rows | self._of_class()

    def _of_class(self) -> dict[str, str]:
        rows = {
            OWN_ACTIVITIES.name: "1",
            CALIBRATED_ROBOTS.name: "1",
            CLASS_PRESETS.name: "id = :classroom",
            GROUPS.name: "classroom_id = :classroom",
            TAUGHT_SIGNS.name: "classroom_id = :classroom",
            LESSONS.name: f"(classroom_id = :classroom OR {_belonging(LESSONS)})",
            CLASSROOMS.name: f"(id = :classroom OR {_belonging(CLASSROOMS)})",
        }
        if self.lesson_id:
            return rows | {PROGRAMS.name: "0", RUNS.name: "0", LESSONS.name: "id = :lesson"}
        return rows | dict.fromkeys((TOMBSTONES.name, DELETIONS.name, FORMER_CLASSES.name), "1")


ALL = Scope()


def _of_setups(condition: str) -> dict[str, str]:
    """Returns the conditions of the rows that the setups of the given programs name."""
    return {
        table: _OF_SETUPS.format(entry=entry, condition=condition)
        for table, entry in _NAMED_IN_SETUPS.items()
    }


def _belonging(table: ReplicatedTable) -> str:
    """Condition: the row's parents were copied; for `_REFERRED`: copied rows refer to the row."""
    if table not in _REFERRED:
        return " AND ".join(
            f"{column} IN (SELECT id FROM main.{parent})" for column, parent in table.parents
        )
    references = [
        f"SELECT {column.name} FROM main.{other.name}"
        for other in REPLICATED
        for column in other.columns
        if column.references == table.name and other is not table
    ]
    return f"id IN ({' UNION '.join(references)})"
