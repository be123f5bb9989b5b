"""The lesson file, which takes a lesson to all PCs."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import RequestModel, ResponseModel
from pinel_desktop.web.models.classes import Classroom, Lesson


class LessonFileName(RequestModel):
    """The name of the chosen file, for messages."""

    name: Annotated[str, Field(max_length=300)] = ""


class LessonFilePath(RequestModel):
    """A file in a folder that `GET /folders` lists."""

    path: Annotated[str, Field(max_length=4000)]


class TargetFolder(RequestModel):
    """The folder for the file."""

    folder: Annotated[str, Field(max_length=4000)]


class WrittenLessonFile(ResponseModel):
    """The file that was written."""

    path: str
    name: str


class OpenedLesson(ResponseModel):
    """The lesson that is open on this PC now; `nothing_new` is true if this PC had all content of the file before."""

    lesson: Lesson
    classroom: Classroom
    n_groups: Annotated[int, Field(description="of the class, on this PC now")]
    nothing_new: bool
