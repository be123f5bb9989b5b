"""The operators of expressions: types of their arguments and results."""

from dataclasses import dataclass, field
from typing import Literal

ValueType = Literal["number", "text", "boolean", "list"]


@dataclass(frozen=True, slots=True)
class Operator:
    """The signature of an operator.

    Attributes:
        n_min, n_max: number of arguments; `n_max` None is unlimited.
        argument_types: types of the arguments, the last one also for all further arguments; None is any type.
        gives: type of the result; None if it depends on the arguments.
        common_type: the common type of all arguments; None if there is none.
    """

    n_min: int
    n_max: int | None
    argument_types: tuple[ValueType | None, ...]
    gives: ValueType | None
    common_type: ValueType | None = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(
            self, "common_type", self.argument_types[0] if len(self.argument_types) == 1 else None
        )

    def accepts(self, count: int) -> bool:
        """True if the operator can have `count` arguments."""
        return count >= self.n_min and (self.n_max is None or count <= self.n_max)

    def fits(self, types: list[ValueType | None]) -> bool:
        """True if arguments of these types are certainly valid; None is a type known only in the run."""
        if len(types) < self.n_min or (self.n_max is not None and len(types) > self.n_max):
            return False
        expected = self.common_type
        if expected is None:
            return False
        return all(found is None or found == expected for found in types)

    def type_at(self, index: int) -> ValueType | None:
        """The type of the argument at `index`."""
        return self.argument_types[min(index, len(self.argument_types) - 1)]


_ARITHMETIC = Operator(2, 2, ("number",), "number")
EQUALITY = Operator(2, 2, (None,), "boolean")
ORDER = Operator(2, 2, (None,), "boolean")  # two numbers or two texts
_JOINED = Operator(2, None, ("boolean",), "boolean")
_FUNCTION = Operator(1, 1, ("number",), "number")
_EXTREME = Operator(1, None, ("number",), "number")

OPERATORS: dict[str, Operator] = {
    **dict.fromkeys(("+", "-", "*", "/", "%", "**"), _ARITHMETIC),
    **dict.fromkeys(("==", "!="), EQUALITY),
    **dict.fromkeys(("<", "<=", ">", ">="), ORDER),
    **dict.fromkeys(("and", "or"), _JOINED),
    "not": Operator(1, 1, ("boolean",), "boolean"),
    **dict.fromkeys(("min", "max"), _EXTREME),
    **dict.fromkeys(("abs", "round", "sqrt", "sin", "cos", "tan"), _FUNCTION),
    "random_int": Operator(2, 2, ("number",), "number"),
    "join": Operator(1, None, (None,), "text"),
    "length": Operator(1, 1, (None,), "number"),  # of a text or a list
    "item": Operator(2, 2, ("list", "number"), None),
    "contains": Operator(2, 2, ("list", None), "boolean"),
    "position_of": Operator(2, 2, ("list", None), "number"),
}
