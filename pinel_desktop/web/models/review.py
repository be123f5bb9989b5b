"""How groups thought: lessons, differences between versions, the history of runs."""

from datetime import date
from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.web.models import Body, Id, Shape, Time
from pinel_desktop.web.models.classes import Lesson
from pinel_desktop.web.models.runs import Run
from pinel_desktop.web.models.work import Version


class GroupHead(Shape):
    """A group as its pupils know it."""

    id: Id
    name: str
    color: str
    picture: str


class ChangeCounts(Shape):
    """How many blocks; one that was both moved and changed counts in both."""

    added: int
    removed: int
    changed: int
    moved: int


class ReviewMark(Shape):
    """A burst of edits between two runs, or a run; times are of the PC's own clock.

    `changes` counts what differs between the versions `since` and `version_id`: of edits since the mark before, of a
    run that `repairs` another since that one. `since` is "" where the program began with it.
    """

    kind: Literal["edit", "run"]
    at: Time
    until: Time | None
    computer: str | None
    program_id: Id | None
    program_name: str | None
    version_id: Id | None
    number: Annotated[int | None, Field(description="of that version in its program")]
    n_edits: int | None
    since: str | None
    changes: ChangeCounts | None
    run_id: Id | None
    state: Literal["running", "finished", "stopped", "failed"] | None
    reason: str | None
    message: str | None
    activity: str | None
    passed: bool | None
    duration_s: float | None
    repairs: Annotated[Id | None, Field(description="the failing run that this one made good")]


class Figures(Shape):
    """What was counted of a group; the catalogue says in words what each number counts, as `figure_NAME`."""

    n_edits: int
    n_runs: int
    n_failed: int
    time_to_first_run_s: float | None
    attempts_until_passed: int | None
    active_s: float


class BlockCount(Shape):
    """Blocks of a type at the end of the lesson: `count` of them hang in a program, `loose` lie beside it."""

    type: str
    count: int
    loose: int


class GroupReview(Shape):
    """A group's line of marks in their order, and what was counted of it."""

    group: GroupHead
    marks: list[ReviewMark]
    figures: Figures
    blocks: list[BlockCount]


class LessonReview(Shape):
    """All groups that worked in the lesson, by name."""

    lesson: Lesson
    groups: list[GroupReview]


class VersionOfProgram(Version):
    """A version with its place in the line of its program."""

    program_id: Id
    number: int
    label: str
    parent_id: Id | None


class DifferenceTo(Body):
    """Which version to compare with: the later one."""

    to: Id


class DifferentBlock(Shape):
    """A block, by its id in the workspace."""

    block: str
    type: str


class BlockChange(Shape):
    """A field, an input with its value, "extraState.KEY", "type", "disabled" or "comment"; null where there is none."""

    name: str
    before: Any
    after: Any


class ChangedBlock(DifferentBlock):
    """A block on which something was set anew."""

    what: list[BlockChange]


class VersionDifference(Shape):
    """What differs, block by block; a block that was moved and changed is in both lists."""

    added: list[DifferentBlock]
    removed: list[DifferentBlock]
    changed: list[ChangedBlock]
    moved: list[DifferentBlock]


class HistoryPage(Body):
    """Which runs, and which part of the list; what is not told does not choose."""

    classroom: Annotated[str | None, Field(description="a class, `none` for groups without")] = None
    group: Id | None = None
    activity: Annotated[str | None, Field(max_length=100)] = None
    lesson: Annotated[Id | None, Field(description="with all lessons joined to it")] = None
    day: Annotated[date | None, Field(description="by the clock and the time zone of this PC")] = (
        None
    )
    outcome: Literal["finished", "stopped", "failed", "passed", "not_passed"] | None = None
    before: Id | None = None
    limit: Annotated[int, Field(ge=1, le=200)] = 50


class HistoryRun(Run):
    """A run with its group, null for runs of the command line."""

    group: GroupHead | None


class History(Shape):
    """Newest first; `next` is what to ask for as `before` to go on, null at the end."""

    runs: list[HistoryRun]
    next: Id | None
