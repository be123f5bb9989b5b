"""Reads all work of a lesson for its review, without worlds, paths and programs. Workspaces are read separately."""

import json
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from storage.file.repository import Repository
from storage.run_validity import confirmation_status, counted, masking_damage
from storage.sql import rows_of, setup_value
from storage.text import readable_object
from storage.work.versions import SETUP_ONLY

_IN = "IN (SELECT value FROM json_each(?))"
_EDITS = f"""
    SELECT programs.group_id, versions.id, versions.program_id, programs.name, versions.number, versions.created_at,
           versions.computer_id, versions.parent_id, coalesce({setup_value("versions.setup", "n_hints")}, 0),
           {SETUP_ONLY}, versions.lesson_id, {setup_value("versions.setup", "activity")}
    FROM versions JOIN programs ON programs.id = versions.program_id
        LEFT JOIN versions AS parents ON parents.id = versions.parent_id
    WHERE versions.lesson_id {_IN} ORDER BY versions.id"""
_RUNS = f"""
    SELECT runs.group_id, runs.id, runs.program_id, runs.program_name, runs.version_id, versions.number,
           runs.started_at, runs.ended_at, {masking_damage("state")}, {masking_damage("reason")},
           {masking_damage("params")},
           runs.activity, {counted()},
           runs.duration_s, runs.computer_id, runs.lesson_id, runs.world, runs.link, runs.block,
           CASE WHEN runs.passed = 0 AND json_valid(runs.check_report)
                THEN (SELECT json_group_array(json(json_extract(value, '$.advice')))
                FROM json_each(runs.check_report, '$.cases')) END,
           {confirmation_status()}
    FROM runs LEFT JOIN versions ON versions.id = runs.version_id
    WHERE runs.lesson_id {_IN} AND runs.group_id IS NOT NULL ORDER BY runs.id"""


class GroupSummary(NamedTuple):
    """A group as a list shows it."""

    id: str
    name: str
    color: str
    picture: str


class EditSummary(NamedTuple):
    """A version that was saved in a lesson, without its content.

    Attributes:
        setup_only: 1 if it has the blocks of its parent, else 0.
        activity: the activity that the program is for.
    """

    version_id: str
    program_id: str
    program_name: str
    number: int
    at: str
    computer_id: str | None
    parent_id: str | None
    n_hints: int
    setup_only: int
    lesson_id: str
    activity: str | None


class LessonRun(NamedTuple):
    """A run of a lesson. JSON is parsed on access.

    Attributes:
        advice_json: list of the advice about each case of a run that did not pass, null for a case that passed.
        unconfirmed: as in `RunSummary`.
    """

    id: str
    program_id: str | None
    program_name: str | None
    version_id: str | None
    number: int | None
    at: str
    ended_at: str | None
    state: str
    reason: str | None
    params_json: str | None
    activity: str | None
    passed_bit: int | None
    duration_s: float | None
    computer_id: str | None
    lesson_id: str
    world: str
    link: str
    block: str | None
    advice_json: str | None
    unconfirmed: str | None

    @property
    def params(self) -> dict[str, Any]:
        """Parameters of the reason's message."""
        return readable_object(self.params_json) or {}

    @property
    def passed(self) -> bool | None:
        """Whether it passed the activity; None without activity, if it was not judged, and while it does not count."""
        return None if self.passed_bit is None else bool(self.passed_bit)


@dataclass(slots=True)
class GroupHistory:
    """The work of one group: edits and runs."""

    edits: list[EditSummary] = field(default_factory=list)
    runs: list[LessonRun] = field(default_factory=list)


@dataclass(slots=True)
class LessonHistory:
    """The work of all groups in a lesson.

    Attributes:
        groups: the groups that worked in it.
        work: the work of each group, by its key.
        computers: names of PCs by their key.
    """

    groups: list[GroupSummary]
    work: dict[str, GroupHistory]
    computers: dict[str, str]


class LessonHistories(Repository):
    """The work in lessons."""

    def of(self, lesson_ids: Collection[str]) -> LessonHistory:
        """Returns edits and runs of all the lessons together."""
        lessons = json.dumps(list(lesson_ids))
        work: dict[str, GroupHistory] = {}
        with self._database.read_connection() as db:
            for group_id, *edit in rows_of(db, _EDITS, [lessons]):
                work.setdefault(group_id, GroupHistory()).edits.append(EditSummary(*edit))
            for group_id, *run in rows_of(db, _RUNS, [lessons]):
                work.setdefault(group_id, GroupHistory()).runs.append(LessonRun(*run))
            query = f"SELECT id, name, color, picture FROM groups WHERE id {_IN}"
            groups = rows_of(db, query, [json.dumps(list(work))])
            computers = rows_of(db, "SELECT id, name FROM computers")
        return LessonHistory(
            [GroupSummary(*row) for row in groups], work, dict(map(tuple, computers))
        )

    def workspaces(self, version_ids: Iterable[str]) -> dict[str, Any]:
        """Returns workspaces by version, without missing and damaged ones."""
        query = f"SELECT id, workspace FROM versions WHERE id {_IN}"
        rows = self._rows(query, json.dumps(list(version_ids)))
        found = {row["id"]: readable_object(row["workspace"]) for row in rows}
        return {key: workspace for key, workspace in found.items() if workspace is not None}
