"""Review of lessons, differences between versions, the history of runs."""

from datetime import date
from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.web.models import Id, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.classes import Lesson
from pinel_desktop.web.models.runs import Run, Unconfirmed
from pinel_desktop.web.models.work import Version


class GroupHead(ResponseModel):
    """A group with its name, colour and picture."""

    id: Id
    name: str
    color: str
    picture: str


class ChangeCounts(ResponseModel):
    """Numbers of blocks; a block that was both moved and changed counts twice."""

    added: int
    removed: int
    changed: int
    moved: int


class TimelineEntry(ResponseModel):
    """A timeline entry: a burst of edits between two runs, or a run; times are by the clock of its PC.

    `changes` counts differences from version `since` to `version_id`. For edits, `since` is the version before the
    burst, "" for an empty program. For a run that `repairs` another run, `since` is the version of that run.
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
    message: Annotated[
        str | None, Field(description="why the run ended, or what its activity said about it")
    ]
    activity: str | None
    other_mission: Annotated[
        str | None, Field(description="title of its activity if the lesson has others")
    ]
    passed: bool | None
    unconfirmed: Annotated[Unconfirmed | None, Field(description="as of a run")]
    duration_s: float | None
    link: Annotated[str | None, Field(description="the robot; null for edits")]
    repairs: Annotated[Id | None, Field(description="the failed run that this run repairs")]


class Figures(ResponseModel):
    """Metrics of a group; messages `figure_NAME` explain what each metric counts."""

    n_edits: int
    n_runs: int
    n_failed: int
    time_to_first_run_s: float | None
    attempts_until_passed: int | None
    n_hints: int
    active_s: float


class BlockCount(ResponseModel):
    """Blocks of one type at the end of the lesson: `count` attached to programs, `loose` not attached."""

    type: str
    count: int
    loose: int


class OpenedHints(ResponseModel):
    """The hints of an activity that a group opened, in order; texts are missing for an activity of a newer release."""

    title: str
    n: int
    texts: list[str]


class GroupReview(ResponseModel):
    """A group's timeline in chronological order, its metrics, blocks and hints, and whether it needs help."""

    group: GroupHead
    need: Annotated[
        Literal["help", "working", "passed"],
        Field(description="`help` if the last three runs or more did not succeed"),
    ]
    sentence: Annotated[str, Field(description="what the group is at")]
    entries: list[TimelineEntry]
    figures: Figures
    blocks: list[BlockCount]
    hints: list[OpenedHints]


class LessonSummary(ResponseModel):
    """The summary of a lesson; it names groups in the order of the review, which is no ranking."""

    n_groups: int
    n_passed: Annotated[int | None, Field(description="groups that passed; null without activity")]
    stuck: Annotated[
        list[str], Field(description="groups whose last three runs or more did not succeed")
    ]
    fault: Annotated[
        str | None,
        Field(description="what was said about the commonest error, if groups share one"),
    ]
    fault_run: Annotated[Id | None, Field(description="the latest run with it")]
    n_with_fault: Annotated[int, Field(description="groups that had this error")]
    not_begun: Annotated[
        list[str], Field(description="groups of the class without work in a lesson that is open")
    ]
    differing: Annotated[
        list[str], Field(description="titles of the activities of joined lessons, if they differ")
    ]


class LessonReview(ResponseModel):
    """All groups that worked in the lesson, ordered by name."""

    lesson: Lesson
    summary: LessonSummary
    groups: list[GroupReview]


class VersionOfProgram(Version):
    """A version with its number, label and parent."""

    program_id: Id
    number: int
    label: str
    parent_id: Id | None


class DifferenceTo(RequestModel):
    """The later version to compare with."""

    to: Id


class DifferentBlock(ResponseModel):
    """A block, by its id in the workspace."""

    block: str
    type: str


class BlockChange(ResponseModel):
    """A change of a field, an input's value, "extraState.KEY", "type", "disabled" or "comment"; null if absent."""

    name: str
    before: Any
    after: Any


class ChangedBlock(DifferentBlock):
    """A block with changed values."""

    what: list[BlockChange]


class VersionDifference(ResponseModel):
    """Differences by block; a block that was moved and changed is in both lists."""

    added: list[DifferentBlock]
    removed: list[DifferentBlock]
    changed: list[ChangedBlock]
    moved: list[DifferentBlock]


class HistoryPage(RequestModel):
    """Filters and page of the list of runs; omitted filters select all."""

    classroom: Annotated[str | None, Field(description="a class, `none` for groups without")] = None
    group: Id | None = None
    activity: Annotated[str | None, Field(max_length=100)] = None
    world: Annotated[str | None, Field(max_length=100, description="a name, or `own`")] = None
    lesson: Annotated[Id | None, Field(description="with all lessons joined to it")] = None
    day: Annotated[date | None, Field(description="by the clock and the time zone of this PC")] = (
        None
    )
    outcome: Literal["finished", "stopped", "failed", "passed", "not_passed"] | None = None
    before: Id | None = None
    limit: Annotated[int, Field(ge=1, le=200)] = 50


class HistoryRun(Run):
    """A run with its group; null for runs of the command line."""

    group: GroupHead | None


class RunHistoryResponse(ResponseModel):
    """Runs, newest first; `next` is the value of `before` for the next page, null at the end."""

    runs: list[HistoryRun]
    next: Id | None
