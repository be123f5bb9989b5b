"""Classes, lessons, notes, the teacher's door."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Body, Id, Shape, Time
from pinel_desktop.web.models.work import Name


class Classroom(Shape):
    """A class of the school; `computer` is where its first lesson was, which tells classes of one name apart."""

    id: Id
    name: str
    created_at: Time
    computer: str | None
    n_groups: int


class ClassroomList(Shape):
    """By name."""

    classrooms: list[Classroom]


class ClassroomName(Body):
    """The name of a class."""

    name: Name


class Lesson(Shape):
    """A meeting of a class; `title` is "" where it opened by itself, `part_of` the lesson that it was joined to.

    Times are those of the PC where it was opened, whose clock may be wrong.
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


class LessonList(Shape):
    """Newest first."""

    lessons: list[Lesson]


class CurrentLesson(Shape):
    """What the work of a class belongs to now, null when a lesson would open by itself."""

    lesson: Lesson | None


class NewLesson(Body):
    """A lesson of one title is one lesson on all PCs where it is opened."""

    title: Name
    activity: Annotated[str | None, Field(max_length=100, description="a name")] = None


class LessonChanges(Body):
    """What is to change; what is not told stays."""

    title: Name | None = None
    activity: Annotated[str | None, Field(max_length=100, description='a name, "" for none')] = None
    part_of: Annotated[str | None, Field(max_length=100, description='a lesson, "" for none')] = (
        None
    )
    closed: bool = False


class Note(Shape):
    """What the teacher has written about a run; `seen_at` is when the group has read it."""

    id: Id
    run_id: Id
    text: str
    written_at: Time
    seen_at: Time | None
    program_id: Id | None
    program_name: str | None


class NoteList(Shape):
    """Notes about runs."""

    notes: list[Note]


class NotePage(Body):
    """Which of a group's notes."""

    unseen: bool = False


class NoteText(Body):
    """What the group is to read."""

    text: Annotated[str, Field(max_length=5000)]


class Door(Shape):
    """Whether there is a PIN, and whether the one who asks has given it."""

    has_pin: bool
    is_open: bool


class Pin(Body):
    """Digits."""

    pin: Annotated[str, Field(max_length=100)]


class Computer(Shape):
    """This PC."""

    id: Id
    name: str


class ComputerName(Body):
    """What people call this PC."""

    name: Name


class ActivityTitle(Shape):
    """A mission, by name, with its title in the language of the page."""

    name: str
    title: str


class ActivityList(Shape):
    """The missions that ship."""

    activities: list[ActivityTitle]
