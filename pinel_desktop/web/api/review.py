"""A lesson as its groups went through it, for the teacher.

What reads it is imported when a teacher asks: the page is drawn before.
"""

from flask import Response

from pinel_desktop.web.api import TEACHER, answers, resource
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.review import LessonReview
from pinel_desktop.web.responses import answer, writable
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher

api = resource("review", "Lessons as their groups went through them.", __name__)

_CSV = {"content": {"text/csv": {"schema": {"type": "string"}}}}


@api.get("/lessons/<id>/review", responses=answers(LessonReview, *TEACHER, "lesson_not_found"))
def get_lesson_review(path: IdPath) -> Response:
    """What the groups did in a lesson and all that were joined to it. For the teacher."""
    from pinel_desktop.web.lesson_review import read_lesson  # noqa: PLC0415 - see above

    require_teacher()
    return answer(read_lesson(path.id, services()).model())


@api.get("/lessons/<id>/review.csv", responses=answers(_CSV, *TEACHER, "lesson_not_found"))
def get_lesson_table(path: IdPath) -> Response:
    """All marks of a lesson as a table that a spreadsheet opens, one row a mark. For the teacher."""
    from pinel_desktop.web.lesson_review import read_lesson  # noqa: PLC0415 - see above

    require_teacher()
    disposition = {"Content-Disposition": "attachment; filename=pinel-lesson.csv"}
    table = writable(read_lesson(path.id, services()).table())
    return Response(table, mimetype="text/csv", headers=disposition)
