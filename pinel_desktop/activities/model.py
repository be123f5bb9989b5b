"""The models of an activity: what a group reads, its world, the inputs of its cases, its checks and its diagnoses."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field
from pydantic_core import PydanticCustomError

from pinel_desktop.activities.checks import Check
from pinel_desktop.activities.checks.base import MAX_ITEMS, Metres, Name
from pinel_desktop.activities.texts import Model, Texts, Title
from pinel_desktop.robot import PIONEER_3DX, Feedback, Preset

FORMAT = 2  # files of all earlier formats are read

PathName = Literal["moves", "shapes", "decisions", "sensors", "games"]
General = Literal["hit", "too_far", "pen_up", "parts", "looked_once", "never_true", "input_ignored"]


class Start(Model):
    """Where the robot starts in a case, in the world's frame."""

    x_m: Metres
    y_m: Metres
    heading_deg: Annotated[float, Field(ge=-360, le=360)] = 0.0


class Case(Model):
    """One run of the program: its seed, start, gestures and answers, and checks of this run alone.

    Attributes:
        start: None for the start of the world.
    """

    seed: Annotated[int, Field(ge=0, le=2**53 - 1)] = 0
    start: Start | None = None
    gestures: list[str] = Field(default_factory=list, max_length=MAX_ITEMS)
    answers: list[str] = Field(default_factory=list, max_length=MAX_ITEMS)
    checks: list[Check] = Field(default_factory=list, max_length=MAX_ITEMS)


# with them, `n_ACTION`: how many of that block the program has, and `x_ACTION`: how many were begun in the run
NUMBER_FACTS = frozenset(
    {"gap_m", "net_deg", "turned_deg", "path_m", "time_s", "end_x", "end_y", "to_goal_m"}
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
    """Refuses lists that are no pair of limits."""
    if isinstance(expected, list) and len(expected) != 2:
        raise PydanticCustomError("activity_value_wrong", "a lower and an upper limit")
    return expected


ExpectedFact = Annotated[float | str | list[float], BeforeValidator(_one_or_two)]


class Diagnosis(Model):
    """What a group is told about a run that does not pass; the first whose `when` fits is said.

    Attributes:
        when: facts of the run with the value, the two limits or the text that each must have.
        block: which block to look at: `first ACTION`, `last ACTION`, `touching`, `running`, `moving` or `worst`.
        say: the words, with facts in braces.
        general: instead of `say`, the name of words that many activities use.
        parts: for the general words `parts`, how many there should be.
    """

    when: Annotated[dict[Name, ExpectedFact], Field(min_length=1, max_length=20)]
    block: Annotated[str, Field(max_length=80)] | None = None
    say: Texts | None = None
    general: General | None = None
    parts: Annotated[int, Field(ge=0, le=10_000)] | None = None


def _number(version: Any) -> Any:
    """Refuses `true`, which Python takes for 1."""
    if isinstance(version, bool):
        raise PydanticCustomError("activity_value_wrong", "true and false are no numbers")
    return version


class Activity(Model):
    """A mission. A program passes if in every case the checks of the case and those of the activity hold.

    Attributes:
        world: name of a shipped world, or a world document.
        limit_s: robot time after which a run is stopped and fails.
        path: the path that it belongs to, and `number` its place there, as "1.1".
        minutes: how long a group needs for it.
        level: level of the toolbox in which it opens.
        blocks: the actions that it offers; None for all of the level.
        story: what the robot should do.
        criteria: what counts, with numbers.
        hints: opened one after the other.
        question: asked by the teacher afterwards.
        diagnoses: what is said about a run that does not pass.
        solution: a program that passes, as a document.
        shows_path: whether the picture of the goal shows what the solution drives. Without it the pupils see where to
            go, and find the way themselves.
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
        """Its own, and those of its cases."""
        yield from self.checks
        for case in self.cases:
            yield from case.checks


# the keys of an activity in format 1, whose cases have no `start`
FORMAT_1 = frozenset(
    {"pinel_activity", "name", "title", "world", "model", "preset", "feedback", "limit_s"}
    | {"cases", "checks"}
)
