"""Expressions as data: literals, operators, variables, sensors, the gesture result, calls. Nothing here evaluates.

A new kind of expression is a model here with its tag in `_KINDS`, its checks in `checks.py` and a case in
`execution/evaluation.py`; a new operator is a row in `operators.py`.
"""

from dataclasses import dataclass, field
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, GetCoreSchemaHandler, Tag
from pydantic_core import CoreSchema, core_schema

from pinel_desktop.program.base import Model
from pinel_desktop.program.limits import MAX_LIDAR_DEG, MAX_LIST, MAX_NAME, MAX_SONAR, MAX_TEXT

Text = Annotated[str, Field(max_length=MAX_TEXT)]
# letters of any script with their marks, digits, underscores; spaces between
NAME_PATTERN = r"^[\p{L}\p{M}\p{N}_](?:[\p{L}\p{M}\p{N}_ ]*[\p{L}\p{M}\p{N}_])?$"
Name = Annotated[str, Field(max_length=MAX_NAME, pattern=NAME_PATTERN)]


@dataclass(frozen=True, slots=True)
class Takes:
    """Marks a parameter that takes a literal of one type within bounds, or an expression.

    Literals are tried first, in pydantic's own code: nearly all parameters of nearly all programs are literals.
    """

    type: Literal["number", "text"]
    ge: float | None = None
    gt: float | None = None
    le: float | None = None
    whole: bool = False

    @property
    def is_bounded(self) -> bool:
        """Whether a literal of the right type can still be wrong."""
        return (self.ge, self.gt, self.le) != (None, None, None)

    def __get_pydantic_core_schema__(
        self, _source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        node = handler.generate_schema(Node)
        return core_schema.union_schema([self._literal(), node], mode="left_to_right")

    def _literal(self) -> CoreSchema:
        if self.type == "text":
            return core_schema.str_schema(strict=True, max_length=MAX_TEXT)
        bounds = {"ge": self.ge, "gt": self.gt, "le": self.le}
        given: Any = {name: bound for name, bound in bounds.items() if bound is not None}
        if not self.whole:
            return core_schema.float_schema(strict=True, allow_inf_nan=False, **given)
        whole: Any = {name: int(bound) for name, bound in given.items()}
        schema = core_schema.int_schema(strict=True, **whole)
        return core_schema.no_info_before_validator_function(_whole, schema)


def _whole(value: Any) -> Any:
    """3.0 is the whole number 3: JSON does not tell them apart."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


class GestureResult(Model):
    """The last gesture result, a text."""

    gesture: Literal["result"]


class Variable(Model):
    """The value of a variable, or of a parameter of the function around it."""

    var: Name


class Operation(Model):
    """An operator with its arguments."""

    op: str
    args: list["Expression"]


class Sonar(Model):
    """What one of the 16 sonars measures, in m; 5.0 when nothing is near."""

    sensor: Literal["sonar"]
    index: Annotated["float | AnyNode", Takes("number", ge=0, le=MAX_SONAR, whole=True)]


class Distance(Model):
    """How much room there is in a direction, in m."""

    sensor: Literal["distance"]
    direction: Literal["front", "left", "right", "back"]


class Lidar(Model):
    """What the laser scanner measures at an angle in degrees, in m."""

    sensor: Literal["lidar"]
    angle: Annotated["float | AnyNode", Takes("number", ge=-MAX_LIDAR_DEG, le=MAX_LIDAR_DEG)]


class Measure(Model):
    """x, y in m, heading in degrees, bumper, time in s, colour of the floor, name of the cell."""

    sensor: Literal["x", "y", "heading", "bumper", "time", "floor", "cell"]


class FunctionCall(Model):
    """The value that a function returns."""

    call: Name
    arguments: dict[Name, "Expression"] = field(default_factory=dict)


AnyNode = Operation | Variable | GestureResult | Sonar | Distance | Lidar | Measure | FunctionCall

# Tags stand in pydantic's error locations; with a space they are never taken for a key of the document.
_SENSOR_KINDS = {"sonar": "a sonar", "distance": "a distance", "lidar": "a lidar"}


_MODELS: dict[type, str] = {
    Operation: "an operation",
    Variable: "a variable",
    GestureResult: "a gesture",
    Sonar: "a sonar",
    Distance: "a distance",
    Lidar: "a lidar",
    Measure: "a measure",
    FunctionCall: "a call",
}


def _node_kind(value: Any) -> str | None:
    """Which model a node is to be read, or written, as; None for what is none."""
    if value.__class__ is not dict:
        return _MODELS.get(type(value))
    if "op" in value:
        return "an operation"
    if "var" in value:
        return "a variable"
    if "sensor" in value:
        sensor = value["sensor"]
        return _SENSOR_KINDS.get(sensor, "a measure") if isinstance(sensor, str) else "a measure"
    if "gesture" in value:
        return "a gesture"
    return "a call" if "call" in value else None


def _kind(value: Any) -> str | None:
    return "a list" if value.__class__ is list else _node_kind(value)


def _unknown(kind: Any) -> Discriminator:
    return Discriminator(
        kind, custom_error_type="unknown_expression", custom_error_message="expression"
    )


# Literals are tried first and in pydantic's own code: most of what a program holds are literals.
_FIRST_THAT_FITS = Field(union_mode="left_to_right")
Item = Annotated[Text | float | bool, _FIRST_THAT_FITS]

_Nodes = (
    Annotated[Operation, Tag("an operation")]
    | Annotated[Variable, Tag("a variable")]
    | Annotated[GestureResult, Tag("a gesture")]
    | Annotated[Sonar, Tag("a sonar")]
    | Annotated[Distance, Tag("a distance")]
    | Annotated[Lidar, Tag("a lidar")]
    | Annotated[Measure, Tag("a measure")]
    | Annotated[FunctionCall, Tag("a call")]
)
Node = Annotated[_Nodes, _unknown(_node_kind)]
_ListOrNode = Annotated[
    Annotated[list[Item], Field(max_length=MAX_LIST), Tag("a list")] | _Nodes, _unknown(_kind)
]
Expression = Annotated[Text | float | bool | _ListOrNode, _FIRST_THAT_FITS]
