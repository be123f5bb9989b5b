"""What an activity may hold: a world, what is given to the program, and what has to be so in the end.

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
    """The program ends by itself and without a failure."""

    check: Literal["finished"]


class EndsAt(_Model):
    """The robot stands near a point of the start frame in the end."""

    check: Literal["ends_at"]
    x_m: _Metres
    y_m: _Metres
    within_m: _Length = 0.1


class EndsHeading(_Model):
    """The robot looks in a direction of the start frame in the end."""

    check: Literal["ends_heading"]
    heading_deg: Annotated[float, Field(ge=-360, le=360)]
    within_deg: Annotated[float, Field(gt=0, le=180)] = 5.0


class EndsIn(_Model):
    """The robot's centre is in a zone of the world in the end."""

    check: Literal["ends_in"]
    zone: _Name


class Visits(_Model):
    """The robot's centre comes through zones of the world, in this order when `ordered`."""

    check: Literal["visits"]
    zones: Annotated[list[_Name], Field(min_length=1, max_length=_MOST)]
    ordered: bool = True


class TouchesNothing(_Model):
    """The robot never touches a wall or a box."""

    check: Literal["touches_nothing"]


class Pushed(_Model):
    """The centre of a box of the world, counted from 0, is in a zone in the end."""

    check: Literal["pushed"]
    box: Annotated[int, Field(ge=0, lt=1000)]
    zone: _Name


class Uses(_Model):
    """The program has so many commands of a kind, wherever they stand."""

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
    """The program says something that contains a text; capitals do not matter."""

    check: Literal["says"]
    text: Annotated[str, Field(min_length=1, max_length=1000)]


class PathLength(_Model):
    """The way that was driven is so long, in metres."""

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
    """What is given to the program in one of its runs."""

    seed: Annotated[int, Field(ge=0, le=2**53 - 1)] = 0
    gestures: list[str] = Field(default_factory=list, max_length=_MOST)
    answers: list[str] = Field(default_factory=list, max_length=_MOST)
    checks: list[Check] = Field(default_factory=list, max_length=_MOST)


class Title(_Model):
    """One text in each language."""

    model_config = ConfigDict(extra="allow", populate_by_name=True)

    __pydantic_extra__: dict[LanguageTag, Annotated[str, Field(max_length=200)]] = Field(init=False)
    pt_br: Annotated[str, Field(alias="pt-BR", max_length=200)]
    en: Annotated[str, Field(max_length=200)]
    es: Annotated[str, Field(max_length=200)]


def _number(version: Any) -> Any:
    """Python takes true for 1; the format does not."""
    if isinstance(version, bool):
        raise PydanticCustomError("activity_value_wrong", "true and false are no numbers")
    return version


class Activity(_Model):
    """A mission: every case is run, and its own checks and those of the activity have to hold.

    Attributes:
        world: the name of one that ships, or a world document.
        limit_s: robot time after which a run is stopped, which fails it.
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
