"""Waiting, loops and conditions."""

import math

from pinel_desktop.execution.clock import TICK_HZ, TICK_S
from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.primitives.base import flow, instant, timed
from pinel_desktop.execution.requests import Body, Leave, Routine
from pinel_desktop.program.model import (
    Break,
    ConditionalExecution,
    Continue,
    For,
    Forever,
    Repeat,
    Until,
    Wait,
    WaitUntil,
    While,
)

# tolerance, in steps, of the last iteration of `for`: three times 0.1 is more than 0.3
_ROUNDING = 1e-9


@timed("wait", "seconds", amount=lambda seconds: seconds)
def wait(context: RunContext, _command: Wait, seconds: float) -> Routine:
    for passed in range(1, round(seconds * TICK_HZ) + 1):
        context.done = passed * TICK_S
        yield None
    return None


@timed("wait_until", "timeout")
def wait_until(context: RunContext, command: WaitUntil, timeout: float | None) -> Routine:
    """Evaluates the condition immediately and then at every tick; ends after the timeout (s)."""
    first = context.tick
    ticks = math.inf if timeout is None else max(1, round(timeout * TICK_HZ))
    while not (yield from context.evaluator.truth(command.condition)):
        if context.tick - first >= ticks:
            break
        yield None
    return None


@flow("repeat", "times", loop=True)
def repeat(_context: RunContext, command: Repeat, times: float) -> Routine:
    body = Body(command.commands, "/commands")
    for _ in range(int(times)):
        yield body
    return None


@flow("while", loop=True)
def while_(context: RunContext, command: While) -> Routine:
    body = Body(command.commands, "/commands")
    while (yield from context.evaluator.truth(command.condition)):
        yield body
    return None


@flow("until", loop=True)
def until(context: RunContext, command: Until) -> Routine:
    body = Body(command.commands, "/commands")
    while not (yield from context.evaluator.truth(command.condition)):
        yield body
    return None


@flow("for", "from_", "to", "by", loop=True)
def for_(context: RunContext, command: For, start: float, end: float, by: float) -> Routine:
    """Inclusive of `end`. Each value is `start + step * by`, so that rounding errors do not accumulate.

    Raises RunFailureError `step_is_zero` or `not_finite_result`.
    """
    if by == 0.0:
        raise RunFailureError("step_is_zero", variable=command.variable)
    body = Body(command.commands, "/commands")
    n_steps = (end - start) / by + _ROUNDING
    step = 0
    while step <= n_steps:
        value = start + step * by
        if not math.isfinite(value):
            raise RunFailureError("not_finite_result", operator="for")
        context.variables.set(command.variable, value)
        yield body
        step += 1
    return None


@flow("forever", loop=True)
def forever(_context: RunContext, command: Forever) -> Routine:
    body = Body(command.commands, "/commands")
    while True:
        yield body


@instant("break")
def break_(_context: RunContext, _command: Break) -> Leave:
    return Leave.LOOP


@instant("continue")
def continue_(_context: RunContext, _command: Continue) -> Leave:
    return Leave.ROUND


@flow("conditional_execution")
def conditional_execution(context: RunContext, command: ConditionalExecution) -> Routine:
    if (yield from context.evaluator.truth(command.condition)):
        yield Body(command.commands, "/commands")
        return None
    for i, branch in enumerate(command.elif_):
        if (yield from context.evaluator.truth(branch.condition)):
            yield Body(branch.commands, f"/elif/{i}/commands")
            return None
    yield Body(command.else_, "/else")
    return None
