"""Base of the commands in `model.py`, and types of parameters with their bounds and units.

A parameter is a literal or an expression.
"""

from typing import Annotated, Any

from pydantic import BeforeValidator
from pydantic_core import PydanticCustomError

from pinel_desktop.program.base import Model, annotations
from pinel_desktop.program.conditions import ConditionError, parse_condition
from pinel_desktop.program.expressions import AnyNode, Expression, ParameterSpec, Text
from pinel_desktop.program.faults import encodable
from pinel_desktop.program.limits import (
    MAX_ANGLE_DEG,
    MAX_DISTANCE_M,
    MAX_LIST,
    MAX_REPEATS,
    MAX_WAIT_S,
)

Number = float | AnyNode
Distance = Annotated[Number, ParameterSpec("number", ge=0, le=MAX_DISTANCE_M, unit="m")]
Coordinate = Annotated[
    Number, ParameterSpec("number", ge=-MAX_DISTANCE_M, le=MAX_DISTANCE_M, unit="m")
]
Angle = Annotated[
    Number, ParameterSpec("number", ge=-MAX_ANGLE_DEG, le=MAX_ANGLE_DEG, unit="degrees")
]
AnyNumber = Annotated[Number, ParameterSpec("number")]
MetresPerSecond = Annotated[Number, ParameterSpec("number", unit="m/s")]
DegreesPerSecond = Annotated[Number, ParameterSpec("number", unit="degrees/s")]
Speed = Annotated[Number, ParameterSpec("number", gt=0, unit="m/s")]
TurningSpeed = Annotated[Number, ParameterSpec("number", gt=0, unit="degrees/s")]
Seconds = Annotated[Number, ParameterSpec("number", ge=0, le=MAX_WAIT_S, unit="s")]
Timeout = Annotated[Number, ParameterSpec("number", gt=0, le=MAX_WAIT_S, unit="s")]
Count = Annotated[Number, ParameterSpec("number", ge=0, le=MAX_REPEATS, whole=True)]
Position = Annotated[Number, ParameterSpec("number", ge=1, le=MAX_LIST, whole=True)]
TextValue = Annotated[str | AnyNode, ParameterSpec("text")]
Symbol = Annotated[str | AnyNode, ParameterSpec("text", choices=("X", "O"))]


def _parsed(condition: Any) -> Any:
    if not isinstance(condition, str):
        return condition
    try:
        return parse_condition(condition)
    except ConditionError as error:
        raise PydanticCustomError(
            "condition_syntax",
            "condition",
            {"position": error.position, "found": encodable(error.found)},
        ) from error


# a tree, or a string in the grammar of `conditions.py`
Condition = Annotated[Expression, BeforeValidator(_parsed)]


class CommandBase(Model):
    """Base of all commands, with their common optional keys.

    The docstring of a command describes what the robot does, for docs/program-document.md and docs/python-text.md.

    Attributes:
        python: an example of the command in Python text. A command `robot.NAME(...)` is read and written by its fields.
        motion: how it moves the robot: "straight", "turn" on the spot, "arc", or "free" for a velocity; else "".
    """

    python = ""
    motion = ""
    block: Text | None = None
    comment: Text | None = None


def parameters_of(model: type[CommandBase]) -> dict[str, Any]:
    """The parameters of a command with their annotations."""
    of_all = {"action", *annotations(CommandBase)}
    return {key: kind for key, kind in annotations(model).items() if key not in of_all}


def action_of(model: type[CommandBase]) -> str:
    """The action of a model in COMMANDS."""
    return str(annotations(model)["action"].__args__[0])
