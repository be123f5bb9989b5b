"""Base of all kinds of checks: model, evaluation, texts for pupils, and fields of the teacher's form."""

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
NO_LIMIT = 5_000  # far below the default of a limit that an activity omits
# progress codes of a remaining deviation; not shown for a check that passes
_SHORTFALLS = frozenset({"measured_off", "measured_gap", "measured_drawing", "measured_net"})

# Data that only the simulator provides: the zone of the robot or of a mark, the positions of boxes,
# each contact with a wall or box of the world, and a duration without the speed limits for people's
# safety.
SimulatorRequirement = Literal["zones", "boxes", "contact", "pace"]


@dataclass(frozen=True, slots=True)
class RealRobotTolerance:
    """Errors of a real robot's motions, which checks must tolerate.

    Attributes:
        move_m, turn_deg: error of position and heading at the end of a motion.
        path: relative error of the path length: the robot overshoots its goals a little and returns.
    """

    move_m: float
    turn_deg: float
    path: float


@dataclass(frozen=True, slots=True)
class CheckResult:
    """Result of evaluating a check.

    Attributes:
        measured, target: measured and required value: m, degrees, s, a number or a name.
        pointer: JSON pointer of the command to look at, or None.
        code: message code for a check that does not pass; `values` are its parameters.
        progress: message code of the progress; "" if a number adds nothing.
        is_irrecoverable: whether the rest of the run cannot make the check pass any more.
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
        """Returns the progress as text, such as "agora a 12 cm"; "" if a number adds nothing."""
        if not self.progress or (self.passed and self.progress in _SHORTFALLS):
            return ""
        return text(self.progress, language, **self.values)


class CheckFault(NamedTuple):
    """A reason why no program could pass a check: path within the check, code and params of the fault."""

    path: Path
    code: str
    params: dict[str, object]


@dataclass(frozen=True, slots=True)
class FormField:
    """A parameter of a check in the teacher's form.

    Attributes:
        key: name of the parameter.
        input: `number`; `text`; `zone`, a zone of the world; `shown`, a list to read; `fixed`, always `value`.
        label: label of a number, a key of `making.numbers` in the page's texts.
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
    """Returns the field of a length, which is in m in the check and in cm in the form."""
    return FormField(key, "number", "cm", min_cm, max_cm, factor=100)


class CheckBase(Model):
    """Base of all kinds of checks.

    Attributes:
        requires: data of the simulator that the check needs; None if the program, the run's events and the robot's
            own odometry suffice. Every kind declares it.
        is_about_end: whether the check is about the end of the run. During a run such a check counts as
            met only after it did not pass once, because the start may already satisfy it.
        form: fields of the teacher's form; None for a kind that the form does not offer.
        label: text in the check list; None for the criterion of the kind.
        check: name of the kind.
    """

    requires: ClassVar[SimulatorRequirement | None]
    is_about_end: ClassVar[bool] = False
    form: ClassVar[tuple[FormField, ...] | None] = None

    label: Title | None = None
    check: str

    def evaluate(self, evidence: Evidence) -> CheckResult:
        """Returns the result of the check for the evidence of a run."""
        raise NotImplementedError

    def criterion(self, language: str) -> str:
        """Returns the criterion as an instruction, such as "Terminar em “padaria”"."""
        return text(f"criterion_{self.check}", language, **self.model_dump())

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        """Returns the initial parameters in the teacher's form; None if the check is of no use for the solution."""
        return None

    def requirements(self) -> frozenset[SimulatorRequirement]:
        """Returns all data of the simulator that the check needs."""
        return frozenset() if self.requires is None else frozenset((self.requires,))

    def with_tolerance(self, tolerance: RealRobotTolerance) -> Self:
        """Returns the check for a run on a real robot, with a tolerance that the robot's motions can meet."""
        return self

    def zones_named(self) -> dict[Path, str]:
        """Returns the zones of the world that the check names, by their path in the check."""
        return {}

    def goal_zones(self) -> list[str]:
        """Returns the zones that the robot must reach, for the picture of the goal."""
        return list(self.zones_named().values())

    def faults(self, world: World | None) -> Iterator[CheckFault]:
        """Yields the reasons why no program could pass the check in a world; `world` is None if unknown."""
        known = [zone.name for zone in world.zones] if world else None
        for path, name in self.zones_named().items():
            if known is not None and name not in known:
                params: dict[str, object] = {"value": name, "allowed": known}
                yield CheckFault(path, "activity_unknown_zone", params)

    def line(self, language: str) -> str:
        """Returns the text of the check in the check list."""
        return self.label.of(language) if self.label else self.criterion(language)


def text(code: str, language: str, **values: Any) -> str:
    """Returns the message of a code, with values formatted for the language."""
    return describe(code, formatted_values(values, language), language).message


def counted(code: str, n: int, language: str, **values: Any) -> str:
    """Returns the message in its form for a count."""
    return describe(code, {**formatted_values(values, language), "count": n}, language).message


def place_text(x_m: float, y_m: float, within_m: float, language: str) -> str:
    """Returns where a point of the start frame lies, seen from the start; "" within `within_m` of it."""
    ahead = ("place_ahead" if x_m > 0 else "place_behind", x_m)
    aside = ("place_left" if y_m > 0 else "place_right", y_m)
    places = [
        text(code, language, by_m=abs(by)) for code, by in (ahead, aside) if abs(by) > within_m
    ]
    return text("criteria_and", language).join(places)


def side(angle_deg: float, language: str) -> str:
    """Returns the word for left or right; a positive angle is to the left."""
    return text("block_left" if angle_deg > 0 else "block_right", language)


def rounded(value: float, digits: int = 2) -> float:
    """Rounds a number as the form shows it."""
    return round(value, digits) + 0.0  # no -0.0


def limits_faults(key: str, min_value: float, max_value: float) -> Iterator[CheckFault]:
    """Yields a fault if a lower limit exceeds its upper limit; `key` is the key of the lower limit."""
    if min_value > max_value:
        params: dict[str, object] = {"name": key, "value": min_value, "max": max_value}
        yield CheckFault((key,), "activity_limits_crossed", params)
