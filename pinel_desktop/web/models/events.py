"""Events as they are on the wire: flat objects told apart by `type` (ARCHITECTURE.md, Events)."""

from typing import Annotated, Literal

from pydantic import Field, RootModel

from pinel_desktop.web.models import Id, Json, Shape, Time

# not a default, which the page's types would take for a promise
_MAYBE_ABSENT = Field(default_factory=lambda: None)


class RunEvent(Shape):
    """What every event of a run carries; time in s is tick / 30."""

    v: Literal[1]
    run: Id
    seq: int
    tick: int


class RunStateEvent(RunEvent):
    """The run goes on or waits; runs of earlier releases do not tell why and where."""

    type: Literal["run_state"]
    state: Literal["running", "paused"]
    cause: Annotated[Literal["person", "breakpoint", "step"] | None, _MAYBE_ABSENT]
    block: Annotated[str | None, _MAYBE_ABSENT]
    n_begun: Annotated[int | None, _MAYBE_ABSENT]


class BlockStartedEvent(RunEvent):
    """A block begins; `amount` is the goal of a motion in m, degrees or s."""

    type: Literal["block_started"]
    block: str | None
    pointer: str
    action: str
    amount: float | None


class BlockEndedEvent(RunEvent):
    """A block is done."""

    type: Literal["block_ended"]
    block: str | None
    pointer: str


class CaptureStartedEvent(RunEvent):
    """The run waits for a sign."""

    type: Literal["capture_started"]
    block: str | None
    timeout_s: float


class GestureResultEvent(RunEvent):
    """A sign was recognised or set; "" means none."""

    type: Literal["gesture_result"]
    result: str
    source: Literal["capture", "block"]


class SaidEvent(RunEvent):
    """The program says something to the group."""

    type: Literal["said"]
    block: str | None
    text: str


class MarkedEvent(RunEvent):
    """A mark on the floor, in the start frame."""

    type: Literal["marked"]
    block: str | None
    symbol: Literal["X", "O"]
    x_m: float
    y_m: float


class BeepedEvent(RunEvent):
    """The robot beeps."""

    type: Literal["beeped"]
    block: str | None


class PenEvent(RunEvent):
    """From now on the way is drawn on the floor, or no longer."""

    type: Literal["pen"]
    block: str | None
    down: bool
    color: str


class AskedEvent(RunEvent):
    """The run waits for an answer."""

    type: Literal["asked"]
    block: str | None
    question: str
    variable: str


class AnsweredEvent(RunEvent):
    """A question was answered; what reads as a number is one."""

    type: Literal["answered"]
    variable: str
    value: str | float


class StackEntry(Shape):
    """A call that runs, and the block that calls."""

    function: str | None
    block: str | None


class WatchEvent(RunEvent):
    """Variables as they are now, long ones cut; the calls that run, the outermost first; the gesture result."""

    type: Literal["watch"]
    variables: Json
    stack: list[StackEntry]
    gesture: str


class TelemetryEvent(RunEvent):
    """Where the robot is and what it was told, in the start frame."""

    type: Literal["telemetry"]
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
    done: float | None
    bumper: bool
    true_x_m: Annotated[float | None, _MAYBE_ABSENT]
    true_y_m: Annotated[float | None, _MAYBE_ABSENT]
    true_yaw_rad: Annotated[float | None, _MAYBE_ABSENT]


class ThingsEvent(RunEvent):
    """Where movable boxes are that have moved: x and y in m, yaw in rad, world's frame, by their place in its list."""

    type: Literal["things"]
    boxes: dict[str, tuple[float, float, float]]


class RangesEvent(RunEvent):
    """What the sensors measure while somebody looks, in m; the lidar from -90 to 90 degrees."""

    type: Literal["ranges"]
    sonar: list[float] | None
    lidar: list[float] | None


class Pose(Shape):
    """A pose in the start frame."""

    x_m: float
    y_m: float
    yaw_rad: float


class RunEndedEvent(RunEvent):
    """Closes every run, once; the figures are null where the run was interrupted."""

    type: Literal["run_ended"]
    state: Literal["finished", "stopped", "failed"]
    reason: str | None
    params: Json
    block: str | None
    n_executed: int | None
    duration_s: float | None
    path_length_m: float | None
    closing_error_m: float | None
    pose: Pose | None
    telemetry_sha256: str | None


class HelloEvent(Shape):
    """The first event of the stream."""

    type: Literal["hello"]
    run: Id | None


class NoticeEvent(Shape):
    """Something a person should know now, such as a full disk."""

    type: Literal["notice"]
    code: str
    message: str
    remedy: str


class JudgedEvent(Shape):
    """Whether a run that has ended passed the activity of its lesson; `missing` is in words what does not hold yet.

    `missing` is null where the program fulfils the activity, but the run did not come to its end.
    """

    type: Literal["judged"]
    run: Id
    passed: bool
    missing: str | None


class ProgramEvent(Shape):
    """What became of a program, for all windows that have it open.

    `version` is the one that was saved, null where the program went into the bin or came out of it.
    """

    type: Literal["program"]
    program: Id
    version: Id | None
    deleted_at: Time | None


_OfRun = (
    RunStateEvent
    | BlockStartedEvent
    | BlockEndedEvent
    | CaptureStartedEvent
    | GestureResultEvent
    | SaidEvent
    | MarkedEvent
    | BeepedEvent
    | PenEvent
    | AskedEvent
    | AnsweredEvent
    | WatchEvent
    | TelemetryEvent
    | ThingsEvent
    | RangesEvent
    | RunEndedEvent
)


class Event(RootModel[Annotated[_OfRun, Field(discriminator="type")]]):
    """One event of a run."""


class StreamEvent(
    RootModel[
        Annotated[
            _OfRun | HelloEvent | NoticeEvent | JudgedEvent | ProgramEvent,
            Field(discriminator="type"),
        ]
    ]
):
    """What one `data:` line of the stream holds."""
