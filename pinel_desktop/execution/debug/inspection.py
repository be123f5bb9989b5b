"""The values of expressions in a paused run."""

from queue import Empty
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.debug.variable_watch import cut_value
from pinel_desktop.execution.expressions.evaluation import Evaluator
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.program.base import Model, values
from pinel_desktop.program.expressions import FunctionCall, Operation
from pinel_desktop.program.model import SetVariable
from pinel_desktop.program.reading import read_document


def answer_evaluations(control: RunControl, context: RunContext) -> None:
    """Evaluates what has been asked since the last time. Called by the run's own thread while it is paused."""
    while True:
        try:
            request = control.evaluations.get_nowait()
        except Empty:
            return
        try:
            request.reply(inspect(request.expression, context), None)
        except PinelError as error:
            request.reply(None, error)


def inspect(expression: Any, context: RunContext) -> Any:
    """The value of an expression at this moment, as plain data; nothing in the run is changed.

    Raises PinelError `peek_invalid` for what is no expression, `peek_not_possible` for what would have to run
    (functions) or would draw a random number, and what evaluating it raises.
    """
    command = {"action": "set_variable", "name": "value", "value": expression}
    reading = read_document([command])
    if reading.program is None:
        called = any(fault.code == "unknown_function" for fault in reading.faults)
        raise RunFailureError("peek_not_possible" if called else "peek_invalid")
    (read,) = reading.program.commands
    assert isinstance(read, SetVariable)
    if _has_effect(read.value):
        raise RunFailureError("peek_not_possible")
    evaluating = Evaluator(context).value(read.value)
    worked = context.n_evaluated
    try:
        while True:
            next(evaluating)  # yields Preempt only: the expression calls no function
    except StopIteration as end:
        return cut_value(end.value)
    finally:
        context.n_evaluated = (
            worked  # an inspection is no work of the program: its ticks stay as they are
        )


def _has_effect(node: Any) -> bool:
    if isinstance(node, FunctionCall) or (isinstance(node, Operation) and node.op == "random_int"):
        return True
    if isinstance(node, Operation):
        return any(_has_effect(argument) for argument in node.args)
    if isinstance(node, Model):
        return any(_has_effect(value) for value in values(node))
    return False
