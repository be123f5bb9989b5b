"""World documents (`sim/worlds/NAME.json`)."""

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field

from pinel_desktop.web.models import RequestModel, ResponseModel
from pinel_desktop.web.models.errors import Fault
from sim.appearance import IF_GIVEN, BoxKind, Ground, Print

Metres2 = tuple[float, float]


class Title(ResponseModel):
    """A title in Portuguese, and in further languages by their tags."""

    model_config = ConfigDict(extra="allow", populate_by_name=True)

    __pydantic_extra__: dict[str, str] = Field(init=False)
    pt_br: Annotated[str, Field(alias="pt-BR")]


class Start(ResponseModel):
    """Start pose of the robot, in the world's frame."""

    x_m: float
    y_m: float
    heading_deg: float


class Wall(ResponseModel):
    """A straight wall between two points."""

    model_config = ConfigDict(extra="forbid", populate_by_name=True)

    from_: Annotated[Metres2, Field(alias="from")]
    to: Metres2


class Box(ResponseModel):
    """A box on the floor."""

    center: Metres2
    size: Metres2
    heading_deg: float
    movable: bool = False
    mass_kg: Annotated[float, Field(description="of a movable one")] = 2.0
    kind: Annotated[BoxKind | None, IF_GIVEN, Field(description="what it looks like")] = None


class Area(ResponseModel):
    """An area of the floor: a disc with `radius`, or a rectangle with `size`; in metres."""

    center: Metres2
    size: Metres2 | None = None
    heading_deg: float = 0
    radius: float | None = None


class Zone(Area):
    """A named area of the floor, such as a cell of a board."""

    name: str


class Paint(Area):
    """A coloured area of the floor."""

    color: str


class Printed(ResponseModel):
    """A picture on the floor, which the robot neither measures nor touches."""

    kind: Print
    center: Metres2
    size: Metres2
    heading_deg: float = 0
    color: Annotated[str | None, IF_GIVEN] = None


class World(ResponseModel):
    """A floor with walls, boxes, zones, colours and prints."""

    pinel_world: Literal[1]
    name: str
    title: Annotated[Title | str, Field(description="one text, or one in each language")]
    size_m: Metres2
    start: Start
    walls: list[Wall]
    boxes: list[Box]
    zones: list[Zone] = Field(default=[])
    floor: list[Paint] = Field(default=[])
    ground: Annotated[Ground | None, IF_GIVEN, Field(description="of the whole floor")] = None
    prints: Annotated[list[Printed], IF_GIVEN] = Field(default=[])


class WorldToCheck(RequestModel):
    """A world document that may have faults."""

    world: Any


class CheckedWorld(ResponseModel):
    """All faults; if the list is empty, runs can use the world."""

    faults: list[Fault]


class WorldList(ResponseModel):
    """All worlds for runs."""

    worlds: list[World]
