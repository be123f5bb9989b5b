"""The events of a run, each declared here once as a frozen dataclass.

The wire models, the OpenAPI schema, the page's types and docs/events.md are generated from these declarations. Code
that records or drops events reads their traits (`types.py`). Recorded runs contain these names, so a `type` or a field
is never renamed. A field with a default is absent from runs that earlier releases recorded.
"""

from dataclasses import asdict, dataclass, fields
from typing import Annotated, Any, ClassVar, Final, Literal, Self, TypedDict


@dataclass(frozen=True, slots=True)
class StreamEvent:
    """Base of all events on the stream. `type` is the event's name on the wire.

    Three class attributes are the traits of an event type:

    - `is_recorded`: the event is stored, merged between PCs, and compared when a run is verified;
    - `lossy`: the hub may drop the event for a page that reads too slowly;
    - `urgent`: the event is written to the disk at once, because the next event may come much later.
    """

    type: ClassVar[str]
    is_recorded: ClassVar[bool] = False
    lossy: ClassVar[bool] = False
    urgent: ClassVar[bool] = False

    def to_wire(self) -> dict[str, Any]:
        """Returns the event as a flat JSON object."""
        return {"type": self.type, **asdict(self)}


@dataclass(frozen=True, slots=True)
class Event(StreamEvent):
    """Base of the events of a run. Poses are in the start frame, in metres and radians, unless a field differs."""

    is_recorded: ClassVar[bool] = True


class NullIfInterrupted:
    """Marks a field that is null on the wire if the run was interrupted by a power cut or a lost engine."""


PauseCause = Literal["person", "breakpoint", "step"]
CaptureOf = Literal["sign", "number"]
CaptureBy = Literal["camera", "taught", "person", "list"]
_NULL_IF_INTERRUPTED: Final = NullIfInterrupted()


class StackEntry(TypedDict):
    """A running function call.

    Attributes:
        function: name of the function.
        block: id of the block that calls it.
    """

    function: str | None
    block: str | None


class Pose(TypedDict):
    """A pose in the start frame."""

    x_m: float
    y_m: float
    yaw_rad: float


@dataclass(frozen=True, slots=True)
class RunState(Event):
    """The run has started, was paused or was resumed.

    Attributes:
        state: the new state of the run.
        cause: why the run pauses; null when it runs.
        block: id of the block that starts next, or of the block in whose middle the run pauses.
        n_begun: number of commands started so far, including loops and conditionals; verification pauses at the same
            number.
    """

    type: ClassVar[str] = "run_state"
    urgent: ClassVar[bool] = True
    state: Literal["running", "paused"]
    cause: PauseCause | None = None
    block: str | None = None
    n_begun: int | None = None


@dataclass(frozen=True, slots=True)
class BlockStarted(Event):
    """A command starts.

    Attributes:
        block: id of its block.
        pointer: JSON pointer of the command in the program document.
        action: name of the command.
        amount: goal of a motion or a wait in m, degrees or s; null for other commands.
    """

    type: ClassVar[str] = "block_started"
    block: str | None
    pointer: str
    action: str
    amount: float | None


@dataclass(frozen=True, slots=True)
class BlockEnded(Event):
    """A command and all commands inside it are done.

    Attributes:
        block: id of its block.
        pointer: JSON pointer of the command in the program document.
    """

    type: ClassVar[str] = "block_ended"
    block: str | None
    pointer: str


@dataclass(frozen=True, slots=True)
class CaptureStarted(Event):
    """The program waits for a sign, or for a number shown by hand.

    Attributes:
        block: id of the block that waits.
        timeout_s: longest time that it waits, in s.
        what: what it waits for.
    """

    type: ClassVar[str] = "capture_started"
    urgent: ClassVar[bool] = True
    block: str | None
    timeout_s: float
    what: CaptureOf = "sign"


@dataclass(frozen=True, slots=True)
class GestureResult(Event):
    """The gesture result has a new value, or the number shown has.

    Attributes:
        result: name of the sign, or the number in digits; "" when none was recognised.
        source: whether a capture recognised the sign or a block set it.
        by: source of a captured sign: the camera (`taught`: with a sign that the class taught it), a person by hand,
            or a list given beforehand; null after the timeout and for a block.
        confidence: confidence of the camera, 0 to 1; null for all other sources.
        second: the camera's second best sign; "" without one.
        what: what was captured; a number leaves the gesture result as it is.
    """

    type: ClassVar[str] = "gesture_result"
    result: str
    source: Literal["capture", "block"]
    by: CaptureBy | None = None
    confidence: float | None = None
    second: str = ""
    what: CaptureOf = "sign"


@dataclass(frozen=True, slots=True)
class TextShown(Event):
    """The program shows a text to the group.

    Attributes:
        block: id of the block that shows it.
        text: the text.
    """

    type: ClassVar[str] = "said"
    block: str | None
    text: str


@dataclass(frozen=True, slots=True)
class Marked(Event):
    """The robot puts a mark on the floor at its own position.

    Attributes:
        block: id of the block that puts the mark.
        symbol: shape of the mark.
        x_m: x of the mark in the start frame, in m.
        y_m: y of the mark in the start frame, in m.
    """

    type: ClassVar[str] = "marked"
    block: str | None
    symbol: Literal["X", "O"]
    x_m: float
    y_m: float


@dataclass(frozen=True, slots=True)
class Beeped(Event):
    """The robot beeps.

    Attributes:
        block: id of the block that beeps.
    """

    type: ClassVar[str] = "beeped"
    block: str | None


@dataclass(frozen=True, slots=True)
class Pen(Event):
    """The pen was lowered or raised. While it is down, the robot draws its path on the floor; a run starts with it up.

    Attributes:
        block: id of the block that moves the pen.
        down: whether the pen is down.
        color: name of the colour.
    """

    type: ClassVar[str] = "pen"
    block: str | None
    down: bool
    color: str


@dataclass(frozen=True, slots=True)
class Asked(Event):
    """The program waits for an answer of the group.

    Attributes:
        block: id of the block that asks.
        question: the question.
        variable: name of the variable that gets the answer.
    """

    type: ClassVar[str] = "asked"
    urgent: ClassVar[bool] = True
    block: str | None
    question: str
    variable: str


@dataclass(frozen=True, slots=True)
class Answered(Event):
    """A question was answered.

    Attributes:
        variable: name of the variable that gets the answer.
        value: the answer; a number if the text is one.
    """

    type: ClassVar[str] = "answered"
    variable: str
    value: str | float


@dataclass(frozen=True, slots=True)
class Watch(Event):
    """Variables or function calls have changed. Sent at most five times a second, when the run pauses and at its end.

    Attributes:
        variables: value of each visible variable by its name; long texts and lists are shortened.
        stack: the running function calls, the outermost first.
        gesture: the gesture result; "" without one.
        number: the number shown by hand; -1 without one.
    """

    type: ClassVar[str] = "watch"
    variables: dict[str, Any]
    stack: list[StackEntry]
    gesture: str
    number: int = -1


@dataclass(frozen=True, slots=True)
class Telemetry(Event):
    """One tick of the robot: pose, velocity, command and setpoint.

    The pose is the robot's estimate. `true_*` is the true pose, which only the simulator knows; else null. The store
    holds telemetry as columns of numbers, separate from the other events.

    Attributes:
        x_m: estimated x, in m.
        y_m: estimated y, in m.
        yaw_rad: estimated heading, in rad.
        v_mps: measured linear velocity in m/s.
        omega_radps: measured angular velocity in rad/s.
        command_v_mps: commanded linear velocity in m/s.
        command_omega_radps: commanded angular velocity in rad/s.
        goal_x_m: x of the moving setpoint, in m.
        goal_y_m: y of the moving setpoint, in m.
        goal_yaw_rad: heading of the moving setpoint, in rad.
        done: finished part of the running motion's `amount`, in the unit of `amount`; 0 without a motion.
        bumper: whether the robot touches an obstacle.
        true_x_m: true x, in m.
        true_y_m: true y, in m.
        true_yaw_rad: true heading, in rad.
    """

    type: ClassVar[str] = "telemetry"
    lossy: ClassVar[bool] = True
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
    true_x_m: float | None = None
    true_y_m: float | None = None
    true_yaw_rad: float | None = None


@dataclass(frozen=True, slots=True)
class BoxesMoved(Event):
    """Movable boxes have moved. Sent at most ten times a second, and once at the end of the run.

    Attributes:
        boxes: x (m), y (m) and yaw (rad) in the world's frame, by the box's index in the world's list; only boxes that
            have moved since the previous event of this type.
    """

    type: ClassVar[str] = "things"
    boxes: dict[str, tuple[float, float, float]]


@dataclass(frozen=True, slots=True)
class Countdown(Event):
    """A capture waits for a person or a camera. Sent at most five times a second, not while the run is paused.

    Attributes:
        left_s: real time until the capture's timeout, in s.
    """

    type: ClassVar[str] = "countdown"
    is_recorded: ClassVar[bool] = False
    lossy: ClassVar[bool] = True
    left_s: float


@dataclass(frozen=True, slots=True)
class Ranges(Event):
    """Readings of the range sensors. Sent at most ten times a second, while a page subscribes to them.

    Attributes:
        sonar: distances in m by index; null without a subscription or without sonars.
        lidar: distances in m over the scanner's field, from right to left, one beam per degree; null without a
            subscription or without a scanner.
    """

    type: ClassVar[str] = "ranges"
    is_recorded: ClassVar[bool] = False
    lossy: ClassVar[bool] = True
    sonar: list[float] | None
    lidar: list[float] | None


@dataclass(frozen=True, slots=True)
class CommandsAwaited(Event):
    """All commands of an open run are done. The run waits for further commands and then continues (docs/bridge.md).

    Attributes:
        n_executed: number of commands executed since the start of the run.
        result: the last gesture result.
    """

    type: ClassVar[str] = "commands_awaited"
    is_recorded: ClassVar[bool] = False
    n_executed: int
    result: str


@dataclass(frozen=True, slots=True)
class RunEnded(Event):
    """The last event of every run. Exactly one closes each run.

    Metrics are null if a lost engine or a power cut interrupted the run.

    Attributes:
        state: how the run ended.
        reason: code of the reason; null if the run finished.
        params: parameters of the reason's message.
        block: id of the block that was running.
        n_executed: number of executed commands.
        duration_s: robot time, in s.
        path_length_m: length of the path, in m: of the true path in the simulator, else of the robot's own poses
            without their noise.
        closing_error_m: true distance between start and end, in m; null without true poses, as on a real robot. In runs
            of earlier releases, which lack `estimated_closing_error_m`, it is the estimated distance.
        pose: the estimated pose.
        telemetry_sha256: hash of the telemetry, which verification must reproduce.
        estimated_closing_error_m: distance between start and end by the robot's estimated poses, in m.
    """

    type: ClassVar[str] = "run_ended"
    urgent: ClassVar[bool] = True
    state: Literal["finished", "stopped", "failed"]
    reason: str | None
    params: dict[str, Any]
    block: str | None
    n_executed: Annotated[int, _NULL_IF_INTERRUPTED]
    duration_s: Annotated[float, _NULL_IF_INTERRUPTED]
    path_length_m: Annotated[float, _NULL_IF_INTERRUPTED]
    closing_error_m: float | None
    pose: Pose | None
    telemetry_sha256: Annotated[str, _NULL_IF_INTERRUPTED]
    estimated_closing_error_m: float | None = None

    @classmethod
    def interrupted(cls, reason: str, duration_s: float) -> Self:
        """Returns the end of an interrupted run; all metrics except `duration_s` are null."""
        unknown: dict[str, Any] = dict.fromkeys(one.name for one in fields(cls))
        known = {"state": "failed", "reason": reason, "params": {}, "duration_s": duration_s}
        return cls(**(unknown | known))
