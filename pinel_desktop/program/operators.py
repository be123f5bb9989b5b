"""The operators of expressions: what they take and what they give. Nothing here evaluates anything."""

from dataclasses import dataclass
from typing import Literal

ValueType = Literal["number", "text", "boolean", "list"]


@dataclass(frozen=True, slots=True)
class Operator:
    """How many arguments an operator takes, of which types, and the type of its result.

    Attributes:
        n_min, n_max: number of arguments; n_max is None where there is no limit.
        takes: types of the arguments, the last one for all that follow; None is any type.
        gives: type of the result; None where it depends on the arguments.
    """

    n_min: int
    n_max: int | None
    takes: tuple[ValueType | None, ...]
    gives: ValueType | None

    def accepts(self, count: int) -> bool:
        """Whether it can have that many arguments."""
        return count >= self.n_min and (self.n_max is None or count <= self.n_max)

    def type_at(self, index: int) -> ValueType | None:
        """The type of the argument at that place."""
        return self.takes[min(index, len(self.takes) - 1)]


_ARITHMETIC = Operator(2, 2, ("number",), "number")
_EQUALITY = Operator(2, 2, (None,), "boolean")
ORDER = Operator(2, 2, (None,), "boolean")  # two numbers or two texts
_JOINED = Operator(2, None, ("boolean",), "boolean")
_FUNCTION = Operator(1, 1, ("number",), "number")
_EXTREME = Operator(1, None, ("number",), "number")

OPERATORS: dict[str, Operator] = {
    **dict.fromkeys(("+", "-", "*", "/", "%", "**"), _ARITHMETIC),
    **dict.fromkeys(("==", "!="), _EQUALITY),
    **dict.fromkeys(("<", "<=", ">", ">="), ORDER),
    **dict.fromkeys(("and", "or"), _JOINED),
    "not": Operator(1, 1, ("boolean",), "boolean"),
    **dict.fromkeys(("min", "max"), _EXTREME),
    **dict.fromkeys(("abs", "round", "sqrt", "sin", "cos", "tan"), _FUNCTION),
    "random_int": Operator(2, 2, ("number",), "number"),
    "join": Operator(1, None, (None,), "text"),
    "length": Operator(1, 1, (None,), "number"),  # of a text or a list
    "item": Operator(2, 2, ("list", "number"), None),
}
SENSORS: dict[str, ValueType] = {
    **dict.fromkeys(("sonar", "distance", "lidar", "x", "y", "heading", "time"), "number"),
    "bumper": "boolean",
    **dict.fromkeys(("floor", "cell"), "text"),
}
