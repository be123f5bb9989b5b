"""What a run reports: one frozen dataclass for each event, declared here and nowhere else.

The wire models, the OpenAPI schema, the page's types and docs/events.md are made from these declarations, and whoever
keeps or drops events asks them (`types.py`). Runs are recorded with these names: a `type` or a field is never renamed.
A field with a default is absent from runs that earlier releases recorded.
"""

from dataclasses import asdict, dataclass, fields
from typing import Annotated, Any, ClassVar, Final, Literal, Self, TypedDict


@dataclass(frozen=True, slots=True)
class StreamEvent:
    """Base of all that the stream tells. `type` is the event's name on the wire.

    The class attributes say what is done with every event of the type:

    - `is_recorded`: it is stored, merged between PCs, and compared when a run is verified;
    - `lossy`: it may be dropped for a page that reads too slowly;
    - `urgent`: it is written to the disk at once, since nothing may follow it for long.
    """

    type: ClassVar[str]
    is_recorded: ClassVar[bool] = False
    lossy: ClassVar[bool] = False
    urgent: ClassVar[bool] = False

    def to_wire(self) -> dict[str, Any]:
        """The event as a flat JSON object."""
        return {"type": self.type, **asdict(self)}


@dataclass(frozen=True, slots=True)
class Event(StreamEvent):
    """Base of what a run reports; poses are in the start frame, metres and radians, unless the field says otherwise."""

    is_recorded: ClassVar[bool] = True


class NullIfInterrupted:
    """Marks a field that is null on the wire when nobody saw the end of the run: power cut, engine lost."""


PauseCause = Literal["person", "breakpoint", "step"]
CaptureBy = Literal["camera", "taught", "person", "list"]
_NULL_IF_INTERRUPTED: Final = NullIfInterrupted()


class StackEntry(TypedDict):
    """A function call that is running.

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
    """The run has begun, was paused or goes on.

    Attributes:
        state: what it does from now on.
        cause: why it pauses; null when it runs.
        block: the block that begins next, or in whose middle the run stands.
        n_begun: how many commands had begun, loops and conditionals included, so that a repetition can pause there.
    """

    type: ClassVar[str] = "run_state"
    urgent: ClassVar[bool] = True
    state: Literal["running", "paused"]
    cause: PauseCause | None = None
    block: str | None = None
    n_begun: int | None = None


@dataclass(frozen=True, slots=True)
class BlockStarted(Event):
    """A command begins.

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
    """A command, with everything inside it, is over.

    Attributes:
        block: id of its block.
        pointer: JSON pointer of the command in the program document.
    """

    type: ClassVar[str] = "block_ended"
    block: str | None
    pointer: str


@dataclass(frozen=True, slots=True)
class CaptureStarted(Event):
    """The program waits for a sign.

    Attributes:
        block: id of the block that waits.
        timeout_s: how long at most, in s.
    """

    type: ClassVar[str] = "capture_started"
    urgent: ClassVar[bool] = True
    block: str | None
    timeout_s: float


@dataclass(frozen=True, slots=True)
class GestureResult(Event):
    """The gesture result has a new value.

    Attributes:
        result: name of the sign; "" when none was recognised.
        source: whether a capture recognised it or a block set it.
        by: who gave it: the camera (`taught`: with a sign the class taught it), a person by hand, or a list given
            beforehand; null after the timeout and for a block.
        confidence: of the camera, 0 to 1; null from all others.
        second: the camera's second best sign; "" when there is none.
    """

    type: ClassVar[str] = "gesture_result"
    result: str
    source: Literal["capture", "block"]
    by: CaptureBy | None = None
    confidence: float | None = None
    second: str = ""


@dataclass(frozen=True, slots=True)
class TextShown(Event):
    """The program says something to the group.

    Attributes:
        block: id of the block that says it.
        text: what it says.
    """

    type: ClassVar[str] = "said"
    block: str | None
    text: str


@dataclass(frozen=True, slots=True)
class Marked(Event):
    """A mark is put on the floor where the robot stands.

    Attributes:
        block: id of the block that marks.
        symbol: shape of the mark.
        x_m: its position, in m.
        y_m: its position, in m.
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
    """From now on the robot draws its path on the floor, or does not. The pen is up at the start.

    Attributes:
        block: id of the block that moves the pen.
        down: whether it draws.
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
        value: the answer; a number where it reads as one.
    """

    type: ClassVar[str] = "answered"
    variable: str
    value: str | float


@dataclass(frozen=True, slots=True)
class Watch(Event):
    """Variables or calls have changed: at most five times a second, when the run pauses and when it ends.

    Attributes:
        variables: value of each visible variable by its name; long texts and lists are cut.
        stack: the calls that are running, the outermost first.
        gesture: the gesture result; "" for none.
    """

    type: ClassVar[str] = "watch"
    variables: dict[str, Any]
    stack: list[StackEntry]
    gesture: str


@dataclass(frozen=True, slots=True)
class Telemetry(Event):
    """One tick of the robot: pose, velocity, command and setpoint.

    The pose is the one that the robot estimates; `true_*` is the true one, null where nobody knows it. The store keeps
    telemetry as columns of numbers, apart from the other events.

    Attributes:
        x_m: estimated position, in m.
        y_m: estimated position, in m.
        yaw_rad: estimated heading, in rad.
        v_mps: measured linear velocity in m/s.
        omega_radps: measured angular velocity in rad/s.
        command_v_mps: commanded linear velocity in m/s.
        command_omega_radps: commanded angular velocity in rad/s.
        goal_x_m: the moving setpoint, in m.
        goal_y_m: the moving setpoint, in m.
        goal_yaw_rad: the moving setpoint, in rad.
        done: how much of the running motion's `amount` is done, in its unit; 0 when nothing moves.
        bumper: whether the robot touches something.
        true_x_m: true position, in m.
        true_y_m: true position, in m.
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
    """Movable boxes have moved: at most ten times a second, and once at the end.

    Attributes:
        boxes: x (m), y (m) and yaw (rad) in the world's frame, by the box's place in the world's list; only boxes
            that have moved since the last such event.
    """

    type: ClassVar[str] = "things"
    boxes: dict[str, tuple[float, float, float]]


@dataclass(frozen=True, slots=True)
class Countdown(Event):
    """The capture that a person or a camera is to answer goes on; at most five times a second, not while it is paused.

    Attributes:
        left_s: seconds of real time until the capture's timeout.
    """

    type: ClassVar[str] = "countdown"
    is_recorded: ClassVar[bool] = False
    lossy: ClassVar[bool] = True
    left_s: float


@dataclass(frozen=True, slots=True)
class Ranges(Event):
    """What the range sensors measure, at most ten times a second while a page has subscribed to them.

    Attributes:
        sonar: distance in m by index; null when nobody subscribed or the robot has none.
        lidar: distance in m over the scanner's field, from the right to the left, one beam per degree; null likewise.
    """

    type: ClassVar[str] = "ranges"
    is_recorded: ClassVar[bool] = False
    lossy: ClassVar[bool] = True
    sonar: list[float] | None
    lidar: list[float] | None


@dataclass(frozen=True, slots=True)
class CommandsAwaited(Event):
    """All commands of an open run are done: it waits for the next ones, which continue it (docs/bridge.md).

    Attributes:
        n_executed: how many commands were executed since the run began.
        result: the last gesture result.
    """

    type: ClassVar[str] = "commands_awaited"
    is_recorded: ClassVar[bool] = False
    n_executed: int
    result: str


@dataclass(frozen=True, slots=True)
class RunEnded(Event):
    """The last event of every run. Exactly one closes each run.

    Figures are null when the run was cut off by a lost engine or a power cut.

    Attributes:
        state: how it ended.
        reason: code of the reason; null where it finished.
        params: parameters of the reason's message.
        block: the block that was running.
        n_executed: how many commands were executed.
        duration_s: robot time, in s.
        path_length_m: length of the way, in m: the true one in the simulator, else that of the robot's own poses
            without their noise.
        closing_error_m: distance between start and end, in m, where the robot truly is; null where only its estimate
            exists, as on a real robot. Without `estimated_closing_error_m` beside it, it is the estimate: so earlier
            releases recorded it.
        pose: the estimated pose.
        telemetry_sha256: hash of the telemetry, which a repetition must give again.
        estimated_closing_error_m: distance between start and end as the robot estimates its pose, in m.
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
        """The end of a run that nobody saw: what is known without it, null for the rest."""
        unknown: dict[str, Any] = dict.fromkeys(one.name for one in fields(cls))
        known = {"state": "failed", "reason": reason, "params": {}, "duration_s": duration_s}
        return cls(**(unknown | known))
