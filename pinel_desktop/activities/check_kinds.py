"""The kinds of checks as models.

Every kind is a model here with its tag, a function in `checks.py`, words in
`messages/catalogue/LANGUAGE/activities.json` and a row in docs/activities.md. It declares what a run on a real robot
tells about it: `needs`, and `widened` where it has a tolerance.
"""

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field

from pinel_desktop.activities.texts import Model, Title

Name = Annotated[str, Field(min_length=1, max_length=64)]
Metres = Annotated[float, Field(ge=-100, le=100)]
Length = Annotated[float, Field(gt=0, le=10_000)]
MOST = 100


# What only the simulator tells of a run: which zone of the world the robot or a mark is in, where boxes are, each touch
# of a wall or box of the world, and how fast a robot is that nobody slows down for people's safety.
Need = Literal["zones", "boxes", "contact", "pace"]


@dataclass(frozen=True, slots=True)
class Slack:
    """How exactly a real robot does what a person calls arrived.

    Attributes:
        move_m, turn_deg: error of a pose at the end of a motion.
        way: share of the length of its way: it drives past its goals a little, and back.
    """

    move_m: float
    turn_deg: float
    way: float


class AnyCheck(Model):
    """Base of all kinds.

    Attributes:
        needs: what it needs that only the simulator tells; None where the program, the run's events and the robot's
            own odometry suffice. Every kind declares it.
        label: what the check list of the card calls it; None for the words of its kind.
    """

    needs: ClassVar[Need | None]

    label: Title | None = None

    def widened(self, slack: Slack) -> Self:
        """The check for a run on a real robot, with a tolerance that its motions can meet."""
        return self


class Finished(AnyCheck):
    """The run ends by itself and without a failure."""

    needs = None
    check: Literal["finished"]


class EndsAt(AnyCheck):
    """At the end the robot is within `within_m` of a point of the start frame."""

    needs = None
    check: Literal["ends_at"]
    x_m: Metres
    y_m: Metres
    within_m: Length = 0.1

    def widened(self, slack: Slack) -> Self:
        return self.model_copy(update={"within_m": max(self.within_m, slack.move_m)})


class EndsHeading(AnyCheck):
    """At the end the robot has a heading in the start frame, within `within_deg`."""

    needs = None
    check: Literal["ends_heading"]
    heading_deg: Annotated[float, Field(ge=-360, le=360)]
    within_deg: Annotated[float, Field(gt=0, le=180)] = 5.0

    def widened(self, slack: Slack) -> Self:
        return self.model_copy(update={"within_deg": max(self.within_deg, slack.turn_deg)})


class EndsIn(AnyCheck):
    """At the end the robot's centre is in a zone of the world."""

    needs = "zones"
    check: Literal["ends_in"]
    zone: Name


class Visits(AnyCheck):
    """The robot's centre passes through zones of the world, in this order if `ordered`."""

    needs = "zones"
    check: Literal["visits"]
    zones: Annotated[list[Name], Field(min_length=1, max_length=MOST)]
    ordered: bool = True


class TouchesNothing(AnyCheck):
    """The robot never touches a wall or a box."""

    needs = "contact"
    check: Literal["touches_nothing"]


class Pushed(AnyCheck):
    """At the end the centre of a box, by its index in the world, is in a zone."""

    needs = "boxes"
    check: Literal["pushed"]
    box: Annotated[int, Field(ge=0, lt=1000)]
    zone: Name


class Uses(AnyCheck):
    """The program has from `at_least` to `at_most` commands of a kind, at any level of nesting."""

    needs = None
    check: Literal["uses"]
    action: Name
    at_least: Annotated[int, Field(ge=0, le=20_000)] = 1
    at_most: Annotated[int, Field(ge=0, le=20_000)] = 20_000


class Marks(AnyCheck):
    """The program leaves a mark in a zone of the world."""

    needs = "zones"
    check: Literal["marks"]
    symbol: Literal["X", "O"]
    zone: Name


class Says(AnyCheck):
    """The program says something that contains a text, ignoring case."""

    needs = None
    check: Literal["says"]
    text: Annotated[str, Field(min_length=1, max_length=1000)]


class PathLength(AnyCheck):
    """The length of the path driven is within limits, in metres."""

    needs = None
    check: Literal["path_length"]
    at_least_m: Annotated[float, Field(ge=0, le=10_000)] = 0.0
    at_most_m: Length = 10_000.0

    def widened(self, slack: Slack) -> Self:
        least_m = self.at_least_m * (1 - slack.way)
        most_m = max(self.at_most_m * (1 + slack.way), slack.move_m)
        return self.model_copy(update={"at_least_m": least_m, "at_most_m": most_m})


Point = Annotated[list[Metres], Field(min_length=2, max_length=2)]
Line = Annotated[list[Point], Field(min_length=2, max_length=500)]


class Draws(AnyCheck):
    """What the pen drew, or the path, is the template: no point of either is farther than `tolerance` from the other.

    Attributes:
        template: lines in m; `scale`, `rotate` and `move` tell whether size, direction and place are free.
        mirror: whether the mirrored figure is right as well.
        figure: its name where several figures are right.
    """

    needs = None
    check: Literal["draws"]
    template: Annotated[list[Line], Field(min_length=1, max_length=MOST)]
    tolerance: Annotated[float, Field(gt=0, le=10)] = 0.06
    scale: bool = True
    rotate: bool = True
    move: bool = True
    mirror: bool = False
    of: Literal["trail", "path"] = "trail"
    figure: Name | None = None

    def widened(self, slack: Slack) -> Self:
        return self.model_copy(update={"tolerance": max(self.tolerance, slack.move_m)})


class Closed(AnyCheck):
    """The last point that the pen drew is within `within_m` of the first."""

    needs = None
    check: Literal["closed"]
    within_m: Length = 0.05

    def widened(self, slack: Slack) -> Self:
        return self.model_copy(update={"within_m": max(self.within_m, slack.move_m)})


class Symmetric(AnyCheck):
    """What the pen drew has at least so many mirror axes through its centroid; `tolerance` is in r.m.s. radii."""

    needs = None
    check: Literal["symmetric"]
    axes: Annotated[int, Field(ge=1, le=180)]
    tolerance: Annotated[float, Field(gt=0, le=1)] = 0.06


class TurnedTotal(AnyCheck):
    """All turning is within limits, and what remains with sign (positive: left) is `net_deg`."""

    needs = None
    check: Literal["turned_total"]
    at_least_deg: Annotated[float, Field(ge=0, le=1_000_000)] = 0.0
    at_most_deg: Annotated[float, Field(gt=0, le=1_000_000)] = 1_000_000.0
    net_deg: Annotated[float, Field(ge=-1_000_000, le=1_000_000)] | None = None
    net_within: Annotated[float, Field(gt=0, le=1_000_000)] = 10.0

    def widened(self, slack: Slack) -> Self:
        least_deg = max(0.0, self.at_least_deg - slack.turn_deg)
        most_deg = self.at_most_deg * (1 + slack.way) + slack.turn_deg
        within = max(self.net_within, slack.turn_deg)
        changes = {"at_least_deg": least_deg, "at_most_deg": most_deg, "net_within": within}
        return self.model_copy(update=changes)


class BlockCount(AnyCheck):
    """The program has at most so many commands."""

    needs = None
    check: Literal["block_count"]
    at_most: Annotated[int, Field(ge=1, le=20_000)]


class Nesting(AnyCheck):
    """The program has loops in loops, so many deep."""

    needs = None
    check: Literal["nesting"]
    at_least: Annotated[int, Field(ge=1, le=100)]


class Executed(AnyCheck):
    """A kind of command begins so many times in the run."""

    needs = None
    check: Literal["executed"]
    action: Name
    n: Annotated[int, Field(ge=0, le=1_000_000)]


class MarkCount(AnyCheck):
    """The run leaves so many marks."""

    needs = None
    check: Literal["mark_count"]
    n: Annotated[int, Field(ge=0, le=10_000)]


class Time(AnyCheck):
    """The run takes at most so much robot time."""

    needs = "pace"
    check: Literal["time"]
    at_most_s: Annotated[float, Field(gt=0, le=3600)]


class AnyOf(AnyCheck):
    """One of several checks holds. What it needs is what its checks need (`needs_of`)."""

    needs = None
    check: Literal["any_of"]
    checks: "Annotated[list[Check], Field(min_length=1, max_length=MOST)]"

    def widened(self, slack: Slack) -> Self:
        return self.model_copy(update={"checks": [one.widened(slack) for one in self.checks]})


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


def needs_of(check: Check) -> frozenset[Need]:
    """All that a check needs of the simulator: another check that holds does not tell that one of these fails."""
    if isinstance(check, AnyOf):
        return frozenset().union(*map(needs_of, check.checks))
    return frozenset() if check.needs is None else frozenset((check.needs,))
