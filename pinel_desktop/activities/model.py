"""The models of an activity: its world, the inputs of its cases, and its checks.

Every kind of check is a model here with its tag, a function in `checks.py`, words in
`messages/catalogue/LANGUAGE/activities.json` and a row in docs/activities.md.
"""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

from pinel_desktop.robot import PIONEER_3DX, Feedback, Preset
from sim.document import LanguageTag

_Name = Annotated[str, Field(min_length=1, max_length=64)]
_Metres = Annotated[float, Field(ge=-100, le=100)]
_Length = Annotated[float, Field(gt=0, le=10_000)]
_MOST = 100


class _Model(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class Finished(_Model):
    """The run ends by itself and without a failure."""

    check: Literal["finished"]


class EndsAt(_Model):
    """At the end the robot is within `within_m` of a point of the start frame."""

    check: Literal["ends_at"]
    x_m: _Metres
    y_m: _Metres
    within_m: _Length = 0.1


class EndsHeading(_Model):
    """At the end the robot has a heading in the start frame, within `within_deg`."""

    check: Literal["ends_heading"]
    heading_deg: Annotated[float, Field(ge=-360, le=360)]
    within_deg: Annotated[float, Field(gt=0, le=180)] = 5.0


class EndsIn(_Model):
    """At the end the robot's centre is in a zone of the world."""

    check: Literal["ends_in"]
    zone: _Name


class Visits(_Model):
    """The robot's centre passes through zones of the world, in this order if `ordered`."""

    check: Literal["visits"]
    zones: Annotated[list[_Name], Field(min_length=1, max_length=_MOST)]
    ordered: bool = True


class TouchesNothing(_Model):
    """The robot never touches a wall or a box."""

    check: Literal["touches_nothing"]


class Pushed(_Model):
    """At the end the centre of a box, by its index in the world, is in a zone."""

    check: Literal["pushed"]
    box: Annotated[int, Field(ge=0, lt=1000)]
    zone: _Name


class Uses(_Model):
    """The program has from `at_least` to `at_most` commands of a kind, at any level of nesting."""

    check: Literal["uses"]
    action: _Name
    at_least: Annotated[int, Field(ge=0, le=20_000)] = 1
    at_most: Annotated[int, Field(ge=0, le=20_000)] = 20_000


class Marks(_Model):
    """The program leaves a mark in a zone of the world."""

    check: Literal["marks"]
    symbol: Literal["X", "O"]
    zone: _Name


class Says(_Model):
    """The program says something that contains a text, ignoring case."""

    check: Literal["says"]
    text: Annotated[str, Field(min_length=1, max_length=1000)]


class PathLength(_Model):
    """The length of the path driven is within limits, in metres."""

    check: Literal["path_length"]
    at_least_m: Annotated[float, Field(ge=0, le=10_000)] = 0.0
    at_most_m: _Length = 10_000.0


Check = Annotated[
    Finished
    | EndsAt
    | EndsHeading
    | EndsIn
    | Visits
    | TouchesNothing
    | Pushed
    | Uses
    | Marks
    | Says
    | PathLength,
    Field(discriminator="check"),
]


class Case(_Model):
    """One run of the program: its seed, the gestures and answers it receives, and checks of this run alone."""

    seed: Annotated[int, Field(ge=0, le=2**53 - 1)] = 0
    gestures: list[str] = Field(default_factory=list, max_length=_MOST)
    answers: list[str] = Field(default_factory=list, max_length=_MOST)
    checks: list[Check] = Field(default_factory=list, max_length=_MOST)


class Title(_Model):
    """A title in each language."""

    model_config = ConfigDict(extra="allow", populate_by_name=True)

    __pydantic_extra__: dict[LanguageTag, Annotated[str, Field(max_length=200)]] = Field(init=False)
    pt_br: Annotated[str, Field(alias="pt-BR", max_length=200)]
    en: Annotated[str, Field(max_length=200)]
    es: Annotated[str, Field(max_length=200)]


def _number(version: Any) -> Any:
    """Refuses `true`, which Python takes for 1."""
    if isinstance(version, bool):
        raise PydanticCustomError("activity_value_wrong", "true and false are no numbers")
    return version


class Activity(_Model):
    """A mission. A program passes if in every case the checks of the case and those of the activity hold.

    Attributes:
        world: name of a shipped world, or a world document.
        limit_s: robot time after which a run is stopped and fails.
    """

    pinel_activity: Annotated[Literal[1], BeforeValidator(_number)]
    name: _Name
    title: Title
    world: _Name | dict[str, Any]
    model: _Name = PIONEER_3DX.name
    preset: Preset = "ideal"
    feedback: Feedback = "pose"
    limit_s: Annotated[float, Field(gt=0, le=3600)] = 300.0
    cases: Annotated[list[Case], Field(min_length=1, max_length=_MOST)] = [Case()]
    checks: Annotated[list[Check], Field(max_length=_MOST)] = []
