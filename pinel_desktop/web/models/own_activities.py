"""Own activities: the form, the proposal from a sample solution, and the trial."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Id, Json, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.activities import GoalPicture
from pinel_desktop.web.models.errors import Fault, Notice

_Text = Annotated[str, Field(max_length=1000)]
_Input = Annotated[str, Field(max_length=100)]


class Stage(RequestModel):
    """World and inputs of a sample solution."""

    solution: Annotated[Json, Field(description="a program that passes, as a document")]
    world: Annotated[str | Json, Field(description="name of a shipped world, or a world document")]
    gestures: Annotated[list[_Input], Field(default_factory=list, max_length=100)]
    answers: Annotated[list[_Input], Field(default_factory=list, max_length=100)]


class OwnActivityDraft(Stage):
    """An activity as a teacher writes it; its texts are in one language.

    That the run finishes is always a check; it is not in `checks`.
    """

    title: Annotated[str, Field(max_length=1000, description="1 to 60 characters")]
    story: _Text = ""
    criteria: Annotated[_Text, Field(description="what counts, in words")] = ""
    hints: Annotated[list[_Text], Field(default_factory=list, max_length=3)]
    question: Annotated[_Text, Field(description="asked afterwards")] = ""
    level: Annotated[int, Field(ge=1, le=3, description="of the toolbox")] = 1
    minutes: Annotated[int | None, Field(ge=1, le=600)] = None
    shows_path: Annotated[bool, Field(description="the picture shows what the solution drives")] = (
        True
    )
    checks: Annotated[list[Json], Field(max_length=100, description="docs/activities.md")]


class OwnActivityToEdit(ResponseModel):
    """An own activity, as its form needs it."""

    id: Id
    title: str
    story: str
    criteria: str
    hints: list[str]
    question: str
    level: int
    minutes: int | None
    shows_path: bool
    checks: list[Json]
    solution: Json
    world: str | Json
    gestures: list[str]
    answers: list[str]


class OwnActivity(ResponseModel):
    """An own activity, as lists show it.

    `problem` is why this release cannot use it, such as an activity of a newer release; it has no picture then.
    """

    id: Id
    title: str
    created_at: Time
    goal_picture: GoalPicture | None
    problem: Notice | None


class OwnActivityList(ResponseModel):
    """Own activities, the oldest first."""

    activities: list[OwnActivity]


class Proposal(ResponseModel):
    """Initial values of the form, from a run of a sample solution under the ideal robot."""

    finished: Annotated[bool, Field(description="the solution ended by itself, without a failure")]
    zones: Annotated[list[str], Field(description="places of the world")]
    checks: Annotated[
        list[Json], Field(description="one of each kind that is of use for this solution")
    ]


class Sample(ResponseModel):
    """The form's proposal for a sample solution.

    If the program or its world has `faults`, the proposal is null.
    """

    faults: list[Fault]
    proposal: Proposal | None


class Trial(ResponseModel):
    """The verdict on a program under a robot; `is_right` if the solution passes, or if the empty program fails."""

    program: Annotated[str, Field(description="`solution` or `empty`")]
    preset: Annotated[str, Field(description="`ideal`, or `realistic` with a camera's pose")]
    passed: bool
    is_right: bool
    words: Annotated[str, Field(description='why it does not pass, else ""')]


class Trials(ResponseModel):
    """The trials of an activity; if `faults` make it unusable, there are no trials."""

    faults: list[Fault]
    trials: list[Trial]
