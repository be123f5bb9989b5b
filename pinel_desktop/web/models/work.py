"""Groups, programs and their versions."""

from typing import Annotated, Any

from pydantic import Field

from pinel_desktop.engine.commands import SpeedFactor
from pinel_desktop.robot import PIONEER_3DX, Feedback, Preset
from pinel_desktop.web.models import Id, Json, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.errors import Fault
from pinel_desktop.web.models.robots import RobotName
from pinel_desktop.web.models.worlds import Start, World

Name = Annotated[
    str, Field(max_length=1000, description="1 to 60 characters; spaces at the ends do not count")
]
RobotTitle = Annotated[
    str, Field(max_length=1000, description="up to 60 characters; empty for the group's name")
]
Color = Annotated[str, Field(pattern="^#[0-9a-f]{6}$")]


class Group(ResponseModel):
    """Pupils who work together; `n_programs` excludes programs in the bin, which `n_in_bin` counts."""

    id: Id
    name: str
    color: Color
    picture: Annotated[
        str, Field(description='name of a drawing; "" for groups of earlier releases')
    ]
    robot_name: Annotated[str, Field(description="empty if the robot has the group's name")]
    robot_pattern: Annotated[
        str, Field(description="of its robot; empty for groups of earlier releases")
    ]
    classroom_id: Id | None
    created_at: Time
    n_programs: int
    n_in_bin: int
    n_runs: int
    has_album: Annotated[
        bool, Field(description="false if the teacher switched the album off for the class")
    ]
    of_teacher: Annotated[bool, Field(description="it holds the teacher's own programs of this PC")]


class GroupList(ResponseModel):
    """Groups, most recently used first."""

    groups: list[Group]


class NewGroup(RequestModel):
    """A new group; if `color`, `picture` or `robot_pattern` is omitted, one that few groups use is chosen."""

    name: Name
    classroom_id: Id | None = None
    color: Color | None = None
    picture: Annotated[str, Field(max_length=100)] = ""
    robot_name: RobotTitle = ""
    robot_pattern: Annotated[str, Field(max_length=100)] = ""


class GroupChanges(RequestModel):
    """Changes of a group; omitted fields stay unchanged. Only the teacher may change the class."""

    name: Name | None = None
    color: Color | None = None
    picture: Annotated[str | None, Field(max_length=100)] = None
    robot_name: RobotTitle | None = None
    robot_pattern: Annotated[str | None, Field(max_length=100)] = None
    classroom_id: Id | None = None


class Program(ResponseModel):
    """A program of a group, without its versions."""

    id: Id
    name: str
    group_id: Id
    created_at: Time
    updated_at: Time
    deleted_at: Annotated[Time | None, Field(description="in the bin since")]
    n_versions: int
    n_runs: int


class ProgramList(ResponseModel):
    """Programs, newest first."""

    programs: list[Program]


class ProgramName(RequestModel):
    """The name of a program."""

    name: Name


class Setup(ResponseModel):
    """World, start pose, robot, speed and activity for a program's runs; stored with each version."""

    world: Annotated[str, Field(max_length=100, description="a name, or `own`: the version's")]
    start: Annotated[Start | None, Field(description="another start than the world's")] = None
    model: RobotName = PIONEER_3DX.name
    preset: Preset = "ideal"
    feedback: Feedback = "pose"
    calibrated_robot: Annotated[
        Id | None,
        Field(description="a robot with a real one's errors, instead of model and preset"),
    ] = None
    speed: SpeedFactor = 1.0
    activity: Annotated[
        str | None, Field(max_length=100, description="the activity that it is to solve")
    ] = None
    n_hints: Annotated[int, Field(ge=0, le=100, description="hints of it that were opened")] = 0

    def as_stored(self) -> Json:
        """Returns the setup as a version stores it, without a calibrated robot where none is chosen, as before 0.4."""
        return self.model_dump(exclude=None if self.calibrated_robot else {"calibrated_robot"})


class Version(ResponseModel):
    """One state of a program, never overwritten; `document` is null if the blocks have faults.

    `world` is the group's own world; null if the program runs in a world chosen by name. `setup` is null if an earlier
    release saved the version.
    """

    id: Id
    created_at: Time
    workspace: Json
    document: Json | None
    faults: list[Fault]
    world: World | None
    setup: Setup | None


class VersionSummary(ResponseModel):
    """A version in the history of its program; `parent_id` is the version that was edited.

    `setup_only` is true if its blocks equal the blocks of `parent_id`: only its setup or the group's own world changed.

    Two versions of equal number come from edits on two PCs; both stay.
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
    setup: Setup | None
    setup_only: bool


class ProgramWithVersion(Program):
    """A program with its newest version.

    `elsewhere` is the latest version of a parallel branch, made on another PC from an older version; null without one.
    """

    version: Version | None
    elsewhere: VersionSummary | None


class VersionLine(ResponseModel):
    """Versions, newest first; `next` is the value of `before` for the next page, null at the end."""

    versions: list[VersionSummary]
    next: Id | None


class VersionPage(RequestModel):
    """A page of the history."""

    before: Id | None = None
    limit: Annotated[int, Field(ge=1, le=500)] = 200


class WhichVersion(RequestModel):
    """The version with which a program is opened."""

    sound: Annotated[
        bool, Field(description="the newest that is as it was saved, where a newer one is damaged")
    ] = False


class VersionLabel(RequestModel):
    """A label for a version; "" removes it."""

    text: Name


class NewVersion(RequestModel):
    """The content of the editor; `document` is null if the blocks cannot be converted to one."""

    workspace: Json
    document: dict[str, Any] | list[Any] | None
    world: Annotated[Json | None, Field(description="a world of the group's own")] = None
    setup: Setup | None = None
    parent_id: Annotated[Id | None, Field(description="the version edited; the newest if null")] = (
        None
    )


class SavedVersion(ResponseModel):
    """A version that is now on disk.

    `before` is the previous newest version; if the page does not know it, another window saved it.
    """

    id: Id
    created_at: Time
    faults: list[Fault]
    before: Id | None
    deleted_at: Annotated[Time | None, Field(description="the program is in the bin since")]


class DocumentToCheck(RequestModel):
    """A program document, or a bare list of commands."""

    document: dict[str, Any] | list[Any]


class CheckedDocument(ResponseModel):
    """All faults; if the list is empty, the document can run."""

    faults: list[Fault]
