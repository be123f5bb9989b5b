"""Groups, programs and their versions."""

from typing import Annotated, Any

from pydantic import Field

from pinel_desktop.web.models import Body, Id, Json, Shape, Time
from pinel_desktop.web.models.errors import Fault
from pinel_desktop.web.models.worlds import World

Name = Annotated[
    str, Field(max_length=1000, description="1 to 60 characters; spaces at the ends do not count")
]
Color = Annotated[str, Field(pattern="^#[0-9a-f]{6}$")]


class Group(Shape):
    """Pupils who work together; `n_programs` without those in the bin, which are `n_in_bin`."""

    id: Id
    name: str
    color: Color
    picture: Annotated[
        str, Field(description='name of a drawing; "" for groups of earlier releases')
    ]
    classroom_id: Id | None
    created_at: Time
    n_programs: int
    n_in_bin: int
    n_runs: int


class GroupList(Shape):
    """Newest use first."""

    groups: list[Group]


class NewGroup(Body):
    """A group needs a name only; a picture that few have is chosen where none is told."""

    name: Name
    classroom_id: Id | None = None
    picture: Annotated[str, Field(max_length=100)] = ""


class GroupChanges(Body):
    """What is to change; what is not told stays. Only the teacher moves a group to another class."""

    name: Name | None = None
    color: Color | None = None
    picture: Annotated[str | None, Field(max_length=100)] = None
    classroom_id: Id | None = None


class Program(Shape):
    """Saved blocks of a group; its content are its versions."""

    id: Id
    name: str
    group_id: Id
    created_at: Time
    updated_at: Time
    deleted_at: Annotated[Time | None, Field(description="in the bin since")]
    n_versions: int
    n_runs: int


class ProgramList(Shape):
    """Newest first."""

    programs: list[Program]


class ProgramName(Body):
    """The name of a program."""

    name: Name


class Version(Shape):
    """One state of a program, never overwritten; `document` is null while it has faults.

    `world` is the group's own, null where the program runs in one chosen by name.
    """

    id: Id
    created_at: Time
    workspace: Json
    document: Json | None
    faults: list[Fault]
    world: World | None


class VersionMark(Shape):
    """A version in the line of its program; `parent_id` is the one that was edited.

    Two of one number came of edits on two PCs: both are kept.
    """

    id: Id
    number: int
    created_at: Time
    can_run: bool
    label: str
    parent_id: Id | None
    lesson_id: Id | None
    computer: str | None
    n_runs: int
    n_passed: int


class ProgramWithVersion(Program):
    """A program with its newest version.

    `elsewhere` is the last version that another PC made of an older one at the same time, null where there is none.
    """

    version: Version | None
    elsewhere: VersionMark | None


class VersionLine(Shape):
    """Newest first; `next` is what to ask for as `before` to go on, null at the end."""

    versions: list[VersionMark]
    next: Id | None


class VersionPage(Body):
    """Which part of the line."""

    before: Id | None = None
    limit: Annotated[int, Field(ge=1, le=500)] = 200


class VersionLabel(Body):
    """A name for a version worth keeping; "" takes it away."""

    text: Name


class NewVersion(Body):
    """What the editor holds; `document` is null where no document could be made of it."""

    workspace: Json
    document: dict[str, Any] | list[Any] | None
    world: Annotated[Json | None, Field(description="a world of the group's own")] = None
    parent_id: Annotated[Id | None, Field(description="the version edited; the newest if null")] = (
        None
    )


class SavedVersion(Shape):
    """On disk when this answer arrives.

    `before` is the version that was the newest until then: where the page does not know it, another window made it.
    """

    id: Id
    created_at: Time
    faults: list[Fault]
    before: Id | None
    deleted_at: Annotated[Time | None, Field(description="the program is in the bin since")]


class DocumentToCheck(Body):
    """A program document, or a bare list of commands."""

    document: dict[str, Any] | list[Any]


class CheckedDocument(Shape):
    """All faults; an empty list means that it can run."""

    faults: list[Fault]
