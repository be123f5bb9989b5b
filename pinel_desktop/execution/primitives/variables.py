"""Variables and lists."""

import math

from pinel_desktop.execution.context import RunContext, RunFailureError
from pinel_desktop.execution.expressions.values import Value
from pinel_desktop.execution.primitives.base import instant
from pinel_desktop.program.model import Append, ChangeVariable, ReplaceItem, SetVariable


@instant("set_variable", "value")
def set_variable(context: RunContext, command: SetVariable, value: Value) -> None:
    if isinstance(value, list):
        context.n_evaluated += len(value)  # copying a list is work
    context.variables.set(command.name, value)


@instant("change_variable", "by")
def change_variable(context: RunContext, command: ChangeVariable, by: float) -> None:
    value = context.variables.number(command.name) + by
    if not math.isfinite(value):
        raise RunFailureError("not_finite_result", operator="+")
    context.variables.set(command.name, value)


@instant("append", "value")
def append(context: RunContext, command: Append, value: Value) -> None:
    context.variables.append(command.list_, value)


@instant("replace_item", "position", "value")
def replace_item(context: RunContext, command: ReplaceItem, position: float, value: Value) -> None:
    context.variables.replace_item(command.list_, int(position), value)
