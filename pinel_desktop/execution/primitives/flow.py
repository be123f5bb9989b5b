"""Waiting, repeating, deciding."""

from collections.abc import Iterator

from pinel_desktop.execution.clock import TICK_HZ, TICK_S
from pinel_desktop.execution.context import RunContext
from pinel_desktop.execution.evaluation import evaluate
from pinel_desktop.execution.primitives.base import Body, flow, timed
from pinel_desktop.program.model import ConditionalExecution, Repeat, Wait


@timed("wait", amount=lambda command: command.seconds)
def wait(context: RunContext, command: Wait) -> Iterator[None]:
    for passed in range(1, round(command.seconds * TICK_HZ) + 1):
        context.done = passed * TICK_S
        yield


@flow("repeat")
def repeat(_context: RunContext, command: Repeat) -> Iterator[Body]:
    for _ in range(command.times):
        yield Body(command.commands, "/commands")


@flow("conditional_execution")
def conditional_execution(context: RunContext, command: ConditionalExecution) -> Iterator[Body]:
    if evaluate(command.condition, context):
        yield Body(command.commands, "/commands")
        return
    for i, branch in enumerate(command.elif_):
        if evaluate(branch.condition, context):
            yield Body(branch.commands, f"/elif/{i}/commands")
            return
    yield Body(command.else_, "/else")
