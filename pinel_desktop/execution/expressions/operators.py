"""The functions of the operators; their argument types are in `program/operators.py`.

The short-circuiting `and` and `or` are in `evaluation.py`.
"""

import math
from collections.abc import Callable
from operator import add, ge, gt, le, lt, mul, sub
from random import Random
from typing import Any

from pinel_desktop.execution.expressions.values import (
    Value,
    fold_case,
    join,
    position_of,
    same,
)
from pinel_desktop.execution.failure import RunFailureError

# from the argument values
Compute = Callable[..., Value]
# the remainder of a tiny negative angle rounds to 360
_QUARTERS = {
    0.0: (0.0, 1.0),
    90.0: (1.0, 0.0),
    180.0: (0.0, -1.0),
    270.0: (-1.0, 0.0),
    360.0: (0.0, 1.0),
}


def computations(random: Random) -> dict[str, Compute]:
    """The function of each operator; `random` is the run's generator."""

    def random_int(low: Value, high: Value) -> Value:
        ends = sorted((_whole("random_int", low), _whole("random_int", high)))
        return float(random.randint(*ends))

    return {**_COMPUTATIONS, "random_int": random_int}


def comparison(op: str, *, of_gesture: bool) -> Compute:
    """The function of a comparison; ignores case if the gesture result is compared."""
    compare = _COMPUTATIONS[op]
    if not of_gesture:
        return compare
    return lambda left, right: compare(fold_case(left), fold_case(right))


def _numbers(op: str, values: tuple[Value, ...]) -> None:
    for value in values:
        if value.__class__ is not float:
            raise RunFailureError("not_number", operator=op)


def _finite(op: str, value: float) -> float:
    if not math.isfinite(value):
        raise RunFailureError("not_finite_result", operator=op)
    return value


def _arithmetic(op: str, function: Callable[[Any, Any], float]) -> Compute:
    def compute(left: Value, right: Value) -> Value:
        if left.__class__ is not float or right.__class__ is not float:
            raise RunFailureError("not_number", operator=op)
        try:
            result = function(left, right)
        except OverflowError:
            result = math.inf
        except ZeroDivisionError:
            raise RunFailureError("division_by_zero", operator=op) from None
        return result if math.isfinite(result) else _finite(op, result)

    return compute


def _power(base: float, exponent: float) -> float:
    if base < 0.0 and not exponent.is_integer():
        raise RunFailureError("power_not_real", value=base, exponent=exponent)
    result: float = base**exponent
    return result


def _function(op: str, function: Callable[[float], float]) -> Compute:
    def compute(value: Value) -> Value:
        if not isinstance(value, float):
            raise RunFailureError("not_number", operator=op)
        return _finite(op, function(value))

    return compute


def _square_root(value: float) -> float:
    if value < 0.0:
        raise RunFailureError("root_of_negative", value=value)
    return math.sqrt(value)


def _sine_cosine(degrees: float) -> tuple[float, float]:
    """Sine and cosine, exact at multiples of 90 degrees."""
    turn = degrees % 360.0
    radians = math.radians(turn)
    return _QUARTERS.get(turn) or (math.sin(radians), math.cos(radians))


def _tangent(degrees: float) -> float:
    sine, cosine = _sine_cosine(degrees)
    return sine / cosine if cosine else math.inf


def _order(op: str, compare: Callable[[Any, Any], bool]) -> Compute:
    def compute(left: Value, right: Value) -> Value:
        if left.__class__ is not right.__class__ or left.__class__ not in (float, str):
            raise RunFailureError("not_comparable", operator=op)
        return compare(left, right)

    return compute


def _extreme(op: str, choose: Callable[[Any], float]) -> Compute:
    def compute(*values: Value) -> Value:
        _numbers(op, values)
        return choose(values)

    return compute


def _not(value: Value) -> Value:
    if not isinstance(value, bool):
        raise RunFailureError("not_boolean", operator="not")
    return not value


def _length(value: Value) -> Value:
    if not isinstance(value, str | list):
        raise RunFailureError("not_text_or_list", operator="length")
    return float(len(value))


def _item(items: Value, index: Value) -> Value:
    if not isinstance(items, list):
        raise RunFailureError("not_list", operator="item")
    place = _whole("item", index)
    if not items:
        raise RunFailureError("list_empty", operator="item")
    if not 1 <= place <= len(items):
        raise RunFailureError("index_out_of_range", value=index, min=1, max=len(items))
    found: Value = items[place - 1]
    return found


def _position_of(items: Value, target: Value) -> Value:
    if not isinstance(items, list):
        raise RunFailureError("not_list", operator="position_of")
    return float(position_of(items, target))


def _contains(items: Value, target: Value) -> Value:
    if not isinstance(items, list):
        raise RunFailureError("not_list", operator="contains")
    return position_of(items, target) > 0


def _whole(op: str, value: Value) -> int:
    if not isinstance(value, float):
        raise RunFailureError("not_number", operator=op)
    if not value.is_integer():
        raise RunFailureError("not_whole", operator=op, value=value)
    return int(value)


def _join(*values: Value) -> Value:
    return join(list(values), "join")


_COMPUTATIONS: dict[str, Compute] = {
    "+": _arithmetic("+", add),
    "-": _arithmetic("-", sub),
    "*": _arithmetic("*", mul),
    "/": _arithmetic("/", lambda a, b: a / b),
    "%": _arithmetic("%", lambda a, b: a % b),
    "**": _arithmetic("**", _power),
    "==": same,
    "!=": lambda left, right: not same(left, right),
    "<": _order("<", lt),
    "<=": _order("<=", le),
    ">": _order(">", gt),
    ">=": _order(">=", ge),
    "not": _not,
    "min": _extreme("min", min),
    "max": _extreme("max", max),
    "abs": _function("abs", abs),
    "round": _function("round", lambda value: float(round(value))),
    "sqrt": _function("sqrt", _square_root),
    "sin": _function("sin", lambda degrees: _sine_cosine(degrees)[0]),
    "cos": _function("cos", lambda degrees: _sine_cosine(degrees)[1]),
    "tan": _function("tan", _tangent),
    "join": _join,
    "length": _length,
    "item": _item,
    "contains": _contains,
    "position_of": _position_of,
}
