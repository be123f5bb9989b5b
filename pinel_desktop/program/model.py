"""The program document as data models (docs/program-document.md, version 1).

Each command is a model in COMMANDS, a row on that page, a primitive in `execution/primitives/` and a block. What one
model cannot know (types of expressions, functions, loops around a `break`) is checked in `checks.py`.
"""

from dataclasses import field
from functools import cache
from typing import Annotated, Any, Literal

from pydantic import AliasChoices, BeforeValidator, Field, TypeAdapter, field_validator
from pydantic_core import PydanticCustomError

from pinel_desktop.program.base import Model, annotations
from pinel_desktop.program.conditions import ConditionError, parse_condition
from pinel_desktop.program.expressions import AnyNode, Expression, Name, Takes, Text
from pinel_desktop.program.faults import writable
from pinel_desktop.program.limits import (
    MAX_ANGLE_DEG,
    MAX_COMMANDS,
    MAX_DISTANCE_M,
    MAX_REPEATS,
    MAX_WAIT_S,
)

Number = float | AnyNode
Words = str | AnyNode
_Distance = Annotated[Number, Takes("number", ge=0, le=MAX_DISTANCE_M)]
_Place = Annotated[Number, Takes("number", ge=-MAX_DISTANCE_M, le=MAX_DISTANCE_M)]
_Angle = Annotated[Number, Takes("number", ge=-MAX_ANGLE_DEG, le=MAX_ANGLE_DEG)]
_AnyNumber = Annotated[Number, Takes("number")]
_Above0 = Annotated[Number, Takes("number", gt=0)]
_Seconds = Annotated[Number, Takes("number", ge=0, le=MAX_WAIT_S)]
_Timeout = Annotated[Number, Takes("number", gt=0, le=MAX_WAIT_S)]
_Words = Annotated[Words, Takes("text")]

Color = Literal["black", "red", "orange", "yellow", "green", "blue", "purple", "white"]


def _no_boolean(value: Any) -> Any:
    return None if isinstance(value, bool) else value  # True == 1 in Python


def _parsed(condition: Any) -> Any:
    if not isinstance(condition, str):
        return condition
    try:
        return parse_condition(condition)
    except ConditionError as error:
        raise PydanticCustomError(
            "condition_syntax",
            "condition",
            {"position": error.position, "found": writable(error.found)},
        ) from error


# a tree, or a string in the original's grammar
_Condition = Annotated[Expression, BeforeValidator(_parsed)]


class _Command(Model):
    """What every command may carry besides its parameters."""

    block: Text | None = None
    comment: Text | None = None


class MoveForward(_Command):
    action: Literal["move_forward"]
    distance: _Distance


class MoveBackward(_Command):
    action: Literal["move_backward"]
    distance: _Distance


class Turn(_Command):
    action: Literal["turn"]
    angle: _Angle


class Stop(_Command):
    action: Literal["stop"]


class Drive(_Command):
    action: Literal["drive"]
    linear: _AnyNumber
    angular: _AnyNumber


class Arc(_Command):
    action: Literal["arc"]
    radius: _Place
    angle: _Angle


class SetSpeed(_Command):
    action: Literal["set_speed"]
    linear: _Above0 | None = None
    angular: _Above0 | None = None

    def __post_init__(self) -> None:
        if self.linear is None and self.angular is None:
            raise PydanticCustomError("missing_speed", "speed", {})


class GoTo(_Command):
    action: Literal["go_to"]
    x: _Place
    y: _Place
    avoid: bool = False


class Wait(_Command):
    action: Literal["wait"]
    seconds: _Seconds


class WaitUntil(_Command):
    action: Literal["wait_until"]
    condition: _Condition
    timeout: _Timeout | None = None


class Pen(_Command):
    action: Literal["pen"]
    down: bool
    color: Color | None = None


class Ask(_Command):
    action: Literal["ask"]
    question: _Words
    variable: Name


class Mark(_Command):
    action: Literal["mark"]
    symbol: Literal["X", "O"]


class Say(_Command):
    action: Literal["say"]
    text: Expression


class Beep(_Command):
    action: Literal["beep"]


class ClassifyGestures(_Command):
    action: Literal["classify_gestures", "classificar_gestos"]
    timeout: _Timeout = 10.0

    @field_validator("action", mode="after")
    @classmethod
    def _one_spelling(cls, _value: str) -> str:
        return "classify_gestures"


class SetGestureResult(_Command):
    action: Literal["set_gesture_result"]
    result: Annotated[_Words, Field(validation_alias=AliasChoices("result", "resultado"))]


class SetVariable(_Command):
    action: Literal["set_variable"]
    name: Name
    value: Expression


class ChangeVariable(_Command):
    action: Literal["change_variable"]
    name: Name
    by: _AnyNumber


class Append(_Command):
    action: Literal["append"]
    list_: Annotated[Name, Field(alias="list")]
    value: Expression


class Repeat(_Command):
    action: Literal["repeat"]
    times: Annotated[Number, Takes("number", ge=0, le=MAX_REPEATS, whole=True)]
    commands: list["Command"]


class While(_Command):
    action: Literal["while"]
    condition: _Condition
    commands: list["Command"]


class Until(_Command):
    action: Literal["until"]
    condition: _Condition
    commands: list["Command"]


class For(_Command):
    action: Literal["for"]
    variable: Name
    from_: Annotated[_AnyNumber, Field(alias="from")]
    to: _AnyNumber
    by: _AnyNumber = 1.0
    commands: list["Command"]


class Forever(_Command):
    action: Literal["forever"]
    commands: list["Command"]


class Break(_Command):
    action: Literal["break"]


class Continue(_Command):
    action: Literal["continue"]


class Branch(Model):
    """An `elif`."""

    condition: _Condition
    commands: list["Command"]


class ConditionalExecution(_Command):
    action: Literal["conditional_execution"]
    condition: _Condition
    commands: list["Command"]
    elif_: Annotated[list[Branch], Field(alias="elif")] = field(default_factory=list)
    else_: Annotated[list["Command"], Field(alias="else")] = field(default_factory=list)


class Call(_Command):
    action: Literal["call"]
    function: Name
    arguments: dict[Name, Expression] = field(default_factory=dict)


class Return(_Command):
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
    | Wait
    | WaitUntil
    | Pen
    | Ask
    | Mark
    | Say
    | Beep
    | ClassifyGestures
    | SetGestureResult
    | SetVariable
    | ChangeVariable
    | Append
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
COMMANDS: tuple[type[_Command], ...] = Command.__origin__.__args__  # type: ignore[attr-defined]


class Function(Model):
    """A function of the program: its parameters are its own, all other variables are everybody's."""

    name: Name
    parameters: list[Name] = field(default_factory=list)
    commands: list[Command]
    block: Text | None = None
    comment: Text | None = None


class Program(Model):
    """A whole document."""

    pinel_ir: Annotated[Literal[1], BeforeValidator(_no_boolean)]
    name: Text = ""
    functions: list[Function] = field(default_factory=list)
    commands: Annotated[list[Command], Field(max_length=MAX_COMMANDS)]


@cache
def documents() -> TypeAdapter[Program]:
    """Pydantic's way from documents to programs and back, made when it is first needed."""
    return TypeAdapter(Program)


def action_of(model: type[_Command]) -> str:
    """The action that a model of COMMANDS stands for."""
    return str(annotations(model)["action"].__args__[0])


def action_names() -> list[str]:
    """The actions there are, in the order of the page's table."""
    return [action_of(model) for model in COMMANDS]
