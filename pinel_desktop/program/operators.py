"""The operators of expressions: what they take and what they give. Nothing here evaluates anything."""

from dataclasses import dataclass, field
from typing import Literal

ValueType = Literal["number", "text", "boolean", "list"]


@dataclass(frozen=True, slots=True)
class Operator:
    """How many arguments an operator takes, of which types, and the type of its result.

    Attributes:
        n_min, n_max: number of arguments; n_max is None where there is no limit.
        takes: types of the arguments, the last one for all that follow; None is any type.
        gives: type of the result; None where it depends on the arguments.
        all_take: the one type that all arguments must have; None where there is none.
    """

    n_min: int
    n_max: int | None
    takes: tuple[ValueType | None, ...]
    gives: ValueType | None
    all_take: ValueType | None = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "all_take", self.takes[0] if len(self.takes) == 1 else None)

    def accepts(self, count: int) -> bool:
        """Whether it can have that many arguments."""
        return count >= self.n_min and (self.n_max is None or count <= self.n_max)

    def fits(self, types: list[ValueType | None]) -> bool:
        """Whether arguments of these types are certainly right; None is a type that only the run will know."""
        if len(types) < self.n_min or (self.n_max is not None and len(types) > self.n_max):
            return False
        wanted = self.all_take
        if wanted is None:
            return False
        return all(found is None or found == wanted for found in types)

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
