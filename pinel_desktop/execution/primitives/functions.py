"""Function calls and `return`."""

from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.primitives.base import flow, instant
from pinel_desktop.execution.requests import Invoke, Returned, Routine
from pinel_desktop.program.model import Call, Return


@flow("call")
def call(context: RunContext, command: Call) -> Routine:
    """Runs a function and discards its value."""
    arguments = yield from context.evaluator.arguments(command.arguments)
    yield Invoke(command.function, arguments)
    return None


@instant("return", "value")
def return_(_context: RunContext, _command: Return, value: Value | None) -> Returned:
    return Returned(value)
