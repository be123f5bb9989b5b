"""The program document as data models (docs/program-document.md, version 1).

Here: the original's actions, move_backward, repeat and wait. Each further command becomes a model in COMMANDS,
a row on that page, a primitive in `execution/primitives/` and a block; functions become models beside Program.
"""

from typing import Annotated, Any, Literal

from pydantic import AliasChoices, BeforeValidator, Field, field_validator
from pydantic_core import PydanticCustomError

from pinel_desktop.program.conditions import ConditionError, parse_condition
from pinel_desktop.program.expressions import Expression, Model, type_of
from pinel_desktop.program.limits import (
    MAX_ANGLE_DEG,
    MAX_COMMANDS,
    MAX_DISTANCE_M,
    MAX_REPEATS,
    MAX_TEXT,
    MAX_WAIT_S,
)

Text = Annotated[str, Field(max_length=MAX_TEXT)]


def _literal_only(value: Any) -> Any:
    if isinstance(value, dict):
        raise PydanticCustomError("expression_not_supported", "literal only", {})
    return value


def _whole(value: Any) -> Any:
    """3.0 is the whole number 3: JSON does not tell them apart."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _no_boolean(value: Any) -> Any:
    return None if isinstance(value, bool) else value  # True == 1 in Python


Number = Annotated[float, BeforeValidator(_literal_only)]
WholeNumber = Annotated[int, BeforeValidator(_whole), BeforeValidator(_literal_only)]


def _read_condition(value: Any) -> Any:
    if not isinstance(value, str):
        return value
    try:
        return parse_condition(value)
    except ConditionError as error:
        raise PydanticCustomError(
            "condition_syntax", "condition", {"position": error.position, "found": error.found}
        ) from error


def _gives_boolean(value: Any) -> Any:
    if type_of(value) != "boolean":
        raise PydanticCustomError("condition_not_boolean", "condition", {})
    return value


class _Condition(Model):
    """Part of every model that has a condition: a tree, or a string in the original's grammar."""

    condition: Expression

    @field_validator("condition", mode="before")
    @classmethod
    def _parse(cls, value: Any) -> Any:
        return _read_condition(value)

    @field_validator("condition", mode="after")
    @classmethod
    def _boolean(cls, value: Any) -> Any:
        return _gives_boolean(value)


class _Command(Model):
    """What every command may carry besides its parameters."""

    block: Text | None = None
    comment: Text | None = None


class MoveForward(_Command):
    action: Literal["move_forward"]
    distance: Annotated[Number, Field(ge=0, le=MAX_DISTANCE_M)]


class MoveBackward(_Command):
    action: Literal["move_backward"]
    distance: Annotated[Number, Field(ge=0, le=MAX_DISTANCE_M)]


class Turn(_Command):
    action: Literal["turn"]
    angle: Annotated[Number, Field(ge=-MAX_ANGLE_DEG, le=MAX_ANGLE_DEG)]


class Stop(_Command):
    action: Literal["stop"]


class Wait(_Command):
    action: Literal["wait"]
    seconds: Annotated[Number, Field(ge=0, le=MAX_WAIT_S)]


class ClassifyGestures(_Command):
    action: Literal["classify_gestures", "classificar_gestos"]
    timeout: Annotated[Number, Field(gt=0, le=MAX_WAIT_S)] = 10.0

    @field_validator("action", mode="after")
    @classmethod
    def _one_spelling(cls, _value: str) -> str:
        return "classify_gestures"


class SetGestureResult(_Command):
    action: Literal["set_gesture_result"]
    result: Annotated[Text, Field(validation_alias=AliasChoices("result", "resultado"))]


class Repeat(_Command):
    action: Literal["repeat"]
    times: Annotated[WholeNumber, Field(ge=0, le=MAX_REPEATS)]
    commands: list["Command"]


class Branch(_Condition):
    """An `elif`."""

    commands: list["Command"]


class ConditionalExecution(_Command, _Condition):
    action: Literal["conditional_execution"]
    commands: list["Command"]
    elif_: Annotated[list[Branch], Field(alias="elif", default_factory=list)]
    else_: Annotated[list["Command"], Field(alias="else", default_factory=list)]


COMMANDS = (
    MoveForward,
    MoveBackward,
    Turn,
    Stop,
    Wait,
    ClassifyGestures,
    SetGestureResult,
    Repeat,
    ConditionalExecution,
)
Command = Annotated[
    MoveForward
    | MoveBackward
    | Turn
    | Stop
    | Wait
    | ClassifyGestures
    | SetGestureResult
    | Repeat
    | ConditionalExecution,
    Field(discriminator="action"),
]


class Program(Model):
    """A whole document."""

    pinel_ir: Annotated[Literal[1], BeforeValidator(_no_boolean)]
    name: Text = ""
    functions: Annotated[list[Any], Field(max_length=0, default_factory=list)]
    commands: Annotated[list[Command], Field(max_length=MAX_COMMANDS)]


def action_names() -> list[str]:
    """The actions there are, in the order of the page's table."""
    return [model.model_fields["action"].annotation.__args__[0] for model in COMMANDS]  # type: ignore[union-attr]
