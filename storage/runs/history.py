"""The history: runs of all groups, page by page, filtered by class, group, lesson, activity, world, day and outcome.

The index `runs_history` has all columns of the filters. A page reads it backward until the page is full. If no run
matches, it reads the whole index, which takes some milliseconds for 100,000 runs.
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from storage.file.repository import Repository
from storage.row_types import RunSummary
from storage.run_validity import confirmation_status, counted, masking_damage
from storage.sqlite import sqlite3
from storage.work.lesson_history import GroupSummary

Outcome = Literal["finished", "stopped", "failed", "passed", "not_passed"]
# filter for groups without a class
NO_CLASSROOM = "none"
_PASSED = {"passed": 1, "not_passed": 0}
_COMPUTED = {"passed_bit": counted(), "unconfirmed": confirmation_status()}
_COLUMNS = ", ".join(
    _COMPUTED.get(name) or masking_damage(name.removesuffix("_json")) for name in RunSummary._fields
)
_SELECT = f"""
    SELECT {_COLUMNS}, groups.id, groups.name, groups.color, groups.picture
    FROM runs LEFT JOIN groups ON groups.id = runs.group_id
    WHERE {{which}} ORDER BY runs.id DESC LIMIT ?"""
# the inner query reads the index only, so that other columns are read of matching rows alone
_FITTING = "runs.id IN (SELECT id FROM runs WHERE {which} ORDER BY id DESC LIMIT ?)"


@dataclass(frozen=True, slots=True)
class RunFilter:
    """A filter of runs; None matches all.

    Attributes:
        classroom_id: `NO_CLASSROOM` for groups without one.
        lesson_ids: a lesson with its parts.
        started_from, started_before: bounds of the time at which a run started.
    """

    classroom_id: str | None = None
    group_id: str | None = None
    activity: str | None = None
    world: str | None = None
    lesson_ids: tuple[str, ...] | None = None
    started_from: str | None = None
    started_before: str | None = None
    outcome: Outcome | None = None


class HistoryEntry(NamedTuple):
    """A run with the group that made it, None for runs of the command line."""

    run: RunSummary
    group: GroupSummary | None


class RunHistory(Repository):
    """The runs of the file, newest first."""

    def page(
        self, which: RunFilter, *, before: str | None = None, limit: int = 50
    ) -> list[HistoryEntry]:
        """Returns a page of runs, newest first; `before` is the id of the last run of the previous page."""
        clauses = [("runs.id < ?", before or "~"), *_clauses(which)]
        where = " AND ".join(clause for clause, _ in clauses)
        values = [value for _, value in clauses]
        if len(clauses) > 1:
            where, values = _FITTING.format(which=where), [*values, limit]
        rows = self._rows(_SELECT.format(which=where), *values, limit)
        return [_entry(row) for row in rows]


def _clauses(which: RunFilter) -> Iterator[tuple[str, Any]]:
    # the plus prevents SQLite from using the index of that column, whose result it would have to sort
    if which.classroom_id is not None:
        classroom = None if which.classroom_id == NO_CLASSROOM else which.classroom_id
        yield "+group_id IN (SELECT id FROM groups WHERE classroom_id IS ?)", classroom
    if which.lesson_ids is not None:
        yield "lesson_id IN (SELECT value FROM json_each(?))", json.dumps(which.lesson_ids)
    if which.outcome in _PASSED:
        yield f"+{counted()} IS ?", _PASSED[which.outcome]
    elif which.outcome is not None:
        yield "+state = ?", which.outcome
    for clause, value in (
        ("group_id = ?", which.group_id),
        ("+activity = ?", which.activity),
        ("+world = ?", which.world),
        ("+started_at >= ?", which.started_from),
        ("+started_at < ?", which.started_before),
    ):
        if value is not None:
            yield clause, value


def _entry(row: sqlite3.Row) -> HistoryEntry:
    run, group = row[: len(RunSummary._fields)], row[len(RunSummary._fields) :]
    return HistoryEntry(
        RunSummary._make(run), None if group[0] is None else GroupSummary._make(group)
    )
