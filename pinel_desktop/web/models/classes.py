"""Classes, lessons, notes, the teacher's session."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Id, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.work import Name
from storage.work.class_presets import LEVELS, SwapMinutes


class Classroom(ResponseModel):
    """A class of the school; `computer` is the PC of its first lesson and distinguishes classes of equal name."""

    id: Id
    name: str
    created_at: Time
    computer: str | None
    n_groups: int


class ClassroomList(ResponseModel):
    """Classes by name."""

    classrooms: list[Classroom]


class ClassroomName(RequestModel):
    """The name of a class."""

    name: Name


class Lesson(ResponseModel):
    """A lesson of a class; `title` is "" if it was opened automatically, `part_of` is the lesson that it was joined to.

    Times are by the clock of the PC that opened the lesson, which may be wrong.
    """

    id: Id
    classroom_id: Id | None
    title: str
    activity: str | None
    by_itself: bool
    computer: str | None
    opened_at: Time
    used_at: Time
    closed_at: Time | None
    part_of: Id | None
    n_versions: int
    n_runs: int


class LessonList(ResponseModel):
    """Lessons, newest first."""

    lessons: list[Lesson]


class ClassPreset(ResponseModel):
    """The preset of a class, with which its groups start; null for values that are not set.

    A group may choose another level, and another world for each program.
    """

    level: Annotated[
        int | None, Field(ge=LEVELS[0], le=LEVELS[-1], description="of the toolbox")
    ] = None
    world: Annotated[
        str | None,
        Field(max_length=100, description="of new programs: a name, or an own activity's key"),
    ] = None
    activity: Annotated[
        str | None, Field(max_length=100, description="proposed for new lessons")
    ] = None
    swap_minutes: Annotated[
        SwapMinutes | None, Field(description="between reminders to swap roles; 0 for none")
    ] = None
    album: Annotated[
        bool | None, Field(description="whether groups have an album; null as true")
    ] = None


class CurrentLesson(ResponseModel):
    """The lesson to which new work of a class belongs, null if the next work would open one; and the class's preset."""

    lesson: Lesson | None
    preset: ClassPreset


class NewLesson(RequestModel):
    """A lesson to open; if several PCs open lessons with the same title, they are one lesson.

    If the title is empty, the lesson gets the title of the activity, in the language of the page.
    """

    title: Name
    activity: Annotated[str | None, Field(max_length=100, description="a name")] = None


class LessonChanges(RequestModel):
    """Changes of a lesson; omitted fields stay unchanged."""

    title: Name | None = None
    activity: Annotated[str | None, Field(max_length=100, description='a name, "" for none')] = None
    part_of: Annotated[str | None, Field(max_length=100, description='a lesson, "" for none')] = (
        None
    )
    closed: bool = False


class Note(ResponseModel):
    """The teacher's note about a run; `seen_at` is when the group read it."""

    id: Id
    run_id: Id
    text: str
    written_at: Time
    seen_at: Time | None
    program_id: Id | None
    program_name: str | None


class NoteList(ResponseModel):
    """Notes about runs."""

    notes: list[Note]


class NotePage(RequestModel):
    """Selects notes of a group."""

    unseen: bool = False


class NoteText(RequestModel):
    """The text of a note."""

    text: Annotated[str, Field(max_length=5000)]


class TeacherSession(ResponseModel):
    """Whether a PIN is set, and whether the request belongs to a teacher's session."""

    has_pin: bool
    is_open: bool


class Pin(RequestModel):
    """A PIN: 4 to 12 digits."""

    pin: Annotated[str, Field(max_length=100)]


class Computer(ResponseModel):
    """This PC."""

    id: Id
    name: str


class ComputerName(RequestModel):
    """A name for this PC."""

    name: Name
