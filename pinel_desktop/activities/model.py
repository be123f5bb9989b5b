"""The models of an activity: texts for the group, world, inputs of the cases, checks and diagnoses."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field
from pydantic_core import PydanticCustomError

from pinel_desktop.activities.checks import Check
from pinel_desktop.activities.checks.base import MAX_ITEMS, Metres, Name
from pinel_desktop.activities.texts import Model, Texts, Title
from pinel_desktop.robot import PIONEER_3DX, Feedback, Preset

FORMAT = 2  # all earlier formats can be read, too

PathName = Literal["moves", "shapes", "decisions", "sensors", "games"]
General = Literal["hit", "too_far", "pen_up", "parts", "looked_once", "never_true", "input_ignored"]


class Start(Model):
    """Where the robot starts in a case, in the world's frame."""

    x_m: Metres
    y_m: Metres
    heading_deg: Annotated[float, Field(ge=-360, le=360)] = 0.0


class Case(Model):
    """One run of the program: its seed, start, gestures and answers, and checks of this run only.

    Attributes:
        start: None for the start of the world.
    """

    seed: Annotated[int, Field(ge=0, le=2**53 - 1)] = 0
    start: Start | None = None
    gestures: list[str] = Field(default_factory=list, max_length=MAX_ITEMS)
    answers: list[str] = Field(default_factory=list, max_length=MAX_ITEMS)
    checks: list[Check] = Field(default_factory=list, max_length=MAX_ITEMS)


# further facts: `n_ACTION`, the number of such commands in the program, and `x_ACTION`, the number
# of such commands that started in the run
NUMBER_FACTS = frozenset(
    {"gap_m", "net_deg", "turned_deg", "path_m", "time_s", "end_x", "end_y"}
    | {"from_start_m", "to_goal_m"}
    | {
        "blocks",
        "nesting",
        "done",
        "amount",
        "missing_m",
        "extra_m",
        "mirror_m",
        "axes",
        "pushed_m",
        "box_left_m",
    }
    | {"marks", "mark_x", "mark_y", "case"}
)
TEXT_FACTS = frozenset({"reason", "zones", "end_zone", "input", "nearest", "mirrored"})


def _one_or_two(expected: Any) -> Any:
    """Rejects lists that are not a pair of limits."""
    if isinstance(expected, list) and len(expected) != 2:
        raise PydanticCustomError("activity_value_wrong", "a lower and an upper limit")
    return expected


ExpectedFact = Annotated[float | str | list[float], BeforeValidator(_one_or_two)]


class Diagnosis(Model):
    """Advice about a run that does not pass; the first diagnosis whose `when` fits is shown.

    Attributes:
        when: facts of the run, each with its required value, two limits or text.
        block: the block to look at: `first ACTION`, `last ACTION`, `touching`, `running`, `moving` or `worst`.
        say: the message, with facts in braces.
        general: instead of `say`, the name of a message that many activities use.
        parts: for the general message `parts`, the required number of parts.
    """

    when: Annotated[dict[Name, ExpectedFact], Field(min_length=1, max_length=20)]
    block: Annotated[str, Field(max_length=80)] | None = None
    say: Texts | None = None
    general: General | None = None
    parts: Annotated[int, Field(ge=0, le=10_000)] | None = None


def _number(version: Any) -> Any:
    """Rejects `true`, which equals 1 in Python."""
    if isinstance(version, bool):
        raise PydanticCustomError("activity_value_wrong", "true and false are no numbers")
    return version


class Activity(Model):
    """A mission. A program passes if in every case the checks of the case and the checks of the activity hold.

    Attributes:
        world: name of a shipped world, or a world document.
        limit_s: robot time after which a run is stopped and fails.
        path: the learning path of the activity; `number` is its place there, such as "1.1".
        minutes: time that a group needs.
        level: level of the toolbox when the activity opens.
        blocks: the actions that the toolbox offers; None for all actions of the level.
        story: the task of the robot.
        criteria: the criteria, with numbers.
        hints: shown one after the other.
        question: the teacher's question afterwards.
        diagnoses: advice about runs that do not pass.
        solution: a program that passes, as a document.
        shows_path: whether the picture of the goal shows the solution's path. If not, pupils see only the goal, and
            find the path themselves.
    """

    pinel_activity: Annotated[Literal[1, 2], BeforeValidator(_number)]
    name: Name
    title: Title
    world: Name | dict[str, Any]
    model: Name = PIONEER_3DX.name
    preset: Preset = "ideal"
    feedback: Feedback = "pose"
    limit_s: Annotated[float, Field(gt=0, le=3600)] = 300.0
    path: PathName | None = None
    number: Annotated[str, Field(pattern=r"^[1-9][0-9]?\.[1-9][0-9]?$")] | None = None
    minutes: Annotated[int, Field(ge=1, le=600)] | None = None
    level: Literal[1, 2, 3] | None = None
    blocks: Annotated[list[Name], Field(min_length=1, max_length=MAX_ITEMS)] | None = None
    story: Texts | None = None
    criteria: Texts | None = None
    hints: list[Texts] = Field(default_factory=list, max_length=3)
    question: Texts | None = None
    cases: list[Case] = Field(default_factory=lambda: [Case()], min_length=1, max_length=MAX_ITEMS)
    checks: list[Check] = Field(default_factory=list, max_length=MAX_ITEMS)
    diagnoses: list[Diagnosis] = Field(default_factory=list, max_length=MAX_ITEMS)
    solution: dict[str, Any] | None = None
    shows_path: bool = True

    def all_checks(self) -> Iterator[Check]:
        """Yields the activity's own checks, and the checks of its cases."""
        yield from self.checks
        for case in self.cases:
            yield from case.checks


# the keys of an activity of format 1; its cases have no `start`
FORMAT_1 = frozenset(
    {"pinel_activity", "name", "title", "world", "model", "preset", "feedback", "limit_s"}
    | {"cases", "checks"}
)
