"""Pydantic models of world documents: types, names and limits. `placement` checks the geometry.

Units are metres, degrees and kilograms. Import this module only to read a document: pydantic takes longer to load than
all worlds.
"""

import re
from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Discriminator,
    Field,
    Tag,
)
from pydantic_core import PydanticCustomError, PydanticKnownError

from sim.appearance import IF_GIVEN, BoxKind, Ground, Print
from sim.floor import MAX_NAME, Color
from sim.world import (
    DEFAULT_BOX_MASS_KG,
    MAX_MOVABLE_KG,
    MIN_MOVABLE_KG,
    MIN_MOVABLE_SIDE_M,
)

MAX_BYTES = 256 * 1024
MAX_WALLS, MAX_BOXES, MAX_AREAS = 500, 200, 200
MAX_TITLE = 60
MIN_FLOOR_M, MAX_FLOOR_M = 1.0, 50.0
WORLD_NAME = r"^[a-z0-9_]{1,64}$"
_NOT_BLANK = r"\S"

_Metres = Annotated[float, Field(ge=-1000.0, le=1000.0)]
_Degrees = Annotated[float, Field(ge=-360.0, le=360.0)]
_Side = Annotated[float, Field(ge=0.02, le=MAX_FLOOR_M)]
_FloorSide = Annotated[float, Field(ge=MIN_FLOOR_M, le=MAX_FLOOR_M)]
_Radius = Annotated[float, Field(ge=0.01, le=MAX_FLOOR_M / 2)]
_Pair = Field(min_length=2, max_length=2)
_Point = Annotated[list[_Metres], _Pair]
_Text = Annotated[str, Field(max_length=MAX_TITLE, pattern=_NOT_BLANK)]


_TAG = re.compile(r"^[a-z]{2,3}(-[A-Za-z0-9]{2,8})*$")


def _known_tag(tag: str) -> str:
    if _TAG.match(tag) is None:
        raise PydanticKnownError("extra_forbidden")
    return tag


LanguageTag = Annotated[str, AfterValidator(_known_tag)]


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


class Languages(_Part):
    """One text in Portuguese, and in any further language by its tag."""

    model_config = ConfigDict(
        extra="allow", json_schema_extra={"propertyNames": {"pattern": _TAG.pattern}}
    )

    __pydantic_extra__: dict[LanguageTag, _Text] = Field(init=False)
    pt_br: Annotated[_Text, Field(alias="pt-BR")]


class Start(_Part):
    """Pose of the robot at the start."""

    x_m: _Metres
    y_m: _Metres
    heading_deg: _Degrees


class Wall(_Part):
    """A thin straight wall between two points."""

    from_: Annotated[_Point, Field(alias="from")]
    to: _Point


class _Rectangle(_Part):
    center: _Point
    size: Annotated[list[_Side], _Pair]
    heading_deg: _Degrees = 0.0


class _Disc(_Part):
    center: _Point
    radius: _Radius
    heading_deg: _Degrees = 0.0  # without effect; accepted so that every area may have this key


_MOVABLE_LIMITS = {
    "if": {"properties": {"movable": {"const": True}}, "required": ["movable"]},
    "then": {
        "properties": {
            "size": {"items": {"minimum": MIN_MOVABLE_SIDE_M}},
            "mass_kg": {"minimum": MIN_MOVABLE_KG, "maximum": MAX_MOVABLE_KG},
        }
    },
}


class Box(_Rectangle):
    """A box on the floor. The robot can push a movable one, whose sides and mass have limits."""

    model_config = ConfigDict(json_schema_extra=_MOVABLE_LIMITS)  # type: ignore[typeddict-item] # plain JSON

    movable: bool = False
    mass_kg: Annotated[float, Field(ge=0.1, le=100.0)] = DEFAULT_BOX_MASS_KG
    kind: Annotated[BoxKind | None, IF_GIVEN] = None


class _Named(_Part):
    name: Annotated[str, Field(max_length=MAX_NAME, pattern=_NOT_BLANK)]


class _Painted(_Part):
    color: Color


class RectangularZone(_Rectangle, _Named):
    """A rectangle of the floor with a name."""


class RoundZone(_Disc, _Named):
    """A circle of the floor with a name."""


class RectangularPaint(_Rectangle, _Painted):
    """A rectangle of the floor with a colour."""


class RoundPaint(_Disc, _Painted):
    """A circle of the floor with a colour."""


class Printed(_Rectangle):
    """A picture on the floor. The robot neither measures it nor touches it."""

    kind: Print
    color: Annotated[Color | None, IF_GIVEN] = None


def _shape(area: Any) -> str:
    is_disc = "radius" in area if isinstance(area, dict) else isinstance(area, _Disc)
    return "disc" if is_disc else "rectangle"


def _title_form(title: Any) -> str | None:
    if isinstance(title, str):
        return "text"
    return "languages" if isinstance(title, dict | Languages) else None


_Title = Annotated[
    Annotated[_Text, Tag("text")] | Annotated[Languages, Tag("languages")],
    Discriminator(_title_form),
]
_Zone = Annotated[
    Annotated[RectangularZone, Tag("rectangle")] | Annotated[RoundZone, Tag("disc")],
    Discriminator(_shape),
]
_Paint = Annotated[
    Annotated[RectangularPaint, Tag("rectangle")] | Annotated[RoundPaint, Tag("disc")],
    Discriminator(_shape),
]


def _not_boolean(version: Any) -> Any:
    """Refuses booleans, because pydantic accepts `true` as 1."""
    if isinstance(version, bool):
        raise PydanticCustomError("world_version_unknown", "true and false are no numbers")
    return version


class WorldDocument(_Part):
    """A floor centred at (0, 0), its obstacles and painted areas, and the robot's start pose.

    `title` is one text, or one in each language. Later zones and paints cover earlier ones. `ground`, `prints` and the
    `kind` of a box are for the eye only.
    """

    pinel_world: Annotated[Literal[1], BeforeValidator(_not_boolean)]
    name: Annotated[str, Field(pattern=WORLD_NAME)]
    title: _Title
    size_m: Annotated[list[_FloorSide], _Pair]
    start: Start
    walls: Annotated[list[Wall], Field(max_length=MAX_WALLS)]
    boxes: Annotated[list[Box], Field(default_factory=list, max_length=MAX_BOXES)]
    zones: Annotated[list[_Zone], Field(default_factory=list, max_length=MAX_AREAS)]
    floor: Annotated[list[_Paint], Field(default_factory=list, max_length=MAX_AREAS)]
    ground: Annotated[Ground | None, IF_GIVEN] = None
    prints: Annotated[list[Printed], IF_GIVEN, Field(default_factory=list, max_length=MAX_AREAS)]
