"""Classes of the school, their lessons, and activities for lessons."""

from flask import Response

from pinel_desktop.school.own_activities import known_activity
from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.classes import (
    ClassPreset,
    Classroom,
    ClassroomList,
    ClassroomName,
    CurrentLesson,
    Lesson,
    LessonChanges,
    LessonList,
    NewLesson,
)
from pinel_desktop.web.presets import preset_of, world_of_preset
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher
from storage import ClassroomRow, LessonRow
from storage.limits import MAX_NAME

api = Resource("classrooms", "Classes and their lessons.", __name__)


@api.get("/classrooms", responses=responses(ClassroomList))
def list_classrooms() -> Response:
    """All classes, by name."""
    rows = services().store.classrooms.all()
    return json_response(ClassroomList(classrooms=[_classroom(row) for row in rows]))


@api.post("/classrooms", responses=responses(Classroom, *TEACHER, "classroom_exists", *WRITES))
def create_classroom(body: ClassroomName) -> Response:
    """Creates a class with a unique name. For the teacher."""
    require_teacher()
    return json_response(_classroom(services().store.classrooms.create(body.name)))


@api.patch(
    "/classrooms/<id>",
    responses=responses(Classroom, *TEACHER, "classroom_not_found", "classroom_exists", *WRITES),
)
def rename_classroom(path: IdPath, body: ClassroomName) -> Response:
    """Renames a class. For the teacher."""
    require_teacher()
    return json_response(_classroom(services().store.classrooms.rename(path.id, body.name)))


@api.get("/classrooms/<id>/lesson", responses=responses(CurrentLesson, "classroom_not_found"))
def get_current_lesson(path: IdPath) -> Response:
    """The lesson to which new work of the class on this PC belongs."""
    store = services().store
    row = store.lessons.current(store.classrooms.get(path.id).id)
    found = None if row is None else _lesson(row)
    return json_response(CurrentLesson(lesson=found, preset=preset_of(path.id, store)))


@api.put(
    "/classrooms/<id>/preset",
    responses=responses(
        ClassPreset, *TEACHER, "classroom_not_found", "unknown_activity", "unknown_world", *WRITES
    ),
)
def set_preset(path: IdPath, body: ClassPreset) -> Response:
    """Sets the preset of a class, with which its groups start. For the teacher."""
    require_teacher()
    _require_activity(body.activity)
    if body.world is not None:
        world_of_preset(body.world, services())
    store = services().store
    store.class_presets.set(path.id, body.model_dump(exclude_none=True))
    return json_response(preset_of(path.id, store))


@api.get(
    "/classrooms/<id>/lessons", responses=responses(LessonList, *TEACHER, "classroom_not_found")
)
def list_lessons(path: IdPath) -> Response:
    """Lessons of the class on all PCs, newest first; `none` selects lessons without a class. For the teacher."""
    require_teacher()
    store = services().store
    classroom_id = None if path.id == "none" else store.classrooms.get(path.id).id
    rows = store.lessons.of_classroom(classroom_id)
    return json_response(LessonList(lessons=[_lesson(row) for row in rows]))


@api.post(
    "/classrooms/<id>/lessons",
    responses=responses(Lesson, *TEACHER, "classroom_not_found", *WRITES),
)
def open_lesson(path: IdPath, body: NewLesson) -> Response:
    """Opens a lesson and closes any other open lesson of the class on this PC. For the teacher."""
    require_teacher()
    _require_activity(body.activity)
    title = body.title if body.title.strip() else _title_of(body.activity)
    row = services().store.lessons.open(path.id, title, body.activity)
    return json_response(_lesson(row))


@api.patch("/lessons/<id>", responses=responses(Lesson, *TEACHER, "lesson_not_found", *WRITES))
def change_lesson(path: IdPath, body: LessonChanges) -> Response:
    """Sets a lesson's title or activity, joins it to another, or closes it. For the teacher."""
    require_teacher()
    lessons = services().store.lessons
    _require_activity(body.activity or None)
    changes = body.model_dump(exclude_none=True, exclude={"closed"})
    # an empty text removes the value
    row = lessons.change(path.id, {name: value or None for name, value in changes.items()})
    return json_response(_lesson(lessons.close(path.id) if body.closed else row))


def _lesson(row: LessonRow) -> Lesson:
    return Lesson.of(row)


def _classroom(row: ClassroomRow) -> Classroom:
    return Classroom.of(row)


def _title_of(activity: str | None) -> str:
    """Returns the title of an activity, which names a lesson without a title; "" without an activity."""
    if activity is None:
        return ""
    parts = services()
    title = known_activity(parts.store, activity).title.of(parts.settings.language)
    return title[:MAX_NAME].strip()


def _require_activity(name: str | None) -> None:
    """Refuses all but shipped and own activities: a lesson must not name a file of this PC."""
    if name is not None:
        known_activity(services().store, name)
