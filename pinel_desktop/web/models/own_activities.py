"""Activities that a teacher makes: what is written in the form, what the sample solution does, and the trial."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Body, Id, Json, Shape, Time
from pinel_desktop.web.models.activities import GoalPicture
from pinel_desktop.web.models.errors import Fault, Notice

_Text = Annotated[str, Field(max_length=1000)]
_Input = Annotated[str, Field(max_length=100)]


class Stage(Body):
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


class OwnActivityToEdit(Shape):
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


class OwnActivity(Shape):
    """An activity that a teacher made, as lists show it.

    `problem` says why this release cannot use it, such as an activity of a newer one; it has no picture then.
    """

    id: Id
    title: str
    created_at: Time
    goal_picture: GoalPicture | None
    problem: Notice | None


class OwnActivityList(Shape):
    """The oldest first."""

    activities: list[OwnActivity]


class Measured(Shape):
    """Numbers to choose checks from; angles with sign are positive to the left."""

    finished: bool
    touched: bool
    end_x_m: float
    end_y_m: float
    heading_deg: float
    path_m: float
    turned_deg: float
    net_deg: float
    time_s: float
    n_blocks: int
    n_nested: int
    n_marks: int
    zones: Annotated[list[str], Field(description="places visited, in order")]
    end_zone: Annotated[str, Field(description='the place at the end, "" outside')]
    all_zones: Annotated[list[str], Field(description="places of the world")]
    said: list[str]
    gap_m: Annotated[
        float | None,
        Field(description="between first and last point drawn; null without a drawing"),
    ]
    template: Annotated[
        list[list[tuple[float, float]]] | None,
        Field(description="what was drawn, else the path; null where it is too much for a check"),
    ]


class Sample(Shape):
    """What a sample solution does under the ideal robot: m, degrees and s in the start frame.

    `faults` are those of the program or its world; all else is null then.
    """

    faults: list[Fault]
    measured: Measured | None


class Trial(Shape):
    """What the checks say of a program under a robot; `is_right` if the solution passes, or the empty one does not."""

    program: Annotated[str, Field(description="`solution` or `empty`")]
    preset: Annotated[str, Field(description="`ideal`, or `realistic` with a camera's pose")]
    passed: bool
    is_right: bool
    words: Annotated[str, Field(description='why it does not pass, else ""')]


class Trials(Shape):
    """The trial of an activity; `faults` are what makes it unusable, and there are no trials then."""

    faults: list[Fault]
    trials: list[Trial]
