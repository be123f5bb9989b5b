"""The kinds of checks as models.

Every kind is a model here with its tag, a function in `checks.py`, words in
`messages/catalogue/LANGUAGE/activities.json` and a row in docs/activities.md.
"""

from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.activities.texts import Model, Title

Name = Annotated[str, Field(min_length=1, max_length=64)]
Metres = Annotated[float, Field(ge=-100, le=100)]
Length = Annotated[float, Field(gt=0, le=10_000)]
MOST = 100


class AnyCheck(Model):
    """Base of all kinds.

    Attributes:
        label: what the check list of the card calls it; None for the words of its kind.
    """

    label: Title | None = None


class Finished(AnyCheck):
    """The run ends by itself and without a failure."""

    check: Literal["finished"]


class EndsAt(AnyCheck):
    """At the end the robot is within `within_m` of a point of the start frame."""

    check: Literal["ends_at"]
    x_m: Metres
    y_m: Metres
    within_m: Length = 0.1


class EndsHeading(AnyCheck):
    """At the end the robot has a heading in the start frame, within `within_deg`."""

    check: Literal["ends_heading"]
    heading_deg: Annotated[float, Field(ge=-360, le=360)]
    within_deg: Annotated[float, Field(gt=0, le=180)] = 5.0


class EndsIn(AnyCheck):
    """At the end the robot's centre is in a zone of the world."""

    check: Literal["ends_in"]
    zone: Name


class Visits(AnyCheck):
    """The robot's centre passes through zones of the world, in this order if `ordered`."""

    check: Literal["visits"]
    zones: Annotated[list[Name], Field(min_length=1, max_length=MOST)]
    ordered: bool = True


class TouchesNothing(AnyCheck):
    """The robot never touches a wall or a box."""

    check: Literal["touches_nothing"]


class Pushed(AnyCheck):
    """At the end the centre of a box, by its index in the world, is in a zone."""

    check: Literal["pushed"]
    box: Annotated[int, Field(ge=0, lt=1000)]
    zone: Name


class Uses(AnyCheck):
    """The program has from `at_least` to `at_most` commands of a kind, at any level of nesting."""

    check: Literal["uses"]
    action: Name
    at_least: Annotated[int, Field(ge=0, le=20_000)] = 1
    at_most: Annotated[int, Field(ge=0, le=20_000)] = 20_000


class Marks(AnyCheck):
    """The program leaves a mark in a zone of the world."""

    check: Literal["marks"]
    symbol: Literal["X", "O"]
    zone: Name


class Says(AnyCheck):
    """The program says something that contains a text, ignoring case."""

    check: Literal["says"]
    text: Annotated[str, Field(min_length=1, max_length=1000)]


class PathLength(AnyCheck):
    """The length of the path driven is within limits, in metres."""

    check: Literal["path_length"]
    at_least_m: Annotated[float, Field(ge=0, le=10_000)] = 0.0
    at_most_m: Length = 10_000.0


Point = Annotated[list[Metres], Field(min_length=2, max_length=2)]
Line = Annotated[list[Point], Field(min_length=2, max_length=500)]


class Draws(AnyCheck):
    """What the pen drew, or the path, is the template: no point of either is farther than `tolerance` from the other.

    Attributes:
        template: lines in m; `scale`, `rotate` and `move` tell whether size, direction and place are free.
        mirror: whether the mirrored figure is right as well.
        figure: its name where several figures are right.
    """

    check: Literal["draws"]
    template: Annotated[list[Line], Field(min_length=1, max_length=MOST)]
    tolerance: Annotated[float, Field(gt=0, le=10)] = 0.06
    scale: bool = True
    rotate: bool = True
    move: bool = True
    mirror: bool = False
    of: Literal["trail", "path"] = "trail"
    figure: Name | None = None


class Closed(AnyCheck):
    """The last point that the pen drew is within `within_m` of the first."""

    check: Literal["closed"]
    within_m: Length = 0.05


class Symmetric(AnyCheck):
    """What the pen drew has at least so many mirror axes through its centroid; `tolerance` is in r.m.s. radii."""

    check: Literal["symmetric"]
    axes: Annotated[int, Field(ge=1, le=180)]
    tolerance: Annotated[float, Field(gt=0, le=1)] = 0.06


class TurnedTotal(AnyCheck):
    """All turning is within limits, and what remains with sign (positive: left) is `net_deg`."""

    check: Literal["turned_total"]
    at_least_deg: Annotated[float, Field(ge=0, le=1_000_000)] = 0.0
    at_most_deg: Annotated[float, Field(gt=0, le=1_000_000)] = 1_000_000.0
    net_deg: Annotated[float, Field(ge=-1_000_000, le=1_000_000)] | None = None
    net_within: Annotated[float, Field(gt=0, le=1_000_000)] = 10.0


class BlockCount(AnyCheck):
    """The program has at most so many commands."""

    check: Literal["block_count"]
    at_most: Annotated[int, Field(ge=1, le=20_000)]


class Nesting(AnyCheck):
    """The program has loops in loops, so many deep."""

    check: Literal["nesting"]
    at_least: Annotated[int, Field(ge=1, le=100)]


class Executed(AnyCheck):
    """A kind of command begins so many times in the run."""

    check: Literal["executed"]
    action: Name
    n: Annotated[int, Field(ge=0, le=1_000_000)]


class MarkCount(AnyCheck):
    """The run leaves so many marks."""

    check: Literal["mark_count"]
    n: Annotated[int, Field(ge=0, le=10_000)]


class Time(AnyCheck):
    """The run takes at most so much robot time."""

    check: Literal["time"]
    at_most_s: Annotated[float, Field(gt=0, le=3600)]


class AnyOf(AnyCheck):
    """One of several checks holds."""

    check: Literal["any_of"]
    checks: "Annotated[list[Check], Field(min_length=1, max_length=MOST)]"


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
    | PathLength
    | Draws
    | Closed
    | Symmetric
    | TurnedTotal
    | BlockCount
    | Nesting
    | Executed
    | MarkCount
    | Time
    | AnyOf,
    Field(discriminator="check"),
]

AnyOf.model_rebuild()
