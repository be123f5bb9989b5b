"""The program document as data models (docs/program-document.md, version 1).

Each command is a model in COMMANDS, a primitive in `execution/primitives/` and a row of the block table. Its rows in
the docs and its Python form derive from the model. `checks.py` has the checks across models (types of expressions,
functions, loops around a `break`).
"""

from dataclasses import field
from functools import cache
from typing import Annotated, Any, Literal

from pydantic import AliasChoices, BeforeValidator, Field, TypeAdapter, field_validator
from pydantic_core import PydanticCustomError

from pinel_desktop.program.base import Model
from pinel_desktop.program.command import (
    Angle,
    AnyNumber,
    CommandBase,
    Condition,
    Coordinate,
    Count,
    DegreesPerSecond,
    Distance,
    MetresPerSecond,
    Position,
    Seconds,
    Speed,
    Symbol,
    TextValue,
    Timeout,
    TurningSpeed,
    action_of,
)
from pinel_desktop.program.expressions import Expression, Name, Text
from pinel_desktop.program.limits import MAX_COMMANDS
from pinel_desktop.program.sensors import Color


class MoveForward(CommandBase):
    """Drives straight ahead by the distance, with feedback from the measured pose."""

    python = "robot.move_forward(1.0)"
    motion = "straight"
    action: Literal["move_forward"]
    distance: Distance


class MoveBackward(CommandBase):
    """Drives straight backwards by the distance."""

    python = "robot.move_backward(1.0)"
    motion = "straight"
    action: Literal["move_backward"]
    distance: Distance


class Turn(CommandBase):
    """Turns on the spot by the full angle, also beyond 360 degrees; positive is to the left."""

    python = "robot.turn(90)"
    motion = "turn"
    action: Literal["turn"]
    angle: Angle


class Stop(CommandBase):
    """Stops the robot; the next command starts when the robot is at rest."""

    python = "robot.stop()"
    action: Literal["stop"]


class Drive(CommandBase):
    """Sets a velocity until the next motion command or the end; the next command starts at once."""

    python = "robot.drive(0.2, 30)"
    motion = "free"
    action: Literal["drive"]
    linear: MetresPerSecond
    angular: DegreesPerSecond


class Arc(CommandBase):
    """Drives along a circle, turning by the angle: positive is to the left; a negative radius drives backwards."""

    python = "robot.arc(1.0, 90)"
    motion = "arc"
    action: Literal["arc"]
    radius: Coordinate
    angle: Angle


class SetSpeed(CommandBase):
    """Sets the speed limits of later motions, initially 0.6 m/s and 90 degrees/s; either may be omitted."""

    python = "robot.set_speed(linear=0.3, angular=45)"
    action: Literal["set_speed"]
    linear: Speed | None = None
    angular: TurningSpeed | None = None

    def __post_init__(self) -> None:
        if self.linear is None and self.angular is None:
            raise PydanticCustomError("missing_speed", "speed", {})


class GoTo(CommandBase):
    """Turns towards the point and drives there; with `avoid` around obstacles."""

    python = "robot.go_to(2.0, 1.0, avoid=True)"
    motion = "straight"
    action: Literal["go_to"]
    x: Coordinate
    y: Coordinate
    avoid: bool = False


class GoToPlace(CommandBase):
    """Turns towards the middle of the place of that name and drives there; with `avoid` around obstacles."""

    python = 'robot.go_to_place("A", avoid=True)'
    motion = "straight"
    action: Literal["go_to_place"]
    place: TextValue
    avoid: bool = False


class Wait(CommandBase):
    """Waits."""

    python = "robot.wait(2)"
    action: Literal["wait"]
    seconds: Seconds


class WaitUntil(CommandBase):
    """Waits until the condition is true, checked 30 times a second, or until the timeout."""

    python = "robot.wait_until(robot.bumper, timeout=5)"
    action: Literal["wait_until"]
    condition: Condition
    timeout: Timeout | None = None


class Pen(CommandBase):
    """Starts or ends a trail on the floor, blue by default; the pen is up at the start."""

    python = 'robot.pen(down=True, color="red")'
    action: Literal["pen"]
    down: bool
    color: Color | None = None


class Ask(CommandBase):
    """Waits for a person's answer and stores it in the variable, as a number if possible, else as text."""

    python = 'name = robot.ask("What is your name?")'
    action: Literal["ask"]
    question: TextValue
    variable: Name


class Mark(CommandBase):
    """Marks the place under the robot."""

    python = 'robot.mark("X")'
    action: Literal["mark"]
    symbol: Symbol


class Say(CommandBase):
    """Shows a value to the group and records it."""

    python = 'robot.say("Hello")'
    action: Literal["say"]
    text: Expression


class Beep(CommandBase):
    """Makes a sound."""

    python = "robot.beep()"
    action: Literal["beep"]


class ClassifyGestures(CommandBase):
    """Waits for a sign, in real time; the gesture result is then its letter, or "" after the timeout."""

    python = "robot.classify_gestures(timeout=10)"
    action: Literal["classify_gestures", "classificar_gestos"]
    timeout: Timeout = 10.0

    @field_validator("action", mode="after")
    @classmethod
    def _one_spelling(cls, _value: str) -> str:
        return "classify_gestures"


class ReadNumber(CommandBase):
    """Waits for 0 to 10 raised fingers, in real time; the number shown is then that, or -1 after the timeout."""

    python = "robot.read_number(timeout=10)"
    action: Literal["read_number"]
    timeout: Timeout = 10.0


class SetGestureResult(CommandBase):
    """Sets the gesture result by hand."""

    python = 'robot.set_gesture_result("B")'
    action: Literal["set_gesture_result"]
    result: Annotated[TextValue, Field(validation_alias=AliasChoices("result", "resultado"))]


class SetVariable(CommandBase):
    """Assigns a value to a variable."""

    python = "x = 1"
    action: Literal["set_variable"]
    name: Name
    value: Expression


class ChangeVariable(CommandBase):
    """Adds a number to a variable that contains a number; in Python `x -= 1` adds -1."""

    python = "x += 1"
    action: Literal["change_variable"]
    name: Name
    by: AnyNumber


class Append(CommandBase):
    """Appends an item to the list of that name."""

    python = "numbers.append(7)"
    action: Literal["append"]
    list_: Annotated[Name, Field(alias="list")]
    value: Expression


class ReplaceItem(CommandBase):
    """Replaces an item of the list of that name by a value; the first item has the position 1."""

    python = "numbers.replace_item(2, 7)"
    action: Literal["replace_item"]
    list_: Annotated[Name, Field(alias="list")]
    position: Position
    value: Expression


class Repeat(CommandBase):
    """Runs the commands the given number of times."""

    python = "for _ in range(4):"
    action: Literal["repeat"]
    times: Count
    commands: list["Command"]


class While(CommandBase):
    """Runs the commands as long as the condition is true; tests first."""

    python = "while x < 3:"
    action: Literal["while"]
    condition: Condition
    commands: list["Command"]


class Until(CommandBase):
    """Runs the commands as long as the condition is false; tests first."""

    python = "while not robot.bumper:"
    action: Literal["until"]
    condition: Condition
    commands: list["Command"]


class For(CommandBase):
    """Counts from the first number to the last, both included; down for a negative step."""

    python = "for i in steps(1, 10, 2):"
    action: Literal["for"]
    variable: Name
    from_: Annotated[AnyNumber, Field(alias="from")]
    to: AnyNumber
    by: AnyNumber = 1.0
    commands: list["Command"]


class Forever(CommandBase):
    """Runs the commands in an endless loop."""

    python = "while True:"
    action: Literal["forever"]
    commands: list["Command"]


class Break(CommandBase):
    """Leaves the innermost loop."""

    python = "break"
    action: Literal["break"]


class Continue(CommandBase):
    """Continues with the next iteration of the innermost loop."""

    python = "continue"
    action: Literal["continue"]


class Branch(Model):
    """An `elif`."""

    condition: Condition
    commands: list["Command"]


class ConditionalExecution(CommandBase):
    """Runs the first list whose condition is true; in Python `elif x == 2:` and `else:` may follow."""

    python = "if x == 1:"
    action: Literal["conditional_execution"]
    condition: Condition
    commands: list["Command"]
    elif_: Annotated[list[Branch], Field(alias="elif")] = field(default_factory=list)
    else_: Annotated[list["Command"], Field(alias="else")] = field(default_factory=list)


class Call(CommandBase):
    """Runs a function."""

    python = "area(2, 3)"
    action: Literal["call"]
    function: Name
    arguments: dict[Name, Expression] = field(default_factory=dict)


class Return(CommandBase):
    """Leaves the function and returns the value, if given, to the caller."""

    python = "return a * b"
    action: Literal["return"]
    value: Expression | None = None


Command = Annotated[
    MoveForward
    | MoveBackward
    | Turn
    | Stop
    | Drive
    | Arc
    | SetSpeed
    | GoTo
    | GoToPlace
    | Wait
    | WaitUntil
    | Pen
    | Ask
    | Mark
    | Say
    | Beep
    | ClassifyGestures
    | ReadNumber
    | SetGestureResult
    | SetVariable
    | ChangeVariable
    | Append
    | ReplaceItem
    | Repeat
    | While
    | Until
    | For
    | Forever
    | Break
    | Continue
    | ConditionalExecution
    | Call
    | Return,
    Field(discriminator="action"),
]
COMMANDS: tuple[type[CommandBase], ...] = Command.__origin__.__args__  # type: ignore[attr-defined]
MOTIONS = {action_of(model): model.motion for model in COMMANDS if model.motion}


class Function(Model):
    """A function of the program; its parameters are local, all other variables are global."""

    name: Name
    parameters: list[Name] = field(default_factory=list)
    commands: list[Command]
    block: Text | None = None
    comment: Text | None = None


def _no_boolean(value: Any) -> Any:
    return None if isinstance(value, bool) else value  # True == 1 in Python


class Program(Model):
    """A whole document."""

    pinel_ir: Annotated[Literal[1], BeforeValidator(_no_boolean)]
    name: Text = ""
    functions: list[Function] = field(default_factory=list)
    commands: Annotated[list[Command], Field(max_length=MAX_COMMANDS)]


@cache
def documents() -> TypeAdapter[Program]:
    """pydantic's adapter for documents, built on first use."""
    return TypeAdapter(Program)


def action_names() -> list[str]:
    """All actions, in the order of the page's block table."""
    return [action_of(model) for model in COMMANDS]
