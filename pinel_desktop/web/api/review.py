"""The review of a lesson, for the teacher. Its modules are imported on the first request, not at the app's start."""

from flask import Response

from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.api.runs import run_model
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.review import LessonReview
from pinel_desktop.web.models.runs import Run
from pinel_desktop.web.responses import encodable, json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher

api = Resource("review", "Review of lessons.", __name__)

_CSV = {"content": {"text/csv": {"schema": {"type": "string"}}}}


@api.get("/lessons/<id>/review", responses=responses(LessonReview, *TEACHER, "lesson_not_found"))
def get_lesson_review(path: IdPath) -> Response:
    """The review of a lesson and all lessons joined to it. For the teacher."""
    from pinel_desktop.web.lesson_review import read_lesson  # noqa: PLC0415 - see above

    require_teacher()
    return json_response(read_lesson(path.id, services()).model(services().store))


@api.get("/lessons/<id>/review.csv", responses=responses(_CSV, *TEACHER, "lesson_not_found"))
def get_lesson_table(path: IdPath) -> Response:
    """The timelines of a lesson as a CSV table, one row per entry. For the teacher."""
    from pinel_desktop.web.lesson_review import read_lesson  # noqa: PLC0415 - see above

    require_teacher()
    disposition = {"Content-Disposition": "attachment; filename=pinel-lesson.csv"}
    table = encodable(read_lesson(path.id, services()).table())
    return Response(table, mimetype="text/csv", headers=disposition)


@api.post("/runs/<id>/accept", responses=responses(Run, *TEACHER, "run_not_found", *WRITES))
def accept_run(path: IdPath) -> Response:
    """Accepts the pass of a merged run that cannot be repeated here. For the teacher.

    Other runs stay unchanged.
    """
    require_teacher()
    store = services().store
    store.unconfirmed.accept(path.id)
    return json_response(run_model(store.runs.get(path.id)))
