"""Activities, their goal pictures, and examples."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.robot import Feedback, Preset
from pinel_desktop.web.models import Json, RequestModel, ResponseModel
from pinel_desktop.web.models.worlds import Metres2, World


class GoalLine(ResponseModel):
    """A line that the robot must drive or draw."""

    sign: Annotated[str | None, Field(description="the sign that it answers; null without signs")]
    color: Annotated[str | None, Field(description="of the pen; null for a path")]
    points: Annotated[list[Metres2], Field(description="x and y in m, world frame")]


class GoalPicture(ResponseModel):
    """The shapes in the picture of an activity's goal."""

    world: World
    lines: list[GoalLine]
    zones: Annotated[list[str], Field(description="names of the zones that count, in order")]
    boxes: Annotated[
        dict[str, tuple[float, float, float]],
        Field(description="x and y in m and yaw in rad of boxes to push, world frame, by index"),
    ]


class ActivityChoice(ResponseModel):
    """An activity to choose; its title is in the language of the page."""

    name: str
    title: str
    path: Annotated[str | None, Field(description="the path of activities that it belongs to")]
    number: Annotated[str | None, Field(description="its place on the path, as `1.2`")]
    minutes: int | None
    level: Annotated[int | None, Field(ge=1, le=3, description="of the toolbox")]
    goal_picture: GoalPicture
    own: Annotated[bool, Field(description="a teacher made it")]


class NextActivity(ResponseModel):
    """The next activity on the path."""

    name: str
    title: str


class Activity(ActivityChoice):
    """An activity as a group gets it. Texts are in the language of the page, "" if the activity has none.

    All runs of a program for the activity use its world (`goal_picture.world`), start pose and robot setting.
    """

    story: str
    criteria: str
    checks: Annotated[
        list[str], Field(description="what counts, check by check; of cases what all of them share")
    ]
    n_cases: Annotated[int, Field(ge=1, description="in how many cases a program is tried")]
    cases: Annotated[
        list[str], Field(description="what each case gives to a program: signs, answers or a start")
    ]
    hints: list[str]
    question: str
    blocks: Annotated[
        list[str] | None, Field(description="the actions that it offers; null for all of the level")
    ]
    world: Annotated[str, Field(description="name of the world, `own` for one of the activity's")]
    preset: Preset
    feedback: Feedback
    not_on_robot: Annotated[
        str | None,
        Field(description="why a run on a real robot is not judged, in words; null if it can be"),
    ]
    next: Annotated[NextActivity | None, Field(description="the one after it on its path")]


class ActivityList(ResponseModel):
    """The shipped activities in the order of the paths, then own activities, the oldest first."""

    activities: list[ActivityChoice]


class ActivityPath(RequestModel):
    """The `{name}` in a path."""

    name: Annotated[str, Field(max_length=100)]


class TriedActivity(ResponseModel):
    """An activity for which a group has a program or a run."""

    name: str
    passed: Annotated[bool, Field(description="a run passed it")]


class TriedActivities(ResponseModel):
    """The activities that a group has tried."""

    activities: list[TriedActivity]


class ChosenActivity(RequestModel):
    """The activity that a group chooses."""

    activity: Annotated[str, Field(max_length=100)]


class Example(ResponseModel):
    """A finished program to open as a copy; its texts and names are in the language of the page."""

    name: str
    title: str
    about: Annotated[str, Field(description="what it does, in a sentence")]
    world: Annotated[str, Field(description="name of the world that it is made for")]
    picture: GoalPicture
    document: Json


class ExampleList(ResponseModel):
    """The shipped examples, in the order of the page."""

    examples: list[Example]
