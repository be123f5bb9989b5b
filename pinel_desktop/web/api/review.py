"""A lesson as its groups went through it, for the teacher."""

from dataclasses import asdict
from typing import Any

from flask import Response

from pinel_desktop.messages import describe
from pinel_desktop.review import (
    BlocksInUse,
    Edit,
    GroupReview,
    GroupWork,
    LessonReview,
    Mark,
    Run,
    review_group,
    review_lesson,
    versions_needed,
)
from pinel_desktop.web.answers import answer, writable
from pinel_desktop.web.api import answers, resource
from pinel_desktop.web.api.classrooms import lesson_model
from pinel_desktop.web.mark_table import mark_table
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models import review as shapes
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher
from storage import GroupLine, GroupLines, LessonLines, LessonRow

api = resource("review", "Lessons as their groups went through them.", __name__)

_CSV = {"content": {"text/csv": {"schema": {"type": "string"}}}}


@api.get("/lessons/<id>/review", responses=answers(shapes.LessonReview, 403, 404))
def get_lesson_review(path: IdPath) -> Response:
    """What the groups did in a lesson and all that were joined to it. For the teacher."""
    require_teacher()
    lesson, lines, review = _read(path.id)
    heads = {group.id: shapes.GroupHead(**group._asdict()) for group in lines.groups}
    words = _reasons(lines)
    groups = [
        shapes.GroupReview(
            group=heads[group.id],
            marks=[_mark(mark, lines, words) for mark in group.marks],
            figures=shapes.Figures(**asdict(group.figures)),
            blocks=_blocks(group.blocks),
        )
        for group in review.groups
    ]
    return answer(shapes.LessonReview(lesson=lesson_model(lesson), groups=groups))


@api.get("/lessons/<id>/review.csv", responses=answers(_CSV, 403, 404))
def get_lesson_table(path: IdPath) -> Response:
    """All marks of a lesson as a table that a spreadsheet opens, one row a mark. For the teacher."""
    require_teacher()
    _, lines, review = _read(path.id)
    table = mark_table(review, lines.computers, _reasons(lines), services().preferences.language)
    disposition = {"Content-Disposition": "attachment; filename=pinel-lesson.csv"}
    return Response(writable(table), mimetype="text/csv", headers=disposition)


def _read(lesson_id: str) -> tuple[LessonRow, LessonLines, LessonReview]:
    """The lesson, its lines and its review; workspaces are read of one group at a time."""
    store = services().store
    lesson = store.lessons.get(lesson_id)
    lines = store.lesson_records.of(store.lessons.parts(lesson_id))
    reviews: list[GroupReview] = []
    for group in lines.groups:
        work = _work(group, lines.work[group.id])
        workspaces = store.lesson_records.workspaces(versions_needed(work))
        reviews.append(review_group(work, workspaces, lesson.activity))
    return lesson, lines, review_lesson(reviews)


def _work(group: GroupLine, lines: GroupLines) -> GroupWork:
    edits = tuple(Edit(**edit._asdict()) for edit in lines.edits)
    fields = Run.__dataclass_fields__
    runs = (Run(**{name: getattr(run, name) for name in fields}) for run in lines.runs)
    return GroupWork(group.id, group.name, edits, tuple(runs))


def _reasons(lines: LessonLines) -> dict[str, str]:
    """Why runs ended, in words, by run."""
    language = services().preferences.language
    runs = (run for work in lines.work.values() for run in work.runs)
    return {
        run.id: describe(run.reason, run.params, language).message for run in runs if run.reason
    }


def _mark(mark: Mark, lines: LessonLines, words: dict[str, str]) -> shapes.ReviewMark:
    run, changes = mark.run, mark.changes
    return shapes.ReviewMark(
        kind="run" if run else "edit",
        at=mark.at,
        until=mark.until,
        computer=lines.computers.get(mark.computer_id or ""),
        program_id=mark.program_id,
        program_name=mark.program_name,
        version_id=mark.version_id,
        number=mark.number,
        n_edits=None if run else mark.n_edits,
        since=mark.since,
        changes=None if changes is None else shapes.ChangeCounts(**asdict(changes)),
        **_of_run(run, words),
        repairs=mark.repairs,
    )


def _of_run(run: Run | None, words: dict[str, str]) -> dict[str, Any]:
    names = ("state", "reason", "activity", "passed", "duration_s")
    if run is None:
        return dict.fromkeys(("run_id", "message", *names))
    values = {name: getattr(run, name) for name in names}
    return {"run_id": run.id, "message": words.get(run.id), **values}


def _blocks(use: BlocksInUse) -> list[shapes.BlockCount]:
    """Types in alphabetical order: how often one is used says nothing about what it is good for."""
    return [
        shapes.BlockCount(type=kind, count=use.attached.get(kind, 0), loose=use.loose.get(kind, 0))
        for kind in sorted({*use.attached, *use.loose})
    ]
