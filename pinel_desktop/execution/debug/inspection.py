"""The values of expressions for somebody who looks into a run that stands still."""

from collections.abc import Callable
from queue import Empty, SimpleQueue
from typing import Any, NamedTuple

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.evaluation import Evaluator
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.execution.watching import cut_value
from pinel_desktop.program.base import Model, values
from pinel_desktop.program.expressions import FunctionCall, Operation
from pinel_desktop.program.model import SetVariable
from pinel_desktop.program.reading import read_document

# takes the value, or why there is none
Answer = Callable[[Any, PinelError | None], None]


class Question(NamedTuple):
    """An expression as document data, and who wants to know."""

    expression: Any
    answer: Answer


class Questions:
    """What is asked by other threads, answered by the run's own."""

    def __init__(self) -> None:
        self._waiting: SimpleQueue[Question] = SimpleQueue()

    def ask(self, expression: Any, answer: Answer) -> None:
        self._waiting.put(Question(expression, answer))

    def answer_all(self, context: RunContext) -> None:
        """Answers what has been asked since the last time."""
        while True:
            try:
                question = self._waiting.get_nowait()
            except Empty:
                return
            try:
                question.answer(peek(question.expression, context), None)
            except PinelError as error:
                question.answer(None, error)


def peek(expression: Any, context: RunContext) -> Any:
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
            next(evaluating)  # takes breaths only: there is no call in it
    except StopIteration as end:
        return cut_value(end.value)
    finally:
        context.n_evaluated = (
            worked  # looking is no work of the program: its ticks stay as they are
        )


def _has_effect(node: Any) -> bool:
    if isinstance(node, FunctionCall) or (isinstance(node, Operation) and node.op == "random_int"):
        return True
    if isinstance(node, Operation):
        return any(_has_effect(argument) for argument in node.args)
    if isinstance(node, Model):
        return any(_has_effect(value) for value in values(node))
    return False
