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
    """Pupils who work together."""

    id: Id
    name: str
    color: Color
    created_at: Time
    n_programs: int
    n_runs: int


class GroupList(Shape):
    """Newest use first."""

    groups: list[Group]


class NewGroup(Body):
    """A group needs a name only."""

    name: Name


class Program(Shape):
    """Saved blocks of a group; its content are its versions."""

    id: Id
    name: str
    group_id: Id
    created_at: Time
    updated_at: Time
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


class ProgramWithVersion(Program):
    """A program with its newest version."""

    version: Version | None


class NewVersion(Body):
    """What the editor holds; `document` is null where no document could be made of it."""

    workspace: Json
    document: dict[str, Any] | list[Any] | None
    world: Annotated[Json | None, Field(description="a world of the group's own")] = None


class SavedVersion(Shape):
    """On disk when this answer arrives."""

    id: Id
    created_at: Time
    faults: list[Fault]


class DocumentToCheck(Body):
    """A program document, or a bare list of commands."""

    document: dict[str, Any] | list[Any]


class CheckedDocument(Shape):
    """All faults; an empty list means that it can run."""

    faults: list[Fault]
