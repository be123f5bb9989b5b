"""The lesson file, which takes class, groups, lesson, preset, own activities and taught signs to all PCs."""

from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from flask import Response

from pinel_desktop.web.api import OCTETS, TEACHER, WRITES, Resource, responses
from pinel_desktop.web.api.exchange import (
    UploadedFile,
    file_name,
    naming_file,
    require_folder,
    uploaded,
)
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.classes import Classroom, Lesson
from pinel_desktop.web.models.lesson_files import (
    LessonFileName,
    LessonFilePath,
    OpenedLesson,
    TargetFolder,
    WrittenLessonFile,
)
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher, require_teacher_if_there_is_one
from storage import StoreError
from storage.file.temporary import temporary_folder

if TYPE_CHECKING:
    from storage.exchange.bundle_writing import BundleInfo

api = Resource("lesson_files", "The file that takes a lesson to all PCs.", __name__)

_READS = ("bundle_not_lesson", "lesson_not_found")


@api.get(
    "/lessons/<id>/file",
    responses=responses(OCTETS, *TEACHER, "lesson_not_found", "lesson_without_class", *WRITES),
)
def get_lesson_file(path: IdPath) -> Response:
    """A file with all that a PC needs for a lesson; contains nothing that pupils made. For the teacher."""
    require_teacher()
    with temporary_folder() as folder:
        info = _written(path.id, folder / "lesson.pinel", is_recorded=False)
        octets = info.path.read_bytes()
    return Response(octets, mimetype="application/octet-stream")


@api.post(
    "/lessons/<id>/file",
    responses=responses(
        WrittenLessonFile,
        *TEACHER,
        "lesson_not_found",
        "lesson_without_class",
        "folder_missing",
        *WRITES,
    ),
)
def write_lesson_file(path: IdPath, body: TargetFolder) -> Response:
    """Writes the lesson file into a folder. For the teacher."""
    require_teacher()
    require_folder(body.folder)
    title = services().store.lessons.get(path.id).title
    name = f"{file_name(title)}-{datetime.now().astimezone():%Y-%m-%d}.pinel"
    info = _written(path.id, Path(body.folder) / name)
    return json_response(WrittenLessonFile(path=str(info.path), name=info.path.name))


@api.post(
    "/lessons/file",
    responses=responses(OpenedLesson, "teacher_only", "body_too_large", *_READS, *WRITES),
)
def open_lesson_file(query: LessonFileName, raw: UploadedFile) -> Response:
    """Opens the lesson of an uploaded file (the body) on this PC. Without a PIN for anybody, else for the teacher."""
    require_teacher_if_there_is_one()
    with uploaded(raw, query.name) as path:
        return _opened(path)


@api.post("/lessons/file/path", responses=responses(OpenedLesson, *TEACHER, *_READS, *WRITES))
def open_found_lesson_file(body: LessonFilePath) -> Response:
    """Opens the lesson of a file on a removable drive or in the shared folder. For the teacher."""
    require_teacher()
    path = Path(body.path)
    with naming_file(path, path.name):
        return _opened(path)


def _opened(path: Path) -> Response:
    parts = services()
    report, lesson_id = parts.store.exchange.merge_lesson(path)
    lesson = parts.store.lessons.resume(lesson_id)
    parts.signs.refresh()
    assert lesson.classroom_id is not None  # a lesson that a teacher opened has a class
    classroom = parts.store.classrooms.get(lesson.classroom_id)
    return json_response(
        OpenedLesson(
            lesson=Lesson.of(lesson),
            classroom=Classroom.of(classroom),
            n_groups=classroom.n_groups,
            nothing_new=report.nothing_new,
        )
    )


def _written(lesson_id: str, dest: Path, *, is_recorded: bool = True) -> "BundleInfo":
    from storage.exchange.scope import Scope  # noqa: PLC0415 - when a file is written

    parts = services()
    lesson = parts.store.lessons.get(lesson_id)
    if lesson.classroom_id is None:
        raise StoreError("lesson_without_class")
    return parts.store.exchange.export(
        dest,
        app_version=parts.app_version,
        computer=parts.store.computers.this(),
        scope=Scope(classroom_id=lesson.classroom_id, lesson_id=lesson.id),
        is_recorded=is_recorded,
    )
