"""The value of an expression while a program runs."""

from collections.abc import Callable
from typing import Any

from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.program.expressions import GestureResult, Operation

Value = bool | float | str

_ORDER: dict[str, Callable[[Any, Any], bool]] = {
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
}


def evaluate(expression: Any, context: RunContext) -> Value:
    """The value of a literal, an operation or the gesture result. Raises RunFailureError."""
    context.n_evaluated += 1
    if isinstance(expression, GestureResult):
        return context.gesture_result
    if isinstance(expression, Operation):
        return _operate(expression, context)
    value: Value = expression
    return value


def _operate(operation: Operation, context: RunContext) -> bool:
    op, args = operation.op, operation.args
    if op == "not":
        return not _boolean(args[0], op, context)
    if op == "and":
        return all(_boolean(arg, op, context) for arg in args)
    if op == "or":
        return any(_boolean(arg, op, context) for arg in args)
    left, right = evaluate(args[0], context), evaluate(args[1], context)
    if any(isinstance(arg, GestureResult) for arg in args):
        left, right = _folded(left), _folded(right)
    if op in ("==", "!="):
        return (_kind(left) == _kind(right) and left == right) == (op == "==")
    if _kind(left) != _kind(right) or isinstance(left, bool):
        raise RunFailureError("not_comparable", operator=op)
    return _ORDER[op](left, right)


def _boolean(expression: Any, op: str, context: RunContext) -> bool:
    value = evaluate(expression, context)
    if not isinstance(value, bool):
        raise RunFailureError("not_boolean", operator=op)
    return value


def _kind(value: Value) -> str:
    if isinstance(value, bool):
        return "boolean"
    return "text" if isinstance(value, str) else "number"


def _folded(value: Value) -> Value:
    """Gesture results are compared without regard to case: "b" is B."""
    return value.casefold() if isinstance(value, str) else value
