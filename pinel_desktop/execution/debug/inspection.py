"""Evaluation of expressions in a paused run."""

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


def process_evaluations(control: RunControl, context: RunContext) -> None:
    """Evaluates the requests since the last call. Called on the run's thread while it is paused."""
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
    """The current value of an expression, as plain data, without side effects on the run.

    Raises PinelError `peek_invalid` for an invalid expression, `peek_not_possible` for one that calls a function or
    draws a random number, and the errors of evaluation.
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
            next(evaluating)  # yields only Preempt: the expression calls no function
    except StopIteration as end:
        return cut_value(end.value)
    finally:
        # inspection must not count as work of the program: it would change the ticks
        context.n_evaluated = worked


def _has_effect(node: Any) -> bool:
    if isinstance(node, FunctionCall) or (isinstance(node, Operation) and node.op == "random_int"):
        return True
    if isinstance(node, Operation):
        return any(_has_effect(argument) for argument in node.args)
    if isinstance(node, Model):
        return any(_has_effect(value) for value in values(node))
    return False
