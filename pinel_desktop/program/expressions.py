"""Models of expressions: literals, operators, variables, sensors, the gesture result, calls.

A new kind of expression needs a model here with a tag in `_MODELS`, checks in `expression_checks.py` and a case in
`execution/expressions/evaluation.py`. A new operator is a row in `operators.py`, a new sensor a row in `sensors.py`.
"""

from dataclasses import dataclass, field
from functools import reduce
from operator import or_
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, GetCoreSchemaHandler, Tag
from pydantic_core import CoreSchema, core_schema

from pinel_desktop.program.base import Model
from pinel_desktop.program.limits import MAX_LIST, MAX_NAME, MAX_TEXT
from pinel_desktop.program.sensors import SENSORS, Argument

Text = Annotated[str, Field(max_length=MAX_TEXT)]
# letters of any script with their marks, digits, underscores; spaces between
NAME_PATTERN = r"^[\p{L}\p{M}\p{N}_](?:[\p{L}\p{M}\p{N}_ ]*[\p{L}\p{M}\p{N}_])?$"
Name = Annotated[str, Field(max_length=MAX_NAME, pattern=NAME_PATTERN)]


@dataclass(frozen=True, slots=True)
class ParameterSpec:
    """Annotation of a parameter: a literal of one type within bounds, or an expression. `unit` is for the docs.

    `choices` are the only allowed texts; empty if any text is allowed.

    Literals are tried first, in pydantic's compiled code, because nearly all parameters are literals.
    """

    type: Literal["number", "text"]
    ge: float | None = None
    gt: float | None = None
    le: float | None = None
    whole: bool = False
    unit: str = ""
    choices: tuple[str, ...] = ()

    def __get_pydantic_core_schema__(
        self, _source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        node = handler.generate_schema(Node)
        return core_schema.union_schema([self._literal(), node], mode="left_to_right")

    def _literal(self) -> CoreSchema:
        if self.choices:
            return core_schema.literal_schema(list(self.choices))
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
    """Accepts whole numbers, including 3.0, which JSON does not distinguish from 3."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


class GestureResult(Model):
    """The last gesture result, a text."""

    gesture: Literal["result"]


class NumberShown(Model):
    """The last number that a hand showed, -1 without one."""

    gesture: Literal["number"]


class Variable(Model):
    """The value of a variable, or of a parameter of the enclosing function."""

    var: Name


class Operation(Model):
    """An operator with its arguments."""

    op: str
    args: list["Expression"]


class SensorReading(Model):
    """The value of a sensor. The models below are generated from the rows of `sensors.SENSORS`."""

    sensor: str


def _reading(name: str, doc: str, **annotations: Any) -> type[SensorReading]:
    namespace = {"__module__": __name__, "__doc__": doc, "__annotations__": annotations}
    metaclass: Any = type(SensorReading)
    made: type[SensorReading] = metaclass(name, (SensorReading,), namespace)
    return made


def _argument(argument: Argument) -> Any:
    if argument.choices:
        return Literal[argument.choices]
    low, high = argument.low, argument.high
    return Annotated[Any, ParameterSpec("number", ge=low, le=high, whole=argument.whole)]


def _readings() -> dict[str, type[SensorReading]]:
    """A model for each sensor with an argument, and one for all others."""
    plain = tuple(name for name, sensor in SENSORS.items() if sensor.argument is None)
    measure = _reading("Measure", "A sensor that is asked nothing.", sensor=Literal[plain])
    made = dict.fromkeys(plain, measure)
    for name, sensor in SENSORS.items():
        if sensor.argument is not None:
            asked = {sensor.argument.name: _argument(sensor.argument)}
            made[name] = _reading(name.title(), sensor.description, sensor=Literal[name], **asked)
    return made


READINGS = _readings()


class FunctionCall(Model):
    """The value that a function returns."""

    call: Name
    arguments: dict[Name, "Expression"] = field(default_factory=dict)


AnyNode = Operation | Variable | GestureResult | NumberShown | SensorReading | FunctionCall

# Tags appear in pydantic's error locations; with a space they cannot be taken for keys of the document.
_SENSOR_KINDS = {name: f"a {model.__name__.lower()}" for name, model in READINGS.items()}
_MODELS: dict[type[Model], str] = {
    Operation: "an operation",
    Variable: "a variable",
    GestureResult: "a gesture",
    NumberShown: "a number shown",
    FunctionCall: "a call",
    **{READINGS[name]: kind for name, kind in _SENSOR_KINDS.items()},
}


def _node_kind(value: Any) -> str | None:
    """Tag of the model of a node, for reading and for writing; None if it is not a node."""
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
        return "a number shown" if value["gesture"] == "number" else "a gesture"
    return "a call" if "call" in value else None


def _kind(value: Any) -> str | None:
    return "a list" if value.__class__ is list else _node_kind(value)


def _unknown(kind: Any) -> Discriminator:
    return Discriminator(
        kind, custom_error_type="unknown_expression", custom_error_message="expression"
    )


# literals are tried first, in pydantic's compiled code, because they are the most frequent
_FIRST_THAT_FITS = Field(union_mode="left_to_right")
Item = Annotated[Text | float | bool, _FIRST_THAT_FITS]


class _OneOf:
    """Validates a node as the model of its kind; with `lists` also a list of literals."""

    def __init__(self, *, lists: bool) -> None:
        self._lists = lists

    def __get_pydantic_core_schema__(
        self, _source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        members: list[Any] = [Annotated[model, Tag(kind)] for model, kind in _MODELS.items()]
        if self._lists:
            members.insert(0, Annotated[list[Item], Field(max_length=MAX_LIST), Tag("a list")])
        kind = _unknown(_kind if self._lists else _node_kind)
        return handler.generate_schema(Annotated[reduce(or_, members), kind])


Node = Annotated[AnyNode, _OneOf(lists=False)]
_ListOrNode = Annotated[list[Item] | AnyNode, _OneOf(lists=True)]
Expression = Annotated[Text | float | bool | _ListOrNode, _FIRST_THAT_FITS]
