"""What a run reports. The fields are those of the table in ARCHITECTURE.md; a test holds them together."""

from dataclasses import asdict, dataclass, field
from typing import Any, ClassVar, Literal

SCHEMA_VERSION = 1


@dataclass(frozen=True, slots=True)
class Event:
    """Base of all events. `type` is the event's name on the wire."""

    type: ClassVar[str]


PauseCause = Literal["person", "breakpoint", "step"]


@dataclass(frozen=True, slots=True)
class RunState(Event):
    """The run has begun, was paused or goes on.

    `cause` is why it pauses; `block` is the one that begins next, or in whose middle the run stands; `n_begun` is how
    many commands had begun, loops and conditionals too, so that the run can be held there again.
    """

    type: ClassVar[str] = "run_state"
    state: Literal["running", "paused"]
    cause: PauseCause | None = None
    block: str | None = None
    n_begun: int | None = None


@dataclass(frozen=True, slots=True)
class BlockStarted(Event):
    """A command begins. `amount` is the goal of a motion or wait in m, degrees or s."""

    type: ClassVar[str] = "block_started"
    block: str | None
    pointer: str
    action: str
    amount: float | None = None


@dataclass(frozen=True, slots=True)
class BlockEnded(Event):
    """A command, with everything inside it, is over."""

    type: ClassVar[str] = "block_ended"
    block: str | None
    pointer: str


@dataclass(frozen=True, slots=True)
class CaptureStarted(Event):
    """The program waits for a gesture, for at most `timeout_s` seconds."""

    type: ClassVar[str] = "capture_started"
    block: str | None
    timeout_s: float


@dataclass(frozen=True, slots=True)
class GestureResult(Event):
    """The gesture result has a new value; "" when nothing was recognised."""

    type: ClassVar[str] = "gesture_result"
    result: str
    source: Literal["capture", "block"]


@dataclass(frozen=True, slots=True)
class Said(Event):
    """The program says something to the group."""

    type: ClassVar[str] = "said"
    block: str | None
    text: str


@dataclass(frozen=True, slots=True)
class Marked(Event):
    """A mark on the floor, "X" or "O", where the robot stands; start frame."""

    type: ClassVar[str] = "marked"
    block: str | None
    symbol: str
    x_m: float
    y_m: float


@dataclass(frozen=True, slots=True)
class Beeped(Event):
    """The robot beeps."""

    type: ClassVar[str] = "beeped"
    block: str | None


@dataclass(frozen=True, slots=True)
class Pen(Event):
    """From now on the robot draws its way on the floor, or does not. It is up at the start."""

    type: ClassVar[str] = "pen"
    block: str | None
    down: bool
    color: str


@dataclass(frozen=True, slots=True)
class Asked(Event):
    """The program waits for an answer of the group, which `variable` gets."""

    type: ClassVar[str] = "asked"
    block: str | None
    question: str
    variable: str


@dataclass(frozen=True, slots=True)
class Answered(Event):
    """A question was answered; what reads as a number is one."""

    type: ClassVar[str] = "answered"
    variable: str
    value: str | float


@dataclass(frozen=True, slots=True)
class Watch(Event):
    """The inside of the program has changed: at most five times a second, when it pauses and when it ends.

    `variables` are those that can be seen, long texts and lists cut; `stack` holds a `{"function", "block"}` for each
    call that runs, the outermost first, `block` being the one that calls.
    """

    type: ClassVar[str] = "watch"
    variables: dict[str, Any]
    stack: list[dict[str, str | None]]
    gesture: str


@dataclass(frozen=True, slots=True)
class Telemetry(Event):
    """One tick. Poses in the start frame, metres and radians; `goal_*` is the moving set-point.

    `done` is how much of the running motion's `amount` is done, in its unit; 0 when nothing moves. The pose is the one
    that the robot believes; `true_*` is where it is, where somebody knows.
    """

    type: ClassVar[str] = "telemetry"
    x_m: float
    y_m: float
    yaw_rad: float
    v_mps: float
    omega_radps: float
    command_v_mps: float
    command_omega_radps: float
    goal_x_m: float
    goal_y_m: float
    goal_yaw_rad: float
    done: float
    bumper: bool
    true_x_m: float | None
    true_y_m: float | None
    true_yaw_rad: float | None


@dataclass(frozen=True, slots=True)
class Things(Event):
    """Movable boxes that have moved since the last such event, at most ten times a second and once at the end.

    `boxes` holds x and y (m) and yaw (rad) in the world's frame, by the box's place in the world's list.
    """

    type: ClassVar[str] = "things"
    boxes: dict[str, list[float]]


@dataclass(frozen=True, slots=True)
class Ranges(Event):
    """What the sensors measure, in m, at most ten times a second while somebody has asked for it; not kept.

    `sonar` by index; `lidar` from -90 to 90 degrees, a beam for each degree; null what was not asked for or is not
    there.
    """

    type: ClassVar[str] = "ranges"
    sonar: list[float] | None
    lidar: list[float] | None


@dataclass(frozen=True, slots=True)
class RunEnded(Event):
    """The last event of every run. Lengths in m, `duration_s` in robot time."""

    type: ClassVar[str] = "run_ended"
    state: Literal["finished", "stopped", "failed"]
    reason: str | None
    params: dict[str, Any]
    block: str | None
    n_executed: int
    duration_s: float
    path_length_m: float
    closing_error_m: float
    pose: dict[str, float] | None
    telemetry_sha256: str


EVENT_TYPES: dict[str, type[Event]] = {
    cls.type: cls
    for cls in (
        RunState,
        BlockStarted,
        BlockEnded,
        CaptureStarted,
        GestureResult,
        Said,
        Marked,
        Beeped,
        Pen,
        Asked,
        Answered,
        Watch,
        Telemetry,
        Things,
        Ranges,
        RunEnded,
    )
}


@dataclass(slots=True)
class EventStamp:
    """Turns the events of one run into wire objects, numbering them."""

    run: str
    _next: int = field(default=0)

    def wire(self, tick: int, event: Event) -> dict[str, Any]:
        """The event as the flat JSON object of ARCHITECTURE.md."""
        head = {
            "v": SCHEMA_VERSION,
            "type": event.type,
            "run": self.run,
            "seq": self._next,
            "tick": tick,
        }
        self._next += 1
        return {**head, **asdict(event)}
