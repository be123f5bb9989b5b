"""Activities that a teacher makes: what is written in the form, what the sample solution does, and the trial."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Id, Json, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.activities import GoalPicture
from pinel_desktop.web.models.errors import Fault, Notice

_Text = Annotated[str, Field(max_length=1000)]
_Input = Annotated[str, Field(max_length=100)]


class Stage(RequestModel):
    """Where a sample solution runs, and with which inputs."""

    solution: Annotated[Json, Field(description="a program that passes, as a document")]
    world: Annotated[str | Json, Field(description="name of a shipped world, or a world document")]
    gestures: Annotated[list[_Input], Field(default_factory=list, max_length=100)]
    answers: Annotated[list[_Input], Field(default_factory=list, max_length=100)]


class OwnActivityDraft(Stage):
    """An activity as a teacher writes it; its texts are in one language.

    That the run finishes is always a check; it is not among `checks`.
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
    """An own activity as its form shows it."""

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
    """An activity that a teacher made, as lists show it.

    `problem` says why this release cannot use it, such as an activity of a newer one; it has no picture then.
    """

    id: Id
    title: str
    created_at: Time
    goal_picture: GoalPicture | None
    problem: Notice | None


class OwnActivityList(ResponseModel):
    """The oldest first."""

    activities: list[OwnActivity]


class Proposal(ResponseModel):
    """What the form begins with for a sample solution, run under the ideal robot."""

    finished: Annotated[bool, Field(description="the solution ended by itself, without a failure")]
    zones: Annotated[list[str], Field(description="places of the world")]
    checks: Annotated[
        list[Json], Field(description="one of each kind that is of use for this solution")
    ]


class Sample(ResponseModel):
    """What the form proposes for a sample solution.

    `faults` are those of the program or its world; the proposal is null then.
    """

    faults: list[Fault]
    proposal: Proposal | None


class Trial(ResponseModel):
    """What the checks say of a program under a robot; `is_right` if the solution passes, or the empty one does not."""

    program: Annotated[str, Field(description="`solution` or `empty`")]
    preset: Annotated[str, Field(description="`ideal`, or `realistic` with a camera's pose")]
    passed: bool
    is_right: bool
    words: Annotated[str, Field(description='why it does not pass, else ""')]


class Trials(ResponseModel):
    """The trial of an activity; `faults` are what makes it unusable, and there are no trials then."""

    faults: list[Fault]
    trials: list[Trial]
