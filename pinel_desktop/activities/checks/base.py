"""What every kind of check has: its model, how it is evaluated, and what pupil and teacher read and choose of it."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Self

from pydantic import Field

from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.activities.texts import Model, Title
from pinel_desktop.activities.wording import formatted_values
from pinel_desktop.messages import describe
from sim.world import World

Name = Annotated[str, Field(min_length=1, max_length=64)]
Metres = Annotated[float, Field(ge=-100, le=100)]
Length = Annotated[float, Field(gt=0, le=10_000)]
Value = float | str | None
Path = tuple[str | int, ...]
MAX_ITEMS = 100
NO_LIMIT = 5_000  # a limit that an activity leaves out is far above
# how much is lacking, which says nothing of a check that passes
_SHORTFALLS = frozenset({"measured_off", "measured_gap", "measured_drawing", "measured_net"})

# What only the simulator tells of a run: which zone of the world the robot or a mark is in, where boxes are, each touch
# of a wall or box of the world, and how fast a robot is that nobody slows down for people's safety.
SimulatorRequirement = Literal["zones", "boxes", "contact", "pace"]


@dataclass(frozen=True, slots=True)
class RealRobotTolerance:
    """How exactly a real robot does what a person calls arrived.

    Attributes:
        move_m, turn_deg: error of a pose at the end of a motion.
        path: share of the length of its path: it drives past its goals a little, and back.
    """

    move_m: float
    turn_deg: float
    path: float


@dataclass(frozen=True, slots=True)
class CheckResult:
    """What evaluating a check gave.

    Attributes:
        measured, target: what was measured, and what it should be: m, degrees, s, a number or a name.
        pointer: JSON pointer of the command to look at, or None.
        code: the words where it does not pass; `values` fill them.
        progress: code of the words of how far the run is; "" where they say nothing more.
        is_irrecoverable: whether nothing that the run still does can make it pass.
    """

    passed: bool
    measured: Value
    target: Value
    pointer: str | None
    code: str
    values: dict[str, Any] = field(default_factory=dict)
    progress: str = ""
    is_irrecoverable: bool = False

    def progress_text(self, language: str) -> str:
        """How far the run is: "agora a 12 cm"; "" where a number says nothing more."""
        if not self.progress or (self.passed and self.progress in _SHORTFALLS):
            return ""
        return text(self.progress, language, **self.values)


class CheckFault(NamedTuple):
    """Why no program could pass a check: path within it, code and params of the fault."""

    path: Path
    code: str
    params: dict[str, object]


@dataclass(frozen=True, slots=True)
class FormField:
    """A parameter of a check in the teacher's form.

    Attributes:
        key: of the check.
        input: `number`; `text`; `zone`, one of the world's; `shown`, a list to read; `fixed`, always `value`.
        label: of a number, among `making.numbers` of the page's texts.
        min, max, step: of the number in the form, which is the parameter times `factor`.
    """

    key: str
    input: Literal["number", "text", "zone", "shown", "fixed"]
    label: Literal["cm", "least", "most", "n"] | None = None
    min: float = 0
    max: float = 0
    step: float = 1
    factor: int = 1
    value: int | None = None


def centimetres(key: str, min_cm: int = 1, max_cm: int = 500) -> FormField:
    """A length in m, which the form has in cm."""
    return FormField(key, "number", "cm", min_cm, max_cm, factor=100)


class CheckBase(Model):
    """Base of all kinds.

    Attributes:
        requires: what it needs that only the simulator tells; None where the program, the run's events and the robot's
            own odometry suffice. Every kind declares it.
        is_about_end: whether it is about where the robot is at the end, which tells nothing before it has been
            elsewhere.
        form: what the teacher chooses of it; None for a kind that the form does not offer.
        label: what the check list of the card calls it; None for the words of its kind.
        check: the name of its kind.
    """

    requires: ClassVar[SimulatorRequirement | None]
    is_about_end: ClassVar[bool] = False
    form: ClassVar[tuple[FormField, ...] | None] = None

    label: Title | None = None
    check: str

    def evaluate(self, evidence: Evidence) -> CheckResult:
        """Whether the check passes by what is known of a run."""
        raise NotImplementedError

    def criterion(self, language: str) -> str:
        """What counts, as an order: "Terminar em “padaria”"."""
        return text(f"criterion_{self.check}", language, **self.model_dump())

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        """Parameters that the teacher's form begins with; None where it is of no use for that solution."""
        return None

    def requirements(self) -> frozenset[SimulatorRequirement]:
        """All that it needs of the simulator."""
        return frozenset() if self.requires is None else frozenset((self.requires,))

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        """The check for a run on a real robot, with a tolerance that its motions can meet."""
        return self

    def zones_named(self) -> dict[Path, str]:
        """The zones of the world that it names, by where it names them."""
        return {}

    def goal_zones(self) -> list[str]:
        """The zones where the robot has to get, for the picture of the goal."""
        return list(self.zones_named().values())

    def faults(self, world: World | None) -> Iterator[CheckFault]:
        """Why no program could pass it in a world; None for a world that is not known."""
        known = [zone.name for zone in world.zones] if world else None
        for path, name in self.zones_named().items():
            if known is not None and name not in known:
                params: dict[str, object] = {"value": name, "allowed": known}
                yield CheckFault(path, "activity_unknown_zone", params)

    def line(self, language: str) -> str:
        """What the check list calls it."""
        return self.label.of(language) if self.label else self.criterion(language)


def text(code: str, language: str, **values: Any) -> str:
    """The message of a code with values in the form of the language."""
    return describe(code, formatted_values(values, language), language).message


def counted(code: str, n: int, language: str, **values: Any) -> str:
    """Words for none, one or several."""
    ending = {0: "_none", 1: "_one"}.get(n, "")
    return text(f"{code}{ending}", language, n=n, **values)


def side(angle_deg: float, language: str) -> str:
    """To the left or to the right."""
    return text("block_left" if angle_deg > 0 else "block_right", language)


def rounded(value: float, digits: int = 2) -> float:
    """A number as a form shows it."""
    return round(value, digits) + 0.0  # no -0.0


def limits_faults(key: str, min_value: float, max_value: float) -> Iterator[CheckFault]:
    """The fault of a least value, by its key, that is above the greatest."""
    if min_value > max_value:
        params: dict[str, object] = {"name": key, "value": min_value, "max": max_value}
        yield CheckFault((key,), "activity_limits_crossed", params)
