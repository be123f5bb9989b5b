"""Expressions: literals, operators and the gesture result, as data. Nothing here evaluates anything.

More are to come (variables, sensors, arithmetic, calls): each becomes a model here, a row in OPERATORS or a tag in
`_kind`, and a case in `execution/evaluation.py`.
"""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag, model_validator
from pydantic_core import PydanticCustomError

from pinel_desktop.program.limits import MAX_TEXT

ValueType = Literal["number", "text", "boolean"]


class Operator:
    """What an operator takes and gives: number of arguments, their type (None = any), result type."""

    def __init__(
        self, n_min: int, n_max: int | None, takes: ValueType | None, gives: ValueType
    ) -> None:
        self.n_min, self.n_max, self.takes, self.gives = n_min, n_max, takes, gives

    def accepts(self, count: int) -> bool:
        return count >= self.n_min and (self.n_max is None or count <= self.n_max)


_EQUALITY = Operator(2, 2, None, "boolean")
_ORDER = Operator(2, 2, None, "boolean")
OPERATORS = {
    "==": _EQUALITY,
    "!=": _EQUALITY,
    "<": _ORDER,
    "<=": _ORDER,
    ">": _ORDER,
    ">=": _ORDER,
    "and": Operator(2, None, "boolean", "boolean"),
    "or": Operator(2, None, "boolean", "boolean"),
    "not": Operator(1, 1, "boolean", "boolean"),
}


class Model(BaseModel):
    """Base of everything in a document: unknown keys are faults, values are not converted, nothing changes."""

    model_config = ConfigDict(
        extra="forbid", strict=True, frozen=True, allow_inf_nan=False, defer_build=True
    )


class GestureResult(Model):
    """The last gesture result, a text."""

    gesture: Literal["result"]


class Operation(Model):
    """An operator with its arguments."""

    op: str
    args: list["Expression"]

    @model_validator(mode="after")
    def _fits(self) -> "Operation":
        operator = OPERATORS.get(self.op)
        if operator is None:
            raise PydanticCustomError(
                "unknown_operator", "unknown", {"value": self.op, "allowed": list(OPERATORS)}
            )
        if not operator.accepts(len(self.args)):
            raise PydanticCustomError(
                "wrong_argument_count",
                "count",
                {"operator": self.op, "value": len(self.args), "min": operator.n_min},
            )
        self._check_types(operator)
        return self

    def _check_types(self, operator: Operator) -> None:
        types = [type_of(argument) for argument in self.args]
        if operator.takes is not None and any(found != operator.takes for found in types):
            raise PydanticCustomError("not_boolean", "type", {"operator": self.op})
        if operator is _ORDER and (types[0] != types[1] or types[0] == "boolean"):
            raise PydanticCustomError("not_comparable", "type", {"operator": self.op})


# Tags stand in pydantic's error locations; with a space they are never taken for a key of the document.
_TAGS: dict[object, str] = {
    bool: "a boolean",
    int: "a number",
    float: "a number",
    str: "a text",
    "op": "an operation",
    "gesture": "a gesture",
}


def _kind(value: Any) -> str | None:
    """Which model an expression is to be read as; None for what is no expression."""
    if isinstance(value, dict):
        return next((_TAGS[key] for key in ("op", "gesture") if key in value), None)
    return _TAGS.get(type(value))


Expression = Annotated[
    Annotated[bool, Tag("a boolean")]
    | Annotated[float, Tag("a number")]
    | Annotated[str, Field(max_length=MAX_TEXT), Tag("a text")]
    | Annotated[Operation, Tag("an operation")]
    | Annotated[GestureResult, Tag("a gesture")],
    Discriminator(_kind, custom_error_type="unknown_expression", custom_error_message="expression"),
]


def type_of(expression: Any) -> ValueType:
    """The type an expression will have when it is evaluated."""
    if isinstance(expression, Operation):
        return OPERATORS[expression.op].gives
    if isinstance(expression, bool):
        return "boolean"
    return "number" if isinstance(expression, int | float) else "text"
