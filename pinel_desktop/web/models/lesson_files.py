"""The file that takes a lesson to all PCs."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import RequestModel, ResponseModel
from pinel_desktop.web.models.classes import Classroom, Lesson


class LessonFileName(RequestModel):
    """The name that the file has where it was chosen."""

    name: Annotated[str, Field(max_length=300)] = ""


class LessonFilePath(RequestModel):
    """A file in a folder that `GET /folders` lists."""

    path: Annotated[str, Field(max_length=4000)]


class TargetFolder(RequestModel):
    """Where the file is to be written."""

    folder: Annotated[str, Field(max_length=4000)]


class WrittenLessonFile(ResponseModel):
    """The file that was written."""

    path: str
    name: str


class OpenedLesson(ResponseModel):
    """The lesson that is open on this PC now; `nothing_new` if all of the file was here before."""

    lesson: Lesson
    classroom: Classroom
    n_groups: Annotated[int, Field(description="of the class, on this PC now")]
    nothing_new: bool
